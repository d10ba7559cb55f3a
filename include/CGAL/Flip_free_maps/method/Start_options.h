// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_START_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_METHOD_START_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Convex shape to which the border is mapped for the start.
enum class Border_shape
{
  circle, ///< arc lengths proportional to the border's edge lengths
  square, ///< corners at quarters of the border's length
  polygon ///< `Start_options::polygon`
};

/// \ingroup PkgFlipFreeMapsRef
/// Weights of the start's linear system.
enum class Tutte_weights
{
  uniform,    ///< Tutte 1963
  mean_value, ///< Floater 2003; needs a general (unsymmetric) solver
  cotangent   ///< harmonic; may flip elements where weights are negative
};

/// \ingroup PkgFlipFreeMapsRef
/// How the start of a parameterization is made.
struct Start_options
{
  Border_shape border = Border_shape::circle;     ///< shape of the border
  std::vector<std::array<double, 2>> polygon;     ///< corners of a convex polygon, for `Border_shape::polygon`
  Tutte_weights weights = Tutte_weights::uniform; ///< weights to begin with
  /// From this number of faces on, the start is found from coarse to fine; below, or when negative, by a Tutte embedding.
  std::int64_t multilevel_size = 1000;
  std::int64_t coarsest_size = 800; ///< faces of the simplest surface
  double level_ratio = 3.5;         ///< the map is optimised each time the number of faces has grown by about this
                                    ///< factor
  double level_tolerance = 1e-3;    ///< relative decrease of the energy at which such an optimisation ends
  /// Whether triangles are laid in the plane next to each other first. The result is the start if none is flipped and they are
  /// distorted little, as on developable surfaces, where it is the isometry.
  bool unfold = false;
  bool fall_back = true; ///< whether other weights and a circle are tried when elements are flipped
  /// Whether border vertices of a single triangle go to their optimum (Claici et al., section 5.4). Off: over 49 surfaces the
  /// default method needed 3 % more factorizations with it (geometric mean; fewer on 9, more on 8).
  bool place_flaps = false;

  /// Checks the polygon; when it is unsuitable, says why in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(border != Border_shape::polygon)
      return true;
    const std::size_t n = polygon.size();
    bool convex = n >= 3;
    double turning = 0;
    for(std::size_t i = 0; convex && i < n; ++i) {
      const auto& a = polygon[i];
      const auto& b = polygon[(i + 1) % n];
      const auto& c = polygon[(i + 2) % n];
      const double cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
      const double dot = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
      convex = cross > 0;
      turning += std::atan2(cross, dot);
    }
    // A star polygon turns left everywhere too, but more than once around.
    return (convex && turning < 6.5) || internal::fail(message, "the border polygon must be strictly convex and counterclockwise");
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_START_OPTIONS_H
