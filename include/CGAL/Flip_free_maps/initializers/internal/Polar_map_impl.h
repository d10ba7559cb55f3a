// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/Polar_map.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Polar_map::place(Positions<2>& x) const
{
  x.resize(2, m_domain.number_of_vertices);
  for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v) {
    const double radius = m_profile.radius(m_depth[v]);
    x.col(v) << radius * std::cos(m_angle[v]), radius * std::sin(m_angle[v]);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Polar_map::build_edges()
{
  std::vector<std::tuple<std::int32_t, std::int32_t, Corner>> sides;
  sides.reserve(3 * m_domain.elements.size());
  for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = vertex(e, k), w = vertex(e, k + 1);
      sides.emplace_back((std::min)(v, w), (std::max)(v, w), 3 * e + k);
    }
  std::sort(sides.begin(), sides.end());
  m_edge_of.resize(sides.size());
  for(const auto& [a, b, corner] : sides) {
    if(!m_edges.empty() && m_edges.back().a == a && m_edges.back().b == b)
      m_edges.back().corners[1] = corner;
    else
      m_edges.push_back({a, b, {corner, -1}});
    m_edge_of[corner] = m_edges.size() - 1;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE double Polar_map::cotangent(Corner corner) const
{
  const Matrix<2> edges = m_domain.rest_inverses[corner / 3].inverse();
  const Vector<2> p[3] = {Vector<2>::Zero(), edges.col(0), edges.col(1)};
  const int k = static_cast<int>(corner % 3);
  const Vector<2> a = p[k] - p[(k + 2) % 3], b = p[(k + 1) % 3] - p[(k + 2) % 3];
  return a.dot(b) / (a[0] * b[1] - a[1] * b[0]);
}

CGAL_FLIP_FREE_MAPS_INLINE void Polar_map::spread(const Eigen::VectorXd& values, Eigen::VectorXd& result) const
{
  result.setZero(m_unknowns.number_of_vertices());
  m_unknowns.for_each([&](std::int32_t v, std::int32_t i) { result[v] = values[i]; });
}

CGAL_FLIP_FREE_MAPS_INLINE bool Polar_map::cut()
{
  const auto cross = [this](std::int64_t e, Corner corner) {
    Edge& edge = m_edges[m_edge_of[corner]];
    edge.turn = vertex(e, static_cast<int>(corner % 3)) == edge.a ? 2 * CGAL_PI : -2 * CGAL_PI;
  };
  constexpr Corner UNKNOWN = -2, FIRST = -1;
  std::vector<Corner> entrance(m_domain.elements.size(), UNKNOWN); // seen from the triangle before
  std::vector<std::int64_t> queue;
  for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
    if(is_at_pole(e)) {
      entrance[e] = FIRST;
      queue.push_back(e);
    }
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(Corner corner = 3 * queue[i]; corner < 3 * queue[i] + 3; ++corner) {
      const auto& corners = m_edges[m_edge_of[corner]].corners;
      if(corners[1] < 0) {
        for(Corner c = corner; c != FIRST; c = entrance[c / 3])
          cross(c / 3, c);
        return true;
      }
      const std::int64_t next = (corners[0] == corner ? corners[1] : corners[0]) / 3;
      if(entrance[next] == UNKNOWN) {
        entrance[next] = corner;
        queue.push_back(next);
      }
    }
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE double Polar_map::turn(Corner corner) const
{
  const Edge& edge = m_edges[m_edge_of[corner]];
  const double increment = m_angle[edge.b] - m_angle[edge.a] + edge.turn;
  return vertex(corner / 3, static_cast<int>(corner % 3)) == edge.a ? increment : -increment;
}

CGAL_FLIP_FREE_MAPS_INLINE void Polar_map::find_radius()
{
  std::vector<double> depths(m_depth.data(), m_depth.data() + m_depth.size());
  std::sort(depths.begin(), depths.end());
  m_profile.set_knots(depths, depths.size() / VERTICES_PER_KNOT);
  for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e) {
    const Matrix<2> gradients = m_domain.rest_inverses[e].transpose();
    const Vector<3> depth(m_depth[vertex(e, 0)], m_depth[vertex(e, 1)], m_depth[vertex(e, 2)]);
    const Vector<2> along = gradients * Vector<2>(depth[1] - depth[0], depth[2] - depth[0]);
    const double weight = m_domain.measures[e];
    m_profile.add_radial(depth.mean(), weight, along.squaredNorm());
    if(is_at_pole(e))
      continue;
    const Vector<3> turns(turn(3 * e), turn(3 * e + 1), turn(3 * e + 2));
    m_profile.add_tangential(depth.mean(), weight, (gradients * Vector<2>(turns[0], -turns[2])).squaredNorm());
    // A side that spans the angle t lies inside its circle by up to r t^2 / 8, and flat triangles would be flipped where radii
    // grow less. To third order the doubled area is r^2 (growth * area in coordinates - product of the turns / 2).
    const double area = (depth[1] - depth[0]) * -turns[2] - (depth[2] - depth[0]) * turns[0];
    if(area > 0)
      m_profile.add_growth(depth.minCoeff(), depth.maxCoeff(), 0.5 * turns.prod() / area);
  }
  m_profile.optimize();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_IMPL_H
