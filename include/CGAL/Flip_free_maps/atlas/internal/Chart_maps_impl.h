// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_maps.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/elements/internal/closest_rotation.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Chart_maps::Chart_maps(const Linked_triangles& surface, double begin, const Unwrap_options& options,
                                                  Unwrap_summary& summary)
  : Chart_surface(surface, begin, summary), m_options(options)
{}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::inherit(const Piece& piece, const Open_piece& open, Positions<2>& x) const
{
  x.resize(2, open.surface.points.cols());
  for(std::size_t e = 0; e < piece.faces.size(); ++e)
    for(int k = 0; k < 3; ++k)
      x.col(open.surface.triangles[e][k]) = m_image[piece.faces[e]].col(k);
  return x.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::draw_apart(const Open_piece& open, Positions<2>& x) const
{
  const double gap = this->gap();
  const auto is_apart = [&](const Positions<2>& y) { return !has_overlap(open, with_moved_border(open, y, gap)) && !has_overlap(open, y); };
  if(is_apart(x))
    return true;
  Positions<2> moved = with_moved_border(open, x, -2 * gap);
  if(!is_flip_free(open.surface.triangles, moved) || !is_apart(moved))
    return !has_overlap(open, x);
  x.swap(moved);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Chart_maps::twins(const Piece& piece, const Open_piece& open) const
{
  // Sides of the border by their halfedges of the surface. Other pieces are opened at the same time, so m_place is of no use.
  std::vector<std::pair<std::int32_t, std::int32_t>> sides;
  const auto& edges = open.border.edges();
  for(std::size_t i = 0; i < edges.size(); ++i) {
    const auto& t = open.surface.triangles[edges[i].element];
    const std::int32_t k = static_cast<std::int32_t>(std::find(t.begin(), t.end(), edges[i].source) - t.begin());
    sides.emplace_back(original_halfedge(piece, 3 * edges[i].element + k), static_cast<std::int32_t>(i));
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> sorted = sides;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::int32_t> result(edges.size(), -1);
  for(const auto& side : sides) {
    const std::int32_t opposite = m_surface.opposite[side.first];
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(opposite, -1));
    if(opposite >= 0 && found != sorted.end() && found->first == opposite)
      result[side.second] = found->second;
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::can_be_split(const Piece& piece) const
{
  return m_surface.polygons[piece.faces[0]] != m_surface.polygons[piece.faces.back()] || number_of_polygons(piece.faces) > 1;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::is_too_long(const Piece& piece, const Positions<2>& x) const
{
  if(!m_options.pack || !m_options.is_bounded() || piece.faces.size() < 4 || !can_be_split(piece) || is_late())
    return false;
  const Vector<2> direction = direction_of_smallest_box(x);
  Matrix<2> rotation;
  rotation << direction[0], direction[1], -direction[1], direction[0];
  const Vector<2> size = extent(rotation * x);
  const double length = size.maxCoeff(), width = size.minCoeff();
  return length > m_options.max_length * std::sqrt(m_area) && length > LONG * width;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Chart_maps::measure(const Piece& piece, const Open_piece& open, const Positions<2>& x,
                                                            Chart_summary& chart)
{
  Distortion_measure measure;
  std::pair<double, std::int32_t> worst(0, 0);
  for(std::size_t e = 0; e < piece.faces.size(); ++e) {
    Matrix<3> points;
    Image& image = m_image[piece.faces[e]];
    for(int k = 0; k < 3; ++k) {
      points.col(k) = open.surface.points.col(open.surface.triangles[e][k]);
      image.col(k) = x.col(open.surface.triangles[e][k]);
    }
    const double energy = measure.add(points, image);
    if(energy > worst.first)
      worst = {energy, static_cast<std::int32_t>(e)};
  }
  const Distortion_report report = measure.report();
  chart.area = report.rest_area; // in the user's units after sort_charts()
  chart.energy = report.energy;
  chart.max_energy = report.max_energy;
  chart.stretch_95 = report.stretch_95;
  return worst.second;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::remember(const Piece& piece, const Open_piece& open, const Positions<2>& x)
{
  for(std::size_t e = 0; e < piece.faces.size(); ++e)
    for(int k = 0; k < 3; ++k)
      m_chart_image[piece.faces[e]].col(k) = x.col(open.surface.triangles[e][k]);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::was_chart(const Piece& piece) const
{
  return std::all_of(piece.faces.begin(), piece.faces.end(), [this](std::int32_t f) { return m_chart_image[f].allFinite(); });
}

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> Chart_maps::chart_again(const Piece& piece, Open_piece& open)
{
  const Unbound_work work;
  std::vector<std::int32_t> sorted = piece.faces;
  std::sort(sorted.begin(), sorted.end());
  for(const std::int32_t f : piece.faces)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t h = 3 * f + k, opposite = m_surface.opposite[h];
      if(opposite < 0 || !m_is_cut[h] || m_is_given[h] || !std::binary_search(sorted.begin(), sorted.end(), opposite / 3))
        continue;
      const Image &a = m_chart_image[f], &b = m_chart_image[opposite / 3];
      const int l = opposite % 3;
      if(a.col(k) == b.col((l + 1) % 3) && a.col((k + 1) % 3) == b.col(l))
        close_seam(h);
    }
  for(const std::int32_t f : piece.faces)
    m_image[f] = m_chart_image[f];
  open = this->open(piece.faces);
  Positions<2> x;
  inherit(piece, open, x);
  return x;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::lay_beside(const std::vector<std::int32_t>& faces, const std::vector<std::int32_t>& sides)
{
  Positions<2> here(2, 2 * sides.size()), there(2, 2 * sides.size());
  std::map<std::array<double, 2>, Vector<2>> common;
  for(std::size_t i = 0; i < sides.size(); ++i) {
    const std::int32_t h = sides[i], opposite = m_surface.opposite[h];
    const int k = h % 3, l = opposite % 3;
    here.middleCols(2 * i, 2) << m_image[h / 3].col(k), m_image[h / 3].col((k + 1) % 3);
    there.middleCols(2 * i, 2) << m_image[opposite / 3].col((l + 1) % 3), m_image[opposite / 3].col(l);
    for(Eigen::Index v = 2 * i; v < Eigen::Index(2 * i + 2); ++v)
      common[{{here(0, v), here(1, v)}}] = there.col(v);
  }
  const Vector<2> from = here.rowwise().mean(), to = there.rowwise().mean();
  Matrix<2> rotation = Matrix<2>::Identity();
  closest_rotation((there.colwise() - to) * (here.colwise() - from).transpose(), rotation);
  for(const std::int32_t f : faces)
    for(int k = 0; k < 3; ++k) {
      const Vector<2> x = m_image[f].col(k);
      const auto found = common.find({{x[0], x[1]}});
      m_image[f].col(k) = found != common.end() ? found->second : Vector<2>(to + rotation * (x - from));
    }
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::keep(Piece& piece, const Open_piece& open, Positions<2>& x, const Chart_summary& chart)
{
  m_faces_done += chart.faces;
  m_charts.push_back({open.surface.triangles, std::move(x), std::move(piece.faces)});
  m_summary.charts.push_back(chart);
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_maps::empty_area(const Flat_chart& chart) const
{
  const Vector<2> direction = direction_of_smallest_box(chart.x);
  Matrix<2> rotation;
  rotation << direction[0], direction[1], -direction[1], direction[0];
  return extent(rotation * chart.x).prod() - signed_area(chart, chart.x);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_maps::halve(std::size_t c, double& seam_length)
{
  Piece whole;
  whole.faces = m_charts[c].faces;
  whole.is_part = true;
  if(!can_be_split(whole))
    return false;
  const Open_piece open = this->open(whole.faces);
  const Chart_splitter splitter(open.surface);
  const std::pair<std::int32_t, std::int32_t> ends = splitter.far_apart();
  const std::vector<Chart_splitter::Edge> seam = splitter.separate(ends.first, ends.second);
  seam_length = 0;
  double across_planes = 0;
  for(const Chart_splitter::Edge& edge : seam) {
    mark_seam(original_halfedge(whole, edge.halfedge));
    const double length = (open.surface.points.col(edge.vertices[0]) - open.surface.points.col(edge.vertices[1])).norm();
    seam_length += length;
    const std::int32_t h = edge.halfedge;
    const auto& triangles = open.surface.triangles;
    if(turning_angle(triangles[h / 3], triangles[open.surface.opposite[h] / 3], open.surface.points) < FLAT)
      across_planes += length;
  }
  // Nobody wants seams across planar faces.
  if(across_planes > MOST_ACROSS_PLANES * seam_length)
    return false;
  enqueue_parts(whole.faces, whole);
  std::deque<Piece> parts;
  parts.swap(m_queue);
  if(parts.size() != 2)
    return false;
  std::array<Flat_chart, 2> halves;
  std::array<Chart_summary, 2> summaries;
  for(int i = 0; i < 2; ++i) {
    const Open_piece part = this->open(parts[i].faces);
    Positions<2> x;
    if(!part.is_mesh || !inherit(parts[i], part, x) || !draw_apart(part, x))
      return false;
    summaries[i] = m_summary.charts[c];
    summaries[i].faces = number_of_polygons(parts[i].faces);
    measure(parts[i], part, x, summaries[i]);
    if(is_too_distorted(summaries[i]) || summaries[i].faces < LEAST_HALF)
      return false;
    halves[i] = {part.surface.triangles, std::move(x), std::move(parts[i].faces)};
  }
  summaries[1].iterations = 0;
  summaries[1].seconds = 0;
  m_charts[c] = std::move(halves[0]);
  m_summary.charts[c] = summaries[0];
  m_charts.push_back(std::move(halves[1]));
  m_summary.charts.push_back(summaries[1]);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::split_for_packing(const std::function<bool()>& must_stop)
{
  // The gain in covered area that makes up for a seam as long as the side of a square with the area of the surface; the least
  // gain; the part of the surface whose area a chart leaves empty at least if it is worth a trial; and the number of trials.
  const double seam_price = 0.04, least_gain = 0.02, least_empty = 0.05;
  const int most_trials = 4;
  // What others leave free is no square, and not for halves to fill better.
  if(!m_options.pack || !m_options.is_bounded() || m_options.min_occupancy == 0 || !m_obstacles.empty())
    return;
  std::vector<double> empty;
  for(const Flat_chart& chart : m_charts)
    empty.push_back(empty_area(chart));
  double covered = -1;
  for(int trial = 0; trial < most_trials && !is_late(); ++trial) {
    const std::size_t c = std::max_element(empty.begin(), empty.end()) - empty.begin();
    if(!(empty[c] >= least_empty * m_area))
      return;
    if(covered < 0)
      covered = expected_occupancy(m_charts, m_options.packing, must_stop);
    if(covered >= m_options.min_occupancy)
      return;
    const Flat_chart whole = m_charts[c];
    const Chart_summary summary = m_summary.charts[c];
    std::vector<char> was_cut;
    for(const std::int32_t f : whole.faces)
      was_cut.insert(was_cut.end(), m_is_cut.begin() + 3 * f, m_is_cut.begin() + 3 * f + 3);
    double seam_length = 0;
    bool is_halved = false;
    try {
      const Improving_work work;
      is_halved = halve(c, seam_length);
    } catch(const Interruption&) {
      m_queue.clear();
    }
    if(is_halved) {
      const double now = expected_occupancy(m_charts, m_options.packing, must_stop);
      if(now - covered >= (std::max)(least_gain, seam_price * seam_length / std::sqrt(m_area))) {
        covered = now;
        empty[c] = empty_area(m_charts[c]);
        empty.push_back(empty_area(m_charts.back()));
        ++m_summary.splits_for_packing;
        continue;
      }
      m_charts.pop_back();
      m_summary.charts.pop_back();
      m_charts[c] = whole;
      m_summary.charts[c] = summary;
    }
    for(std::size_t i = 0; i < whole.faces.size(); ++i)
      std::copy(was_cut.begin() + 3 * i, was_cut.begin() + 3 * i + 3, m_is_cut.begin() + 3 * whole.faces[i]);
    empty[c] = 0;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::sort_charts()
{
  std::vector<std::size_t> order(m_charts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [this](std::size_t a, std::size_t b) { return m_summary.charts[a].area > m_summary.charts[b].area; });
  std::vector<Flat_chart> charts;
  std::vector<Chart_summary> summaries;
  for(const std::size_t c : order) {
    charts.push_back(std::move(m_charts[c]));
    summaries.push_back(std::move(m_summary.charts[c]));
  }
  m_charts.swap(charts);
  m_summary.charts.swap(summaries);
  for(Chart_summary& chart : m_summary.charts) {
    m_areas.push_back(chart.area);
    chart.area = std::ldexp(chart.area, 2 * m_surface.exponent);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_maps::count()
{
  const std::size_t size = m_surface.triangles.size();
  std::vector<std::int32_t> chart_of(size);
  std::vector<std::array<std::int32_t, 3>> elements(size);
  double energy = 0, area = 0;
  for(std::size_t c = 0; c < m_charts.size(); ++c) {
    for(std::size_t e = 0; e < m_charts[c].faces.size(); ++e) {
      chart_of[m_charts[c].faces[e]] = static_cast<std::int32_t>(c);
      elements[m_charts[c].faces[e]] = m_charts[c].elements[e];
    }
    energy += m_areas[c] * m_summary.charts[c].energy;
    area += m_areas[c];
  }
  m_summary.energy = energy / area;
  m_summary.seam_edges = 0;
  m_summary.seam_length = 0;
  const auto image = [&](std::int32_t corner) { return elements[corner / 3][corner % 3]; };
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(3 * size); ++h) {
    const std::int32_t g = m_surface.opposite[h];
    if(g < h)
      continue;
    const std::int32_t h_end = next_in_triangle(h), g_end = next_in_triangle(g);
    const bool is_one = chart_of[h / 3] == chart_of[g / 3] && image(h) == image(g_end) && image(g) == image(h_end);
    m_is_cut[h] = m_is_cut[g] = !is_one;
    if(is_one)
      continue;
    ++m_summary.seam_edges;
    const auto& t = m_surface.triangles[h / 3];
    m_summary.seam_length += (m_surface.points.col(t[h_end % 3]) - m_surface.points.col(t[h % 3])).norm();
  }
  m_summary.seam_length = std::ldexp(m_summary.seam_length, m_surface.exponent);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_IMPL_H
