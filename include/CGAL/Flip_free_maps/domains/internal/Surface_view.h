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
#include <CGAL/Flip_free_maps/domains/internal/Polygon_soup.h>
#include <CGAL/Flip_free_maps/domains/internal/Side_joiner.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

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
  // area, or cannot all be joined by their indices are refused, too. Some polygons may be left out: what is next to them is border.
  Status load(const Polygon_soup& soup, bool is_strict, std::string& message, const std::vector<char>& is_left_out = {});

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
  Status fail(Status status, const std::string& text);

  bool is_left_out(std::int32_t polygon) const { return !m_is_left_out.empty() && m_is_left_out[polygon]; }

  Status check_points();
  void make_rings();
  void cut_to_triangles(const Side_joiner& joiner);
  void add_triangles(std::int32_t polygon, const std::vector<std::array<int, 3>>& triangles);
  void link_triangles(const std::vector<std::int32_t>& opposite);
  void place_corners();
  bool is_fit(std::int32_t triangle) const;
  bool give_area();
  Status check_strictly(std::int32_t parted_polygon);
  Status check_fans();

  Vector<3> point(std::int32_t welded) const { return m_triangles.points.col(welded); }
  const Polygon_soup* m_soup = nullptr;
  std::vector<char> m_is_left_out; // by polygon, if any is
  bool m_is_strict = false;
  std::string* m_message = nullptr;
  Linked_triangles m_triangles;
  std::vector<std::int32_t> m_triangle_corners, m_halfedges; // by corner
  std::vector<std::int32_t> m_without_area;
  std::int64_t m_parted_edges = 0;

  Polygon_rings m_rings;
  std::vector<std::int32_t> m_side_halfedges; // by place
  std::vector<std::int32_t> m_fans;           // by corner of triangles
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Surface_view_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SURFACE_VIEW_H
