// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Half the sum of the cross products of a polygon's corners: its normal, as long as its area if it is planar.
Vector<3> area_vector(const Positions<3>& corners);

// Cuts polygons in space, planar or not, convex or not, into triangles by diagonals. Triangles are seen counterclockwise from where
// the polygon is, and as round as can be; where that is impossible, as in polygons that cross themselves, others are made.
class Polygon_triangulator
{
public:
  // `is_undesired(i, j)` tells of a diagonal between two corners that it should be avoided.
  using Is_undesired = std::function<bool(int, int)>;

  // The triangles, n - 2 for n corners, each by the numbers of its corners in ascending order.
  const std::vector<std::array<int, 3>>& triangulate(const Positions<3>& corners, const Is_undesired& is_undesired);

private:
  // The best choice takes the third power of the number of corners as its time: what is tried first, and what is tried last.
  static constexpr int FEW_CORNERS = 64, MOST_CORNERS = 300;
  // Costs; a round triangle has about 3.
  static constexpr double UNDESIRED = 1e8, NOT_POSITIVE = 1e12, TWO_AT_ONE_PLACE = 1e20;

  double cost(int i, int j, int k) const;

  double diagonal_cost(int i, int j) const;

  void add(int i, int j, int k) { m_triangles.push_back({{i, j, k}}); }

  void choose_best(int n);

  // False when the polygon crosses itself as it is seen along its normal.
  bool triangulate_in_plane(const Positions<3>& corners, const Vector<3>& normal);

  void strip(int n);

  const Positions<3>* m_corners = nullptr;
  const Is_undesired* m_is_undesired = nullptr;
  Vector<3> m_normal;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<double> m_costs;
  std::vector<int> m_tips;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_H
