// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Chart_zipper::Chart_zipper(const Linked_triangles& chart, const Border_curves& border,
                                                      const std::vector<std::int32_t>& twins, double gap)
  : m_chart(chart),
    m_border(border),
    m_twins(twins),
    m_gap(gap),
    m_next(border.edges().size()),
    m_prev(border.edges().size()),
    m_first_corner(chart.points.cols(), -1),
    m_next_corner(3 * chart.triangles.size())
{
  for(const auto& curve : border.curves())
    for(std::size_t i = 0; i < curve.size(); ++i) {
      m_next[curve[i]] = curve[(i + 1) % curve.size()];
      m_prev[curve[(i + 1) % curve.size()]] = curve[i];
    }
  for(std::size_t c = 0; c < m_next_corner.size(); ++c) {
    std::int32_t& first = m_first_corner[chart.triangles[c / 3][c % 3]];
    m_next_corner[c] = first;
    first = static_cast<std::int32_t>(c);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Vector<2> Chart_zipper::normal(const Positions<2>& x, std::int32_t i) const
{
  const Border_edge& a = m_border.edges()[i];
  const Border_edge& b = m_border.edges()[m_twins[i]];
  const Vector<2> along = x.col(a.target) - x.col(a.source) + x.col(b.source) - x.col(b.target);
  return Vector<2>(along[1], -along[0]).normalized();
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_zipper::distance(const Positions<2>& x, std::int32_t i) const
{
  const Border_edge& a = m_border.edges()[i];
  const Border_edge& b = m_border.edges()[m_twins[i]];
  const Vector<2> normal = this->normal(x, i);
  // Where the seam ends there is one vertex.
  const double at_source = a.source == b.target ? 0 : normal.dot(x.col(b.target) - x.col(a.source));
  const double at_target = a.target == b.source ? 0 : normal.dot(x.col(b.source) - x.col(a.target));
  return a.source == b.target ? at_target : a.target == b.source ? at_source : (std::min)(at_source, at_target);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_zipper::is_near(std::int32_t i, std::int32_t j) const
{
  std::int32_t before = i, after = i;
  for(int k = 0; k <= NEAR; ++k) {
    if(before == j || after == j)
      return true;
    before = m_prev[before];
    after = m_next[after];
  }
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_zipper::is_zippable(std::int32_t i, std::int32_t j) const
{
  // Where a seam ends at the border of the surface the edges that cross may be beyond it.
  std::int32_t before = i, after = i;
  for(int k = 0; k <= NEAR; ++k) {
    for(const std::int32_t e : {before, after})
      if(m_twins[e] >= 0 && is_near(m_twins[e], j))
        return true;
    before = m_prev[before];
    after = m_next[after];
  }
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Chart_zipper::next_of_seam(std::int32_t i) const
{
  const std::int32_t next = m_next[i];
  return m_twins[next] >= 0 && m_twins[next] == m_prev[m_twins[i]] && m_twins[next] != i ? next : -1;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Chart_zipper::prev_of_seam(std::int32_t i) const
{
  const std::int32_t prev = m_prev[i];
  return m_twins[prev] >= 0 && m_twins[prev] == m_next[m_twins[i]] && m_twins[prev] != i ? prev : -1;
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_zipper::Stretch Chart_zipper::stretch(const Positions<2>& x, std::int32_t i, std::int32_t j) const
{
  const auto overlaps = [&](std::int32_t e) { return e >= 0 && m_twins[e] >= 0 && distance(x, e) < 2 * m_gap; };
  // The edges that cross need not be those that lie over each other most.
  std::int32_t seed = -1;
  for(const std::int32_t start : {i, j}) {
    std::int32_t before = start, after = start;
    for(int k = 0; k <= NEAR && seed < 0; ++k) {
      seed = overlaps(before) ? before : overlaps(after) ? after : -1;
      before = m_prev[before];
      after = m_next[after];
    }
  }
  if(seed < 0)
    return {};
  while(overlaps(prev_of_seam(seed)) && prev_of_seam(seed) != seed)
    seed = prev_of_seam(seed);
  Stretch result(1, seed);
  for(std::int32_t e = next_of_seam(seed); overlaps(e) && e != seed; e = next_of_seam(e))
    result.push_back(e);
  double length = 0, depth = 0;
  for(const std::int32_t e : result) {
    const Border_edge& edge = m_border.edges()[e];
    length += (x.col(edge.target) - x.col(edge.source)).norm();
    depth = (std::max)(depth, -distance(x, e));
  }
  return depth <= MOST_TURN * length ? result : Stretch();
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Chart_zipper::rings(const std::vector<std::int32_t>& vertices, int number) const
{
  std::vector<std::int32_t> result, ring = vertices;
  std::unordered_set<std::int32_t> seen_vertices(ring.begin(), ring.end()), seen;
  for(int k = 0; k < number; ++k) {
    std::vector<std::int32_t> following;
    for(const std::int32_t v : ring)
      for(std::int32_t c = m_first_corner[v]; c >= 0; c = m_next_corner[c]) {
        if(!seen.insert(c / 3).second)
          continue;
        result.push_back(c / 3);
        for(const std::int32_t w : m_chart.triangles[c / 3])
          if(seen_vertices.insert(w).second)
            following.push_back(w);
      }
    ring.swap(following);
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_zipper::Goals Chart_zipper::goals(const Positions<2>& x, const Stretch& stretch) const
{
  Goals result;
  std::unordered_set<std::int32_t> has_goal;
  const auto part = [&](std::int32_t v, std::int32_t w, const Vector<2>& normal) {
    if(v != w && !(normal.dot(x.col(w) - x.col(v)) < 2 * m_gap))
      return;
    // Where several seams meet the first one decides.
    if(has_goal.count(v) > 0 || has_goal.count(w) > 0)
      return;
    has_goal.insert({v, w});
    const Vector<2> middle = 0.5 * (x.col(v) + x.col(w));
    result.emplace_back(v, v == w ? middle : Vector<2>(middle - m_gap * normal));
    if(v != w)
      result.emplace_back(w, middle + m_gap * normal);
  };
  for(const std::int32_t e : stretch) {
    const Border_edge& a = m_border.edges()[e];
    const Border_edge& b = m_border.edges()[m_twins[e]];
    const Vector<2> normal = this->normal(x, e);
    part(a.source, b.target, normal);
    part(a.target, b.source, normal);
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_zipper::make_patch(const Positions<2>& x, const Stretch& stretch, Patch& patch) const
{
  const Goals goals = this->goals(x, stretch);
  std::vector<std::int32_t> centers;
  for(const auto& goal : goals)
    centers.push_back(goal.first);
  const std::vector<std::int32_t> elements =
    rings(centers, (std::min)(RINGS + static_cast<int>(stretch.size()), static_cast<int>(MOST_RINGS)));

  Simplicial_domain<2>& domain = patch.domain;
  std::unordered_map<std::int32_t, std::int32_t> numbers;
  std::unordered_set<std::int32_t> is_inside(elements.begin(), elements.end());
  double area = 0;
  for(const std::int32_t e : elements) {
    const auto& t = m_chart.triangles[e];
    Simplicial_domain<2>::Element element;
    for(int k = 0; k < 3; ++k) {
      const auto entry = numbers.emplace(t[k], static_cast<std::int32_t>(patch.vertices.size()));
      if(entry.second)
        patch.vertices.push_back(t[k]);
      element[k] = entry.first->second;
    }
    domain.elements.push_back(element);
    domain.rest_inverses.emplace_back();
    domain.measures.emplace_back();
    if(!planar_rest_shape(m_chart.points.col(t[0]), m_chart.points.col(t[1]), m_chart.points.col(t[2]), domain.rest_inverses.back(),
                          domain.measures.back()))
      return false;
    area += domain.measures.back();
  }
  domain.number_of_vertices = static_cast<std::int32_t>(patch.vertices.size());
  // A power of two rounds nothing.
  patch.unit = std::ldexp(1., std::ilogb(std::sqrt(area)));
  for(std::size_t e = 0; e < elements.size(); ++e) {
    domain.measures[e] /= area;
    domain.rest_inverses[e] *= patch.unit;
  }
  patch.x.resize(2, patch.vertices.size());
  for(std::size_t v = 0; v < patch.vertices.size(); ++v) {
    patch.x.col(v) = x.col(patch.vertices[v]) / patch.unit;
    bool is_frame = false;
    for(std::int32_t c = m_first_corner[patch.vertices[v]]; c >= 0; c = m_next_corner[c])
      is_frame = is_frame || is_inside.count(c / 3) == 0;
    if(is_frame)
      patch.constraints.fixed_vertices.push_back(static_cast<std::int32_t>(v));
  }
  patch.targets = patch.x;
  for(const auto& goal : goals) {
    const std::int32_t v = numbers.at(goal.first);
    patch.targets.col(v) = goal.second / patch.unit;
    patch.constraints.fixed_vertices.push_back(v);
  }
  return !goals.empty();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_IMPL_H
