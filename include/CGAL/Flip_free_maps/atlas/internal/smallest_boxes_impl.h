// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/smallest_boxes.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <CGAL/Min_quadrilateral_traits_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The corners, counterclockwise.
CGAL_FLIP_FREE_MAPS_INLINE std::vector<Exact_kernel::Point_2> hull_corners(const Positions<2>& x)
{
  std::vector<Exact_kernel::Point_2> points, hull;
  points.reserve(x.cols());
  for(Eigen::Index v = 0; v < x.cols(); ++v)
    points.emplace_back(x(0, v), x(1, v));
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  return hull;
}

CGAL_FLIP_FREE_MAPS_INLINE Vector<2> direction_of_smallest_box(const Positions<2>& x)
{
  const std::vector<Exact_kernel::Point_2> hull = hull_corners(x);
  if(hull.size() < 3)
    return Vector<2>(1, 0);
  std::vector<Exact_kernel::Point_2> box;
  CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(box));
  Vector<2> direction(0, 0);
  for(std::size_t k = 0; k + 1 < box.size(); ++k) {
    const Vector<2> side(box[k + 1].x() - box[k].x(), box[k + 1].y() - box[k].y());
    if(side.allFinite() && side.squaredNorm() > direction.squaredNorm())
      direction = side;
  }
  return direction.squaredNorm() > 0 ? direction.normalized() : Vector<2>(1, 0);
}

CGAL_FLIP_FREE_MAPS_INLINE Vector<2> direction_of_smallest_square(const Positions<2>& x)
{
  const std::vector<Exact_kernel::Point_2> hull = hull_corners(x);
  const std::size_t n = hull.size();
  if(n < 3)
    return Vector<2>(1, 0);
  std::vector<Vector<2>> corners;
  for(const Exact_kernel::Point_2& p : hull)
    corners.emplace_back(p.x(), p.y());
  // Angles at which an edge lies on a side of the square, and which repeat after a quarter turn. Between two of them the corners on the
  // sides stay the same, and width and height are concave: the smallest square is at one of them or where width and height are equal.
  const double quarter = CGAL_PI / 2;
  std::vector<double> angles;
  for(std::size_t i = 0; i < n; ++i) {
    const Vector<2> edge = corners[(i + 1) % n] - corners[i];
    const double angle = std::fmod(std::atan2(edge[1], edge[0]) + 4 * quarter, quarter);
    angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + quarter);
  const auto direction = [](double angle) { return Vector<2>(std::cos(angle), std::sin(angle)); };
  std::array<std::size_t, 4> farthest; // in the directions of the square's sides
  farthest.fill(0);
  double best_size = std::numeric_limits<double>::infinity(), best_angle = 0;
  for(std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const double begin = angles[i], end = angles[i + 1];
    for(int k = 0; k < 4; ++k) {
      const Vector<2> side = direction((begin + end) / 2 + k * quarter);
      const auto height = [&](std::size_t corner) { return corners[corner].dot(side); };
      std::size_t& corner = farthest[k];
      if(i == 0)
        for(std::size_t j = 1; j < n; ++j)
          corner = height(j) > height(corner) ? j : corner;
      for(std::size_t steps = 0; steps < n && height((corner + 1) % n) > height(corner); ++steps)
        corner = (corner + 1) % n;
    }
    const Vector<2> across = corners[farthest[0]] - corners[farthest[2]], up = corners[farthest[1]] - corners[farthest[3]];
    const auto consider = [&](double angle) {
      const Vector<2> u = direction(angle);
      const double size = (std::max)(across.dot(u), up[1] * u[0] - up[0] * u[1]);
      if(angle >= begin && angle <= end && size < best_size) {
        best_size = size;
        best_angle = angle;
      }
    };
    consider(begin);
    consider(end);
    const double equal = std::atan2(up[1] - across[0], across[1] + up[0]);
    for(int k = -2; k <= 3; ++k)
      consider(equal + 2 * quarter * k);
  }
  return direction(best_angle);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_IMPL_H
