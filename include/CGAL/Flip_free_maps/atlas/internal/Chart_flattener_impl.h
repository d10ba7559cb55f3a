// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_flattener.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Chart_flattener::flatten(const Piece& piece, Flat_piece& flat)
{
  const double begin = wall_seconds();
  flat.open = this->open(piece.faces);
  const Open_piece& open = flat.open;
  Chart_summary& chart = flat.chart;
  chart.faces = number_of_polygons(piece.faces);
  Map_request request;
  request.has_start = piece.is_part && open.is_mesh && inherit(piece, open, flat.x);
  if(request.has_start) {
    chart.message = "a part of a larger chart";
    settle(piece, flat);
    flat.is_mapped = flat.is_overlapping ? can_be_split(piece) : !is_too_distorted(chart);
  }
  if(flat.is_mapped) {
    chart.seconds = wall_seconds() - begin;
    return;
  }
  if(is_late() && inherit(piece, open, flat.x)) {
    chart.status = m_is_stopped ? Status::stopped_by_observer : deadline_status();
    chart.message = "a part of a larger chart, as it was when the time was up";
    flat.is_mapped = true;
  } else if(open.is_mesh) {
    if(can_be_split(piece) && m_options.is_bounded() && piece.faces.size() > FEW_FACES)
      request.is_hopeless = [this, &piece, &open](const Positions<2>& x) { return has_far_crossing(piece, open, x); };
    Summary summary = flatten_piece(open, flat.x, request);
    // Rounding may flip a thin triangle of a map that is scaled.
    if(summary.status == Status::start_not_flip_free && request.has_start) {
      request.has_start = false;
      summary = flatten_piece(open, flat.x, request);
    }
    chart.status = summary.status;
    chart.message = summary.message;
    chart.iterations = summary.iterations;
    flat.is_mapped = summary.is_valid();
    flat.is_inherited = !flat.is_mapped && inherit(piece, open, flat.x);
  } else {
    chart.status = Status::non_manifold;
    chart.message = "two edges of the chart have the same vertices";
  }
  if(flat.is_mapped || flat.is_inherited) {
    settle(piece, flat);
    if(flat.is_overlapping && !can_be_split(piece)) {
      request = Map_request();
      request.is_convex = true;
      flat.is_mapped = flatten_piece(open, flat.x, request).is_valid();
      flat.is_overlapping = flat.is_mapped && !draw_apart(open, flat.x);
      flat.worst = measure(piece, open, flat.x, chart);
    }
  }
  chart.seconds = wall_seconds() - begin;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_flattener::flatten_union(const Piece& piece, Flat_piece& flat)
{
  const Open_piece open = this->open(piece.faces);
  Positions<2> x;
  if(inherit(piece, open, x) && !is_flip_free(open.surface.triangles, x) && has_overlap(open, x))
    return;
  // Maps of two charts are none of their union.
  for(const std::int32_t f : piece.faces)
    m_image[f].setConstant(std::numeric_limits<double>::quiet_NaN());
  flatten(piece, flat);
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_flattener::flatten_and_decide(Piece& piece, Flat_piece& flat)
{
  if(!was_chart(piece)) {
    flatten(piece, flat);
    return decide(piece, flat);
  }
  if(!is_late())
    try {
      const Improving_work work;
      flatten(piece, flat);
      decide(piece, flat);
      if(flat.failure != Status::interrupted && !(flat.is_cut && is_late()))
        return;
    } catch(const Interruption&) {}
  flat = Flat_piece();
  flat.x = chart_again(piece, flat.open);
  flat.is_mapped = true;
  flat.chart.faces = number_of_polygons(piece.faces);
  flat.chart.status = m_is_stopped ? Status::stopped_by_observer : deadline_status();
  flat.chart.message = "as it was before it was cut again, when the time was up";
  flat.worst = measure(piece, flat.open, flat.x, flat.chart);
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_flattener::keep_holes(const Piece& piece, Flat_piece& flat)
{
  ask_deadline();
  const double most_missing = 2 * CGAL_PI, most_energy = (std::min)(1.01, m_options.max_distortion);
  if(!m_options.cut.join_borders)
    return;
  flat.open = this->open(piece.faces);
  if(!flat.open.is_mesh || !(missing_angles(flat.open) <= most_missing))
    return;
  const double begin = wall_seconds();
  const Summary summary = flatten_piece(flat.open, flat.x);
  if(!summary.is_valid())
    return;
  Chart_summary& chart = flat.chart;
  chart.status = summary.status;
  chart.message = summary.message;
  chart.faces = number_of_polygons(piece.faces);
  chart.iterations = summary.iterations;
  const bool overlaps = !draw_apart(flat.open, flat.x);
  measure(piece, flat.open, flat.x, chart);
  flat.is_mapped = chart.energy <= most_energy && !overlaps;
  if(!flat.is_mapped)
    for(const std::int32_t f : piece.faces)
      m_image[f].setConstant(std::numeric_limits<double>::quiet_NaN());
  chart.seconds = wall_seconds() - begin;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_flattener::thicken(std::size_t number, double length)
{
  const Piece piece{m_charts[number].faces, true};
  const Open_piece open = this->open(piece.faces);
  Open_piece moved = open;
  std::uint32_t noise = 1;
  Positions<3>& points = moved.surface.points;
  for(Eigen::Index v = 0; v < points.cols(); ++v) {
    for(int i = 0; i < 3; ++i) {
      noise = noise * 1664525u + 1013904223u;
      points(i, v) += length * (noise / 2147483648. - 1);
    }
    moved.mesh.point(Vertex(static_cast<Mesh::size_type>(v))) = {points(0, v), points(1, v), points(2, v)};
  }
  Positions<2> x;
  const Summary summary = flatten_piece(moved, x);
  if(!summary.is_valid() || !draw_apart(open, x))
    return false;
  Chart_summary& chart = m_summary.charts[number];
  const double area = chart.area;
  measure(piece, open, x, chart);
  chart.area = area;
  m_charts[number].x.swap(x);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE Summary Chart_flattener::flatten_piece(const Open_piece& open, Positions<2>& x, const Map_request& request)
{
  if(!is_late())
    return solve(open, x, request, false);
  double late_since = m_late_since;
  if(late_since == 0)
    m_late_since = late_since = wall_seconds();
  const Unbound_work work;
  const Deadline last(late_since + GRACE - wall_seconds(), nullptr, 0);
  return solve(open, x, request, true);
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_flattener::settle(const Piece& piece, Flat_piece& flat)
{
  flat.is_overlapping = !draw_apart(flat.open, flat.x);
  flat.worst = measure(piece, flat.open, flat.x, flat.chart);
  // What is far too distorted will be cut anyway.
  const bool was_too_distorted = is_too_distorted(flat.chart);
  if(!flat.is_overlapping || !can_be_split(piece) || !m_options.is_bounded() || (was_too_distorted && excess(flat.chart) >= WORST_EXCESS))
    return;
  Positions<2> x = flat.x;
  if(has_far_crossing(piece, flat.open, x) || !zip(piece, flat.open, x))
    return;
  Chart_summary chart = flat.chart;
  const bool is_overlapping = !draw_apart(flat.open, x);
  const std::int32_t worst = measure(piece, flat.open, x, chart);
  if(is_too_distorted(chart) && !was_too_distorted) {
    measure(piece, flat.open, flat.x, flat.chart);
    return;
  }
  flat.is_overlapping = is_overlapping;
  flat.worst = worst;
  flat.chart = chart;
  flat.x.swap(x);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_flattener::zip(const Piece& piece, const Open_piece& open, Positions<2>& x) const
{
  bool is_changed = false;
  if(!can_relax())
    return false;
  const std::vector<std::int32_t> twins = this->twins(piece, open);
  const Chart_zipper zipper(open.surface, open.border, twins, ZIPPED_GAPS * gap());
  // What did not go once will hardly go later.
  std::vector<char> has_failed(twins.size(), 0);
  for(int round = 0; round < MOST_ROUNDS && !is_late(); ++round) {
    bool is_changed_now = false;
    std::vector<char> is_done(twins.size(), 0);
    for(const Crossing& crossing : crossings(open, with_moved_border(open, x, gap()))) {
      const std::int32_t i = crossing.edges[0], j = crossing.edges[1];
      if(is_done[i] || is_done[j] || has_failed[i] || has_failed[j] || !zipper.is_zippable(i, j))
        continue;
      is_done[i] = is_done[j] = 1;
      const Chart_zipper::Stretch stretch = zipper.stretch(x, i, j);
      for(const std::int32_t e : stretch)
        is_done[e] = is_done[twins[e]] = 1;
      Chart_zipper::Patch patch;
      if(!stretch.empty() && zipper.make_patch(x, stretch, patch) && relax(patch) && put(patch, x))
        is_changed_now = true;
      else
        has_failed[i] = has_failed[j] = 1;
    }
    if(!is_changed_now)
      break;
    is_changed = true;
  }
  return is_changed;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_flattener::put(const Chart_zipper::Patch& patch, Positions<2>& x)
{
  for(const auto& v : patch.domain.elements)
    if(CGAL::orientation(exact_point(patch.x, v[0]), exact_point(patch.x, v[1]), exact_point(patch.x, v[2])) != CGAL::LEFT_TURN)
      return false;
  for(std::size_t v = 0; v < patch.vertices.size(); ++v)
    x.col(patch.vertices[v]) = patch.unit * patch.x.col(v);
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_IMPL_H
