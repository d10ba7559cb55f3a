// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Incomplete_factor.h>

#include <memory>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool Incomplete_cholesky::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_is_factorized = false;
  m_factor.reset();
  const internal::Block_graph graph(matrix);
  m_factor =
    internal::Block_graph::with_block_size(graph.block_size, [&graph](auto b) -> std::unique_ptr<internal::Incomplete_factor_base> {
      return std::make_unique<internal::Incomplete_factor<b>>(graph);
    });
  m_number_of_entries = matrix.number_of_entries();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Incomplete_cholesky::factorize(const Block_sparse_matrix& matrix)
{
  m_is_factorized = m_factor != nullptr && m_number_of_entries == matrix.number_of_entries() && m_factor->factorize(matrix);
  return m_is_factorized;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Incomplete_cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_is_factorized)
    return false;
  m_factor->solve(b, x);
  return x.allFinite();
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INCOMPLETE_CHOLESKY_IMPL_H
