// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_seams.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper.h>
#include <CGAL/Flip_free_maps/cutting/internal/cut_mesh.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::cut_sharp_edges()
{
  if(!std::isfinite(m_options.seam_angle))
    return;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
    if(h < m_surface.opposite[h] && turns_by(h, m_options.seam_angle))
      mark_seam(h);
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_seams::Seams Chart_seams::creases(const Piece& piece)
{
  ask_deadline();
  Seams seams;
  bool is_any = false;
  for(std::size_t i = 0; i < piece.faces.size() && !is_any; ++i)
    for(std::int32_t h = 3 * piece.faces[i]; h < 3 * piece.faces[i] + 3; ++h)
      is_any = is_any || (neighbor(h) >= 0 && turns_by(h, m_options.crease_angle));
  if(is_any) {
    const Linked_triangles open = open_surface(piece.faces);
    for(const std::int32_t h : Chart_creases(open, m_options.crease_angle).cuts())
      seams.push_back(original_halfedge(piece, h));
  }
  return seams;
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_seams::Piece_cuts Chart_seams::cut(const Piece& piece, const Linked_triangles& open,
                                                                    const Cut_options& options)
{
  const std::int32_t size = static_cast<std::int32_t>(open.opposite.size());
  std::vector<char> is_cut(size, 0), is_feature(size);
  for(std::int32_t h = 0; h < size; ++h)
    is_feature[h] = m_is_feature[original_halfedge(piece, h)];
  Piece_cuts cuts;
  cuts.area = open.area();
  cuts.summary = cut_triangles(open, is_cut, is_feature, options, [this] { return must_stop(); });
  for(std::int32_t h = 0; h < size && cuts.summary.is_valid(); ++h)
    if(is_cut[h])
      cuts.seams.push_back(original_halfedge(piece, h));
  return cuts;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::decide(Piece& piece, Flat_piece& flat)
{
  const Open_piece& open = flat.open;
  Chart_summary& chart = flat.chart;
  const auto face = [&] { return "face number " + std::to_string(m_surface.polygons[piece.faces[0]]); };
  if(chart.status == Status::out_of_memory || chart.status == Status::invalid_option ||
     (chart.status == Status::interrupted && !flat.is_inherited))
    return give_up(flat, chart.status, chart.message);
  if((chart.status == Status::not_a_disk || chart.status == Status::no_border) && !piece.was_cut) {
    Cut_options cut = m_options.cut;
    cut.branches = Cut_options::Branches::none;
    piece.was_cut = true;
    cut_again(piece, flat, cut);
    flat.is_cut = true;
    return;
  }
  if(flat.is_inherited) {
    chart.status = Status::success;
    chart.message = "a part of a larger chart; not on its own: " + chart.message;
  }
  if(!flat.is_mapped && !flat.is_inherited) {
    if(!can_be_split(piece))
      return give_up(flat, chart.status, face() + " cannot be flattened: " + chart.message);
    return split(piece, flat, {{0, 0}}, &Unwrap_summary::splits_of_failures);
  }
  if(flat.is_overlapping) {
    if(!can_be_split(piece))
      return give_up(flat, Status::result_not_representable, face() + " was not laid flat without overlaps");
    piece.is_part = m_options.is_bounded() && excess(chart) < (piece.faces.size() > FEW_FACES ? WORST_EXCESS : 1);
    return split(piece, flat, overlaps(piece, open, flat.x), &Unwrap_summary::splits_of_overlaps);
  }
  bool is_interrupted = false;
  try {
    const Improving_work work;
    improve(piece, flat);
    is_interrupted = flat.failure == Status::interrupted;
    if(flat.is_cut)
      remember(piece, open, flat.x);
  } catch(const Interruption&) {
    is_interrupted = true;
  }
  if(is_interrupted) {
    flat.is_cut = false;
    flat.seams.clear();
    flat.failure = Status::success;
    chart.status = deadline_status();
    chart.message = "as it was when the time was up";
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::improve(Piece& piece, Flat_piece& flat)
{
  // Without time for flattening a part is as distorted as the whole.
  if(is_too_distorted(flat.chart) && can_be_split(piece) && !is_late()) {
    if(cut_for_less_distortion(piece, flat))
      return;
    piece.is_part = false;
    return split(piece, flat, {{flat.worst, -1}}, &Unwrap_summary::splits_of_distortion);
  }
  if(is_too_long(piece, flat.x)) {
    piece.is_part = true;
    split(piece, flat, {{0, 0}}, &Unwrap_summary::splits_of_length);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_seams::has_far_crossing(const Piece& piece, const Open_piece& open, const Positions<2>& x) const
{
  const std::vector<Crossing> all = crossings(open, x);
  if(all.empty())
    return false;
  const std::vector<std::int32_t> twins = this->twins(piece, open);
  const Chart_zipper zipper(open.surface, open.border, twins, gap());
  return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return !zipper.is_zippable(c.edges[0], c.edges[1]); });
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_seams::turns_by(std::int32_t h, double angle) const
{
  return !m_surface.is_diagonal(h) &&
         turning_angle(m_surface.triangles[h / 3], m_surface.triangles[m_surface.opposite[h] / 3], m_surface.points) >= angle;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::give_up(Flat_piece& flat, Status status, const std::string& message)
{
  flat.failure = status;
  flat.failure_message = message;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_seams::cut_for_less_distortion(Piece& piece, Flat_piece& flat)
{
  if(piece.recuts >= MOST_RECUTS || !flat.open.is_mesh || m_options.cut.branches != Cut_options::Branches::extremities)
    return false;
  Cut_options cut = m_options.cut;
  cut.cut_disks = true;
  cut.target_energy = piece.target > 0 ? piece.target : first_target();
  if(excess(flat.chart) < SMALL_EXCESS && cut.max_rounds == 0)
    cut.max_rounds = (std::max)(1, piece.recuts);
  ++piece.recuts;
  // Less is expected in the proportion of what is wanted to what came out, and less again if that was so already.
  double factor = CAUTION / excess(flat.chart);
  for(int i = 0; i < MOST_RECUTS && !flat.is_cut && flat.failure == Status::success; ++i, factor = 0.5) {
    cut.target_energy = 1 + factor * (cut.target_energy - 1);
    cut_again(piece, flat, cut);
  }
  piece.target = cut.target_energy;
  if(flat.is_cut)
    piece.is_part = piece.faces.size() > FEW_FACES && excess(flat.chart) < WORST_EXCESS;
  return flat.is_cut || flat.failure != Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::cut_again(const Piece& piece, Flat_piece& flat, const Cut_options& options)
{
  Piece_cuts cuts = cut(piece, flat.open.surface, options);
  if(!cuts.summary.is_valid())
    return give_up(flat, cuts.summary.status, "a part of the surface was not cut open: " + cuts.summary.message);
  flat.seams.swap(cuts.seams);
  flat.is_cut = !flat.seams.empty();
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::pair<std::int32_t, std::int32_t>> Chart_seams::overlaps(const Piece& piece,
                                                                                                    const Open_piece& open,
                                                                                                    const Positions<2>& x) const
{
  std::vector<Crossing> all = crossings(open, x), far = all;
  const std::vector<std::int32_t> twins = this->twins(piece, open);
  const Chart_zipper zipper(open.surface, open.border, twins, gap());
  far.erase(std::remove_if(far.begin(), far.end(), [&](const Crossing& c) { return zipper.is_zippable(c.edges[0], c.edges[1]); }),
            far.end());
  std::vector<std::pair<std::int32_t, std::int32_t>> result;
  for(const Crossing& crossing : far.empty() ? all : far)
    result.emplace_back(open.border.edges()[crossing.edges[0]].element, open.border.edges()[crossing.edges[1]].element);
  if(result.empty())
    result.emplace_back(0, 0);
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_seams::split(const Piece& piece, Flat_piece& flat,
                                                   std::vector<std::pair<std::int32_t, std::int32_t>> seeds, int Unwrap_summary::*reason)
{
  Chart_splitter splitter(flat.open.surface);
  std::pair<std::int32_t, std::int32_t>& first = seeds.front();
  if(first.second < 0)
    first.second = splitter.farthest_from(first.first);
  if(first.first == first.second)
    first = splitter.far_apart();
  std::vector<Chart_splitter::Edge> edges = splitter.separate(seeds, piece.is_part ? MOST_SPLITS : 1);
  // Polygons whose centres coincide have no distance, and those of the same polygon none from anything.
  if(edges.empty())
    edges = splitter.around(seeds.front().first);
  for(const Chart_splitter::Edge& edge : edges)
    flat.seams.push_back(original_halfedge(piece, edge.halfedge));
  flat.is_cut = true;
  flat.reason = reason;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_IMPL_H
