// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE cholmod_sparse cholmod_view(std::int64_t n, const std::vector<Block_sparse_matrix::Index>& columns,
                                                       const std::vector<Block_sparse_matrix::Index>& rows, const double* values)
{
  static_assert(sizeof(SuiteSparse_long) == sizeof(Block_sparse_matrix::Index), "CHOLMOD's long indices must have 64 bits");
  cholmod_sparse matrix = {};
  matrix.nrow = matrix.ncol = n;
  matrix.nzmax = rows.size();
  matrix.p = const_cast<Block_sparse_matrix::Index*>(columns.data());
  matrix.i = const_cast<Block_sparse_matrix::Index*>(rows.data());
  matrix.x = const_cast<double*>(values);
  matrix.stype = -1;
  matrix.itype = CHOLMOD_LONG;
  matrix.xtype = values != nullptr ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = 1;
  matrix.packed = 1;
  return matrix;
}

CGAL_FLIP_FREE_MAPS_INLINE Cholmod_factor::Cholmod_factor()
{
  cholmod_l_start(&m_common);
  m_common.print = 0;
  m_common.quick_return_if_not_posdef = 1;
  // An LDL^T factorization, the other choice of the simplicial kernel, would accept indefinite matrices.
  m_common.final_ll = 1;
  m_common.error_handler = nullptr;
}

CGAL_FLIP_FREE_MAPS_INLINE Cholmod_factor::~Cholmod_factor()
{
  clear();
  cholmod_l_finish(&m_common);
}

CGAL_FLIP_FREE_MAPS_INLINE void Cholmod_factor::clear()
{
  if(m_factor != nullptr)
    cholmod_l_free_factor(&m_factor, &m_common);
  if(m_solution != nullptr)
    cholmod_l_free_dense(&m_solution, &m_common);
  if(m_work_y != nullptr)
    cholmod_l_free_dense(&m_work_y, &m_common);
  if(m_work_e != nullptr)
    cholmod_l_free_dense(&m_work_e, &m_common);
  m_is_factorized = false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::order(cholmod_sparse graph, int ordering)
{
  m_common.supernodal = CHOLMOD_SIMPLICIAL;
  const bool found = analyze(graph, ordering, nullptr, true);
  m_common.supernodal = CHOLMOD_AUTO;
  return found;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::analyze_in_order(cholmod_sparse matrix, const std::vector<SuiteSparse_long>* order)
{
  return order != nullptr ? analyze(matrix, CHOLMOD_GIVEN, const_cast<SuiteSparse_long*>(order->data()), true)
                          : analyze(matrix, CHOLMOD_NATURAL, nullptr, false);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::factorize(cholmod_sparse matrix)
{
  m_is_factorized = false;
  if(m_factor == nullptr)
    return false;
  cholmod_l_factorize(&matrix, m_factor, &m_common);
  // Another solver would not have more.
  if(m_common.status == CHOLMOD_OUT_OF_MEMORY)
    throw std::bad_alloc();
  // A NaN in the matrix is no error to CHOLMOD, but leaves no condition number.
  m_is_factorized = m_common.status == CHOLMOD_OK && m_factor->minor == m_factor->n && cholmod_l_rcond(m_factor, &m_common) > 0;
  return m_is_factorized;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_is_factorized)
    return false;
  const std::int64_t n = m_factor->n;
  m_permuted.resize(n);
  for(std::int64_t k = 0; k < n; ++k)
    m_permuted[k] = b[order()[k]];
  if(!solve_lower(m_permuted) || !solve_upper(m_permuted))
    return false;
  x.resize(n);
  for(std::int64_t k = 0; k < n; ++k)
    x[order()[k]] = m_permuted[k];
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::solve_lower(Eigen::VectorXd& x)
{
  if(!m_is_factorized || !m_factor->is_super)
    return solve_simplicial(CHOLMOD_L, x);
  for(std::size_t s = 0; s < m_factor->nsuper; ++s) {
    const Supernode node = supernode(s);
    if(node.is_small()) {
      solve_small_lower(node, x.data());
      continue;
    }
    auto y = x.segment(node.first, node.columns);
    node.diagonal_block().triangularView<Eigen::Lower>().solveInPlace(y);
    if(node.rows == node.columns)
      continue;
    m_gathered.noalias() = node.lower_block() * y;
    for(std::int64_t i = node.columns; i < node.rows; ++i)
      x[node.row_indices[i]] -= m_gathered[i - node.columns];
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::solve_upper(Eigen::VectorXd& x)
{
  if(!m_is_factorized || !m_factor->is_super)
    return solve_simplicial(CHOLMOD_Lt, x);
  for(std::size_t s = m_factor->nsuper; s-- > 0;) {
    const Supernode node = supernode(s);
    if(node.is_small()) {
      solve_small_upper(node, x.data());
      continue;
    }
    auto y = x.segment(node.first, node.columns);
    if(node.rows > node.columns) {
      m_gathered.resize(node.rows - node.columns);
      for(std::int64_t i = node.columns; i < node.rows; ++i)
        m_gathered[i - node.columns] = x[node.row_indices[i]];
      y.noalias() -= node.lower_block().transpose() * m_gathered;
    }
    node.diagonal_block().transpose().triangularView<Eigen::Upper>().solveInPlace(y);
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cholmod_factor::last_block(std::int64_t first, Eigen::MatrixXd& block) const
{
  const std::int64_t n = m_factor->n;
  block.setZero(n - first, n - first);
  const double* values = static_cast<const double*>(m_factor->x);
  if(!m_factor->is_super) {
    const SuiteSparse_long *columns = static_cast<const SuiteSparse_long*>(m_factor->p),
                           *rows = static_cast<const SuiteSparse_long*>(m_factor->i),
                           *counts = static_cast<const SuiteSparse_long*>(m_factor->nz);
    for(std::int64_t j = first; j < n; ++j)
      for(std::int64_t k = columns[j]; k < columns[j] + counts[j]; ++k)
        block(rows[k] - first, j - first) = values[k];
    return;
  }
  for(std::size_t s = m_factor->nsuper; s-- > 0;) {
    const Supernode node = supernode(s);
    if(node.first + node.columns <= first)
      break;
    for(std::int64_t j = (std::max)(node.first, first); j < node.first + node.columns; ++j)
      for(std::int64_t i = j - node.first; i < node.rows; ++i)
        block(node.row_indices[i] - first, j - first) = node.values[(j - node.first) * node.rows + i];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cholmod_factor::solve_small_lower(const Supernode& node, double* x)
{
  double below[SMALL];
  std::fill(below + node.columns, below + node.rows, 0.);
  double* y = x + node.first;
  for(std::int64_t j = 0; j < node.columns; ++j) {
    const double* column = node.values + j * node.rows;
    const double value = y[j] /= column[j];
    for(std::int64_t i = j + 1; i < node.columns; ++i)
      y[i] -= column[i] * value;
    for(std::int64_t i = node.columns; i < node.rows; ++i)
      below[i] += column[i] * value;
  }
  for(std::int64_t i = node.columns; i < node.rows; ++i)
    x[node.row_indices[i]] -= below[i];
}

CGAL_FLIP_FREE_MAPS_INLINE void Cholmod_factor::solve_small_upper(const Supernode& node, double* x)
{
  double below[SMALL];
  for(std::int64_t i = node.columns; i < node.rows; ++i)
    below[i] = x[node.row_indices[i]];
  double* y = x + node.first;
  for(std::int64_t j = node.columns; j-- > 0;) {
    const double* column = node.values + j * node.rows;
    double value = y[j];
    for(std::int64_t i = j + 1; i < node.columns; ++i)
      value -= column[i] * y[i];
    for(std::int64_t i = node.columns; i < node.rows; ++i)
      value -= column[i] * below[i];
    y[j] = value / column[j];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Cholmod_factor::Supernode Cholmod_factor::supernode(std::size_t s) const
{
  const auto array = [](const void* pointer) { return static_cast<const SuiteSparse_long*>(pointer); };
  Supernode node;
  node.first = array(m_factor->super)[s];
  node.columns = array(m_factor->super)[s + 1] - node.first;
  node.rows = array(m_factor->pi)[s + 1] - array(m_factor->pi)[s];
  node.row_indices = array(m_factor->s) + array(m_factor->pi)[s];
  node.values = static_cast<const double*>(m_factor->x) + array(m_factor->px)[s];
  return node;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::solve_simplicial(int system, Eigen::VectorXd& x)
{
  if(!m_is_factorized)
    return false;
  cholmod_dense right = {};
  right.nrow = right.nzmax = right.d = x.size();
  right.ncol = 1;
  right.x = x.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  if(!cholmod_l_solve2(system, m_factor, &right, nullptr, &m_solution, nullptr, &m_work_y, &m_work_e, &m_common))
    return false;
  x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(m_solution->x), x.size());
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cholmod_factor::analyze(cholmod_sparse& matrix, int ordering, SuiteSparse_long* order, bool postorder)
{
  clear();
  m_common.nmethods = 1;
  m_common.method[0].ordering = ordering;
  m_common.postorder = postorder;
  m_factor = order != nullptr ? cholmod_l_analyze_p(&matrix, order, nullptr, 0, &m_common) : cholmod_l_analyze(&matrix, &m_common);
  m_operations = m_common.fl;
  m_entries = m_common.lnz;
  return m_factor != nullptr;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_IMPL_H
