// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Polygons without corners that are at the same place as the one before: their places.
struct Polygon_rings
{
  const Polygon_soup* soup = nullptr;
  std::vector<std::int32_t> welded;       // by vertex, the first at the same place
  std::vector<std::int32_t> corners;      // by place
  std::vector<std::int32_t> first_places; // by polygon
  std::vector<std::int32_t> polygons;     // by place

  std::int32_t polygon_of(std::int32_t place) const { return polygons[place]; }
  std::int32_t next_place(std::int32_t place) const
  {
    const std::int32_t p = polygons[place];
    return place + 1 == first_places[p + 1] ? first_places[p] : place + 1;
  }
  // The welded vertex at a place.
  std::int32_t vertex(std::int32_t place) const { return welded[soup->vertices[corners[place]]]; }
};

// Joins polygons where one passes an edge in one direction and another in the other one; where more meet, those that are next to each
// other. All else is border: between polygons of different windings, or sheets that meet.
class Side_joiner
{
public:
  // Points are those of welded vertices.
  Side_joiner(const Polygon_rings& rings, const Positions<3>& points) : m_rings(rings), m_points(points) {}

  void join();

  // By place, the side it is joined to or -1.
  const std::vector<std::int32_t>& opposite() const { return m_opposite; }
  bool is_edge(std::int32_t v, std::int32_t w) const;
  // Edges where polygons meet that are not joined, and the first that is parted from another there.
  std::int64_t number_of_parted_edges() const { return m_parted_edges; }
  std::int32_t parted_polygon() const { return m_parted_polygon; }

private:
  // A side that is passed from its lower vertex to the higher one, or backwards.
  struct Side
  {
    std::int32_t high, place; // the vertex; in the rings
    bool is_forward;
  };

  // Radians; nearer than this, polygons at an edge lie upon each other.
  static constexpr double SAME_ANGLE = 1e-6;
  // Sides at an edge: with more it takes too long to compare all pairs.
  static constexpr std::size_t MOST_PAIRS = 100;

  void link_bundle(std::vector<Side> sides, std::int32_t low);
  void link_by_indices(std::vector<Side>& sides);
  void link_around(const std::vector<Side>& sides, const std::vector<double>& angles);
  void link_smoothly(const std::vector<Side>& sides, const std::vector<double>& angles);
  bool link(const Side& a, const Side& b);
  // Of length 1, or 0 if there is no area.
  Vector<3> normal(std::int32_t polygon) const;

  const Polygon_rings& m_rings;
  const Positions<3>& m_points;
  std::vector<std::int32_t> m_opposite;
  std::vector<Side> m_sides;               // sorted by their vertices
  std::vector<std::int32_t> m_first_sides; // by lower vertex
  std::int64_t m_parted_edges = 0;
  std::int32_t m_parted_polygon = -1;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Side_joiner_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_SIDE_JOINER_H
