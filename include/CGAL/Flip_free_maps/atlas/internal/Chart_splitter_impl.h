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
#include <cmath>
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
  : m_surface(surface),
    m_elements(surface.triangles),
    m_points(surface.points),
    m_centers(surface.triangles.size()),
    m_is_cut(surface.opposite.size(), 0),
    m_is_seen(surface.triangles.size(), 0),
    m_first_corner(surface.points.cols(), -1),
    m_next_corner(surface.opposite.size())
{
  for(std::size_t c = 0; c < m_next_corner.size(); ++c) {
    std::int32_t& first = m_first_corner[m_elements[c / 3][c % 3]];
    m_next_corner[c] = first;
    first = static_cast<std::int32_t>(c);
  }
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
  const std::vector<double> distances = this->distances({seed});
  return static_cast<std::int32_t>(std::max_element(distances.begin(), distances.end()) - distances.begin());
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::separate(std::int32_t a, std::int32_t b) const
{
  std::vector<char> is_nearer_to_a;
  const std::vector<double> distances = this->distances({a, b}, &is_nearer_to_a);
  const std::vector<std::int32_t> part = connected_to(a, m_is_cut);
  std::vector<Edge> meeting;
  for(const std::int32_t e : part)
    for(std::int32_t h = 3 * e; h < 3 * e + 3; ++h)
      if(is_nearer_to_a[e] && neighbor(h) >= 0 && !is_nearer_to_a[neighbor(h)])
        meeting.push_back(edge(h));
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
  std::vector<Edge> straight = shortest_way((std::min)(ends[0], ends[1]), (std::max)(ends[0], ends[1]), distances);
  return smallest_part(part, straight) < SMALLEST_PART * smallest_part(part, meeting) ? meeting : straight;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::separate(
  const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs, int most_splits)
{
  std::vector<Edge> result;
  // Of each triangle one of its part, as long as there is that part.
  std::vector<std::int32_t> parts(m_elements.size(), 0);
  for(const auto& pair : pairs) {
    if(parts[pair.first] != parts[pair.second])
      continue;
    const std::vector<std::int32_t> whole = connected_to(pair.first, m_is_cut);
    const std::vector<Edge> edges = separate(pair.first, pair.second);
    if(edges.empty())
      continue;
    result.insert(result.end(), edges.begin(), edges.end());
    if(--most_splits <= 0)
      break;
    cut(edges, m_is_cut);
    for(const std::int32_t e : whole)
      parts[e] = -1;
    for(const std::int32_t first : whole)
      if(parts[first] < 0)
        for(const std::int32_t e : connected_to(first, m_is_cut))
          parts[e] = first;
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_splitter::cut(const std::vector<Edge>& edges, std::vector<char>& is_cut) const
{
  for(const Edge& edge : edges)
    is_cut[edge.halfedge] = is_cut[m_surface.opposite[edge.halfedge]] = 1;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Chart_splitter::connected_to(std::int32_t first, const std::vector<char>& is_cut) const
{
  std::vector<std::int32_t> result(1, first);
  m_is_seen[first] = 1;
  for(std::size_t q = 0; q < result.size(); ++q)
    for(std::int32_t h = 3 * result[q]; h < 3 * result[q] + 3; ++h) {
      const std::int32_t e = m_surface.opposite[h] < 0 || is_cut[h] ? -1 : m_surface.opposite[h] / 3;
      if(e >= 0 && !m_is_seen[e]) {
        m_is_seen[e] = 1;
        result.push_back(e);
      }
    }
  for(const std::int32_t e : result)
    m_is_seen[e] = 0;
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::around(std::int32_t e) const
{
  std::vector<Edge> result;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
    if(m_surface.polygons[h / 3] == m_surface.polygons[e] && is_inner_edge(h))
      result.push_back(edge(h));
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_splitter::smallest_part(const std::vector<std::int32_t>& part, const std::vector<Edge>& edges) const
{
  std::vector<char> is_cut = m_is_cut, is_counted(m_elements.size(), 0);
  cut(edges, is_cut);
  double smallest = std::numeric_limits<double>::infinity();
  for(const std::int32_t first : part) {
    if(is_counted[first])
      continue;
    double area = 0;
    for(const std::int32_t e : connected_to(first, is_cut)) {
      is_counted[e] = 1;
      area += this->area(e);
    }
    smallest = (std::min)(smallest, area);
  }
  return smallest;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> Chart_splitter::distances(const std::vector<std::int32_t>& seeds,
                                                                         std::vector<char>* is_nearer_to_first) const
{
  std::vector<double> result(m_elements.size(), std::numeric_limits<double>::infinity());
  std::vector<char> is_first(m_elements.size(), 0);
  Queue queue;
  for(const std::int32_t seed : seeds) {
    queue.emplace(0, seed);
    result[seed] = 0;
  }
  is_first[seeds.front()] = 1;
  std::size_t steps = 0;
  while(!queue.empty()) {
    ask_deadline_sometimes(++steps);
    const Entry entry = queue.top();
    queue.pop();
    const std::int32_t e = entry.second;
    if(entry.first > result[e])
      continue;
    for(std::int32_t h = 3 * e; h < 3 * e + 3; ++h) {
      const std::int32_t f = neighbor(h);
      if(f < 0)
        continue;
      const double distance = entry.first + crease_factor(e, f) * (m_centers[f] - m_centers[e]).norm();
      // What is as far from both is the first one's, so that triangles of a polygon stay together.
      if(distance < result[f] || (distance == result[f] && is_first[e] && !is_first[f])) {
        result[f] = distance;
        is_first[f] = is_first[e];
        queue.emplace(distance, f);
      }
    }
  }
  if(is_nearer_to_first != nullptr)
    is_nearer_to_first->swap(is_first);
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_splitter::Edge> Chart_splitter::shortest_way(std::int32_t from, std::int32_t to,
                                                                                          const std::vector<double>& distances) const
{
  std::vector<double> lengths(m_points.cols(), std::numeric_limits<double>::infinity());
  std::vector<std::int32_t> halfedge_before(m_points.cols(), -1);
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
    for(std::int32_t c = m_first_corner[v]; c >= 0; c = m_next_corner[c])
      for(const std::int32_t h : {c, prev_in_triangle(c)}) {
        if(!is_inner_edge(h) || !std::isfinite(distances[h / 3]))
          continue;
        const Edge way = edge(h);
        const std::int32_t w = way.vertices[0] == v ? way.vertices[1] : way.vertices[0];
        const double length = entry.first + (m_points.col(w) - m_points.col(v)).norm() / crease_factor(h / 3, neighbor(h));
        if(length < lengths[w]) {
          lengths[w] = length;
          halfedge_before[w] = h;
          queue.emplace(length, w);
        }
      }
  }
  std::vector<Edge> result;
  for(std::int32_t v = to; v != from;) {
    const Edge way = edge(halfedge_before[v]);
    result.push_back(way);
    v = way.vertices[0] == v ? way.vertices[1] : way.vertices[0];
  }
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_IMPL_H
