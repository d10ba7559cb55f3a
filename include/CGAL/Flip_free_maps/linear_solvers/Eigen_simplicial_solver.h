// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// Eigen's simplicial LDL^T factorization with an approximate minimum degree ordering. Always available.
///
/// \cgalModels{SymmetricSparseSolver}
class Eigen_simplicial_solver
{
public:
  /// "eigen_simplicial_ldlt"
  std::string name() const { return "eigen_simplicial_ldlt"; }
  /// "amd"
  std::string ordering() const { return "amd"; }

  /// Computes the ordering and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Factorizes; the pattern must be the one analysed. `false` when a pivot vanishes or is not finite.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Solves for one right-hand side with the last factorization.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of the factor.
  std::int64_t factor_entries() const { return m_factorized ? m_solver.matrixL().nestedExpression().nonZeros() : -1; }

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Block_sparse_matrix::Index>;

  Matrix m_matrix;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<Block_sparse_matrix::Index>> m_solver;
  bool m_factorized = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_EIGEN_SIMPLICIAL_SOLVER_H
