// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H

#include <CGAL/Flip_free_maps/report/Status.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Distortion of a map of a whole surface. Means are weighted by the areas of the surface.
struct Distortion_report
{
  Status status = Status::empty_mesh; ///< `success`, `empty_mesh`, `not_triangular`,
                                      ///< `non_finite_input` or `degenerate_rest_element`
  std::string message;                ///< a sentence, when the status is not `success`
  std::int64_t elements = 0;          ///< number of triangles
  std::int64_t flips = 0;             ///< triangles that are not positively oriented, by exact predicates
  double rest_area = 0;               ///< area of the surface
  double image_area = 0;              ///< area of the image, flipped triangles counted negatively
  double energy = 0;                  ///< mean symmetric Dirichlet energy (isometry 1);
                                      ///< infinite when a triangle collapses or flips
  double energy_of_similarity = 0;    ///< the same after the best uniform scaling of the image
  double max_energy = 0;              ///< largest energy of a triangle
  double mean_angle_distortion = 0;   ///< mean of (s_1/s_2 + s_2/s_1) / 2, 1 for a conformal map
  double mean_area_distortion = 0;    ///< mean of (s_1 s_2 + 1/(s_1 s_2)) / 2, 1 for an equiareal map
  double min_singular_value = 0;      ///< smallest singular value, negative on flipped triangles
  double max_singular_value = 0;      ///< largest singular value
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H
