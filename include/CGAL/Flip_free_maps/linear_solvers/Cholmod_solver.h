// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Split_cholesky.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

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
  std::string name() const
  {
    const bool is_supernodal = m_split != nullptr ? m_split->is_supernodal() : !m_whole.is_analyzed() || m_whole.is_supernodal();
    return is_supernodal ? "cholmod_supernodal" : "cholmod_simplicial";
  }
  /// "amd" or "metis"
  std::string ordering() const { return m_ordering; }

  /// Computes the ordering and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix)
  {
    m_whole.clear();
    m_split.reset();
    const internal::Single_thread guard;
    std::vector<Block_sparse_matrix::Index> graph_rows(matrix.block_row_indices().begin(), matrix.block_row_indices().end());
    const cholmod_sparse graph = internal::cholmod_view(matrix.number_of_vertices(), matrix.block_column_starts(), graph_rows, nullptr);

    m_ordering = "amd";
    auto best = std::make_unique<internal::Cholmod_factor>();
    bool is_ordered = best->order(graph, CHOLMOD_AMD);
    // A column of the factor of the graph with c entries stands for b columns with b c entries.
    const double b = matrix.block_size();
    if(!is_ordered || b * b * b * best->operations() >= METIS_THRESHOLD * matrix.number_of_vertices()) {
      auto metis = std::make_unique<internal::Cholmod_factor>();
      if(order_by_metis(graph, *metis) && (!is_ordered || metis->operations() < best->operations())) {
        std::swap(best, metis);
        is_ordered = true;
        m_ordering = "metis";
      }
    }
    if(!is_ordered)
      return false;

    if(matrix.block_size() <= internal::Split_cholesky::LARGEST_BLOCK && b * b * b * best->operations() >= SPLIT_THRESHOLD) {
      const internal::Elimination_split split(matrix, best->order(), best->column_counts());
      if(split.is_worthwhile()) {
        best.reset();
        m_split = std::make_unique<internal::Split_cholesky>();
        return m_split->analyze(matrix, split);
      }
    }

    std::vector<SuiteSparse_long> expanded(matrix.rows());
    for(std::int64_t v = 0; v < matrix.number_of_vertices(); ++v)
      for(std::int64_t i = 0; i < matrix.block_size(); ++i)
        expanded[v * matrix.block_size() + i] = best->order()[v] * matrix.block_size() + i;
    best.reset();
    return m_whole.analyze_in_order(internal::cholmod_view(matrix), &expanded);
  }

  /// Factorizes; the pattern must be the one analysed. `false` when the matrix is not positive definite or memory is exhausted.
  bool factorize(const Block_sparse_matrix& matrix)
  {
    const internal::Single_thread guard;
    m_is_factorized = m_split != nullptr ? m_split->factorize(matrix) : m_whole.factorize(internal::cholmod_view(matrix));
    return m_is_factorized;
  }

  /// Solves for one right-hand side with the last factorization.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    if(!m_is_factorized)
      return false;
    const internal::Single_thread guard;
    const bool solved = m_split != nullptr ? m_split->solve(b, x) : m_whole.solve(b, x);
    return solved && x.allFinite();
  }

  /// Entries of the factor, known after the analysis.
  std::int64_t factor_entries() const
  {
    if(m_split != nullptr)
      return static_cast<std::int64_t>(m_split->entries());
    return m_whole.is_analyzed() ? static_cast<std::int64_t>(m_whole.entries()) : -1;
  }

  /// Floating-point operations of a factorization, known after the analysis.
  double factor_operations() const { return m_split != nullptr ? m_split->operations() : m_whole.operations(); }

private:
  // METIS draws from the random numbers of the C library, which it seeds when it begins: its calls must not overlap.
  static bool order_by_metis(const cholmod_sparse& graph, internal::Cholmod_factor& factor)
  {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    return factor.order(graph, CHOLMOD_METIS);
  }

  internal::Cholmod_factor m_whole;
  std::unique_ptr<internal::Split_cholesky> m_split;
  std::string m_ordering;
  bool m_is_factorized = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
