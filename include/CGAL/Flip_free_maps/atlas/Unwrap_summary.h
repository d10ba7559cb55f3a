// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H

#include <CGAL/Flip_free_maps/cutting/Cut_summary.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/internal/report_header.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// The account of one chart of an atlas.
struct Chart_summary
{
  Status status = Status::success; ///< how its flattening ended
  std::string message;             ///< a sentence that says why
  std::int64_t faces = 0;          ///< number of faces
  double area = 0;                 ///< area on the surface
  double energy = -1;              ///< mean symmetric Dirichlet energy before all charts were scaled alike (an isometry has 1)
  double max_energy = -1;          ///< largest symmetric Dirichlet energy of a face
  int iterations = 0;              ///< steps of the minimizer
  double seconds = 0;              ///< wall-clock seconds of its flattening
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of `unwrap()`. Fields that it did not reach keep their initial values.
struct Unwrap_summary
{
  Status status = Status::invalid_option; ///< how it ended
  std::string message = "not run";        ///< a sentence that says why
  std::int64_t faces = -1;                ///< faces of the mesh
  Cut_summary cut;                        ///< how the surface was cut open
  std::vector<Chart_summary> charts;      ///< the charts, the largest first; their places are the numbers in `face_chart_map`
  int splits_of_overlaps = 0;             ///< how often a chart was split because it overlapped itself
  int splits_of_distortion = 0;           ///< how often a chart was split because of `Unwrap_options::max_distortion`
  int splits_of_failures = 0;             ///< how often a chart was split because it could not be flattened
  double energy = -1;                     ///< mean symmetric Dirichlet energy, weighted by areas on the surface
  std::int64_t flips = -1;                ///< triangles that are not positively oriented, by exact predicates:
                                          ///< 0 in every valid atlas
  std::int64_t seam_edges = -1;           ///< edges within the surface whose two triangles give different images to them
  double seam_length = -1;                ///< their length on the surface
  double scale = -1;                      ///< length in the atlas over length on the surface: the scale of the packing,
                                          ///< or 1 without
  double occupancy = -1;                  ///< the part of the unit square that is covered; -1 without packing
  double cut_seconds = 0;                 ///< wall-clock seconds of cutting
  double flatten_seconds = 0;             ///< of flattening, tests for overlaps and splits
  double pack_seconds = 0;                ///< of packing
  double certify_seconds = 0;             ///< of the last test of the whole atlas
  double seconds = 0;                     ///< of everything

  /// `true` when the caller's property maps hold an atlas without flips and overlaps.
  bool is_valid() const { return is_valid_map(status); }
};

/// \ingroup PkgFlipFreeMapsRef
/// Fills a JSON value with all fields of a chart's summary. Written against the interface of nlohmann::json.
template <typename Json>
void to_json(Json& json, const Chart_summary& summary)
{
  internal::report_header(json, summary);
  json["faces"] = summary.faces;
  json["area"] = summary.area;
  json["energy"] = summary.energy;
  json["max_energy"] = summary.max_energy;
  json["iterations"] = summary.iterations;
  json["seconds"] = summary.seconds;
}

/// \ingroup PkgFlipFreeMapsRef
/// Fills a JSON value with all fields of a summary. Written against the interface of nlohmann::json.
template <typename Json>
void to_json(Json& json, const Unwrap_summary& summary)
{
  internal::report_header(json, summary);
  json["faces"] = summary.faces;
  json["energy"] = summary.energy;
  json["flips"] = summary.flips;
  json["number_of_charts"] = summary.charts.size();
  json["seam_edges"] = summary.seam_edges;
  json["seam_length"] = summary.seam_length;
  json["scale"] = summary.scale;
  json["occupancy"] = summary.occupancy;
  json["splits_of_overlaps"] = summary.splits_of_overlaps;
  json["splits_of_distortion"] = summary.splits_of_distortion;
  json["splits_of_failures"] = summary.splits_of_failures;
  Json seconds = Json::object();
  seconds["cut"] = summary.cut_seconds;
  seconds["flatten"] = summary.flatten_seconds;
  seconds["pack"] = summary.pack_seconds;
  seconds["certify"] = summary.certify_seconds;
  seconds["total"] = summary.seconds;
  json["seconds"] = seconds;
  json["cut"] = summary.cut;
  json["charts"] = summary.charts;
}

/// \ingroup PkgFlipFreeMapsRef
/// Writes a summary as a few lines of text.
inline std::ostream& operator<<(std::ostream& os, const Unwrap_summary& summary)
{
  os << status_name(summary.status) << ": " << summary.message << '\n';
  if(!summary.is_valid())
    return os;
  os << "  " << summary.faces << " faces in " << summary.charts.size() << " charts, " << summary.flips << " flipped\n"
     << "  energy " << summary.energy << ", seams of " << summary.seam_edges << " edges and length " << summary.seam_length << '\n';
  if(summary.occupancy >= 0)
    os << "  scale " << summary.scale << ", " << 100 * summary.occupancy << " % of the square are covered\n";
  if(summary.splits_of_overlaps + summary.splits_of_distortion + summary.splits_of_failures > 0)
    os << "  charts were split " << summary.splits_of_overlaps << " times because of overlaps, " << summary.splits_of_distortion
       << " times because of distortion, " << summary.splits_of_failures << " times because they could not be flattened\n";
  return os << "  " << summary.seconds << " s, of which cutting " << summary.cut_seconds << ", flattening " << summary.flatten_seconds
            << ", packing " << summary.pack_seconds << '\n';
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_SUMMARY_H
