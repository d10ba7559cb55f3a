// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_SPARSE_LINEAR_ALGEBRA_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_SPARSE_LINEAR_ALGEBRA_SOLVER_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

template <typename Traits, typename = void>
struct Has_factor : std::false_type
{};

template <typename Traits>
struct Has_factor<Traits, std::void_t<decltype(std::declval<Traits&>().factor(std::declval<const typename Traits::Matrix&>(),
                                                                              std::declval<typename Traits::NT&>()))>> : std::true_type
{};

} // namespace internal

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// Makes a linear solver of any model of CGAL's concept `SparseLinearAlgebraTraits_d`, such as `CGAL::Eigen_solver_traits`, so
/// that the solver argument of CGAL's parameterizers keeps its meaning. Models with a member `factor()`
/// (`SparseLinearAlgebraWithFactorTraits_d`) factorize once per matrix, others once per right-hand side; that concept has no
/// symbolic analysis, so the ordering is computed anew each time.
///
/// \tparam SparseLinearAlgebraTraits must be a model of CGAL's `SparseLinearAlgebraTraits_d`, default constructible
///
/// \cgalModels{SymmetricSparseSolver}
template <typename SparseLinearAlgebraTraits>
class Sparse_linear_algebra_solver
{
  using Matrix = typename SparseLinearAlgebraTraits::Matrix;
  using Vector = typename SparseLinearAlgebraTraits::Vector;
  using NT = typename SparseLinearAlgebraTraits::NT;

public:
  /// Keeps a copy of `traits`.
  explicit Sparse_linear_algebra_solver(const SparseLinearAlgebraTraits& traits = SparseLinearAlgebraTraits()) : m_traits(traits) {}

  /// "sparse_linear_algebra_traits"
  std::string name() const { return "sparse_linear_algebra_traits"; }
  /// The ordering is the traits' own affair.
  std::string ordering() const { return "traits"; }

  /// Nothing to do: the concept has no symbolic analysis.
  bool analyze_pattern(const Block_sparse_matrix&) { return true; }

  /// Hands both triangles of the matrix to the traits.
  bool factorize(const Block_sparse_matrix& matrix)
  {
    const int n = static_cast<int>(matrix.rows());
    m_matrix = std::make_unique<Matrix>(n, n);
    const auto& columns = matrix.column_starts();
    const auto& rows = matrix.row_indices();
    const auto& values = matrix.values();
    for(int column = 0; column < n; ++column)
      for(auto k = columns[column]; k < columns[column + 1]; ++k) {
        const int row = static_cast<int>(rows[k]);
        m_matrix->set_coef(row, column, values[k], true);
        if(row != column)
          m_matrix->set_coef(column, row, values[k], true);
      }
    if constexpr(internal::Has_factor<SparseLinearAlgebraTraits>::value) {
      NT denominator;
      return m_traits.factor(*m_matrix, denominator);
    }
    return true;
  }

  /// Solves for one right-hand side.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    if(m_matrix == nullptr)
      return false;
    const int n = static_cast<int>(b.size());
    Vector right(n), left(n);
    for(int i = 0; i < n; ++i)
      right.set(i, b[i]);
    NT denominator = 1;
    bool solved;
    if constexpr(internal::Has_factor<SparseLinearAlgebraTraits>::value)
      solved = m_traits.linear_solver(right, left);
    else
      solved = m_traits.linear_solver(*m_matrix, right, left, denominator);
    if(!solved)
      return false;
    x.resize(n);
    for(int i = 0; i < n; ++i)
      x[i] = left[i] / denominator;
    return x.allFinite();
  }

  /// Unknown to the concept.
  std::int64_t factor_entries() const { return -1; }

private:
  SparseLinearAlgebraTraits m_traits;
  std::unique_ptr<Matrix> m_matrix;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_SPARSE_LINEAR_ALGEBRA_SOLVER_H
