// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H

#include <CGAL/Flip_free_maps/cutting/Cut_summary.h>
#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// The account of one chart of an atlas.
struct Chart_summary : Outcome
{
  std::int64_t faces = 0; ///< number of faces
  double area = 0;        ///< area on the surface
  double energy = -1;     ///< mean symmetric Dirichlet energy before all charts were scaled alike (an isometry has 1)
  double max_energy = -1; ///< largest symmetric Dirichlet energy of a face
  double stretch_95 = -1; ///< the factor by which 95 % of the area are stretched or compressed at most in any direction
  int iterations = 0;     ///< steps of the minimizer
  double seconds = 0;     ///< wall-clock seconds of its flattening

  Chart_summary() : Outcome(Status::success, "") {}

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    Outcome::for_each_field(visit);
    visit("faces", faces);
    visit("area", area);
    visit("energy", energy);
    visit("max_energy", max_energy);
    visit("stretch_95", stretch_95);
    visit("iterations", iterations);
    visit("seconds", seconds);
  }
};

namespace internal {

// The seconds of an atlas as an object of their own.
struct Unwrap_seconds
{
  double cut, flatten, pack, certify, total;

  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    visit("cut", cut);
    visit("flatten", flatten);
    visit("pack", pack);
    visit("certify", certify);
    visit("total", total);
  }
};

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// The account of `unwrap()`. Fields that it did not reach keep their initial values.
struct Unwrap_summary : Outcome
{
  std::int64_t faces = -1;                            ///< faces of the mesh
  Cut_summary cut;                                    ///< how the surface was cut open
  std::vector<Chart_summary> charts;                  ///< the charts, the largest first; their places are the numbers in `face_chart_map`
  int splits_of_overlaps = 0;                         ///< how often a chart was split, in two or more, because it overlapped itself
  int splits_of_distortion = 0;                       ///< how often a chart was split because of `Unwrap_options::max_distortion`
  int splits_of_length = 0;                           ///< how often a chart was split because of `Unwrap_options::max_length`
  int splits_for_packing = 0;                         ///< how often a chart was split because of `Unwrap_options::min_occupancy`
  int splits_of_failures = 0;                         ///< how often a chart was split because it could not be flattened
  std::int64_t pinned_faces = 0;                      ///< faces that kept their images; charts and figures are those of the others
  int joined_charts = 0;                              ///< how many charts were joined to larger ones again, since no bound asks for a seam
  double energy = -1;                                 ///< mean symmetric Dirichlet energy, weighted by areas on the surface
  std::int64_t flips = -1;                            ///< triangles that are not positively oriented, by exact predicates:
                                                      ///< 0 in every valid atlas
  std::int64_t faces_without_area = 0;                ///< faces whose corners are on a line, up to rounding, or at less than three places
  std::vector<std::int64_t> first_faces_without_area; ///< the numbers of the first ten of them
  std::int64_t parted_edges = 0; ///< edges where faces meet that cannot all be joined: more than two, or of different windings
  std::int64_t seam_edges = -1;  ///< edges within the surface whose two triangles give different images to them
  double seam_length = -1;       ///< their length on the surface
  double scale = -1;             ///< length in the atlas over length on the surface: the scale of the packing,
                                 ///< or 1 without
  double occupancy = -1;         ///< the part of the unit square that is covered, by pinned faces, too; -1 without packing
  double cut_seconds = 0;        ///< wall-clock seconds of cutting
  double flatten_seconds = 0;    ///< of flattening, tests for overlaps and splits
  double pack_seconds = 0;       ///< of packing
  double certify_seconds = 0;    ///< of the last test of the whole atlas
  double seconds = 0;            ///< of everything

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    const auto if_any = [](int number) { return number > 0 ? Field_role::shown : Field_role::detail; };
    const Field_role if_valid = is_valid() ? Field_role::shown : Field_role::detail;
    Outcome::for_each_field(visit);
    visit("faces", faces);
    visit("pinned_faces", pinned_faces, pinned_faces > 0 ? Field_role::shown : Field_role::detail);
    visit("number_of_charts", static_cast<std::int64_t>(charts.size()), if_valid);
    visit("flips", flips);
    visit("energy", energy);
    visit("faces_without_area", faces_without_area, faces_without_area > 0 ? Field_role::shown : Field_role::detail);
    visit("first_faces_without_area", first_faces_without_area, Field_role::detail);
    visit("parted_edges", parted_edges, parted_edges > 0 ? Field_role::shown : Field_role::detail);
    visit("seam_edges", seam_edges);
    visit("seam_length", seam_length);
    visit("scale", scale);
    visit("occupancy", occupancy);
    visit("splits_of_overlaps", splits_of_overlaps, if_any(splits_of_overlaps));
    visit("splits_of_distortion", splits_of_distortion, if_any(splits_of_distortion));
    visit("splits_of_length", splits_of_length, if_any(splits_of_length));
    visit("splits_for_packing", splits_for_packing, if_any(splits_for_packing));
    visit("splits_of_failures", splits_of_failures, if_any(splits_of_failures));
    visit("joined_charts", joined_charts, if_any(joined_charts));
    visit("seconds", internal::Unwrap_seconds{cut_seconds, flatten_seconds, pack_seconds, certify_seconds, seconds}, if_valid);
    visit("cut", cut, Field_role::detail);
    visit("charts", charts, Field_role::detail);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H
