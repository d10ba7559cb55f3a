// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool Eigen_simplicial_solver::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_factorized = false;
  m_matrix = matrix.lower();
  m_solver.analyzePattern(m_matrix);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Eigen_simplicial_solver::factorize(const Block_sparse_matrix& matrix)
{
  m_factorized = false;
  if(m_matrix.nonZeros() != matrix.number_of_entries())
    return false;
  std::copy(matrix.values().begin(), matrix.values().end(), m_matrix.valuePtr());
  m_solver.factorize(m_matrix);
  m_factorized = m_solver.info() == Eigen::Success && m_solver.vectorD().allFinite();
  return m_factorized;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Eigen_simplicial_solver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_factorized)
    return false;
  x = m_solver.solve(b);
  return x.allFinite();
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_IMPL_H
