// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_VERTEX_PLACEMENT_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_VERTEX_PLACEMENT_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/initializers/internal/Progressive_disk.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Vertex_relaxation.h>

#include <CGAL/enum.h>

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

// Places the vertices of a progressive disk in its planar map: first somewhere in the kernel of the ring of neighbours, then
// where the energy of the triangles around is least.
template <typename Kernel, typename Energy>
class Vertex_placement
{
public:
  Vertex_placement(const Progressive_disk& disk, const Energy& energy, Positions<2>& x) : m_disk(disk), m_x(x), m_relaxation(energy) {}

  // Puts a vertex where its triangles are positive, and their energy is least after up to `steps` Newton steps; false when exact
  // predicates find no positive place.
  bool place(std::int32_t v, int steps)
  {
    load(v);
    Vector<2> origin, centre;
    if(!load_rest_shapes(v)) {
      if(!kernel_centre(v, centre))
        return false;
      m_x.col(v) = centre;
      return true;
    }
    origin = m_disk.is_on_border(v) ? mean_apex() : harmonic_mean();
    const bool is_guessed = is_positive(origin);
    if(!is_guessed && !kernel_centre(v, origin))
      return false;
    enter_elements(origin);
    Vector<2> u = Vector<2>::Zero();
    // Such a guess may be close to the border of the kernel.
    if(is_guessed && !(m_relaxation.energy_at(u) <= LARGEST_GUESS * m_area) && kernel_centre(v, centre) &&
       !(m_relaxation.energy_at(u) <= m_relaxation.energy_at(centre - origin)))
      u = centre - origin;
    relax_elements(v, origin, u, steps);
    return true;
  }

  // Up to `steps` Newton steps on the position of a vertex whose triangles are all positive.
  void relax(std::int32_t v, int steps)
  {
    load(v);
    // A degenerate triangle of a simplified surface has no rest shape to be true to.
    if(load_rest_shapes(v)) {
      enter_elements(m_x.col(v));
      relax_elements(v, m_x.col(v), Vector<2>::Zero(), steps);
    }
  }

  // Relaxes, by one Newton step in each sweep, the vertices of triangles whose symmetric Dirichlet energy exceeds a bound.
  void relax_distorted(double bound, int sweeps)
  {
    std::vector<char> is_distorted(m_disk.points().cols());
    for(int sweep = 0; sweep < sweeps; ++sweep) {
      std::fill(is_distorted.begin(), is_distorted.end(), 0);
      for(std::int32_t t = 0; t < m_disk.number_of_all_triangles(); ++t) {
        const auto& triangle = m_disk.triangle(t);
        if(m_disk.is_triangle_awake(t) && !(distortion(triangle) <= bound))
          for(std::int32_t v : triangle)
            is_distorted[v] = 1;
      }
      for(std::size_t v = 0; v < is_distorted.size(); ++v) {
        ask_deadline_sometimes(v);
        if(is_distorted[v])
          relax(static_cast<std::int32_t>(v), 1);
      }
    }
  }

private:
  // The symmetric Dirichlet energy of a triangle, 1 where it has no rest shape.
  double distortion(const std::array<std::int32_t, 3>& triangle) const
  {
    const Positions<3>& points = m_disk.points();
    const Vector<3> a = points.col(triangle[1]) - points.col(triangle[0]), b = points.col(triangle[2]) - points.col(triangle[0]);
    const double squared_a = a.squaredNorm(), squared_b = b.squaredNorm(), squared_cross = a.cross(b).squaredNorm();
    if(!has_area(squared_cross, squared_a * squared_b))
      return 1;
    const Vector<2> p = m_x.col(triangle[1]) - m_x.col(triangle[0]), q = m_x.col(triangle[2]) - m_x.col(triangle[0]);
    const double cross = p[0] * q[1] - p[1] * q[0];
    // |J|^2 (1 + 1 / det(J)^2) / 4
    return 0.25 * (squared_b * p.squaredNorm() - 2 * a.dot(b) * p.dot(q) + squared_a * q.squaredNorm()) *
           (1 / squared_cross + 1 / (cross * cross));
  }

  // Mean energy up to which a guess is taken without further thought.
  static constexpr double LARGEST_GUESS = 1.5;

  // A triangle (v, a, b).
  struct Corner
  {
    Vector<2> a, b;
    std::int32_t number_a, number_b;
    // Of the edges from v to a and b in the rest shape:
    double squared_a, squared_b, dot, cross;
  };

  void load(std::int32_t v)
  {
    m_corners.clear();
    for(std::int32_t t : m_disk.star(v)) {
      const auto& triangle = m_disk.triangle(t);
      const int k = triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
      const std::int32_t a = triangle[(k + 1) % 3], b = triangle[(k + 2) % 3];
      m_corners.push_back({m_x.col(a), m_x.col(b), a, b, 0, 0, 0, 0});
    }
  }

  // False where a triangle is degenerate.
  bool load_rest_shapes(std::int32_t v)
  {
    const Positions<3>& points = m_disk.points();
    const Vector<3> p = points.col(v);
    for(Corner& corner : m_corners) {
      const Vector<3> a = points.col(corner.number_a) - p, b = points.col(corner.number_b) - p;
      corner.squared_a = a.squaredNorm();
      corner.squared_b = b.squaredNorm();
      corner.dot = a.dot(b);
      const double squared_cross = a.cross(b).squaredNorm();
      if(!has_area(squared_cross, corner.squared_a * corner.squared_b))
        return false;
      corner.cross = std::sqrt(squared_cross);
    }
    return true;
  }

  // Whether the area of a triangle is more than rounding.
  static bool has_area(double squared_cross, double squared_lengths)
  {
    constexpr double ROUNDING = 4 * std::numeric_limits<double>::epsilon();
    return squared_cross > ROUNDING * ROUNDING * squared_lengths && squared_cross > (std::numeric_limits<double>::min)();
  }

  // Where the Dirichlet energy of the triangles is least: exact wherever the map is affine.
  Vector<2> harmonic_mean() const
  {
    Vector<2> sum = Vector<2>::Zero();
    double weights = 0;
    for(const Corner& corner : m_corners) {
      const double weight_a = (corner.squared_b - corner.dot) / corner.cross, weight_b = (corner.squared_a - corner.dot) / corner.cross;
      sum += weight_a * corner.a + weight_b * corner.b;
      weights += weight_a + weight_b;
    }
    return sum / weights;
  }

  // The mean of where each triangle would have its vertex as an isometric image.
  Vector<2> mean_apex() const
  {
    Vector<2> sum = Vector<2>::Zero();
    for(const Corner& corner : m_corners) {
      const double squared_side = corner.squared_a - 2 * corner.dot + corner.squared_b;
      const Vector<2> side = corner.b - corner.a, normal(-side[1], side[0]);
      sum += corner.a + (corner.squared_a - corner.dot) / squared_side * side +
             corner.cross / std::sqrt(squared_side * side.squaredNorm()) * normal;
    }
    return sum / static_cast<double>(m_corners.size());
  }

  // A point in the kernel of the ring; false when exact predicates find it outside.
  bool kernel_centre(std::int32_t v, Vector<2>& centre)
  {
    Vector<2> low = m_corners.front().a, high = low;
    for(const Corner& corner : m_corners)
      for(const Vector<2>& p : {corner.a, corner.b}) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    // The kernel of a border vertex' ring is open to the outside; the rest shape tells how far to look.
    if(m_disk.is_on_border(v)) {
      double reach = 0;
      for(const Corner& corner : m_corners)
        reach = (std::max)({reach, (m_disk.points().col(corner.number_a) - m_disk.points().col(v)).norm(),
                            (m_disk.points().col(corner.number_b) - m_disk.points().col(v)).norm()});
      low.array() -= reach;
      high.array() += reach;
    }
    m_polygon = {low, Vector<2>(high[0], low[1]), high, Vector<2>(low[0], high[1])};
    for(const Corner& corner : m_corners)
      clip(corner);
    if(m_polygon.size() < 3)
      return false;
    centre.setZero();
    for(const Vector<2>& p : m_polygon)
      centre += p;
    centre /= static_cast<double>(m_polygon.size());
    return is_positive(centre);
  }

  void enter_elements(const Vector<2>& origin)
  {
    m_relaxation.clear();
    m_area = 0;
    for(const Corner& corner : m_corners) {
      const double length = std::sqrt(corner.squared_a);
      Matrix<2> rest_inverse, edges;
      rest_inverse << 1 / length, -corner.dot / (length * corner.cross), 0, length / corner.cross;
      edges << corner.a - origin, corner.b - origin;
      m_relaxation.add(edges * rest_inverse, -rest_inverse.colwise().sum().transpose(), 0.5 * corner.cross);
      m_area += 0.5 * corner.cross;
    }
  }

  void relax_elements(std::int32_t v, const Vector<2>& origin, Vector<2> u, int steps)
  {
    m_relaxation.relax(u, steps, [&](const Vector<2>& displacement) { return is_positive(origin + displacement); });
    m_x.col(v) = origin + u;
  }

  bool is_positive(const Vector<2>& p) const
  {
    using Point_2 = typename Kernel::Point_2;
    const Point_2 q(p[0], p[1]);
    for(const Corner& corner : m_corners)
      if(typename Kernel::Orientation_2()(q, Point_2(corner.a[0], corner.a[1]), Point_2(corner.b[0], corner.b[1])) != CGAL::POSITIVE)
        return false;
    return true;
  }

  // Keeps the part of the polygon to the left of a -> b (Sutherland and Hodgman 1974).
  void clip(const Corner& corner)
  {
    const Vector<2> side = corner.b - corner.a;
    const auto height = [&](const Vector<2>& p) { return side[0] * (p[1] - corner.a[1]) - side[1] * (p[0] - corner.a[0]); };
    m_clipped.clear();
    for(std::size_t i = 0; i < m_polygon.size(); ++i) {
      const Vector<2>& p = m_polygon[i];
      const Vector<2>& q = m_polygon[(i + 1) % m_polygon.size()];
      const double h_p = height(p), h_q = height(q);
      if(h_p >= 0)
        m_clipped.push_back(p);
      if((h_p > 0 && h_q < 0) || (h_p < 0 && h_q > 0))
        m_clipped.push_back(p + h_p / (h_p - h_q) * (q - p));
    }
    m_polygon.swap(m_clipped);
  }

  const Progressive_disk& m_disk;
  Positions<2>& m_x;
  Vertex_relaxation<2, Energy> m_relaxation;
  std::vector<Corner> m_corners;
  double m_area = 0;
  std::vector<Vector<2>> m_polygon, m_clipped;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_VERTEX_PLACEMENT_H
