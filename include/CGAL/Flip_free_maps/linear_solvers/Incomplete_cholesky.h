// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Incomplete_factor_base.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The preconditioner of conjugate gradients that factorizes without fill (Meijerink and van der Vorst 1977): a Cholesky factor with
/// the pattern of the matrix, whose product with its transpose equals the matrix there and has other entries beside. What it solves
/// for is the solution with that product instead of the matrix. Where a pivot is not positive, the diagonal is raised by 10<sup>-3</sup>
/// of itself, and by twice as much until all pivots are positive (Manteuffel 1980).
///
/// The order of the vertices, reverse Cuthill-McKee, and all storage are made once for a pattern. The factor consists of
/// blocks as the matrix does, off the diagonal in single precision; it is symmetric and positive definite all the same.
///
/// Complexity: linear in the entries of the matrix, each time; memory about a third of that of the matrix.
///
/// \cgalModels{SymmetricSparseSolver}
class Incomplete_cholesky
{
public:
  /// "incomplete Cholesky"
  std::string name() const { return "incomplete Cholesky"; }
  /// "rcm"
  std::string ordering() const { return "rcm"; }

  /// Computes the order of the vertices and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Factorizes; the pattern must be the one analysed. `false` when no shift makes all pivots positive.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Solves with the last factorization, which may be far from a solution with the matrix.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of the factor, known after the analysis.
  std::int64_t factor_entries() const { return m_factor != nullptr ? m_factor->entries() : -1; }

  /// The multiple of the diagonal that the last factorization added to it, 0 where all pivots were positive without.
  double shift() const { return m_is_factorized ? m_factor->shift() : 0; }

private:
  std::int64_t m_number_of_entries = 0;
  std::unique_ptr<internal::Incomplete_factor_base> m_factor;
  bool m_is_factorized = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_H
