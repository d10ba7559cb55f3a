// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_IMPL_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Border_curves::load(const std::vector<std::array<std::int32_t, 3>>& elements,
                                                    std::int32_t number_of_vertices)
{
  struct Side
  {
    std::int32_t low, high, element, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * elements.size());
  for(std::size_t e = 0; e < elements.size(); ++e)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = elements[e][k], w = elements[e][(k + 1) % 3];
      sides.push_back({(std::min)(v, w), (std::max)(v, w), static_cast<std::int32_t>(e), k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high) ||
           (a.low == b.low && a.high == b.high && std::make_pair(a.element, a.corner) < std::make_pair(b.element, b.corner));
  });
  m_edges.clear();
  for(std::size_t i = 0, j; i < sides.size(); i = j) {
    for(j = i + 1; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;)
      ++j;
    const auto begins_at = [&](const Side& side) { return elements[side.element][side.corner]; };
    if(sides[i].low == sides[i].high || j - i > 2 || (j - i == 2 && begins_at(sides[i]) == begins_at(sides[i + 1])))
      return false;
    if(j - i == 1) {
      const std::int32_t v = begins_at(sides[i]);
      m_edges.push_back({v, v == sides[i].low ? sides[i].high : sides[i].low, sides[i].element, -1});
    }
  }
  return link(number_of_vertices);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Border_curves::load(const std::vector<std::array<std::int32_t, 3>>& elements,
                                                    const std::vector<std::int32_t>& opposite, std::int32_t number_of_vertices)
{
  m_edges.clear();
  for(std::size_t h = 0; h < opposite.size(); ++h)
    if(opposite[h] < 0)
      m_edges.push_back({elements[h / 3][h % 3], elements[h / 3][(h + 1) % 3], static_cast<std::int32_t>(h / 3), -1});
  return link(number_of_vertices);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Border_curves::link(std::int32_t number_of_vertices)
{
  std::vector<std::int32_t> leaving(number_of_vertices, -1);
  for(std::size_t i = 0; i < m_edges.size(); ++i) {
    if(leaving[m_edges[i].source] >= 0)
      return false;
    leaving[m_edges[i].source] = static_cast<std::int32_t>(i);
  }
  // As many border edges arrive at a vertex as leave it.
  m_curves.clear();
  for(const Border_edge& first : m_edges)
    if(first.curve < 0) {
      const std::int32_t curve = static_cast<std::int32_t>(m_curves.size());
      m_curves.emplace_back();
      for(std::int32_t i = leaving[first.source]; m_edges[i].curve < 0; i = leaving[m_edges[i].target]) {
        m_edges[i].curve = curve;
        m_curves.back().push_back(i);
      }
    }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Border_curves::are_nested(const Positions<2>& x) const
{
  std::vector<CGAL::Bbox_2> boxes(m_curves.size());
  for(const Border_edge& edge : m_edges)
    boxes[edge.curve] += exact_point(x, edge.source).bbox();
  for(std::size_t c = 0; c < m_curves.size(); ++c) {
    const std::vector<std::int32_t>& curve = m_curves[c];
    const std::size_t n = curve.size();
    std::size_t lowest = 0;
    for(std::size_t i = 1; i < n; ++i)
      if(exact_point(x, m_edges[curve[i]].source) < exact_point(x, m_edges[curve[lowest]].source))
        lowest = i;
    const Exact_kernel::Point_2 p = exact_point(x, m_edges[curve[lowest]].source);
    // At its extreme vertex a simple polygon turns as it does as a whole.
    const bool is_outer = CGAL::orientation(exact_point(x, m_edges[curve[(lowest + n - 1) % n]].source), p,
                                            exact_point(x, m_edges[curve[lowest]].target)) == CGAL::LEFT_TURN;
    int winding = 0;
    for(std::size_t other = 0; other < m_curves.size(); ++other)
      if(other != c && CGAL::do_overlap(boxes[other], p.bbox()))
        winding += winding_number(m_curves[other], x, p);
    if(winding != (is_outer ? 0 : 1))
      return false;
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Border_curves::cross(const Border_edge& a, const Border_edge& b, const Positions<2>& x)
{
  if(a.source == b.target && b.source == a.target)
    return true;
  if(a.target == b.source || a.source == b.target) {
    const Border_edge& first = a.target == b.source ? a : b;
    const Border_edge& second = a.target == b.source ? b : a;
    const Exact_kernel::Point_2 p = exact_point(x, first.source), q = exact_point(x, first.target), r = exact_point(x, second.target);
    return CGAL::collinear(p, q, r) && !CGAL::collinear_are_strictly_ordered_along_line(p, q, r);
  }
  return CGAL::do_intersect(Exact_kernel::Segment_2(exact_point(x, a.source), exact_point(x, a.target)),
                            Exact_kernel::Segment_2(exact_point(x, b.source), exact_point(x, b.target)));
}

CGAL_FLIP_FREE_MAPS_INLINE int Border_curves::winding_number(const std::vector<std::int32_t>& curve, const Positions<2>& x,
                                                             const Exact_kernel::Point_2& p) const
{
  int winding = 0;
  for(const std::int32_t i : curve) {
    const Exact_kernel::Point_2 s = exact_point(x, m_edges[i].source), t = exact_point(x, m_edges[i].target);
    if(s.y() <= p.y() && p.y() < t.y())
      winding += CGAL::orientation(s, t, p) == CGAL::LEFT_TURN ? 1 : 0;
    else if(t.y() <= p.y() && p.y() < s.y())
      winding -= CGAL::orientation(s, t, p) == CGAL::RIGHT_TURN ? 1 : 0;
  }
  return winding;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_IMPL_H
