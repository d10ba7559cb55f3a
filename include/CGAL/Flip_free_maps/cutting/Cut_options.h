// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_CUT_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_CUT_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// Settings of `cut_to_disk()`.
struct Cut_options
{
  /// What seams reach beside what the topology asks for.
  enum class Branches
  {
    none,            ///< nothing: the handles are opened and the borders joined, no more
    extremities,     ///< the peaks of curvature, then the places that would be distorted most, until `target_energy` is expected
    curvature_peaks, ///< corners and tips of limbs: peaks of the Gaussian curvature summed over discs, after Sheffer 2002
    farthest_points  ///< `number_of_points` points that are far from each other, the set D2 of Liu et al. 2018 (section 4.2)
  };

  /// See `Branches`. Pieces that are disks already are left as they are, see `cut_disks`.
  Branches branches = Branches::extremities;
  /// `Branches::extremities`: branches are added to a piece until the mean symmetric Dirichlet energy expected of its map (an
  /// isometry has 1) is at most this.
  double target_energy = 1.2;
  /// `Branches::farthest_points`: the points of each piece, at least 2. Otherwise the most points of each piece, 0 for no limit;
  /// spheres get two at least.
  int number_of_points = 0;
  /// `Branches::extremities`: how many times the places that would be distorted most are sought, and reached; 0 for as often as it
  /// takes. The energy that is expected is above the true one where the distortion is small, and may grow before it falls.
  int max_rounds = 0;
  /// Whether all borders of a component are joined by seams, so that the pieces are disks.
  /// Otherwise the pieces are disks with holes.
  bool join_borders = true;
  /// Whether pieces that are disks from the beginning, or after the user's seams, get branches, too.
  bool cut_disks = false;
  /// The cost of a seam per length on a feature edge, where it is 1 elsewhere; in (0, 1].
  double feature_cost = 0.25;
  /// How much seams follow creases and folds, rather than being short: an edge across which the surface turns by the angle a
  /// costs its length over 1 + crease_preference * a / pi. Not negative.
  double crease_preference = 1;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!(target_energy > 1))
      return internal::fail(message, "target_energy must be above 1");
    if(number_of_points < 0)
      return internal::fail(message, "number_of_points must not be negative");
    if(max_rounds < 0)
      return internal::fail(message, "max_rounds must not be negative");
    if(branches == Branches::farthest_points && number_of_points < 2)
      return internal::fail(message, "number_of_points must be at least 2 for farthest points");
    if(!(feature_cost > 0 && feature_cost <= 1))
      return internal::fail(message, "feature_cost must be in (0, 1]");
    if(!(crease_preference >= 0) || !std::isfinite(crease_preference))
      return internal::fail(message, "crease_preference must be finite and not negative");
    return true;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_CUT_OPTIONS_H
