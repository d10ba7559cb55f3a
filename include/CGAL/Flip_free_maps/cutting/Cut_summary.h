// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H

#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/internal/report_header.h>

#include <cstdint>
#include <ostream>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// The account of `cut_to_disk()`.
struct Cut_summary
{
  Status status = Status::invalid_option; ///< `Status::success`, or why no seam was written
  std::string message = "not run";        ///< a sentence that says why
  int components = 0;                     ///< connected components of the mesh
  int borders = 0;                        ///< borders of the mesh, of all components
  int genus = 0;                          ///< handles of the mesh, of all components
  int pieces = 0;                         ///< connected components of the cut surface;
                                          ///< more than `components` where the user's seams part one
  int borders_of_pieces = 0;              ///< borders of the cut surface: `pieces` if all of these are disks
  int points = 0;                         ///< extremities, peaks or far points that seams were led to
  std::int64_t user_seam_edges = 0;       ///< seam edges that were there before
  std::int64_t seam_edges = 0;            ///< seam edges, those of the user included; edges on the mesh' border do not count
  double seam_length = 0;                 ///< length of the seam edges, in the units of the mesh
  double expected_energy = -1;            ///< estimate of the mean symmetric Dirichlet energy of maps of the pieces,
                                          ///< -1 where none was made
  double seconds = 0;                     ///< wall-clock seconds

  /// `true` when the seams were written.
  bool is_valid() const { return status == Status::success; }
};

/// \ingroup PkgFlipFreeMapsSeams
/// Fills a JSON value with all fields of a summary. Written against the interface of nlohmann::json, which finds this function by
/// argument-dependent lookup.
template <typename Json>
void to_json(Json& json, const Cut_summary& summary)
{
  internal::report_header(json, summary);
  json["components"] = summary.components;
  json["borders"] = summary.borders;
  json["genus"] = summary.genus;
  json["pieces"] = summary.pieces;
  json["borders_of_pieces"] = summary.borders_of_pieces;
  json["points"] = summary.points;
  json["user_seam_edges"] = summary.user_seam_edges;
  json["seam_edges"] = summary.seam_edges;
  json["seam_length"] = summary.seam_length;
  json["expected_energy"] = summary.expected_energy;
  json["seconds"] = summary.seconds;
}

/// \ingroup PkgFlipFreeMapsSeams
/// Writes a summary as a few lines of text.
inline std::ostream& operator<<(std::ostream& os, const Cut_summary& summary)
{
  os << status_name(summary.status) << ": " << summary.message << '\n';
  if(!summary.is_valid())
    return os;
  return os << "  " << summary.components << " components, " << summary.borders << " borders, genus " << summary.genus << "; cut into "
            << summary.pieces << " pieces with " << summary.borders_of_pieces << " borders\n"
            << "  " << summary.seam_edges << " seam edges, length " << summary.seam_length << ", " << summary.points << " points reached, "
            << summary.seconds << " s\n";
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H
