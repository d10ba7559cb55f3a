// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/domains/internal/Side_joiner.h>
#include <CGAL/Flip_free_maps/domains/internal/give_area.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Side_joiner::join()
{
  m_opposite.assign(m_rings.corners.size(), -1);
  m_first_sides.assign(m_rings.welded.size() + 1, 0);
  const auto for_each_side = [this](auto&& visit) {
    for(std::size_t s = 0; s < m_rings.corners.size(); ++s) {
      const std::int32_t place = static_cast<std::int32_t>(s), v = m_rings.vertex(place), w = m_rings.vertex(m_rings.next_place(place));
      visit((std::min)(v, w), Side{(std::max)(v, w), place, v < w});
    }
  };
  for_each_side([this](std::int32_t low, const Side&) { ++m_first_sides[low + 1]; });
  std::partial_sum(m_first_sides.begin(), m_first_sides.end(), m_first_sides.begin());
  m_sides.resize(m_rings.corners.size());
  std::vector<std::int32_t> free(m_first_sides.begin(), m_first_sides.end() - 1);
  for_each_side([&](std::int32_t low, const Side& side) { m_sides[free[low]++] = side; });
  for(std::size_t low = 0; low < m_rings.welded.size(); ++low) {
    const auto begin = m_sides.begin() + m_first_sides[low], end = m_sides.begin() + m_first_sides[low + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) { return std::tie(a.high, a.place) < std::tie(b.high, b.place); });
    for(auto first = begin; first != end;) {
      const auto last = std::find_if(first, end, [&](const Side& side) { return side.high != first->high; });
      if(last - first > 2 || (last - first == 2 && !link(first[0], first[1])))
        link_bundle(std::vector<Side>(first, last), static_cast<std::int32_t>(low));
      first = last;
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Side_joiner::link(const Side& a, const Side& b)
{
  if(a.is_forward == b.is_forward || m_rings.polygon_of(a.place) == m_rings.polygon_of(b.place))
    return false;
  m_opposite[a.place] = b.place;
  m_opposite[b.place] = a.place;
  return true;
}

// Joins sides at an edge where more than two meet, or two that do not fit. Those with the same indices come first, since what is
// written as one surface is meant to be one; then those between which there is no other in the solid that they bound.
CGAL_FLIP_FREE_MAPS_INLINE void Side_joiner::link_bundle(std::vector<Side> sides, std::int32_t low)
{
  link_by_indices(sides);
  if(sides.empty())
    return;
  ++m_parted_edges;
  if(m_parted_polygon < 0)
    m_parted_polygon = m_rings.polygon_of(sides.back().place);
  // Polygons without area have no place around the edge, and come last.
  const auto first_flat = std::stable_partition(
    sides.begin(), sides.end(), [this](const Side& side) { return normal(m_rings.polygon_of(side.place)).squaredNorm() > 0; });
  const std::vector<Side> flat(first_flat, sides.end()), all = sides;
  sides.erase(first_flat, sides.end());
  const Vector<3> axis = (m_points.col(all[0].high) - m_points.col(low)).normalized();
  std::vector<Vector<3>> inwards;
  for(const Side& side : sides)
    inwards.push_back(normal(m_rings.polygon_of(side.place)).cross(side.is_forward ? axis : Vector<3>(-axis)));
  // Seen along the axis; what is less than nothing by rounding is nothing.
  const Vector<3> x = inwards.empty() ? axis.unitOrthogonal() : inwards[0].normalized(), y = axis.cross(x);
  std::vector<double> angles;
  for(const Vector<3>& direction : inwards) {
    const double angle = std::atan2(direction.dot(y), direction.dot(x));
    angles.push_back(angle < -SAME_ANGLE ? angle + 2 * CGAL_PI : (std::max)(angle, 0.));
  }
  const auto forward = std::count_if(sides.begin(), sides.end(), [](const Side& side) { return side.is_forward; });
  if(2 * static_cast<std::size_t>(forward) == sides.size() || sides.size() > MOST_PAIRS)
    link_around(sides, angles);
  else
    link_smoothly(sides, angles);
  for(const Side& side : flat)
    for(std::size_t i = 0; i < (std::min)(all.size(), MOST_PAIRS); ++i)
      if(m_opposite[side.place] < 0 && m_opposite[all[i].place] < 0)
        link(side, all[i]);
}

CGAL_FLIP_FREE_MAPS_INLINE void Side_joiner::link_by_indices(std::vector<Side>& sides)
{
  const auto indices = [this](const Side& side) {
    const std::int32_t c = m_rings.corners[m_rings.next_place(side.place)];
    return std::minmax({m_rings.soup->vertices[m_rings.soup->prev(m_rings.polygon_of(side.place), c)], m_rings.soup->vertices[c]});
  };
  std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return indices(a) < indices(b); });
  std::vector<Side> others;
  for(auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const Side& side) { return indices(side) != indices(*first); });
    if(last - first != 2 || !link(first[0], first[1]))
      others.insert(others.end(), first, last);
    first = last;
  }
  sides.swap(others);
}

// Forward sides have what they bound at smaller angles, the others at larger ones; so they are paired as parentheses are, around the
// edge. Polygons that lie upon each other are the two sides of a sheet, which is not what is between them.
CGAL_FLIP_FREE_MAPS_INLINE void Side_joiner::link_around(const std::vector<Side>& sides, const std::vector<double>& angles)
{
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return std::tie(angles[a], a) < std::tie(angles[b], b); });
  std::vector<double> snapped(sides.size());
  for(std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && angles[order[i]] - snapped[order[i - 1]] <= SAME_ANGLE;
    snapped[order[i]] = is_same ? snapped[order[i - 1]] : angles[order[i]];
  }
  // Of equal polygons the first is always the one that is met first.
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) {
      const std::int32_t p = m_rings.polygon_of(sides[i].place);
      return std::make_tuple(snapped[i], sides[i].is_forward ? 0 : 1, sides[i].is_forward ? p : -p);
    };
    return key(a) < key(b);
  });
  std::vector<std::size_t> open;
  for(int turn = 0; turn < 2; ++turn)
    for(const std::size_t i : order) {
      if(m_opposite[sides[i].place] >= 0)
        continue;
      if(!sides[i].is_forward) {
        if(turn == 0)
          open.push_back(i);
      } else if(!open.empty() && link(sides[open.back()], sides[i])) {
        open.pop_back();
      }
    }
}

// The flattest pairs first.
CGAL_FLIP_FREE_MAPS_INLINE void Side_joiner::link_smoothly(const std::vector<Side>& sides, const std::vector<double>& angles)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for(std::size_t i = 0; i < sides.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const double bend = std::abs(std::abs(angles[i] - angles[j]) - CGAL_PI);
      pairs.emplace_back(std::floor(bend / SAME_ANGLE), j, i);
    }
  const auto polygon = [&](std::size_t i) { return m_rings.polygon_of(sides[i].place); };
  std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    const auto key = [&](const auto& pair) {
      const std::int32_t p = polygon(std::get<1>(pair)), q = polygon(std::get<2>(pair));
      return std::make_tuple(std::get<0>(pair), (std::min)(p, q), (std::max)(p, q));
    };
    return key(a) < key(b);
  });
  for(const auto& pair : pairs)
    if(m_opposite[sides[std::get<1>(pair)].place] < 0 && m_opposite[sides[std::get<2>(pair)].place] < 0)
      link(sides[std::get<1>(pair)], sides[std::get<2>(pair)]);
}

CGAL_FLIP_FREE_MAPS_INLINE Vector<3> Side_joiner::normal(std::int32_t polygon) const
{
  Positions<3> corners(3, m_rings.first_places[polygon + 1] - m_rings.first_places[polygon]);
  for(std::int32_t s = m_rings.first_places[polygon]; s < m_rings.first_places[polygon + 1]; ++s)
    corners.col(s - m_rings.first_places[polygon]) = m_points.col(m_rings.vertex(s));
  const Vector<3> area = area_vector(corners);
  const Vector<3> size = corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
  return area.norm() > LEAST_HEIGHT * size.squaredNorm() ? area.normalized() : Vector<3>(Vector<3>::Zero());
}

CGAL_FLIP_FREE_MAPS_INLINE bool Side_joiner::is_edge(std::int32_t v, std::int32_t w) const
{
  const std::int32_t low = (std::min)(v, w), high = (std::max)(v, w);
  const auto begin = m_sides.begin() + m_first_sides[low], end = m_sides.begin() + m_first_sides[low + 1];
  const auto found = std::lower_bound(begin, end, high, [](const Side& side, std::int32_t value) { return side.high < value; });
  return found != end && found->high == high;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_IMPL_H
