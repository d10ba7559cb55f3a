// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LAPLACIAN_MATRIX_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LAPLACIAN_MATRIX_H

#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Core>

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The matrix of the Laplacian of a graph with weights, on the vertices that are unknowns.
class Laplacian_matrix
{
public:
  // Keeps a reference to `unknowns`. The vertices of each stencil may become neighbours.
  template <typename Stencils>
  Laplacian_matrix(const Unknowns& unknowns, const Stencils& stencils) : m_unknowns(unknowns)
  {
    m_matrix.build_pattern(unknowns.size(), 1, unknowns.of(stencils));
  }

  // Adds `weight` times (x_v - x_w)^2 / 2 to the quadratic form.
  void add_edge(std::int32_t v, std::int32_t w, double weight)
  {
    add_neighbor(v, w, weight);
    add_neighbor(w, v, weight);
  }

  // Adds the row of v of what `add_edge()` adds. What is stored is symmetric, so the row of w must follow.
  void add_neighbor(std::int32_t v, std::int32_t w, double weight)
  {
    const std::int32_t r = m_unknowns[v], c = m_unknowns[w];
    if(r < 0)
      return;
    m_matrix.diagonal(r) += weight;
    if(r < c)
      m_matrix.add_block(r, c, m_matrix.slot(r, c), Eigen::Matrix<double, 1, 1>(-weight));
  }

  template <typename LinearSolver>
  bool factorize(LinearSolver& solver) const
  {
    ask_deadline();
    if(!solver.analyze_pattern(m_matrix))
      return false;
    ask_deadline();
    return solver.factorize(m_matrix);
  }

private:
  const Unknowns& m_unknowns;
  Block_sparse_matrix m_matrix;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LAPLACIAN_MATRIX_H
