// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H

#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Distortion of a map of a whole surface. Means are weighted by the areas of the surface. The status is `success`, `empty_mesh`,
/// `not_triangular`, `non_finite_input`, `degenerate_rest_element` or `invalid_option`; there is a message unless it is `success`.
struct Distortion_report : Outcome
{
  std::int64_t elements = 0;        ///< number of triangles
  std::int64_t flips = 0;           ///< triangles that are not positively oriented, by exact predicates
  double rest_area = 0;             ///< area of the surface
  double image_area = 0;            ///< area of the image, flipped triangles counted negatively
  double energy = 0;                ///< mean symmetric Dirichlet energy (isometry 1);
                                    ///< infinite when a triangle collapses or flips
  double energy_of_similarity = 0;  ///< the same after the best uniform scaling of the image
  double max_energy = 0;            ///< largest energy of a triangle
  double mean_angle_distortion = 0; ///< mean of (s_1/s_2 + s_2/s_1) / 2, 1 for a conformal map
  double mean_area_distortion = 0;  ///< mean of (s_1 s_2 + 1/(s_1 s_2)) / 2, 1 for an equiareal map
  double min_singular_value = 0;    ///< smallest singular value, negative on flipped triangles
  double max_singular_value = 0;    ///< largest singular value
  double stretch_95 = 0;            ///< the factor by which 95 % of the area are stretched or compressed at most in any direction,
                                    ///< after the best uniform scaling; infinite when more than that is flipped

  Distortion_report() : Outcome(Status::empty_mesh, "") {}

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    const Field_role if_valid = is_valid() ? Field_role::shown : Field_role::detail;
    Outcome::for_each_field(visit);
    visit("faces", elements, if_valid);
    visit("flips", flips, if_valid);
    visit("rest_area", rest_area, if_valid);
    visit("image_area", image_area, if_valid);
    visit("energy", energy, if_valid);
    visit("energy_of_similarity", energy_of_similarity, if_valid);
    visit("max_energy", max_energy, if_valid);
    visit("mean_angle_distortion", mean_angle_distortion, if_valid);
    visit("mean_area_distortion", mean_area_distortion, if_valid);
    visit("min_singular_value", min_singular_value, if_valid);
    visit("max_singular_value", max_singular_value, if_valid);
    visit("stretch_95", stretch_95, if_valid);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_REPORT_H
