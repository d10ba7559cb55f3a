// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/give_area.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Where a vertex goes: so far, across an edge.
struct Vertex_lift
{
  double height = 0;
  Vector<3> edge = Vector<3>::Zero();
};

CGAL_FLIP_FREE_MAPS_INLINE bool has_area(const Positions<3>& points, const std::array<std::int32_t, 3>& triangle, double least_height)
{
  const Vector<3> a = points.col(triangle[0]), b = points.col(triangle[1]), c = points.col(triangle[2]);
  const double longest = std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double coordinate = (std::max)({a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>()});
  const double least = (std::max)(least_height * longest, 8 * std::numeric_limits<double>::epsilon() * coordinate);
  return Vector<3>(b - a).cross(Vector<3>(c - a)).norm() > least * longest;
}

// Lifts the vertex opposite of the longest edge of a triangle, or all of them, by a height that grows from round to round.
CGAL_FLIP_FREE_MAPS_INLINE void lift_triangle(const std::array<std::int32_t, 3>& t, const Positions<3>& points, int round,
                                              std::vector<Vertex_lift>& lifts)
{
  // Of the distance to the nearer end, of the longest edge, of the coordinate.
  constexpr double SLOPE = 1e-3, LEAST = 1e-7, ROUNDING = 1e4 * std::numeric_limits<double>::epsilon();
  std::array<double, 3> lengths; // of the edges opposite of the corners
  for(int k = 0; k < 3; ++k)
    lengths[k] = (points.col(t[(k + 2) % 3]) - points.col(t[(k + 1) % 3])).norm();
  const int middle = static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const double nearer = (std::min)(lengths[(middle + 1) % 3], lengths[(middle + 2) % 3]);
  const double coordinate = points.col(t[middle]).lpNorm<Eigen::Infinity>();
  const double height = std::ldexp((std::max)({SLOPE * nearer, LEAST * lengths[middle], ROUNDING * coordinate}), 2 * round);
  for(int k = 0; k < 3; ++k)
    if((k == middle || round > 1) && height > lifts[t[k]].height) {
      lifts[t[k]].height = height;
      lifts[t[k]].edge = (points.col(t[(middle + 2) % 3]) - points.col(t[(middle + 1) % 3])).normalized();
    }
}

// Moves, of each triangle without area, the vertex opposite of its longest edge out of the surface, where it changes the other
// triangles least; later all of them, anywhere. True if there still are such triangles.
CGAL_FLIP_FREE_MAPS_INLINE bool move_vertices(const std::vector<std::array<std::int32_t, 3>>& triangles, int round, double least_height,
                                              Positions<3>& points)
{
  std::vector<Vertex_lift> lifts(points.cols());
  std::vector<std::size_t> flat;
  for(std::size_t f = 0; f < triangles.size(); ++f)
    if(!has_area(points, triangles[f], least_height)) {
      flat.push_back(f);
      lift_triangle(triangles[f], points, round, lifts);
    }
  std::vector<Vector<3>> normals(points.cols(), Vector<3>::Zero());
  for(const auto& t : triangles)
    for(const std::int32_t v : t)
      if(lifts[v].height > 0)
        normals[v] += Vector<3>(points.col(t[1]) - points.col(t[0])).cross(Vector<3>(points.col(t[2]) - points.col(t[0])));
  for(Eigen::Index v = 0; v < points.cols(); ++v) {
    if(!(lifts[v].height > 0))
      continue;
    const Vector<3> edge = lifts[v].edge.squaredNorm() > 0 ? lifts[v].edge : Vector<3>(Vector<3>::UnitX());
    Vector<3> across = normals[v].normalized();
    across -= edge * across.dot(edge);
    if(!(across.norm() > 0.1) || round > 1)
      across = edge.unitOrthogonal() + (round % 2) * edge.cross(edge.unitOrthogonal());
    // Of vertices in a row each is moved by another distance.
    const std::uint32_t noise = (static_cast<std::uint32_t>(v) + 1) * 2654435761u + static_cast<std::uint32_t>(round) * 40503u;
    points.col(v) += lifts[v].height * (1 + (noise >> 8) / 16777216.) * across.normalized();
  }
  return std::any_of(flat.begin(), flat.end(), [&](std::size_t f) { return !has_area(points, triangles[f], least_height); });
}

CGAL_FLIP_FREE_MAPS_INLINE bool give_area(const std::vector<std::array<std::int32_t, 3>>& triangles, Positions<3>& points,
                                          double least_height)
{
  constexpr int ROUNDS = 8;
  for(int round = 0; round < ROUNDS; ++round)
    if(!move_vertices(triangles, round, least_height, points))
      return true;
  return false;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_IMPL_H
