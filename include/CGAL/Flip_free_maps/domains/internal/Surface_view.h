// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
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

// Polygons of any kind as triangles that can be mapped, of which each knows its polygon. Nothing is asked of the polygons but finite
// coordinates:
// - points at the same place are one as far as it matters what is joined to what;
// - polygons are joined where one passes an edge in one direction and another in the other one; where more meet, those that are
//   next to each other are. All else is border: between polygons of different windings, or sheets that meet;
// - polygons with less than three places are left out, and what lies on both sides of them is joined;
// - other triangles without area become thin ones: their vertices are moved a little, here only.
class Surface_view
{
public:
  // False, and `message` says why, if there is nothing that can be mapped. If it `is_strict`, polygons that are no triangles, have no
  // area, or cannot all be joined by their indices are refused, too.
  Status load(const Polygon_soup& soup, bool is_strict, std::string& message);

  const Linked_triangles& triangles() const { return m_triangles; }

  // A corner of triangles whose image is that of a corner of a polygon; -1 where no triangle has that place.
  std::int32_t triangle_corner(std::int32_t corner) const { return m_triangle_corners[corner]; }
  // The halfedge that is a side of a polygon; -1 of a side without length or of a polygon that is left out.
  std::int32_t halfedge_of_side(std::int32_t corner) const { return m_halfedges[corner]; }
  // Ascending.
  const std::vector<std::int32_t>& polygons_without_area() const { return m_without_area; }
  // Edges where polygons meet that are not joined.
  std::int64_t number_of_parted_edges() const { return m_parted_edges; }

private:
  // A side that is passed from its lower vertex to the higher one, or backwards.
  struct Side
  {
    std::int32_t high, place; // the vertex; in the rings
    bool is_forward;
  };

  // Of longest edges: the height below which a triangle has no area, and that which it is given at least.
  static constexpr double SMALLEST_HEIGHT = 1e-13, GIVEN_HEIGHT = 1e-7;
  // Of the distance to the nearer end: the height that it is given.
  static constexpr double GIVEN_SLOPE = 1e-3;
  // Radians; nearer than this, polygons at an edge lie upon each other.
  static constexpr double SAME_ANGLE = 1e-6;
  // Sides at an edge: with more it takes too long to compare all pairs.
  static constexpr std::size_t MOST_PAIRS = 100;

  Status fail(Status status, const std::string& text);

  Status check_points();
  void weld_points();
  void make_rings();
  void link_sides();
  void link_bundle(std::vector<Side> sides, std::int32_t low);
  void link_by_indices(std::vector<Side>& sides);
  void link_around(const std::vector<Side>& sides, const std::vector<double>& angles);
  void link_smoothly(const std::vector<Side>& sides, const std::vector<double>& angles);
  bool link(const Side& a, const Side& b);
  void cut_to_triangles();
  void add_triangles(std::int32_t polygon, const std::vector<std::array<int, 3>>& triangles);
  void link_triangles();
  void place_corners();
  bool has_area(std::int32_t triangle) const;
  bool give_area();
  bool move_vertices(int round);
  Status check_strictly();
  Status check_fans();

  std::int32_t polygon_of(std::int32_t place) const { return m_polygon_of[place]; }
  std::int32_t next_place(std::int32_t place) const
  {
    const std::int32_t p = m_polygon_of[place];
    return place + 1 == m_first_places[p + 1] ? m_first_places[p] : place + 1;
  }
  // The welded vertex at a place.
  std::int32_t vertex(std::int32_t place) const { return m_welded[m_soup->vertices[m_ring[place]]]; }
  Vector<3> point(std::int32_t welded) const { return m_triangles.points.col(welded); }
  // Of length 1, or 0 if there is no area.
  Vector<3> normal(std::int32_t polygon) const;
  bool is_edge(std::int32_t v, std::int32_t w) const;

  const Polygon_soup* m_soup = nullptr;
  bool m_is_strict = false;
  std::string* m_message = nullptr;
  Linked_triangles m_triangles;
  std::vector<std::int32_t> m_triangle_corners, m_halfedges; // by corner
  std::vector<std::int32_t> m_without_area;
  std::int64_t m_parted_edges = 0;

  std::vector<std::int32_t> m_welded; // by vertex, the first at the same place
  // Polygons without corners that are at the same place as the one before: their places.
  std::vector<std::int32_t> m_ring;           // by place, the corner
  std::vector<std::int32_t> m_first_places;   // by polygon
  std::vector<std::int32_t> m_polygon_of;     // by place
  std::vector<std::int32_t> m_opposite;       // by place, the side it is joined to or -1
  std::vector<Side> m_sides;                  // sorted by their vertices
  std::vector<std::int32_t> m_first_sides;    // by lower vertex
  std::vector<std::int32_t> m_side_halfedges; // by place
  std::vector<std::int32_t> m_fans;           // by corner of triangles
  std::int32_t m_parted_polygon = -1;         // the first that is parted from another
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Surface_view_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_H
