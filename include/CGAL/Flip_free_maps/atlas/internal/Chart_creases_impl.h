// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE double turning_angle(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b,
                                                const Positions<3>& points)
{
  const auto normal = [&points](const std::array<std::int32_t, 3>& v) {
    const Vector<3> p = points.col(v[1]) - points.col(v[0]), q = points.col(v[2]) - points.col(v[0]);
    return Vector<3>(p.cross(q));
  };
  const Vector<3> m = normal(a), n = normal(b);
  return std::atan2(m.cross(n).norm(), m.dot(n));
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_creases::Chart_creases(const Linked_triangles& surface, double sharp_angle)
  : m_surface(surface), m_elements(surface.triangles), m_points(surface.points), m_is_sharp(surface.opposite.size(), 0)
{
  double turns = 0, lengths = 0;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_is_sharp.size()); ++h)
    if(neighbor(h) >= 0 && !surface.is_diagonal(h)) {
      const double angle = turning_angle(m_elements[h / 3], m_elements[neighbor(h)], m_points);
      if(angle < sharp_angle)
        continue;
      m_is_sharp[h] = 1;
      turns += angle * length(h);
      lengths += length(h);
    }
  m_is_clearly_sharp = turns >= SMALLEST_MEAN_ANGLE * lengths;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Chart_creases::cuts()
{
  std::vector<std::int32_t> result;
  if(!is_constructed())
    return result;
  find_regions();
  const std::vector<char> is_hinge = find_hinges();
  double cut_length = 0;
  for(std::size_t b = 0; b < m_borders.size(); ++b)
    if(!is_hinge[b]) {
      cut_length += m_borders[b].length;
      result.insert(result.end(), m_borders[b].sides.begin(), m_borders[b].sides.end());
    }
  if(!m_is_clearly_sharp && cut_length > LONGEST_DOUBTFUL_CUT * std::sqrt(m_surface.area()))
    result.clear();
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_creases::is_constructed() const
{
  std::vector<double> curvatures(m_points.cols(), 2 * CGAL_PI);
  std::vector<char> is_inner(m_points.cols(), 1), has_sharp_edge(m_points.cols(), 0);
  std::int64_t sharp = 0, smooth = 0;
  for(std::size_t e = 0; e < m_elements.size(); ++e)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = m_elements[e][k], w = m_elements[e][(k + 1) % 3];
      const Vector<3> a = m_points.col(w) - m_points.col(v), b = m_points.col(m_elements[e][(k + 2) % 3]) - m_points.col(v);
      curvatures[v] -= std::atan2(a.cross(b).norm(), a.dot(b));
      const std::int32_t h = static_cast<std::int32_t>(3 * e) + k;
      if(neighbor(h) < 0)
        is_inner[v] = is_inner[w] = 0;
      if(m_is_sharp[h])
        has_sharp_edge[v] = has_sharp_edge[w] = 1;
      (m_is_sharp[h] ? sharp : smooth) += 1;
    }
  double at_sharp_edges = 0, elsewhere = 0;
  for(std::size_t v = 0; v < curvatures.size(); ++v)
    if(is_inner[v])
      (has_sharp_edge[v] ? at_sharp_edges : elsewhere) += std::abs(curvatures[v]);
  return sharp > 0 && static_cast<double>(smooth) >= SMALLEST_SMOOTH_PART * static_cast<double>(sharp + smooth) &&
         at_sharp_edges >= SMALLEST_CURVATURE && elsewhere <= LARGEST_SMOOTH_PART_OF_CURVATURE * at_sharp_edges;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_creases::find_regions()
{
  m_region.assign(m_elements.size(), -1);
  std::int32_t number = 0;
  for(std::size_t first = 0; first < m_elements.size(); ++first) {
    if(m_region[first] >= 0)
      continue;
    std::vector<std::int32_t> front(1, static_cast<std::int32_t>(first));
    m_region[first] = number;
    while(!front.empty()) {
      const std::int32_t e = front.back();
      front.pop_back();
      for(std::int32_t h = 3 * e; h < 3 * e + 3; ++h) {
        const std::int32_t f = neighbor(h);
        if(f >= 0 && !m_is_sharp[h] && m_region[f] < 0) {
          m_region[f] = number;
          front.push_back(f);
        }
      }
    }
    ++number;
  }
  m_outlines.assign(number, 0.);
  std::map<std::array<std::int32_t, 2>, std::vector<Border>> lines;
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h) {
    const std::int32_t f = neighbor(h), p = m_region[h / 3], q = f < 0 ? -1 : m_region[f];
    if(p == q)
      continue;
    m_outlines[p] += length(h);
    if(q > p)
      add(h, lines[{{p, q}}], {{p, q}});
  }
  m_borders.clear();
  for(auto& entry : lines)
    m_borders.insert(m_borders.end(), entry.second.begin(), entry.second.end());
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_creases::add(std::int32_t side, std::vector<Border>& lines,
                                                   const std::array<std::int32_t, 2>& regions) const
{
  const Vector<3> a = m_points.col(end(side, 0)), d = m_points.col(end(side, 1)) - a;
  const auto is_on = [&](const Border& line) {
    const Vector<3> b = m_points.col(end(line.sides[0], 0)), c = m_points.col(end(line.sides[0], 1)) - b;
    return d.cross(c).norm() <= COLLINEAR * d.norm() * c.norm() && (a - b).cross(c).norm() <= COLLINEAR * (a - b).norm() * c.norm();
  };
  auto line = std::find_if(lines.begin(), lines.end(), is_on);
  if(line == lines.end())
    line = lines.insert(lines.end(), Border{regions, {}, 0.});
  line->sides.push_back(side);
  line->length += length(side);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<char> Chart_creases::find_hinges() const
{
  std::vector<std::size_t> order(m_borders.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) { return m_borders[a].length > m_borders[b].length; });
  std::vector<std::int32_t> joined(m_outlines.size());
  std::iota(joined.begin(), joined.end(), 0);
  const auto root = [&joined](std::int32_t p) {
    while(joined[p] != p)
      p = joined[p] = joined[joined[p]];
    return p;
  };
  std::vector<std::int32_t> triangles(m_outlines.size(), 0), hinges(m_outlines.size(), 0);
  for(const std::int32_t region : m_region)
    ++triangles[region];
  std::vector<char> result(m_borders.size(), 0);
  const auto join_along = [&](auto&& is_long) {
    for(const std::size_t b : order) {
      const std::int32_t r = m_borders[b].regions[0], t = m_borders[b].regions[1], p = root(r), q = root(t);
      if(p == q || !is_long(m_borders[b].length, r, t))
        continue;
      joined[p] = q;
      result[b] = 1;
      ++hinges[r];
      ++hinges[t];
    }
  };
  join_along(
    [&](double length, std::int32_t r, std::int32_t t) { return length >= SMALLEST_HINGE * (std::max)(m_outlines[r], m_outlines[t]); });
  // A triangle that would be alone, such as the cut corner of a box, hangs on a region of any size.
  join_along([&](double length, std::int32_t r, std::int32_t t) {
    const auto is_alone = [&](std::int32_t region) { return triangles[region] == 1 && hinges[region] == 0; };
    return (is_alone(r) && length >= SMALLEST_HINGE * m_outlines[r]) || (is_alone(t) && length >= SMALLEST_HINGE * m_outlines[t]);
  });
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_IMPL_H
