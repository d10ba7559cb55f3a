// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CONJUGATE_GRADIENT_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CONJUGATE_GRADIENT_SOLVER_H

#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The preconditioner of conjugate gradients that inverts the blocks on the diagonal,
/// in the form that Eigen's iterative solvers ask for.
///
/// Complexity: linear in the number of rows, a hundred bytes per vertex.
template <int D>
class Block_jacobi
{
public:
  using StorageIndex = Block_sparse_matrix::Index; ///< type of indices
  enum
  {
    ColsAtCompileTime = Eigen::Dynamic,
    MaxColsAtCompileTime = Eigen::Dynamic
  };

  static const char* name() { return "block Jacobi"; } ///< "block Jacobi"

  /// Nothing to do.
  template <typename Matrix>
  Block_jacobi& analyzePattern(const Matrix& /* matrix */)
  {
    return *this;
  }

  /// Inverts the blocks of a matrix with sorted columns of which the lower triangle is stored.
  template <typename Matrix>
  Block_jacobi& factorize(const Matrix& matrix)
  {
    m_inverses.resize(D, matrix.cols());
    m_info = Eigen::Success;
    for(StorageIndex v = 0; v < matrix.cols(); v += D) {
      Eigen::Matrix<double, D, D> block;
      for(int j = 0; j < D; ++j) {
        typename Matrix::InnerIterator entry(matrix, v + j);
        for(int i = j; i < D; ++i, ++entry)
          block(i, j) = block(j, i) = entry.value();
      }
      const Eigen::LLT<Eigen::Matrix<double, D, D>> factor(block);
      if(factor.info() != Eigen::Success)
        m_info = Eigen::NumericalIssue;
      m_inverses.template block<D, D>(0, v) = factor.solve(Eigen::Matrix<double, D, D>::Identity());
    }
    return *this;
  }

  /// Both of these.
  template <typename Matrix>
  Block_jacobi& compute(const Matrix& matrix)
  {
    return factorize(matrix);
  }

  /// Multiplies by the inverses.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    Eigen::VectorXd x(b.size());
    for(StorageIndex v = 0; v < b.size(); v += D)
      x.template segment<D>(v).noalias() = m_inverses.template block<D, D>(0, v) * b.template segment<D>(v);
    return x;
  }

  /// Whether all blocks are positive definite.
  Eigen::ComputationInfo info() const { return m_info; }

private:
  Eigen::Matrix<double, D, Eigen::Dynamic> m_inverses;
  Eigen::ComputationInfo m_info = Eigen::InvalidInput;
};

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The preconditioner of conjugate gradients that factorizes without fill, Eigen's `IncompleteCholesky`.
///
/// Complexity: linear in the entries of the matrix, of which it keeps as many.
class Incomplete_cholesky : public Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<Block_sparse_matrix::Index>>
{
public:
  static const char* name() { return "incomplete Cholesky"; } ///< "incomplete Cholesky"
};

namespace internal {

// A preconditioner that is interrupted by a `Deadline`: Eigen's iteration, which calls it, is not.
template <typename Preconditioner>
class Interruptible : public Preconditioner
{
public:
  template <typename Right>
  auto solve(const Right& b) const
  {
    ask_deadline();
    return Preconditioner::solve(b);
  }
};

} // namespace internal

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// Conjugate gradients with a preconditioner, for meshes of which the factor does not fit into memory. Directions are inexact: a
/// right-hand side b is solved for up to the residual `tolerance` |b| sqrt(|b| / |c|), where c is the longest right-hand side so
/// far. That is the 1 % of Claici et al. 2017, section 6.2, far from the solution, and tightens as the gradient shrinks, so that
/// steps of Newton still converge faster than linearly (the inexact Newton rule of Dembo and Steihaug).
///
/// \tparam Preconditioner_ a preconditioner of Eigen's iterative solvers with a name: `Incomplete_cholesky` or `Block_jacobi`
///
/// Complexity: as much memory as twice the matrix, three times with `Incomplete_cholesky`; iterations grow with the number of
/// vertices along the mesh and with the distortion.
///
/// \cgalModels{SymmetricSparseSolver}
template <typename Preconditioner_ = Incomplete_cholesky>
class Conjugate_gradient_solver
{
public:
  /// \param tolerance of the first solve
  /// \param max_iterations at which the last iterate is taken as it is
  explicit Conjugate_gradient_solver(double tolerance = 0.01, int max_iterations = 2000) : m_tolerance(tolerance)
  {
    m_solver.setMaxIterations(max_iterations);
  }

  /// The name with that of the preconditioner.
  std::string name() const { return std::string("conjugate gradients (") + Preconditioner_::name() + ")"; }
  /// "none"
  std::string ordering() const { return "none"; }

  /// Copies the pattern.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Copies the matrix and prepares the preconditioner. `false` if that fails.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Iterates from zero, so that what is found descends wherever the matrix is positive definite.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Whether the last solve met its tolerance.
  bool converged() const { return m_solver.info() == Eigen::Success; }

  /// Iterations of the last solve.
  int iterations() const { return m_iterations; }

  /// Entries of the copy.
  std::int64_t factor_entries() const { return m_matrix.nonZeros(); }

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Block_sparse_matrix::Index>;

  double m_tolerance;
  double m_longest = 0;
  int m_iterations = 0;
  bool m_is_ready = false;
  Matrix m_matrix;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower, internal::Interruptible<Preconditioner_>> m_solver;
};

template <typename Preconditioner_>
bool Conjugate_gradient_solver<Preconditioner_>::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_matrix = matrix.lower();
  m_solver.analyzePattern(m_matrix);
  m_longest = 0;
  return true;
}

template <typename Preconditioner_>
bool Conjugate_gradient_solver<Preconditioner_>::factorize(const Block_sparse_matrix& matrix)
{
  m_is_ready = false;
  if(m_matrix.nonZeros() != matrix.number_of_entries())
    return false;
  std::copy(matrix.values().begin(), matrix.values().end(), m_matrix.valuePtr());
  m_solver.factorize(m_matrix);
  m_is_ready = m_solver.preconditioner().info() == Eigen::Success;
  return m_is_ready;
}

template <typename Preconditioner_>
bool Conjugate_gradient_solver<Preconditioner_>::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_is_ready)
    return false;
  const double length = b.norm();
  m_longest = (std::max)(m_longest, length);
  m_solver.setTolerance(length > 0 ? m_tolerance * std::sqrt(length / m_longest) : m_tolerance);
  x = m_solver.solve(b);
  m_iterations = static_cast<int>(m_solver.iterations());
  return x.allFinite();
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Conjugate_gradient_solver<Incomplete_cholesky>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CONJUGATE_GRADIENT_SOLVER_H
