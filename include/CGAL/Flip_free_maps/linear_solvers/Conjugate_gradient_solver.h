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
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Symmetric_product.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The preconditioner of conjugate gradients that inverts the blocks on the diagonal, for matrices with blocks of D rows. What it
/// solves for is the solution with these blocks instead of the matrix.
///
/// Complexity: linear in the number of rows, a hundred bytes per vertex.
///
/// \cgalModels{SymmetricSparseSolver}
template <int D>
class Block_jacobi
{
public:
  /// "block Jacobi"
  std::string name() const { return "block Jacobi"; }
  /// "none"
  std::string ordering() const { return "none"; }

  /// Nothing to do. `false` if the blocks have another size.
  bool analyze_pattern(const Block_sparse_matrix& matrix)
  {
    m_is_ready = false;
    return matrix.block_size() == D;
  }

  /// Inverts the blocks. `false` unless all are positive definite.
  bool factorize(const Block_sparse_matrix& matrix)
  {
    m_inverses.resize(D, matrix.rows());
    m_is_ready = true;
    for(std::int32_t v = 0; v < matrix.number_of_vertices(); ++v) {
      Eigen::Matrix<double, D, D> block;
      matrix.get_block(v, v, 0, block);
      const Eigen::LLT<Eigen::Matrix<double, D, D>> factor(block);
      m_is_ready = m_is_ready && factor.info() == Eigen::Success;
      m_inverses.template middleCols<D>(Eigen::Index(v) * D) = factor.solve(Eigen::Matrix<double, D, D>::Identity());
    }
    return m_is_ready;
  }

  /// Multiplies by the inverses.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    if(!m_is_ready)
      return false;
    x.resize(b.size());
    for(Eigen::Index i = 0; i < b.size(); i += D)
      x.template segment<D>(i).noalias() = m_inverses.template middleCols<D>(i) * b.template segment<D>(i);
    return x.allFinite();
  }

  /// Entries of the inverses.
  std::int64_t factor_entries() const { return m_inverses.size(); }

private:
  Eigen::Matrix<double, D, Eigen::Dynamic> m_inverses;
  bool m_is_ready = false;
};

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// Conjugate gradients with a preconditioner, for meshes of which the factor does not fit into memory. Directions are inexact: a
/// right-hand side b is solved for up to the residual `tolerance` |b| sqrt(|b| / |c|), where c is the longest right-hand side so
/// far. That is the 1 % of Claici et al. 2017, section 6.2, far from the solution, and tightens as the gradient shrinks, so that
/// steps of Newton still converge faster than linearly (the inexact Newton rule of Dembo and Steihaug).
///
/// \tparam Preconditioner_ must be a model of `SymmetricSparseSolver`, of which it is only asked that it solves with some symmetric
///   positive definite matrix: `Incomplete_cholesky`, `Petsc_multigrid`, `Block_jacobi` or, over MPI, `Distributed_multigrid`
/// \tparam World_ must be a model of `World`: where vectors and matrices are
///
/// Complexity: more than half as much memory as the matrix, and the preconditioner; iterations grow with the number of vertices
/// along the mesh and with the distortion.
///
/// \cgalModels{SymmetricSparseSolver}
template <typename Preconditioner_ = Incomplete_cholesky, typename World_ = Sequential_world>
class Conjugate_gradient_solver
{
public:
  static constexpr bool takes_positions = internal::Takes_positions<Preconditioner_>::value; ///< for the preconditioner
  static constexpr bool has_part_of_matrix = !World_::is_sequential; ///< the rows of unknowns that this process owns

  /// \param tolerance of the first solve
  /// \param max_iterations at which the last iterate is taken as it is
  explicit Conjugate_gradient_solver(double tolerance = 0.01, int max_iterations = 2000)
    : m_tolerance(tolerance), m_max_iterations(max_iterations)
  {}

  /// The same for vectors and matrices of which each process has a part; the preconditioner is made in that world.
  template <typename World, std::enable_if_t<std::is_same_v<World, World_> && !World::is_sequential, int> = 0>
  explicit Conjugate_gradient_solver(const World& world, double tolerance = 0.01, int max_iterations = 2000)
    : m_tolerance(tolerance), m_max_iterations(max_iterations), m_world(world), m_preconditioner(world)
  {}

  /// The name with that of the preconditioner.
  std::string name() const { return "conjugate gradients (" + m_preconditioner.name() + ")"; }
  /// That of the preconditioner.
  std::string ordering() const { return m_preconditioner.ordering(); }

  /// Copies the pattern, and has the preconditioner analyse it.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Passed on to a preconditioner that takes them.
  void set_positions(const Eigen::VectorXd& positions)
  {
    internal::give_positions(m_preconditioner, [&]() -> const Eigen::VectorXd& { return positions; });
  }

  /// Copies the matrix and prepares the preconditioner. `false` if that fails.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Iterates from zero, so that what is found descends; it ends early where the matrix is not positive.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Whether the last solve met its tolerance.
  bool converged() const { return m_converged; }

  /// Iterations of the last solve.
  int iterations() const { return m_iterations; }

  /// Entries of the copy.
  std::int64_t factor_entries() const { return m_matrix.number_of_entries(); }

private:
  double m_tolerance;
  int m_max_iterations;
  double m_longest = 0;
  int m_iterations = 0;
  bool m_converged = false;
  bool m_is_ready = false;
  World_ m_world;
  internal::Symmetric_product m_matrix;
  Preconditioner_ m_preconditioner;
  Eigen::VectorXd m_residual, m_preconditioned, m_search, m_product;
};

template <typename Preconditioner_, typename World_>
bool Conjugate_gradient_solver<Preconditioner_, World_>::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_is_ready = false;
  m_matrix.analyze_pattern(matrix);
  m_longest = 0;
  return m_preconditioner.analyze_pattern(matrix);
}

template <typename Preconditioner_, typename World_>
bool Conjugate_gradient_solver<Preconditioner_, World_>::factorize(const Block_sparse_matrix& matrix)
{
  m_is_ready = m_matrix.copy(matrix) && m_preconditioner.factorize(matrix);
  return m_is_ready;
}

template <typename Preconditioner_, typename World_>
bool Conjugate_gradient_solver<Preconditioner_, World_>::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  m_iterations = 0;
  m_converged = false;
  if(!m_is_ready)
    return false;
  const double length = m_world.norm(b);
  m_longest = (std::max)(m_longest, length);
  x.setZero(b.size());
  if(length == 0) {
    m_converged = true;
    return true;
  }
  const double bound = m_tolerance * std::sqrt(length / m_longest) * length;
  m_residual = b;
  double decrease = 0;
  while(m_iterations < m_max_iterations) {
    internal::ask_deadline();
    if(!m_preconditioner.solve(m_residual, m_preconditioned))
      return false;
    const double next = m_world.dot(m_residual, m_preconditioned);
    // A multigrid of a matrix that is not positive need not be positive itself.
    if(!(next > 0)) {
      if(m_iterations == 0)
        return false;
      break;
    }
    if(m_iterations == 0)
      m_search = m_preconditioned;
    else
      m_search = m_preconditioned + next / decrease * m_search;
    decrease = next;
    m_matrix.multiply(m_world.with_ghosts(m_search), m_product);
    m_world.keep_owned(m_product);
    ++m_iterations;
    const double curvature = m_world.dot(m_search, m_product);
    if(!(curvature > 0))
      break;
    x += decrease / curvature * m_search;
    m_residual -= decrease / curvature * m_product;
    if(m_world.norm(m_residual) <= bound) {
      m_converged = true;
      break;
    }
  }
  // Where the matrix is not positive at once, the preconditioner alone leads on.
  if(m_iterations == 1 && !m_converged && !m_world.any(!x.isZero(0)))
    x = m_search;
  return !m_world.any(!x.allFinite());
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Conjugate_gradient_solver<Incomplete_cholesky>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CONJUGATE_GRADIENT_SOLVER_H
