// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

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
  for(std::size_t e = 0; e < m_elements.size(); ++e)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t other = m_neighbors[e][k];
      if(other >= 0 && (to_a[e] <= to_b[e]) && !(to_a[other] <= to_b[other]))
        meeting.push_back({{m_elements[e][k], m_elements[e][(k + 1) % 3]}, {static_cast<std::int32_t>(e), other}});
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
  for(int k = 0; k < 3; ++k)
    if(m_neighbors[e][k] >= 0)
      result.push_back({{m_elements[e][k], m_elements[e][(k + 1) % 3]}, {e, m_neighbors[e][k]}});
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_splitter::smallest_part(const std::vector<Edge>& edges) const
{
  std::set<std::pair<std::int32_t, std::int32_t>> is_cut;
  for(const Edge& edge : edges)
    is_cut.insert(std::minmax(edge.elements[0], edge.elements[1]));
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
      const auto& v = m_elements[e];
      area += 0.5 * Vector<3>(m_points.col(v[1]) - m_points.col(v[0])).cross(Vector<3>(m_points.col(v[2]) - m_points.col(v[0]))).norm();
      for(const std::int32_t f : m_neighbors[e])
        if(f >= 0 && !is_seen[f] && is_cut.count(std::minmax(e, f)) == 0) {
          is_seen[f] = 1;
          front.push_back(f);
        }
    }
    smallest = (std::min)(smallest, area);
  }
  return smallest;
}

CGAL_FLIP_FREE_MAPS_INLINE Vector<3> Chart_splitter::center(std::int32_t e) const
{
  const auto& v = m_elements[e];
  return (m_points.col(v[0]) + m_points.col(v[1]) + m_points.col(v[2])) / 3;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> Chart_splitter::distances(std::int32_t seed) const
{
  std::vector<double> result(m_elements.size(), std::numeric_limits<double>::infinity());
  Queue queue;
  queue.emplace(0, seed);
  result[seed] = 0;
  while(!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if(entry.first > result[entry.second])
      continue;
    for(const std::int32_t e : m_neighbors[entry.second])
      if(e >= 0) {
        const double distance = entry.first + crease_factor(entry.second, e) * (center(e) - center(entry.second)).norm();
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
  for(std::size_t e = 0; e < m_elements.size(); ++e)
    for(int k = 0; k < 3; ++k)
      if(m_neighbors[e][k] > static_cast<std::int32_t>(e)) {
        const std::int32_t v = m_elements[e][k], w = m_elements[e][(k + 1) % 3];
        const Edge edge{{v, w}, {static_cast<std::int32_t>(e), m_neighbors[e][k]}};
        ways[v].emplace_back(w, edge);
        ways[w].emplace_back(v, edge);
      }
  std::vector<double> lengths(m_points.cols(), std::numeric_limits<double>::infinity());
  std::vector<std::pair<std::int32_t, Edge>> before(m_points.cols());
  Queue queue;
  queue.emplace(0, from);
  lengths[from] = 0;
  while(!queue.empty() && queue.top().second != to) {
    const Entry entry = queue.top();
    queue.pop();
    const std::int32_t v = entry.second;
    if(entry.first > lengths[v])
      continue;
    for(const auto& way : ways[v]) {
      const Edge& edge = way.second;
      const double length =
        entry.first + (m_points.col(way.first) - m_points.col(v)).norm() / crease_factor(edge.elements[0], edge.elements[1]);
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
