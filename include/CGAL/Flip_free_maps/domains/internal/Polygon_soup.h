// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_SOUP_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_SOUP_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/array_traits.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Polygons as they are given: those of polygon p are the corners from first_corners[p] to before first_corners[p + 1]. A corner
// names the side of its polygon that goes to the next corner, too.
struct Polygon_soup
{
  Positions<3> points; // those that no polygon uses may have any value
  std::vector<std::int32_t> first_corners{0};
  std::vector<std::int32_t> vertices; // by corner
  // Whether the numbers of points are the user's, for messages.
  bool has_point_numbers = true;
  // Whether points at the same place are meant to be different ones.
  bool is_welded = false;

  std::int32_t number_of_polygons() const { return static_cast<std::int32_t>(first_corners.size()) - 1; }
  std::int32_t number_of_corners() const { return static_cast<std::int32_t>(vertices.size()); }
  std::int32_t size(std::int32_t p) const { return first_corners[p + 1] - first_corners[p]; }
  std::int32_t next(std::int32_t p, std::int32_t c) const { return c + 1 == first_corners[p + 1] ? first_corners[p] : c + 1; }
  std::int32_t prev(std::int32_t p, std::int32_t c) const { return c == first_corners[p] ? first_corners[p + 1] - 1 : c - 1; }
};

template <typename Polygon, typename = void>
struct Has_size : std::false_type
{};

template <typename Polygon>
struct Has_size<Polygon, std::void_t<decltype(std::declval<const Polygon&>().size())>> : std::true_type
{};

// Ranges that say nothing of their size are triples.
template <typename Polygon>
std::size_t number_of_corners(const Polygon& polygon)
{
  if constexpr(Has_size<Polygon>::value)
    return static_cast<std::size_t>(polygon.size());
  else
    return 3;
}

// Reads points, whose third coordinate may be missing, and ranges of indices.
template <typename PointRange, typename PolygonRange>
Status read_polygon_soup(const PointRange& points, const PolygonRange& polygons, Polygon_soup& soup, std::string& message)
{
  const std::size_t size = points.size();
  constexpr std::size_t MOST = static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)() / 4);
  for(const auto& polygon : polygons) {
    const std::size_t corners = number_of_corners(polygon);
    if(size > MOST || soup.vertices.size() + corners > MOST || soup.first_corners.size() > MOST) {
      message = "the mesh has more vertices or faces than 32-bit numbers can count";
      return Status::out_of_memory;
    }
    for(std::size_t k = 0; k < corners; ++k) {
      // A negative number becomes a very large one.
      const std::size_t v = static_cast<std::size_t>(polygon[k]);
      if(v >= size) {
        message = "face number " + std::to_string(soup.number_of_polygons()) + " has the vertex " + std::to_string(polygon[k]) +
                  ", but there are " + std::to_string(size) + " points";
        return Status::invalid_option;
      }
      soup.vertices.push_back(static_cast<std::int32_t>(v));
    }
    soup.first_corners.push_back(soup.number_of_corners());
  }
  soup.points.setZero(3, size);
  for(std::size_t v = 0; v < size; ++v) {
    soup.points.col(v) << CGAL::to_double(points[v][0]), CGAL::to_double(points[v][1]), 0;
    if constexpr(!Is_planar_point<std::decay_t<decltype(points[v])>>::value)
      soup.points(2, v) = CGAL::to_double(points[v][2]);
  }
  return Status::success;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_SOUP_H
