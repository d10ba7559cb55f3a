// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_IMPL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_planner.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> cut_costs(const Cut_surface& surface, const Cut_options& options)
{
  const auto normal = [&surface](std::int32_t f) {
    const auto& v = surface.faces[f];
    const Vector<3> a = surface.points.col(v[1]) - surface.points.col(v[0]), b = surface.points.col(v[2]) - surface.points.col(v[0]);
    return Vector<3>(a.cross(b));
  };
  std::vector<double> costs = surface.lengths;
  for(std::int32_t e = 0; e < surface.number_of_edges(); ++e) {
    const std::int32_t h = surface.edge_halfedge[e];
    if(surface.is_border(e))
      continue;
    const Vector<3> m = normal(h / 3), n = normal(surface.opposite[h] / 3);
    const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
    const double crease_cost = 1 / (1 + options.crease_preference * angle / CGAL_PI);
    costs[e] *= surface.is_feature[e] ? (std::min)(crease_cost, options.feature_cost) : crease_cost;
  }
  return costs;
}

CGAL_FLIP_FREE_MAPS_INLINE Cut_planner::Cut_planner(const Cut_surface& surface, const Cut_options& options,
                                                    const std::function<bool()>& must_stop)
  : m_surface(surface),
    m_options(options),
    m_must_stop([&must_stop] { return must_stop && must_stop(); }),
    m_opening(surface, surface.is_seam),
    m_costs(cut_costs(surface, options)),
    m_graph(surface, m_opening, m_costs)
{
  const std::int32_t pieces = m_opening.number_of_pieces();
  for(std::int32_t p = 0; p < pieces; ++p) {
    const std::int32_t loops = m_opening.loops_of_piece[p];
    const bool is_done = m_opening.genus_of_piece[p] == 0 && (loops == 1 || (loops > 1 && !options.join_borders));
    m_is_active.push_back(!is_done || options.cut_disks);
    m_is_closed.push_back(loops == 0 && m_opening.genus_of_piece[p] == 0);
  }
  m_corner_of.assign(surface.number_of_vertices(), -1);
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(surface.opposite.size()); ++h)
    m_corner_of[surface.source(h)] = h;
  m_points_of_piece.assign(pieces, 0);
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::plan(Cut_summary& summary)
{
  if(std::find(m_is_active.begin(), m_is_active.end(), 1) != m_is_active.end())
    grow(summary);
  m_graph.extend_single_edges();
  summary.points = std::accumulate(m_points_of_piece.begin(), m_points_of_piece.end(), 0);
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::grow(Cut_summary& summary)
{
  std::vector<std::int32_t> ends;
  if(m_options.join_borders)
    for(std::int32_t n = 0; n < m_opening.number_of_loops(); ++n)
      if(m_is_active[m_graph.piece_of(n)])
        ends.push_back(n);
  m_graph.open_handles(m_options.join_borders, m_must_stop);
  m_graph.shorten(ROUNDS_OF_SHORTENING, m_must_stop);
  switch(m_options.branches) {
  case Cut_options::Branches::none:
    cut_slits();
    m_graph.connect(ends);
    break;
  case Cut_options::Branches::farthest_points:
    m_graph.connect(ends);
    m_graph.connect(farthest_points());
    break;
  case Cut_options::Branches::curvature_peaks:
  case Cut_options::Branches::extremities:
    reach_extremities(ends, summary);
    break;
  }
  m_graph.prune();
  m_graph.shorten(ROUNDS_OF_SHORTENING, m_must_stop);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> Cut_planner::areas_of_pieces() const
{
  std::vector<double> areas(m_opening.number_of_pieces(), 0.);
  for(std::int32_t f = 0; f < m_surface.number_of_faces(); ++f)
    areas[m_opening.piece_of[f]] += m_surface.areas[f];
  return areas;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::add_point(std::int32_t v, std::vector<std::int32_t>& ends)
{
  const std::int32_t n = m_graph.node_of(m_corner_of[v]);
  if(!m_graph.is_loop(n))
    ends.push_back(n);
  ++m_points_of_piece[piece_of_vertex(v)];
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::cut_slits()
{
  std::vector<char> is_waiting = m_is_closed;
  for(std::int32_t n = 0; n < m_graph.number_of_nodes(); ++n)
    if(is_waiting[m_graph.piece_of(n)]) {
      is_waiting[m_graph.piece_of(n)] = 0;
      m_graph.cut_slit(n);
    }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::add_far_pairs(std::vector<std::int32_t>& ends)
{
  const std::int32_t pieces = m_opening.number_of_pieces();
  std::vector<std::int32_t> far(pieces, -1);
  for(std::int32_t n = m_graph.number_of_nodes() - 1; n >= 0; --n)
    if(m_is_closed[m_graph.piece_of(n)] && m_points_of_piece[m_graph.piece_of(n)] < 2)
      far[m_graph.piece_of(n)] = n;
  for(int sweep = 0; sweep < 2; ++sweep) {
    std::vector<std::int32_t> sources;
    std::copy_if(far.begin(), far.end(), std::back_inserter(sources), [](std::int32_t n) { return n >= 0; });
    if(sweep == 1)
      ends.insert(ends.end(), sources.begin(), sources.end());
    const std::vector<double>& distances = m_graph.find_distances(sources);
    for(std::int32_t n = 0; n < m_graph.number_of_nodes(); ++n) {
      const std::int32_t p = m_graph.piece_of(n);
      if(far[p] >= 0 && distances[n] > distances[far[p]])
        far[p] = n;
    }
  }
  for(std::int32_t p = 0; p < pieces; ++p)
    if(far[p] >= 0) {
      ends.push_back(far[p]);
      m_points_of_piece[p] += 2;
    }
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Cut_planner::farthest_points()
{
  const std::int32_t pieces = m_opening.number_of_pieces();
  const std::int32_t vertices = m_surface.number_of_vertices();
  Positions<3> corners = Positions<3>::Constant(3, pieces, std::numeric_limits<double>::infinity());
  for(std::int32_t v = 0; v < vertices; ++v)
    corners.col(piece_of_vertex(v)) = corners.col(piece_of_vertex(v)).cwiseMin(m_surface.points.col(v));
  std::vector<std::int32_t> ends;
  std::vector<double> scores(vertices);
  std::vector<char> is_chosen(vertices, 0);
  for(std::int32_t v = 0; v < vertices; ++v)
    scores[v] = -(m_surface.points.col(v) - corners.col(piece_of_vertex(v))).norm();
  for(int i = 0; i < m_options.number_of_points; ++i) {
    std::vector<std::int32_t> best(pieces, -1);
    for(std::int32_t v = 0; v < vertices; ++v) {
      const std::int32_t p = piece_of_vertex(v);
      if(m_is_active[p] && !is_chosen[v] && (best[p] < 0 || scores[v] > scores[best[p]]))
        best[p] = v;
    }
    for(std::int32_t p = 0; p < pieces; ++p)
      if(best[p] >= 0) {
        is_chosen[best[p]] = 1;
        add_point(best[p], ends);
      }
    for(std::int32_t v = 0; v < vertices; ++v) {
      if(best[piece_of_vertex(v)] < 0)
        continue;
      const double distance = (m_surface.points.col(v) - m_surface.points.col(best[piece_of_vertex(v)])).norm();
      scores[v] = i == 0 ? distance : scores[v] + distance;
    }
  }
  return ends;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::reach_extremities(std::vector<std::int32_t>& ends, Cut_summary& summary)
{
  if(m_must_stop()) {
    add_far_pairs(ends);
    return m_graph.connect(ends);
  }
  Cut_potential potential(m_surface);
  add_curvature_peaks(potential, ends);
  if(m_options.branches == Cut_options::Branches::extremities)
    add_cones(potential, ends);
  add_far_pairs(ends);
  m_graph.connect(ends);
  if(m_options.branches == Cut_options::Branches::extremities)
    reach_distorted_places(potential, summary);
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::add_curvature_peaks(Cut_potential& curvature, std::vector<std::int32_t>& ends)
{
  const std::int32_t vertices = m_surface.number_of_vertices();
  const std::vector<double> piece_areas = areas_of_pieces();
  std::vector<double> times(vertices);
  for(std::int32_t v = 0; v < vertices; ++v)
    times[v] = DISC_RADIUS * DISC_RADIUS * piece_areas[piece_of_vertex(v)];
  if(!curvature.find_summed_curvature(times))
    return;
  auto peaks = curvature.peaks(SMALLEST_CURVATURE / 2, [&](std::int32_t v) { return curvature.value(v) >= SMALLEST_CURVATURE / 2; });
  std::sort(peaks.begin(), peaks.end(), [&](const Cut_potential::Peak& a, const Cut_potential::Peak& b) {
    const double value_a = curvature.value(a.vertex), value_b = curvature.value(b.vertex);
    return value_a != value_b ? value_a > value_b : a.vertex < b.vertex;
  });
  for(const Cut_potential::Peak& peak : peaks) {
    const bool is_on_border = m_graph.is_loop(m_graph.node_of(m_corner_of[peak.vertex]));
    if(curvature.value(peak.vertex) >= SMALLEST_CURVATURE && !is_on_border && may_grow(piece_of_vertex(peak.vertex)))
      add_point(peak.vertex, ends);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::add_cones(const Cut_potential& potential, std::vector<std::int32_t>& ends)
{
  const std::vector<double> piece_areas = areas_of_pieces();
  const std::vector<std::int32_t> known = ends;
  std::vector<char> is_end(m_graph.number_of_nodes(), 0);
  for(const std::int32_t n : known)
    is_end[n] = 1;
  for(std::int32_t v = 0; v < m_surface.number_of_vertices(); ++v) {
    const std::int32_t n = m_graph.node_of(m_corner_of[v]), p = piece_of_vertex(v);
    if(m_graph.is_loop(n) || is_end[n] || !may_grow(p))
      continue;
    if(potential.cone_excess(v) >= PART_OF_TARGET * (m_options.target_energy - 1) * piece_areas[p])
      add_point(v, ends);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_planner::reach_distorted_places(Cut_potential& potential, Cut_summary& summary)
{
  const std::int32_t pieces = m_opening.number_of_pieces(), vertices = m_surface.number_of_vertices();
  const std::vector<double> piece_areas = areas_of_pieces();
  const int rounds = m_options.max_rounds > 0 ? m_options.max_rounds : MOST_ROUNDS;
  for(int round = 0; round < rounds && !m_must_stop(); ++round) {
    std::vector<char> is_fixed(vertices, 0);
    for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
      if(!m_is_active[m_opening.piece_of[h / 3]] || m_graph.is_on_cut(m_graph.node_of(h)))
        is_fixed[m_surface.source(h)] = 1;
    if(!potential.find_potential(is_fixed))
      return;
    std::vector<double> excesses(pieces, 0.);
    for(std::int32_t v = 0; v < vertices; ++v)
      if(!is_fixed[v])
        excesses[piece_of_vertex(v)] += potential.excess(v);
    double excess = 0, area = 0;
    for(std::int32_t p = 0; p < pieces; ++p)
      if(m_is_active[p]) {
        excess += excesses[p];
        area += piece_areas[p];
      }
    summary.expected_energy = 1 + excess / area;
    const auto is_wanted = [&](std::int32_t v) {
      const std::int32_t p = piece_of_vertex(v);
      return may_grow(p) && excesses[p] > (m_options.target_energy - 1) * piece_areas[p];
    };
    std::vector<double> worst(pieces, 0.);
    std::vector<std::int32_t> ends;
    for(const Cut_potential::Peak& peak : potential.peaks(SMALLEST_PROMINENCE, is_wanted)) {
      const std::int32_t p = piece_of_vertex(peak.vertex);
      worst[p] = (std::max)(worst[p], peak.excess);
      if(peak.excess < PART_OF_WORST * worst[p] || !may_grow(p))
        continue;
      add_point(peak.vertex, ends);
    }
    if(ends.empty())
      return;
    m_graph.connect(ends);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void describe_surface(const Cut_surface& surface, Cut_summary& summary)
{
  const Cut_opening whole(surface, std::vector<char>(surface.number_of_edges(), 0));
  if(whole.number_of_copies() != surface.number_of_vertices()) {
    summary.status = Status::non_manifold;
    summary.message = "several sheets of the surface meet at a vertex";
    return;
  }
  summary.components = whole.number_of_pieces();
  summary.borders = whole.number_of_loops();
  summary.genus = std::accumulate(whole.genus_of_piece.begin(), whole.genus_of_piece.end(), 0);
  summary.status = Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Cut_opening describe_seams(const Cut_surface& surface, const std::vector<char>& is_cut, Cut_summary& summary)
{
  std::vector<char> all = is_cut;
  for(std::size_t e = 0; e < all.size(); ++e) {
    summary.user_seam_edges += surface.is_seam[e] != 0;
    all[e] = all[e] || surface.is_seam[e];
    if(all[e]) {
      ++summary.seam_edges;
      summary.seam_length += surface.lengths[e] * surface.scale;
    }
  }
  const Cut_opening result(surface, all);
  summary.pieces = result.number_of_pieces();
  summary.borders_of_pieces = result.number_of_loops();
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void plan_cuts(const Cut_surface& surface, const Cut_options& options, std::vector<char>& is_cut,
                                          Cut_summary& summary, const std::function<bool()>& must_stop)
{
  describe_surface(surface, summary);
  if(!summary.is_valid())
    return;
  Cut_planner planner(surface, options, must_stop);
  planner.plan(summary);
  is_cut = planner.is_cut();
  const Cut_opening result = describe_seams(surface, is_cut, summary);
  for(std::int32_t p = 0; p < result.number_of_pieces(); ++p) {
    const std::int32_t loops = result.loops_of_piece[p];
    if(result.genus_of_piece[p] != 0 || loops == 0 || (options.join_borders && loops != 1)) {
      summary.status = Status::not_a_disk;
      summary.message = "the seams that were found do not cut the surface to disks";
      return;
    }
  }
  summary.message = options.join_borders ? "cut to disks" : "cut to disks with holes";
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_IMPL_H
