// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LINKED_TRIANGLES_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LINKED_TRIANGLES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The halfedges before and after one in its triangle: halfedge 3 f + k goes from corner k of triangle f to the next corner, so it
// names the corner, too.
inline std::int32_t next_in_triangle(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline std::int32_t prev_in_triangle(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

// Triangles that are joined along sides of opposite directions, whatever their vertices: two may have several edges in common, and
// different edges the same ends.
struct Linked_triangles
{
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> opposite; // by halfedge, -1 on borders
  std::vector<std::int32_t> polygons; // by triangle, ascending: what polygon of the user's it is a part of
  Positions<3> points;                // those of vertices, in units of 2^exponent of the user's
  int exponent = 0;

  // Whether a halfedge lies within a polygon.
  bool is_diagonal(std::int32_t h) const { return opposite[h] >= 0 && polygons[h / 3] == polygons[opposite[h] / 3]; }
  // Whether a triangle is the first of its polygon, so that polygons can be counted.
  bool is_first(std::int32_t f) const { return f == 0 || polygons[f - 1] != polygons[f]; }

  double area() const
  {
    double sum = 0;
    for(const auto& t : triangles)
      sum += 0.5 * Vector<3>(points.col(t[1]) - points.col(t[0])).cross(Vector<3>(points.col(t[2]) - points.col(t[0]))).norm();
    return sum;
  }
};

// Numbers the fans of corners that are joined around their vertices; `is_border(h)` says which halfedges end them. `first_corners`
// receives a corner of each fan from which `opposite[prev_in_triangle(corner)]` leads to all of it.
template <typename IsBorder>
void number_fans(const std::vector<std::int32_t>& opposite, const IsBorder& is_border, std::vector<std::int32_t>& fans,
                 std::vector<std::int32_t>& first_corners)
{
  fans.assign(opposite.size(), -1);
  first_corners.clear();
  for(std::int32_t start = 0; start < static_cast<std::int32_t>(fans.size()); ++start) {
    if(fans[start] >= 0)
      continue;
    std::int32_t first = start;
    while(!is_border(first)) {
      first = next_in_triangle(opposite[first]);
      if(first == start)
        break;
    }
    std::int32_t corner = first;
    do {
      fans[corner] = static_cast<std::int32_t>(first_corners.size());
      const std::int32_t h = prev_in_triangle(corner);
      corner = is_border(h) ? -1 : opposite[h];
    } while(corner >= 0 && corner != first);
    first_corners.push_back(first);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LINKED_TRIANGLES_H
