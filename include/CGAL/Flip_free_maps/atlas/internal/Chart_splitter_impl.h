// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Chart_splitter::Chart_splitter(const Linked_triangles& surface)
  : m_surface(surface), m_elements(surface.triangles), m_points(surface.points), m_centers(surface.triangles.size())
{
  std::unordered_map<std::int32_t, std::pair<Vector<3>, double>> sums;
  const auto center = [this](std::size_t e) {
    const auto& v = m_elements[e];
    return Vector<3>((m_points.col(v[0]) + m_points.col(v[1]) + m_points.col(v[2])) / 3);
  };
  for(int pass = 0; pass < 2; ++pass)
    for(std::size_t e = 0; e < m_elements.size(); ++e) {
      const bool is_whole = !m_surface.is_diagonal(static_cast<std::int32_t>(3 * e)) &&
                            !m_surface.is_diagonal(static_cast<std::int32_t>(3 * e + 1)) &&
                            !m_surface.is_diagonal(static_cast<std::int32_t>(3 * e + 2));
      if(is_whole) {
        m_centers[e] = center(e);
        continue;
      }
      auto& sum = sums.emplace(m_surface.polygons[e], std::make_pair(Vector<3>(Vector<3>::Zero()), 0.)).first->second;
      if(pass == 0) {
        sum.first += area(e) * center(e);
        sum.second += area(e);
      } else {
        m_centers[e] = sum.first / sum.second;
      }
    }
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_splitter::area(std::size_t e) const
{
  const auto& v = m_elements[e];
  return 0.5 * Vector<3>(m_points.col(v[1]) - m_points.col(v[0])).cross(Vector<3>(m_points.col(v[2]) - m_points.col(v[0]))).norm();
}

CGAL_FLIP_FREE_MAPS_INLINE std::pair<std::int32_t, std::int32_t> Chart_splitter::far_apart() const
{
  const std::int32_t first = farthest_from(0);
  return {first, farthest_from(first)};
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Chart_splitter::farthest_from(std::int32_t seed) const
{
  const std::vector<double> distances = this->distances(seed);
  return static_cast<std::int32_t>(std::max_element(distances.begin(), distances.end()) - distances.begin());
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::separate(std::int32_t a, std::int32_t b) const
{
  const std::vector<double> to_a = distances(a), to_b = distances(b);
  std::vector<Edge> meeting;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h) {
    const std::int32_t e = h / 3, other = neighbor(h);
    if(other >= 0 && (to_a[e] <= to_b[e]) && !(to_a[other] <= to_b[other]))
      meeting.push_back(edge(h));
  }
  std::unordered_map<std::int32_t, int> degrees;
  for(const Edge& edge : meeting)
    for(const std::int32_t v : edge.vertices)
      ++degrees[v];
  std::vector<std::int32_t> ends;
  bool is_line = true;
  for(const auto& degree : degrees) {
    is_line = is_line && degree.second <= 2;
    if(degree.second == 1)
      ends.push_back(degree.first);
  }
  if(!is_line || ends.size() != 2)
    return meeting;
  // A way along the border would cut off crumbs.
  std::vector<Edge> straight = shortest_way((std::min)(ends[0], ends[1]), (std::max)(ends[0], ends[1]));
  return smallest_part(straight) < SMALLEST_PART * smallest_part(meeting) ? meeting : straight;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::around(std::int32_t e) const
{
  std::vector<Edge> result;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
    if(m_surface.polygons[h / 3] == m_surface.polygons[e] && is_inner_edge(h))
      result.push_back(edge(h));
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_splitter::smallest_part(const std::vector<Edge>& edges) const
{
  std::vector<char> is_cut(m_surface.opposite.size(), 0);
  for(const Edge& edge : edges)
    is_cut[edge.halfedge] = is_cut[m_surface.opposite[edge.halfedge]] = 1;
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<char> is_seen(m_elements.size(), 0);
  std::vector<std::int32_t> front;
  for(std::size_t first = 0; first < m_elements.size(); ++first) {
    if(is_seen[first])
      continue;
    double area = 0;
    is_seen[first] = 1;
    front.assign(1, static_cast<std::int32_t>(first));
    while(!front.empty()) {
      const std::int32_t e = front.back();
      front.pop_back();
      area += this->area(e);
      for(std::int32_t h = 3 * e; h < 3 * e + 3; ++h) {
        const std::int32_t f = neighbor(h);
        if(f >= 0 && !is_seen[f] && !is_cut[h]) {
          is_seen[f] = 1;
          front.push_back(f);
        }
      }
    }
    smallest = (std::min)(smallest, area);
  }
  return smallest;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> Chart_splitter::distances(std::int32_t seed) const
{
  std::vector<double> result(m_elements.size(), std::numeric_limits<double>::infinity());
  Queue queue;
  queue.emplace(0, seed);
  result[seed] = 0;
  std::size_t steps = 0;
  while(!queue.empty()) {
    ask_deadline_sometimes(++steps);
    const Entry entry = queue.top();
    queue.pop();
    if(entry.first > result[entry.second])
      continue;
    for(std::int32_t h = 3 * entry.second; h < 3 * entry.second + 3; ++h) {
      const std::int32_t e = neighbor(h);
      if(e < 0)
        continue;
      const double distance = entry.first + crease_factor(entry.second, e) * (m_centers[e] - m_centers[entry.second]).norm();
      if(distance < result[e]) {
        result[e] = distance;
        queue.emplace(distance, e);
      }
    }
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::shortest_way(std::int32_t from, std::int32_t to) const
{
  std::vector<std::vector<std::pair<std::int32_t, Edge>>> ways(m_points.cols());
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
    if(h < m_surface.opposite[h] && is_inner_edge(h)) {
      const Edge way = edge(h);
      ways[way.vertices[0]].emplace_back(way.vertices[1], way);
      ways[way.vertices[1]].emplace_back(way.vertices[0], way);
    }
  std::vector<double> lengths(m_points.cols(), std::numeric_limits<double>::infinity());
  std::vector<std::pair<std::int32_t, Edge>> before(m_points.cols());
  Queue queue;
  queue.emplace(0, from);
  lengths[from] = 0;
  std::size_t steps = 0;
  while(!queue.empty() && queue.top().second != to) {
    ask_deadline_sometimes(++steps);
    const Entry entry = queue.top();
    queue.pop();
    const std::int32_t v = entry.second;
    if(entry.first > lengths[v])
      continue;
    for(const auto& way : ways[v]) {
      const std::int32_t h = way.second.halfedge;
      const double length = entry.first + (m_points.col(way.first) - m_points.col(v)).norm() / crease_factor(h / 3, neighbor(h));
      if(length < lengths[way.first]) {
        lengths[way.first] = length;
        before[way.first] = {v, way.second};
        queue.emplace(length, way.first);
      }
    }
  }
  std::vector<Edge> result;
  for(std::int32_t v = to; v != from; v = before[v].first)
    result.push_back(before[v].second);
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H
