// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE std::string Cholmod_solver::name() const
{
  const bool is_supernodal = m_split != nullptr ? m_split->is_supernodal() : !m_whole.is_analyzed() || m_whole.is_supernodal();
  return is_supernodal ? "cholmod_supernodal" : "cholmod_simplicial";
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_solver::analyze_pattern(const Block_sparse_matrix& matrix)
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
    internal::ask_deadline();
    auto metis = std::make_unique<internal::Cholmod_factor>();
    if(order_by_metis(graph, *metis) && (!is_ordered || metis->operations() < best->operations())) {
      std::swap(best, metis);
      is_ordered = true;
      m_ordering = "metis";
    }
  }
  if(!is_ordered)
    return false;
  internal::ask_deadline();

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

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_solver::factorize(const Block_sparse_matrix& matrix)
{
  const internal::Single_thread guard;
  m_is_factorized = m_split != nullptr ? m_split->factorize(matrix) : m_whole.factorize(internal::cholmod_view(matrix));
  return m_is_factorized;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_solver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_is_factorized)
    return false;
  const internal::Single_thread guard;
  const bool solved = m_split != nullptr ? m_split->solve(b, x) : m_whole.solve(b, x);
  return solved && x.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t Cholmod_solver::factor_entries() const
{
  if(m_split != nullptr)
    return static_cast<std::int64_t>(m_split->entries());
  return m_whole.is_analyzed() ? static_cast<std::int64_t>(m_whole.entries()) : -1;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_solver::order_by_metis(const cholmod_sparse& graph, internal::Cholmod_factor& factor)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return factor.order(graph, CHOLMOD_METIS);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_IMPL_H
