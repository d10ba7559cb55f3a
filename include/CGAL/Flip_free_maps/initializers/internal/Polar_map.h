// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/initializers/internal/Radial_profile.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Laplacian_matrix.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A map of a disk in polar coordinates around its innermost vertex, the pole, for long closed tubes with one open end. A harmonic
// map of the whole tube shrinks it exponentially, beyond what double precision holds. Here only the coordinates are harmonic:
// Green's function of the pole, which is linear along a tube, and the angle around the pole, whose increments along edges are
// single-valued but for a cut of triangles from the pole to the border. The radius is the function of the former for which the
// symmetric Dirichlet energy is least.
class Polar_map
{
public:
  // Keeps a reference to the domain.
  explicit Polar_map(const Simplicial_domain<2>& domain) : m_domain(domain) {}

  // Finds the coordinates and the radii; false where there are none. Complexity:
  // two factorizations with an unknown for each vertex.
  template <typename MakeLinearSolver>
  bool build(MakeLinearSolver&& make_linear_solver)
  {
    if(!m_domain.holes.empty() || m_domain.number_of_vertices < 2 * VERTICES_PER_KNOT)
      return false;
    build_edges();
    if(!find_depth(make_linear_solver) || !cut() || !find_angle(make_linear_solver))
      return false;
    find_radius();
    return std::isfinite(m_profile.energy());
  }

  // The symmetric Dirichlet energy of the map, in the limit of small triangles.
  double energy() const { return m_profile.energy(); }

  // The map. Its triangles may be flipped where they are not small.
  void place(Positions<2>& x) const;

private:
  // Corner 3 e + k is the edge of element e from its vertex k to the next.
  using Corner = std::int64_t;

  struct Edge
  {
    std::int32_t a, b;
    std::array<Corner, 2> corners; // the second is -1 on the border
    double turn = 0;               // 2 pi times the number of cuts that are crossed from a to b
  };

  std::int32_t vertex(std::int64_t e, int k) const { return m_domain.elements[e][k % 3]; }

  void build_edges();

  // Twice the dual length of an edge over its length, as far as one triangle contributes: the cotangent of the angle opposite.
  double cotangent(Corner corner) const;

  bool is_at_pole(std::int64_t e) const { return vertex(e, 0) == m_pole || vertex(e, 1) == m_pole || vertex(e, 2) == m_pole; }

  // The Laplacian of the vertices that are not fixed, of the triangles that do not touch the pole if there is one. Positive
  // weights make an embedding likely. Increments by `turn` along edges are moved to the right-hand side.
  template <typename LinearSolver>
  bool factorize(const std::vector<std::int32_t>& fixed, LinearSolver& solver, Eigen::VectorXd& right)
  {
    constexpr double SMALLEST_WEIGHT = 0.01;
    m_unknowns.assign(m_domain.number_of_vertices, fixed);
    Laplacian_matrix matrix(m_unknowns, m_domain.elements);
    right.setZero(m_unknowns.size());
    for(const Edge& edge : m_edges) {
      if(edge.a == m_pole || edge.b == m_pole)
        continue;
      double weight = 0;
      for(Corner corner : edge.corners)
        if(corner >= 0 && !is_at_pole(corner / 3))
          weight += 0.5 * cotangent(corner);
      weight = (std::max)(weight, SMALLEST_WEIGHT);
      matrix.add_edge(edge.a, edge.b, weight);
      if(!m_unknowns.is_fixed(edge.a))
        right[m_unknowns[edge.a]] += weight * edge.turn;
      if(!m_unknowns.is_fixed(edge.b))
        right[m_unknowns[edge.b]] -= weight * edge.turn;
    }
    return matrix.factorize(solver);
  }

  void spread(const Eigen::VectorXd& values, Eigen::VectorXd& result) const;

  // The pole is where a particle that moves at random takes longest to reach the border.
  // The depth is 0 there and 1 on the border.
  template <typename MakeLinearSolver>
  bool find_depth(MakeLinearSolver&& make_linear_solver)
  {
    auto solver = make_linear_solver();
    Eigen::VectorXd right, left;
    if(!factorize(m_domain.border, solver, right) || right.size() == 0)
      return false;
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      for(std::int32_t v : m_domain.elements[e])
        if(!m_unknowns.is_fixed(v))
          right[m_unknowns[v]] += m_domain.measures[e];
    if(!solver.solve(right, left))
      return false;
    spread(left, m_depth);
    m_depth.maxCoeff(&m_pole);
    right = Eigen::VectorXd::Unit(right.size(), m_unknowns[m_pole]);
    if(!solver.solve(right, left))
      return false;
    spread(left / left[m_unknowns[m_pole]], m_depth);
    m_depth = 1 - m_depth.array();
    return m_depth.allFinite();
  }

  // Crosses the edges of a shortest strip of triangles from the pole to the border.
  bool cut();

  template <typename MakeLinearSolver>
  bool find_angle(MakeLinearSolver&& make_linear_solver)
  {
    // Any vertex may have angle 0.
    auto solver = make_linear_solver();
    Eigen::VectorXd right, left;
    if(!factorize({m_pole, m_domain.border.front()}, solver, right) || !solver.solve(right, left))
      return false;
    spread(left, m_angle);
    return m_angle.allFinite();
  }

  // The increment of the angle along an edge of an element.
  double turn(Corner corner) const;

  void find_radius();

  static constexpr std::int32_t VERTICES_PER_KNOT = 24;

  const Simplicial_domain<2>& m_domain;
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_edge_of; // corners
  Unknowns m_unknowns;
  std::int32_t m_pole = -1;
  Eigen::VectorXd m_depth, m_angle;
  Radial_profile m_profile;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/Polar_map_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_POLAR_MAP_H
