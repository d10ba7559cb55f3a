// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Split_cholesky.h>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// CHOLMOD's Cholesky factorization (Chen, Davis, Hager and Rajamanickam 2008), with 64-bit indices. Orderings are computed on
/// the graph of the vertices and expanded to the blocks: approximate minimum degree, and where that leaves many operations METIS
/// nested dissection as well, which takes several times as long; the one with fewer floating-point operations is kept. CHOLMOD
/// chooses the supernodal or the simplicial kernel by the operations per entry of the factor.
/// The factor's storage is kept between factorizations.
///
/// Where a factorization is large, the elimination tree is cut into two parts of about the same work and a separator that is
/// eliminated last. The parts are analysed, factorized and solved with by two threads, if TBB is linked and allows as many, and
/// one after the other otherwise, with the same result. Within each, the threads of OpenMP and of OpenBLAS are held off:
/// the sums of the latter, and so the map, would depend on their number.
///
/// Available when `CGAL_FLIP_FREE_MAPS_USE_CHOLMOD` is defined.
///
/// \cgalModels{SymmetricSparseSolver}
class Cholmod_solver
{
public:
  /// Floating-point operations of a factorization per vertex from which METIS is tried as well: it takes as long as so many.
  static constexpr double METIS_THRESHOLD = 7e4;
  /// Floating-point operations of a factorization from which it is done in two parts.
  static constexpr double SPLIT_THRESHOLD = 3e8;

  /// "cholmod_supernodal" or "cholmod_simplicial", known after the analysis.
  std::string name() const;
  /// "amd" or "metis"
  std::string ordering() const { return m_ordering; }

  /// Computes the ordering and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Factorizes; the pattern must be the one analysed. `false` when the matrix is not positive definite or memory is exhausted.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Solves for one right-hand side with the last factorization.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of the factor, known after the analysis.
  std::int64_t factor_entries() const;

  /// Whether factorizations are done in two parts, known after the analysis.
  bool is_split() const { return m_split != nullptr; }

  /// Floating-point operations of a factorization, known after the analysis.
  double factor_operations() const { return m_split != nullptr ? m_split->operations() : m_whole.operations(); }

private:
  // METIS draws from the random numbers of the C library, which it seeds when it begins: its calls must not overlap.
  static bool order_by_metis(const cholmod_sparse& graph, internal::Cholmod_factor& factor);

  internal::Cholmod_factor m_whole;
  std::unique_ptr<internal::Split_cholesky> m_split;
  std::string m_ordering;
  bool m_is_factorized = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
