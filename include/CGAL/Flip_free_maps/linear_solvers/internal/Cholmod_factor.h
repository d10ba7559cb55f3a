// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Single_thread.h>

#include <Eigen/Core>

#include <cholmod.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#endif

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A function of the BLAS that serves CHOLMOD, null where it cannot be found.
template <typename Function>
Function* blas_function(const char* name)
{
#if defined(__unix__) || defined(__APPLE__)
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
#else
  static_cast<void>(name);
  return nullptr;
#endif
}

// A lower triangle by columns as CHOLMOD sees it, without a copy; a pattern only when there are no values.
cholmod_sparse cholmod_view(std::int64_t n, const std::vector<Block_sparse_matrix::Index>& columns,
                            const std::vector<Block_sparse_matrix::Index>& rows, const double* values);

inline cholmod_sparse cholmod_view(const Block_sparse_matrix& matrix)
{
  return cholmod_view(matrix.rows(), matrix.column_starts(), matrix.row_indices(), matrix.values().data());
}

// A Cholesky factor L L^T with everything that belongs to it.
class Cholmod_factor
{
public:
  Cholmod_factor();

  ~Cholmod_factor();

  Cholmod_factor(const Cholmod_factor&) = delete;
  Cholmod_factor& operator=(const Cholmod_factor&) = delete;

  void clear();

  // One of CHOLMOD's orderings on a graph, and what it costs. The scalar pattern of the graph is only a means to this end;
  // building supernodes for it would be wasted.
  bool order(cholmod_sparse graph, int ordering);

  // The pattern of the factor in a given order, or, without one, in the matrix' own.
  bool analyze_in_order(cholmod_sparse matrix, const std::vector<SuiteSparse_long>* order);

  bool is_analyzed() const { return m_factor != nullptr; }
  bool is_factorized() const { return m_is_factorized; }
  bool is_supernodal() const { return m_factor != nullptr && m_factor->is_super; }
  double operations() const { return m_operations; }
  double entries() const { return m_entries; }
  // After the analysis: row k of the permuted matrix is row order()[k] of the given one.
  const SuiteSparse_long* order() const { return static_cast<const SuiteSparse_long*>(m_factor->Perm); }
  // Entries of each column of the factor, after `order()` was computed.
  const SuiteSparse_long* column_counts() const { return static_cast<const SuiteSparse_long*>(m_factor->ColCount); }

  // `false` when the matrix is not positive definite or memory is exhausted.
  bool factorize(cholmod_sparse matrix);

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  // Solves with L, in place and in the permuted order. CHOLMOD's own solution calls the BLAS for every supernode; most are so
  // small that the calls take longer than the arithmetic.
  bool solve_lower(Eigen::VectorXd& x);

  // The same with L^T.
  bool solve_upper(Eigen::VectorXd& x);

  // The last rows and columns of the factor from `first` on, the upper triangle zero.
  void last_block(std::int64_t first, Eigen::MatrixXd& block) const;

private:
  static constexpr std::int64_t SMALL = 1024;

  // Columns of the factor with the same rows, stored as one dense matrix; its upper triangle is not to be read.
  struct Supernode
  {
    using Block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

    std::int64_t first, columns, rows;
    const SuiteSparse_long* row_indices;
    const double* values;

    // So that loops are faster than calls.
    bool is_small() const { return rows * columns <= SMALL; }

    Block diagonal_block() const { return Block(values, columns, columns, Eigen::OuterStride<>(rows)); }
    Block lower_block() const { return Block(values + columns, rows - columns, columns, Eigen::OuterStride<>(rows)); }
  };

  static void solve_small_lower(const Supernode& node, double* x);

  static void solve_small_upper(const Supernode& node, double* x);

  Supernode supernode(std::size_t s) const;

  bool solve_simplicial(int system, Eigen::VectorXd& x);

  bool analyze(cholmod_sparse& matrix, int ordering, SuiteSparse_long* order, bool postorder);

  cholmod_common m_common;
  cholmod_factor* m_factor = nullptr;
  cholmod_dense* m_solution = nullptr;
  cholmod_dense* m_work_y = nullptr;
  cholmod_dense* m_work_e = nullptr;
  Eigen::VectorXd m_permuted, m_gathered;
  double m_operations = 0;
  double m_entries = 0;
  bool m_is_factorized = false;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CHOLMOD_FACTOR_H
