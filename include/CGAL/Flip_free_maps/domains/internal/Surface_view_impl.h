// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::load(const Polygon_soup& soup, bool is_strict, std::string& message)
{
  m_soup = &soup;
  m_is_strict = is_strict;
  m_message = &message;
  if(soup.number_of_polygons() == 0)
    return fail(Status::empty_mesh, "the mesh has no faces");
  Status status = check_points();
  if(status != Status::success)
    return status;
  weld_points();
  make_rings();
  link_sides();
  status = is_strict ? check_strictly() : Status::success;
  if(status != Status::success)
    return status;
  if(m_ring.empty())
    return fail(Status::degenerate_rest_element, "no face has corners at three different places");
  cut_to_triangles();
  link_triangles();
  status = is_strict ? check_fans() : Status::success;
  if(status != Status::success)
    return status;
  place_corners();
  if(!give_area())
    return Status::degenerate_rest_element;
  std::sort(m_without_area.begin(), m_without_area.end());
  for(auto* used : {&m_welded, &m_ring, &m_first_places, &m_polygon_of, &m_opposite, &m_first_sides, &m_side_halfedges, &m_fans})
    std::vector<std::int32_t>().swap(*used);
  std::vector<Side>().swap(m_sides);
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::fail(Status status, const std::string& text)
{
  *m_message = text;
  return status;
}

// A power of two as the unit of length rounds nothing, and keeps areas within the range of double precision.
CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::check_points()
{
  const Positions<3>& points = m_soup->points;
  const double infinity = std::numeric_limits<double>::infinity();
  Vector<3> low = Vector<3>::Constant(infinity), high = -low;
  m_welded.assign(points.cols(), -1);
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p)
    for(std::int32_t c = m_soup->first_corners[p]; c < m_soup->first_corners[p + 1]; ++c) {
      const std::int32_t v = m_soup->vertices[c];
      if(m_welded[v] >= 0)
        continue;
      m_welded[v] = v;
      if(!points.col(v).allFinite())
        return fail(Status::non_finite_input,
                    "a coordinate of corner " + std::to_string(c - m_soup->first_corners[p]) + " of face number " + std::to_string(p) +
                      (m_soup->has_point_numbers ? ", point number " + std::to_string(v) + "," : std::string()) + " is NaN or infinite");
      low = low.cwiseMin(points.col(v));
      high = high.cwiseMax(points.col(v));
    }
  const double extent = m_soup->vertices.empty() ? 0 : (high / 2 - low / 2).maxCoeff();
  if(!(extent > 0) || !std::isfinite(extent))
    return fail(extent > 0 ? Status::non_finite_input : Status::degenerate_rest_element,
                extent > 0 ? "the extent of the mesh exceeds the range of double precision" : "all vertices of the mesh coincide");
  m_triangles.exponent = std::ilogb(extent);
  m_triangles.points = points.unaryExpr([this](double c) { return std::ldexp(c, -m_triangles.exponent); });
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::weld_points()
{
  if(m_is_strict)
    return;
  const Positions<3>& points = m_soup->points;
  std::vector<std::pair<std::uint64_t, std::int32_t>> order;
  for(std::size_t v = 0; v < m_welded.size(); ++v) {
    if(m_welded[v] < 0)
      continue;
    std::uint64_t hash = 0;
    for(int i = 0; i < 3; ++i) {
      // Adding 0 makes both zeros the same.
      const double c = points(i, v) + 0.;
      std::uint64_t bits;
      std::memcpy(&bits, &c, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    order.emplace_back(hash, static_cast<std::int32_t>(v));
  }
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> different;
  for(std::size_t i = 0; i < order.size(); ++i) {
    if(i == 0 || order[i].first != order[i - 1].first)
      different.clear();
    const std::int32_t v = order[i].second;
    const auto same = std::find_if(different.begin(), different.end(), [&](std::int32_t w) { return points.col(v) == points.col(w); });
    if(same == different.end())
      different.push_back(v);
    else
      m_welded[v] = *same;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::make_rings()
{
  const std::int32_t polygons = m_soup->number_of_polygons();
  m_triangle_corners.assign(m_soup->number_of_corners(), -1);
  m_first_places.assign(1, 0);
  m_ring.reserve(m_soup->number_of_corners());
  m_polygon_of.reserve(m_soup->number_of_corners());
  for(std::int32_t p = 0; p < polygons; ++p) {
    const std::int32_t begin = m_soup->first_corners[p], end = m_soup->first_corners[p + 1], first = m_first_places[p];
    for(std::int32_t c = begin; c < end; ++c)
      if(m_welded[m_soup->vertices[c]] != m_welded[m_soup->vertices[m_soup->prev(p, c)]])
        m_ring.push_back(c);
    // The first two are at different places.
    const bool is_third = std::any_of(m_ring.begin() + first, m_ring.end(), [&](std::int32_t c) {
      const std::int32_t v = m_welded[m_soup->vertices[c]];
      return v != m_welded[m_soup->vertices[m_ring[first]]] && v != m_welded[m_soup->vertices[m_ring[first + 1]]];
    });
    if(!is_third) {
      m_ring.resize(first);
      m_without_area.push_back(p);
    } else {
      // What comes before the first place of the ring is at the last one.
      std::int32_t place = static_cast<std::int32_t>(m_ring.size()) - 1, next = first;
      for(std::int32_t c = begin; c < end; ++c) {
        if(next < static_cast<std::int32_t>(m_ring.size()) && m_ring[next] == c)
          place = next++;
        m_triangle_corners[c] = place;
      }
    }
    m_polygon_of.resize(m_ring.size(), p);
    m_first_places.push_back(static_cast<std::int32_t>(m_ring.size()));
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_sides()
{
  m_opposite.assign(m_ring.size(), -1);
  m_first_sides.assign(m_welded.size() + 1, 0);
  const auto for_each_side = [this](auto&& visit) {
    for(std::size_t s = 0; s < m_ring.size(); ++s) {
      const std::int32_t place = static_cast<std::int32_t>(s), v = vertex(place), w = vertex(next_place(place));
      visit((std::min)(v, w), Side{(std::max)(v, w), place, v < w});
    }
  };
  for_each_side([this](std::int32_t low, const Side&) { ++m_first_sides[low + 1]; });
  std::partial_sum(m_first_sides.begin(), m_first_sides.end(), m_first_sides.begin());
  m_sides.resize(m_ring.size());
  std::vector<std::int32_t> free(m_first_sides.begin(), m_first_sides.end() - 1);
  for_each_side([&](std::int32_t low, const Side& side) { m_sides[free[low]++] = side; });
  for(std::size_t low = 0; low < m_welded.size(); ++low) {
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

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::link(const Side& a, const Side& b)
{
  if(a.is_forward == b.is_forward || polygon_of(a.place) == polygon_of(b.place))
    return false;
  m_opposite[a.place] = b.place;
  m_opposite[b.place] = a.place;
  return true;
}

// Joins sides at an edge where more than two meet, or two that do not fit. Those with the same indices come first, since what is
// written as one surface is meant to be one; then those between which there is no other in the solid that they bound.
CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_bundle(std::vector<Side> sides, std::int32_t low)
{
  link_by_indices(sides);
  if(sides.empty())
    return;
  ++m_parted_edges;
  if(m_parted_polygon < 0)
    m_parted_polygon = polygon_of(sides.back().place);
  // Polygons without area have no place around the edge, and come last.
  const auto first_flat = std::stable_partition(sides.begin(), sides.end(),
                                                [this](const Side& side) { return normal(polygon_of(side.place)).squaredNorm() > 0; });
  const std::vector<Side> flat(first_flat, sides.end()), all = sides;
  sides.erase(first_flat, sides.end());
  const Vector<3> axis = (point(all[0].high) - point(low)).normalized();
  std::vector<Vector<3>> inwards;
  for(const Side& side : sides)
    inwards.push_back(normal(polygon_of(side.place)).cross(side.is_forward ? axis : Vector<3>(-axis)));
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

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_by_indices(std::vector<Side>& sides)
{
  const auto indices = [this](const Side& side) {
    const std::int32_t c = m_ring[next_place(side.place)];
    return std::minmax({m_soup->vertices[m_soup->prev(polygon_of(side.place), c)], m_soup->vertices[c]});
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
CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_around(const std::vector<Side>& sides, const std::vector<double>& angles)
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
      const std::int32_t p = polygon_of(sides[i].place);
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
CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_smoothly(const std::vector<Side>& sides, const std::vector<double>& angles)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for(std::size_t i = 0; i < sides.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const double bend = std::abs(std::abs(angles[i] - angles[j]) - CGAL_PI);
      pairs.emplace_back(std::floor(bend / SAME_ANGLE), j, i);
    }
  const auto polygon = [&](std::size_t i) { return polygon_of(sides[i].place); };
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

CGAL_FLIP_FREE_MAPS_INLINE Vector<3> Surface_view::normal(std::int32_t polygon) const
{
  Positions<3> corners(3, m_first_places[polygon + 1] - m_first_places[polygon]);
  for(std::int32_t s = m_first_places[polygon]; s < m_first_places[polygon + 1]; ++s)
    corners.col(s - m_first_places[polygon]) = point(vertex(s));
  const Vector<3> area = area_vector(corners);
  const Vector<3> size = corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
  return area.norm() > SMALLEST_HEIGHT * size.squaredNorm() ? area.normalized() : Vector<3>(Vector<3>::Zero());
}

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::is_edge(std::int32_t v, std::int32_t w) const
{
  const std::int32_t low = (std::min)(v, w), high = (std::max)(v, w);
  const auto begin = m_sides.begin() + m_first_sides[low], end = m_sides.begin() + m_first_sides[low + 1];
  const auto found = std::lower_bound(begin, end, high, [](const Side& side, std::int32_t value) { return side.high < value; });
  return found != end && found->high == high;
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::cut_to_triangles()
{
  m_side_halfedges.assign(m_ring.size(), -1);
  Polygon_triangulator triangulator;
  Positions<3> corners;
  std::unordered_set<std::uint64_t> diagonals;
  std::int32_t first = 0;
  const auto key = [&](int i, int j) {
    const auto ends = std::minmax({vertex(first + i), vertex(first + j)});
    return static_cast<std::uint64_t>(ends.first) << 32 | static_cast<std::uint64_t>(ends.second);
  };
  // An edge between the ends of another one makes a surface that cannot be flattened in one piece.
  const Polygon_triangulator::Is_undesired is_undesired = [&](int i, int j) {
    const std::int32_t v = vertex(first + i), w = vertex(first + j);
    return v == w || is_edge(v, w) || diagonals.count(key(i, j)) > 0;
  };
  const std::vector<std::array<int, 3>> single{{{0, 1, 2}}};
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p) {
    first = m_first_places[p];
    const std::int32_t n = m_first_places[p + 1] - first;
    if(n < 4) {
      if(n == 3)
        add_triangles(p, single);
      continue;
    }
    corners.resize(3, n);
    for(std::int32_t i = 0; i < n; ++i)
      corners.col(i) = point(vertex(first + i));
    const auto& triangles = triangulator.triangulate(corners, is_undesired);
    add_triangles(p, triangles);
    for(const auto& t : triangles)
      for(int k = 0; k < 3; ++k)
        if((t[k] + 1) % n != t[(k + 1) % 3])
          diagonals.insert(key(t[k], t[(k + 1) % 3]));
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::add_triangles(std::int32_t polygon, const std::vector<std::array<int, 3>>& triangles)
{
  const std::int32_t first = m_first_places[polygon], n = m_first_places[polygon + 1] - first;
  std::vector<std::tuple<int, int, std::int32_t>> diagonals;
  for(const auto& t : triangles) {
    const std::int32_t f = static_cast<std::int32_t>(m_triangles.triangles.size());
    m_triangles.triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
    m_triangles.polygons.push_back(polygon);
    m_triangles.opposite.insert(m_triangles.opposite.end(), 3, -1);
    for(int k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3];
      if((i + 1) % n == j)
        m_side_halfedges[first + i] = 3 * f + k;
      else
        diagonals.emplace_back((std::min)(i, j), (std::max)(i, j), 3 * f + k);
    }
  }
  std::sort(diagonals.begin(), diagonals.end());
  for(std::size_t i = 0; i + 1 < diagonals.size(); i += 2) {
    const std::int32_t h = std::get<2>(diagonals[i]), g = std::get<2>(diagonals[i + 1]);
    m_triangles.opposite[h] = g;
    m_triangles.opposite[g] = h;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_triangles()
{
  for(std::size_t s = 0; s < m_ring.size(); ++s)
    if(m_opposite[s] >= 0)
      m_triangles.opposite[m_side_halfedges[s]] = m_side_halfedges[m_opposite[s]];
  std::vector<std::int32_t> first_corners;
  number_fans(
    m_triangles.opposite, [this](std::int32_t h) { return m_triangles.opposite[h] < 0; }, m_fans, first_corners);
  Positions<3> points(3, first_corners.size());
  for(std::size_t f = 0; f < m_triangles.triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      std::int32_t& v = m_triangles.triangles[f][k];
      const std::int32_t fan = m_fans[3 * f + k];
      points.col(fan) = point(vertex(v));
      v = fan;
    }
  m_triangles.points.swap(points);
}

// From places to corners of triangles. What is left out is put to where something else has the same place on the surface.
CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::place_corners()
{
  m_halfedges.assign(m_triangle_corners.size(), -1);
  std::vector<std::int32_t> corner_at;
  if(!m_without_area.empty()) {
    corner_at.assign(m_welded.size(), -1);
    for(std::size_t s = 0; s < m_ring.size(); ++s)
      corner_at[vertex(static_cast<std::int32_t>(s))] = m_side_halfedges[s];
  }
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p) {
    const std::int32_t first = m_first_places[p], end = m_first_places[p + 1];
    for(std::int32_t c = m_soup->first_corners[p]; c < m_soup->first_corners[p + 1]; ++c) {
      if(first == end) {
        m_triangle_corners[c] = corner_at[m_welded[m_soup->vertices[c]]];
        continue;
      }
      const std::int32_t place = m_triangle_corners[c];
      if(m_ring[place] == c)
        m_halfedges[m_soup->prev(p, c)] = m_side_halfedges[place == first ? end - 1 : place - 1];
    }
    if(first < end)
      for(std::int32_t c = m_soup->first_corners[p]; c < m_soup->first_corners[p + 1]; ++c)
        m_triangle_corners[c] = m_side_halfedges[m_triangle_corners[c]];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::has_area(std::int32_t triangle) const
{
  const auto& t = m_triangles.triangles[triangle];
  const Vector<3> a = m_triangles.points.col(t[0]), b = m_triangles.points.col(t[1]), c = m_triangles.points.col(t[2]);
  if(m_is_strict) {
    Matrix<2> rest_inverse;
    double area;
    return planar_rest_shape(a, b, c, rest_inverse, area);
  }
  const double longest = std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double coordinate = (std::max)({a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>()});
  const double least = (std::max)(SMALLEST_HEIGHT * longest, 8 * std::numeric_limits<double>::epsilon() * coordinate);
  return Vector<3>(b - a).cross(Vector<3>(c - a)).norm() > least * longest;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::give_area()
{
  const std::int32_t size = static_cast<std::int32_t>(m_triangles.triangles.size());
  bool is_without = false, is_any = false;
  for(std::int32_t f = 0; f < size; ++f) {
    const bool is_flat = !has_area(f);
    is_any = is_any || is_flat;
    is_without = is_flat && (is_without || m_triangles.is_first(f));
    if(is_without && (f + 1 == size || m_triangles.is_first(f + 1)))
      m_without_area.push_back(m_triangles.polygons[f]);
    if(is_flat && m_is_strict) {
      *m_message = "zero area, or none within double precision, has face number " + std::to_string(m_triangles.polygons[f]);
      return false;
    }
  }
  constexpr int ROUNDS = 8;
  for(int round = 0; is_any && round < ROUNDS; ++round)
    is_any = move_vertices(round);
  if(is_any)
    *m_message = "some faces have no area, and are at places that cannot be told apart in double precision";
  return !is_any;
}

// Moves, of each triangle without area, the vertex opposite of its longest edge out of the surface, where it changes the other
// triangles least; later all of them, anywhere. True if there still are such triangles.
CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::move_vertices(int round)
{
  Positions<3>& points = m_triangles.points;
  const std::int32_t size = static_cast<std::int32_t>(m_triangles.triangles.size());
  std::vector<double> heights(points.cols(), 0.);
  std::vector<Vector<3>> edges(points.cols(), Vector<3>::Zero());
  std::vector<std::int32_t> flat;
  for(std::int32_t f = 0; f < size; ++f) {
    if(has_area(f))
      continue;
    flat.push_back(f);
    const auto& t = m_triangles.triangles[f];
    std::array<double, 3> lengths; // of the edges opposite of the corners
    for(int k = 0; k < 3; ++k)
      lengths[k] = (points.col(t[(k + 2) % 3]) - points.col(t[(k + 1) % 3])).norm();
    const int middle = static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const double nearer = (std::min)(lengths[(middle + 1) % 3], lengths[(middle + 2) % 3]);
    const double coordinate = points.col(t[middle]).lpNorm<Eigen::Infinity>();
    const double height = std::ldexp(
      (std::max)({GIVEN_SLOPE * nearer, GIVEN_HEIGHT * lengths[middle], 1e4 * std::numeric_limits<double>::epsilon() * coordinate}),
      2 * round);
    for(int k = 0; k < 3; ++k)
      if((k == middle || round > 1) && height > heights[t[k]]) {
        heights[t[k]] = height;
        edges[t[k]] = (points.col(t[(middle + 2) % 3]) - points.col(t[(middle + 1) % 3])).normalized();
      }
  }
  std::vector<Vector<3>> normals(points.cols(), Vector<3>::Zero());
  for(const auto& t : m_triangles.triangles)
    for(const std::int32_t v : t)
      if(heights[v] > 0)
        normals[v] += Vector<3>(points.col(t[1]) - points.col(t[0])).cross(Vector<3>(points.col(t[2]) - points.col(t[0])));
  for(Eigen::Index v = 0; v < points.cols(); ++v) {
    if(!(heights[v] > 0))
      continue;
    Vector<3> across = normals[v].normalized();
    across -= edges[v] * across.dot(edges[v]);
    if(!(across.norm() > 0.1) || round > 1)
      across = edges[v].unitOrthogonal() + (round % 2) * edges[v].cross(edges[v].unitOrthogonal());
    // Of vertices in a row each is moved by another distance.
    const std::uint32_t noise = (static_cast<std::uint32_t>(v) + 1) * 2654435761u + static_cast<std::uint32_t>(round) * 40503u;
    points.col(v) += heights[v] * (1 + (noise >> 8) / 16777216.) * across.normalized();
  }
  return std::any_of(flat.begin(), flat.end(), [this](std::int32_t f) { return !has_area(f); });
}

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::check_strictly()
{
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p)
    if(m_soup->size(p) != 3)
      return fail(Status::not_triangular, "the mesh must consist of triangles; not so face number " + std::to_string(p));
  if(!m_without_area.empty())
    return fail(Status::non_manifold, "a vertex occurs twice in face number " + std::to_string(m_without_area[0]));
  if(m_parted_polygon >= 0)
    return fail(Status::non_manifold,
                "two faces have an edge in the same direction, one of them face number " + std::to_string(m_parted_polygon));
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::check_fans()
{
  std::vector<std::int32_t> fan_of(m_welded.size(), -1);
  for(std::size_t s = 0; s < m_ring.size(); ++s) {
    const std::int32_t v = vertex(static_cast<std::int32_t>(s)), fan = m_fans[m_side_halfedges[s]];
    if(fan_of[v] >= 0 && fan_of[v] != fan)
      return fail(Status::non_manifold, "several sheets of the surface meet at a vertex of face number " +
                                          std::to_string(polygon_of(static_cast<std::int32_t>(s))));
    fan_of[v] = fan;
  }
  return Status::success;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H
