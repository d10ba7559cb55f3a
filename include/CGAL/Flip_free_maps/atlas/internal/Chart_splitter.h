// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Splits a connected surface of triangles in two or more parts, of at least two polygons, between these: all triangles of a polygon
// are at the same distance from anything.
class Chart_splitter
{
public:
  // An inner edge that can be cut.
  struct Edge
  {
    std::int32_t vertices[2];
    std::int32_t halfedge; // one of its two
  };

  explicit Chart_splitter(const Linked_triangles& surface);

  // Two triangles that are far from each other.
  std::pair<std::int32_t, std::int32_t> far_apart() const;

  // A triangle that is as far from the given one as can be.
  std::int32_t farthest_from(std::int32_t seed) const;

  // Inner edges that part the surface when it is cut along them, somewhere between the two triangles, which must differ: where
  // the regions that are nearer to either meet, straightened if that is a single line from border to border.
  std::vector<Edge> separate(std::int32_t a, std::int32_t b) const;

  // Edges that part the two triangles of each pair from each other, one pair after the other in the parts that there are by then,
  // but not in more than so many splits.
  std::vector<Edge> separate(const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs, int most_splits);

  // The inner edges of the polygon of a triangle.
  std::vector<Edge> around(std::int32_t e) const;

private:
  static constexpr double CREASE_PREFERENCE = 8;
  // Of a part that is cut off by a straightened line, over that by the line before.
  static constexpr double SMALLEST_PART = 0.3;

  void cut(const std::vector<Edge>& edges, std::vector<char>& is_cut) const;

  // The triangles of the part that one is in when halfedges are cut.
  std::vector<std::int32_t> connected_to(std::int32_t first, const std::vector<char>& is_cut) const;

  // The least area of the parts when a part is cut along some edges.
  double smallest_part(const std::vector<std::int32_t>& part, const std::vector<Edge>& edges) const;

  using Entry = std::pair<double, std::int32_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  // How much harder it is to go across a crease than across a flat edge, so that borders of parts come to lie on creases; or
  // along a flat edge than along a crease.
  double crease_factor(std::int32_t e, std::int32_t f) const
  {
    return 1 + CREASE_PREFERENCE * turning_angle(m_elements[e], m_elements[f], m_points) / CGAL_PI;
  }

  // Lengths of ways over the centres of triangles from the nearest of some; infinite in other parts.
  std::vector<double> distances(const std::vector<std::int32_t>& seeds, std::vector<char>* is_nearer_to_first = nullptr) const;

  // Along inner edges of the triangles that have a distance, some of which lead from one end to the other.
  // Parts that are cut off by a way along the border are parts, too.
  std::vector<Edge> shortest_way(std::int32_t from, std::int32_t to, const std::vector<double>& distances) const;

  double area(std::size_t e) const;

  // The triangle across a halfedge, -1 on the border.
  std::int32_t neighbor(std::int32_t h) const { return m_surface.opposite[h] < 0 || m_is_cut[h] ? -1 : m_surface.opposite[h] / 3; }
  bool is_inner_edge(std::int32_t h) const { return neighbor(h) >= 0 && !m_surface.is_diagonal(h); }
  Edge edge(std::int32_t h) const { return {{m_elements[h / 3][h % 3], m_elements[h / 3][(h + 1) % 3]}, h}; }

  const Linked_triangles& m_surface;
  const std::vector<std::array<std::int32_t, 3>>& m_elements;
  const Positions<3>& m_points;
  std::vector<Vector<3>> m_centers;                        // by triangle, those of their polygons
  std::vector<char> m_is_cut;                              // by halfedge
  mutable std::vector<char> m_is_seen;                     // by triangle, all 0 between searches
  std::vector<std::int32_t> m_first_corner, m_next_corner; // by vertex, and by corner
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SPLITTER_H
