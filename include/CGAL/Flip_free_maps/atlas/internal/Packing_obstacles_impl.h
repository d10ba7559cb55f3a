// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_figure.h>
#include <CGAL/Flip_free_maps/atlas/internal/Packing_obstacles.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Packing_obstacles::add(const Positions<2>& polygon) { m_polygons.push_back(polygon); }

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> Packing_obstacles::clipped(const Positions<2>& polygon, double low, double high)
{
  std::vector<Vector<2>> corners, kept;
  for(Eigen::Index i = 0; i < polygon.cols(); ++i)
    corners.push_back(polygon.col(i));
  // By one side of the square after the other.
  for(int side = 0; side < 4; ++side) {
    const int c = side / 2;
    const double bound = side % 2 == 0 ? low : high, sign = side % 2 == 0 ? 1 : -1;
    kept.clear();
    for(std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<2>&p = corners[i], &q = corners[i + 1 == corners.size() ? 0 : i + 1];
      const bool is_in = sign * (p[c] - bound) >= 0;
      if(is_in)
        kept.push_back(p);
      if(is_in != (sign * (q[c] - bound) >= 0)) {
        const double t = (bound - p[c]) / (q[c] - p[c]);
        kept.emplace_back(p + t * (q - p));
        kept.back()[c] = bound;
      }
    }
    corners.swap(kept);
  }
  Positions<2> result(2, corners.size());
  for(std::size_t i = 0; i < corners.size(); ++i)
    result.col(i) = corners[i];
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE double Packing_obstacles::area() const
{
  double sum = 0;
  for(const Positions<2>& polygon : m_polygons) {
    const Positions<2> part = clipped(polygon, 0, 1);
    double twice = 0;
    for(Eigen::Index i = 0; i < part.cols(); ++i) {
      const Eigen::Index j = i + 1 == part.cols() ? 0 : i + 1;
      twice += part(0, i) * part(1, j) - part(1, i) * part(0, j);
    }
    sum += std::abs(twice) / 2;
  }
  return sum;
}

CGAL_FLIP_FREE_MAPS_INLINE void Packing_obstacles::take(Cell_grid& grid, const Vector<2>& lower_left, double cells_per_unit,
                                                        double distance) const
{
  // No distance reaches farther than half of the square.
  const double low = -1, high = 2;
  const int most_cells = static_cast<int>(std::ceil((high - low) * cells_per_unit)) + 2;
  for(const Positions<2>& polygon : m_polygons) {
    Chart_outline outline;
    outline.sources = clipped(polygon, low, high);
    const Eigen::Index n = outline.sources.cols();
    if(n == 0)
      continue;
    outline.sources = (cells_per_unit * (outline.sources.colwise() - lower_left)).eval();
    outline.targets.resize(2, n);
    outline.targets << outline.sources.rightCols(n - 1), outline.sources.leftCols(1);
    const Vector<2> first = outline.sources.rowwise().minCoeff().array().floor();
    grid.take(Cell_figure(Cell_mask(outline, most_cells, first)), static_cast<int>(first[0]), static_cast<int>(first[1]), distance);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Packing_obstacles::Square Packing_obstacles::largest_square(double distance) const
{
  if(empty())
    return {Vector<2>(0, 0), 1};
  const int cells = 512;
  const double side = 1 - distance;
  Cell_grid grid(cells);
  take(grid, Vector<2>::Constant(distance / 2), cells / side, distance * cells / side);
  const Cell_grid::Free_square square = grid.largest_free_square();
  if(square.size == 0)
    return {Vector<2>(0, 0), 0};
  return {Vector<2>(square.x, square.y) * (side / cells), square.size * (side / cells) + distance};
}

CGAL_FLIP_FREE_MAPS_INLINE bool Packing_obstacles::are_touched(const std::vector<std::array<std::int32_t, 3>>& triangles,
                                                               const Positions<2>& x) const
{
  using Point = Exact_kernel::Point_2;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  const auto corners = [](const Positions<2>& polygon) {
    std::vector<Point> points;
    for(Eigen::Index i = 0; i < polygon.cols(); ++i)
      points.emplace_back(polygon(0, i), polygon(1, i));
    return points;
  };
  const auto bbox = [](const std::vector<Point>& points) { return CGAL::bbox_2(points.begin(), points.end()); };
  std::vector<Box> ours, theirs;
  for(std::size_t i = 0; i < m_polygons.size(); ++i)
    ours.emplace_back(bbox(corners(m_polygons[i])), i);
  const auto triangle = [&](std::size_t t) {
    Positions<2> corner(2, 3);
    for(int k = 0; k < 3; ++k)
      corner.col(k) = x.col(triangles[t][k]);
    return corners(corner);
  };
  for(std::size_t t = 0; t < triangles.size(); ++t)
    theirs.emplace_back(bbox(triangle(t)), t);
  bool is_any = false;
  CGAL::box_intersection_d(ours.begin(), ours.end(), theirs.begin(), theirs.end(), [&](const Box& a, const Box& b) {
    if(is_any)
      return;
    // Either sides meet, or one is in the other.
    const std::vector<Point> p = corners(m_polygons[a.info()]), q = triangle(b.info());
    const Exact_kernel::Triangle_2 t(q[0], q[1], q[2]);
    for(std::size_t i = 0; i < p.size() && !is_any; ++i) {
      const Point& next = p[(i + 1) % p.size()];
      is_any = p[i] == next ? !t.has_on_unbounded_side(next) : CGAL::do_intersect(t, Exact_kernel::Segment_2(p[i], next));
    }
    is_any = is_any || CGAL::bounded_side_2(p.begin(), p.end(), q[0]) != CGAL::ON_UNBOUNDED_SIDE;
  });
  return is_any;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_IMPL_H
