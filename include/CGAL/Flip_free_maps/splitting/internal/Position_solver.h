// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_POSITION_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_POSITION_SOLVER_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/splitting/Linear_constraints.h>
#include <CGAL/Flip_free_maps/splitting/internal/Dense_system.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The global step of the splitting: the increment d of the positions with the least sum_e mu_e / 2 |(G d)_e - T_e|^2 plus the
// soft positions' terms, under the constraints. The same matrix serves all coordinates, so it has a row for each vertex that is
// not fixed. Solving for the increment instead of the positions keeps fixed vertices exactly where they are.
template <int D, typename Traits>
class Position_solver
{
  using Tag = typename Traits::Concurrency_tag;
  using Element = typename Simplicial_domain<D>::Element;

public:
  Position_solver(const Simplicial_domain<D>& domain, const Element_coloring& schedule, const Position_constraints<D>& constraints,
                  const Linear_constraints<D>& linear_constraints)
    : m_domain(domain), m_schedule(schedule), m_constraints(constraints), m_linear(linear_constraints)
  {
    m_row.assign(domain.number_of_vertices, constraints.fixed_vertices);
    m_stencils = m_row.of(domain.elements);
    m_matrix.build_pattern(m_row.size(), 1, m_stencils);
    find_floating_components();
  }

  bool has_unknowns() const { return m_row.size() > 0; }

  template <typename Solver>
  bool analyze_pattern(Solver& solver) const
  {
    return solver.analyze_pattern(m_matrix);
  }

  // `penalty(e)` is mu_e.
  template <typename Solver, typename Penalty>
  bool factorize(Solver& solver, Penalty&& penalty)
  {
    m_matrix.set_zero();
    m_schedule.template scatter<Tag>([&](std::int64_t e) {
      const auto& rows = m_stencils[e];
      const Eigen::Matrix<double, D + 1, D> gradients = hat_gradients(e);
      const double mu = penalty(e);
      for(int i = 0; i <= D; ++i)
        for(int j = 0; j <= i; ++j)
          if(rows[i] >= 0 && rows[j] >= 0)
            m_matrix.add_block(rows[i], rows[j], i == j ? 0 : m_matrix.slot(rows[i], rows[j]),
                               Eigen::Matrix<double, 1, 1>(mu * gradients.row(i).dot(gradients.row(j))));
    });
    for(const Soft_position<D>& soft : m_constraints.soft_positions)
      if(m_row[soft.vertex] >= 0)
        m_matrix.diagonal(m_row[soft.vertex]) += 2 * soft.weight;
    // Stiffness on one vertex of a component that nothing holds removes its translations from the null space and does not change
    // the solution, since the right-hand side is orthogonal to them.
    for(std::int32_t pin : m_pins)
      m_matrix.diagonal(pin) += m_matrix.diagonal(pin) > 0 ? m_matrix.diagonal(pin) : 1;
    return solver.factorize(m_matrix, 0) && factorize_constraints(solver);
  }

  // Moves the positions; `pull(e)` is mu_e T_e.
  template <typename Solver, typename Pull>
  bool move(Solver& solver, Pull&& pull, Positions<D>& x)
  {
    Eigen::Matrix<double, D, Eigen::Dynamic>& force = m_force;
    force.setZero(D, x.cols());
    m_schedule.template scatter<Tag>([&](std::int64_t e) {
      const Element& v = m_domain.elements[e];
      const Matrix<D> corners = pull(e) * m_domain.rest_inverses[e].transpose();
      Vector<D> sum = corners.col(0);
      force.col(v[1]) += corners.col(0);
      for(int i = 1; i < D; ++i) {
        force.col(v[i + 1]) += corners.col(i);
        sum += corners.col(i);
      }
      force.col(v[0]) -= sum;
    });
    for(const Soft_position<D>& soft : m_constraints.soft_positions)
      force.col(soft.vertex) += 2 * soft.weight * (soft.target - x.col(soft.vertex));

    for(int c = 0; c < D; ++c) {
      m_right.resize(m_row.size());
      m_row.for_each([&](std::int32_t v, std::int32_t row) { m_right[row] = force(c, v); });
      if(!solver.solve(m_right, m_left))
        return false;
      if(!m_linear.empty())
        satisfy_constraints(c, x);
      m_row.for_each([&](std::int32_t v, std::int32_t row) { x(c, v) += m_left[row]; });
    }
    return true;
  }

private:
  // Row i is the gradient of the function that is 1 at vertex i of the element and 0 at the others.
  Eigen::Matrix<double, D + 1, D> hat_gradients(std::int64_t e) const
  {
    Eigen::Matrix<double, D + 1, D> gradients;
    gradients.template bottomRows<D>() = m_domain.rest_inverses[e];
    gradients.row(0) = -m_domain.rest_inverses[e].colwise().sum();
    return gradients;
  }

  // Components of the mesh without a fixed vertex or a soft position: one row of each is pinned.
  void find_floating_components()
  {
    m_components.assign(m_domain.number_of_vertices);
    for(const Element& element : m_domain.elements)
      for(std::int32_t v : element)
        m_components.unite(v, element[0]);
    std::vector<char> is_held(m_domain.number_of_vertices, 0);
    for(std::int32_t v : m_constraints.fixed_vertices)
      is_held[m_components.root(v)] = 1;
    for(const Soft_position<D>& soft : m_constraints.soft_positions)
      if(soft.weight > 0)
        is_held[m_components.root(soft.vertex)] = 1;
    for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v)
      if(m_components.root(v) == v && !is_held[v])
        m_pins.push_back(m_row[v]);
  }

  // The Schur complement of the constraints, with the translations t of floating components as further unknowns: for an increment
  // d + Z t, where d vanishes at the pins, the multipliers l and t solve [A K^-1 A^T, -A Z; -(A Z)^T, 0] (l,
  // t) = (A K^-1 f - c, -Z^T f).
  template <typename Solver>
  bool factorize_constraints(Solver& solver)
  {
    const Eigen::Index m = m_linear.matrix.rows(), k = m_pins.size();
    if(m == 0)
      return true;
    m_coefficients.setZero(m, m_row.size());
    m_row.for_each([&](std::int32_t v, std::int32_t row) {
      for(Eigen::SparseMatrix<double>::InnerIterator entry(m_linear.matrix, v); entry; ++entry)
        m_coefficients(entry.row(), row) = entry.value();
    });
    m_translations.setZero(m_row.size(), k);
    for(Eigen::Index i = 0; i < k; ++i)
      for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v)
        if(m_row[v] >= 0 && m_row[m_components.root(v)] == m_pins[i])
          m_translations(m_row[v], i) = 1;
    m_responses.resize(m_row.size(), m);
    for(Eigen::Index i = 0; i < m; ++i) {
      m_right = m_coefficients.row(i).transpose();
      if(!solver.solve(m_right, m_left))
        return false;
      m_responses.col(i) = m_left;
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(m + k, m + k);
    system.topLeftCorner(m, m) = m_coefficients * m_responses;
    system.topRightCorner(m, k) = -m_coefficients * m_translations;
    system.bottomLeftCorner(k, m) = system.topRightCorner(m, k).transpose();
    m_schur.factorize(system);
    return true;
  }

  // Corrects the increment `m_left` of coordinate c, the solution for the right-hand side `m_right` without constraints.
  void satisfy_constraints(int c, const Positions<D>& x)
  {
    const Eigen::Index m = m_linear.matrix.rows(), k = m_pins.size();
    Eigen::VectorXd right(m + k);
    right.head(m) = m_coefficients * m_left - (m_linear.values.col(c) - m_linear.matrix * x.row(c).transpose());
    right.tail(k) = -(m_translations.transpose() * m_right);
    const Eigen::VectorXd solution = m_schur.solve(right);
    m_left += m_translations * solution.tail(k) - m_responses * solution.head(m);
  }

  const Simplicial_domain<D>& m_domain;
  const Element_coloring& m_schedule;
  const Position_constraints<D>& m_constraints;
  const Linear_constraints<D>& m_linear;

  Unknowns m_row;                                          // of each vertex
  std::vector<std::array<std::int32_t, D + 1>> m_stencils; // rows of the elements' vertices
  Disjoint_sets m_components;
  std::vector<std::int32_t> m_pins; // rows
  Block_sparse_matrix m_matrix;
  Eigen::Matrix<double, D, Eigen::Dynamic> m_force;
  Eigen::VectorXd m_right, m_left;

  Eigen::MatrixXd m_coefficients;
  Eigen::MatrixXd m_translations;
  Eigen::MatrixXd m_responses;
  Dense_system m_schur;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_POSITION_SOLVER_H
