// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/domains/internal/Side_joiner.h>
#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>
#include <CGAL/Flip_free_maps/domains/internal/give_area.h>
#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::load(const Polygon_soup& soup, bool is_strict, std::string& message,
                                                     const std::vector<char>& is_left_out)
{
  m_is_left_out = is_left_out;
  m_rings = Polygon_rings();
  m_soup = m_rings.soup = &soup;
  m_is_strict = is_strict;
  m_message = &message;
  if(soup.number_of_polygons() == 0)
    return fail(Status::empty_mesh, "the mesh has no faces");
  Status status = check_points();
  if(status != Status::success)
    return status;
  if(!is_strict)
    weld_points(soup.points, m_rings.welded);
  make_rings();
  Side_joiner joiner(m_rings, m_triangles.points);
  joiner.join();
  m_parted_edges = joiner.number_of_parted_edges();
  status = is_strict ? check_strictly(joiner.parted_polygon()) : Status::success;
  if(status != Status::success)
    return status;
  if(m_rings.corners.empty())
    return fail(Status::degenerate_rest_element, "no face has corners at three different places");
  cut_to_triangles(joiner);
  link_triangles(joiner.opposite());
  // What is left out may have joined what meets at a vertex.
  status = is_strict && is_left_out.empty() ? check_fans() : Status::success;
  if(status != Status::success)
    return status;
  place_corners();
  if(!give_area())
    return Status::degenerate_rest_element;
  std::sort(m_without_area.begin(), m_without_area.end());
  m_rings = Polygon_rings();
  for(auto* used : {&m_side_halfedges, &m_fans})
    std::vector<std::int32_t>().swap(*used);
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
  m_rings.welded.assign(points.cols(), -1);
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p)
    for(std::int32_t c = m_soup->first_corners[p]; !is_left_out(p) && c < m_soup->first_corners[p + 1]; ++c) {
      const std::int32_t v = m_soup->vertices[c];
      if(m_rings.welded[v] >= 0)
        continue;
      m_rings.welded[v] = v;
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

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::make_rings()
{
  const std::int32_t polygons = m_soup->number_of_polygons();
  m_triangle_corners.assign(m_soup->number_of_corners(), -1);
  m_rings.first_places.assign(1, 0);
  m_rings.corners.reserve(m_soup->number_of_corners());
  m_rings.polygons.reserve(m_soup->number_of_corners());
  for(std::int32_t p = 0; p < polygons; ++p) {
    const std::int32_t begin = m_soup->first_corners[p], end = m_soup->first_corners[p + 1], first = m_rings.first_places[p];
    if(is_left_out(p)) {
      m_rings.first_places.push_back(first);
      continue;
    }
    for(std::int32_t c = begin; c < end; ++c)
      if(m_rings.welded[m_soup->vertices[c]] != m_rings.welded[m_soup->vertices[m_soup->prev(p, c)]])
        m_rings.corners.push_back(c);
    // The first two are at different places.
    const bool is_third = std::any_of(m_rings.corners.begin() + first, m_rings.corners.end(), [&](std::int32_t c) {
      const std::int32_t v = m_rings.welded[m_soup->vertices[c]];
      return v != m_rings.welded[m_soup->vertices[m_rings.corners[first]]] &&
             v != m_rings.welded[m_soup->vertices[m_rings.corners[first + 1]]];
    });
    if(!is_third) {
      m_rings.corners.resize(first);
      m_without_area.push_back(p);
    } else {
      // What comes before the first place of the ring is at the last one.
      std::int32_t place = static_cast<std::int32_t>(m_rings.corners.size()) - 1, next = first;
      for(std::int32_t c = begin; c < end; ++c) {
        if(next < static_cast<std::int32_t>(m_rings.corners.size()) && m_rings.corners[next] == c)
          place = next++;
        m_triangle_corners[c] = place;
      }
    }
    m_rings.polygons.resize(m_rings.corners.size(), p);
    m_rings.first_places.push_back(static_cast<std::int32_t>(m_rings.corners.size()));
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::cut_to_triangles(const Side_joiner& joiner)
{
  m_side_halfedges.assign(m_rings.corners.size(), -1);
  Polygon_triangulator triangulator;
  Positions<3> corners;
  std::unordered_set<std::uint64_t> diagonals;
  std::int32_t first = 0;
  const auto key = [&](int i, int j) {
    const auto ends = std::minmax({m_rings.vertex(first + i), m_rings.vertex(first + j)});
    return static_cast<std::uint64_t>(ends.first) << 32 | static_cast<std::uint64_t>(ends.second);
  };
  // An edge between the ends of another one makes a surface that cannot be flattened in one piece.
  const Polygon_triangulator::Is_undesired is_undesired = [&](int i, int j) {
    const std::int32_t v = m_rings.vertex(first + i), w = m_rings.vertex(first + j);
    return v == w || joiner.is_edge(v, w) || diagonals.count(key(i, j)) > 0;
  };
  const std::vector<std::array<int, 3>> single{{{0, 1, 2}}};
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p) {
    first = m_rings.first_places[p];
    const std::int32_t n = m_rings.first_places[p + 1] - first;
    if(n < 4) {
      if(n == 3)
        add_triangles(p, single);
      continue;
    }
    corners.resize(3, n);
    for(std::int32_t i = 0; i < n; ++i)
      corners.col(i) = point(m_rings.vertex(first + i));
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
  const std::int32_t first = m_rings.first_places[polygon], n = m_rings.first_places[polygon + 1] - first;
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

CGAL_FLIP_FREE_MAPS_INLINE void Surface_view::link_triangles(const std::vector<std::int32_t>& opposite)
{
  for(std::size_t s = 0; s < m_rings.corners.size(); ++s)
    if(opposite[s] >= 0)
      m_triangles.opposite[m_side_halfedges[s]] = m_side_halfedges[opposite[s]];
  std::vector<std::int32_t> first_corners;
  number_fans(
    m_triangles.opposite, [this](std::int32_t h) { return m_triangles.opposite[h] < 0; }, m_fans, first_corners);
  Positions<3> points(3, first_corners.size());
  for(std::size_t f = 0; f < m_triangles.triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      std::int32_t& v = m_triangles.triangles[f][k];
      const std::int32_t fan = m_fans[3 * f + k];
      points.col(fan) = point(m_rings.vertex(v));
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
    corner_at.assign(m_rings.welded.size(), -1);
    for(std::size_t s = 0; s < m_rings.corners.size(); ++s)
      corner_at[m_rings.vertex(static_cast<std::int32_t>(s))] = m_side_halfedges[s];
  }
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p) {
    const std::int32_t first = m_rings.first_places[p], end = m_rings.first_places[p + 1];
    for(std::int32_t c = m_soup->first_corners[p]; c < m_soup->first_corners[p + 1]; ++c) {
      if(is_left_out(p))
        continue;
      if(first == end) {
        m_triangle_corners[c] = corner_at[m_rings.welded[m_soup->vertices[c]]];
        continue;
      }
      const std::int32_t place = m_triangle_corners[c];
      if(m_rings.corners[place] == c)
        m_halfedges[m_soup->prev(p, c)] = m_side_halfedges[place == first ? end - 1 : place - 1];
    }
    if(first < end)
      for(std::int32_t c = m_soup->first_corners[p]; c < m_soup->first_corners[p + 1]; ++c)
        m_triangle_corners[c] = m_side_halfedges[m_triangle_corners[c]];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::is_fit(std::int32_t triangle) const
{
  const auto& t = m_triangles.triangles[triangle];
  const Positions<3>& points = m_triangles.points;
  if(!m_is_strict)
    return has_area(points, t);
  Matrix<2> rest_inverse;
  double area;
  return planar_rest_shape(points.col(t[0]), points.col(t[1]), points.col(t[2]), rest_inverse, area);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Surface_view::give_area()
{
  const std::int32_t size = static_cast<std::int32_t>(m_triangles.triangles.size());
  bool is_without = false, is_any = false;
  for(std::int32_t f = 0; f < size; ++f) {
    const bool is_flat = !is_fit(f);
    is_any = is_any || is_flat;
    is_without = is_flat && (is_without || m_triangles.is_first(f));
    if(is_without && (f + 1 == size || m_triangles.is_first(f + 1)))
      m_without_area.push_back(m_triangles.polygons[f]);
    if(is_flat && m_is_strict) {
      *m_message = "zero area, or none within double precision, has face number " + std::to_string(m_triangles.polygons[f]);
      return false;
    }
  }
  if(!is_any || internal::give_area(m_triangles.triangles, m_triangles.points))
    return true;
  *m_message = NO_PLACES_FOR_AREA;
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::check_strictly(std::int32_t parted_polygon)
{
  for(std::int32_t p = 0; p < m_soup->number_of_polygons(); ++p)
    if(m_soup->size(p) != 3)
      return fail(Status::not_triangular, "the mesh must consist of triangles; not so face number " + std::to_string(p));
  if(!m_without_area.empty())
    return fail(Status::non_manifold, "a vertex occurs twice in face number " + std::to_string(m_without_area[0]));
  if(parted_polygon >= 0)
    return fail(Status::non_manifold,
                "two faces have an edge in the same direction, one of them face number " + std::to_string(parted_polygon));
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Surface_view::check_fans()
{
  std::vector<std::int32_t> fan_of(m_rings.welded.size(), -1);
  for(std::size_t s = 0; s < m_rings.corners.size(); ++s) {
    const std::int32_t v = m_rings.vertex(static_cast<std::int32_t>(s)), fan = m_fans[m_side_halfedges[s]];
    if(fan_of[v] >= 0 && fan_of[v] != fan)
      return fail(Status::non_manifold, "several sheets of the surface meet at a vertex of face number " +
                                          std::to_string(m_rings.polygon_of(static_cast<std::int32_t>(s))));
    fan_of[v] = fan;
  }
  return Status::success;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_IMPL_H
