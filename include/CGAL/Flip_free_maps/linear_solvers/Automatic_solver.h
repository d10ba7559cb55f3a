// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H

#include <CGAL/Flip_free_maps/internal/memory.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// A direct solver, or conjugate gradients where these are better: when the factor exceeds a budget of memory, and, for solids,
/// when a factorization needs more than 30000 operations per entry of the matrix, which a cube reaches at some 60000 tetrahedra
/// and a bar five times as long as wide at some 125000. Where the two change places depends on the problem, too: with hard
/// handles a cube of 48000 tetrahedra takes a third of the direct solver's time already, a thin solid of 36000 nearly four times as much.
/// With `Petsc_multigrid` it is 10000 operations, and such a bar of 40000 tetrahedra.
/// The size of the factor and the operations are known after the analysis of the pattern, before memory is taken. When conjugate
/// gradients do not converge, the direct solver takes over from the next matrix on, if its factor fits.
///
/// \tparam DirectSolver must be a model of `SymmetricSparseSolver` with a member `factor_operations()`, which like
///   `factor_entries()` is known after the analysis
/// \tparam IterativeSolver must be a `Conjugate_gradient_solver`
///
/// \cgalModels{SymmetricSparseSolver}
template <typename DirectSolver, typename IterativeSolver = Conjugate_gradient_solver<>>
class Automatic_solver
{
public:
  static constexpr bool takes_memory_budget = true;                                          ///< by its constructor
  static constexpr bool takes_positions = internal::Takes_positions<IterativeSolver>::value; ///< for the iterative solver

  /// \param memory_budget bytes for the factor; 0 stands for half of the machine's memory
  explicit Automatic_solver(double memory_budget = 0) : m_budget(memory_budget > 0 ? memory_budget : 0.5 * internal::physical_memory()) {}

  /// That of the solver in use.
  std::string name() const { return m_is_direct ? m_direct->name() : m_iterative.name(); }
  /// That of the solver in use.
  std::string ordering() const { return m_is_direct ? m_direct->ordering() : m_iterative.ordering(); }

  /// Analyses the pattern for the direct solver, and chooses.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Passed on to an iterative solver that takes them.
  void set_positions(const Eigen::VectorXd& positions)
  {
    if(!m_is_direct)
      internal::give_positions(m_iterative, [&]() -> const Eigen::VectorXd& { return positions; });
  }

  /// Passed on.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Passed on.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Iterations of the last solve, 0 for the direct solver.
  int iterations() const { return m_is_direct ? 0 : m_iterative.iterations(); }

  /// That of the solver in use.
  std::int64_t factor_entries() const { return m_is_direct ? m_direct->factor_entries() : m_iterative.factor_entries(); }

private:
  // A value, and what supernodes and work space take in proportion.
  static constexpr double ENTRY_BYTES = 10;
  // Operations per entry from which the iterative solver is faster. One that knows the rigid motions is so earlier.
  static constexpr double SLOW = takes_positions ? 1e4 : 3e4;

  double m_budget;
  std::unique_ptr<DirectSolver> m_direct = std::make_unique<DirectSolver>();
  IterativeSolver m_iterative;
  bool m_fits = true;
  bool m_is_direct = true;
  bool m_has_failed = false;
};

template <typename DirectSolver, typename IterativeSolver>
bool Automatic_solver<DirectSolver, IterativeSolver>::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_direct = std::make_unique<DirectSolver>();
  m_fits = m_direct->analyze_pattern(matrix) && ENTRY_BYTES * static_cast<double>(m_direct->factor_entries()) <= m_budget;
  const bool is_slow = matrix.block_size() == 3 && m_direct->factor_operations() > SLOW * static_cast<double>(matrix.number_of_entries());
  m_is_direct = m_fits && !is_slow;
  m_has_failed = false;
  if(m_is_direct)
    return true;
  // What the analysis left would take as much memory as the matrix, and more.
  m_direct.reset();
  return m_iterative.analyze_pattern(matrix);
}

template <typename DirectSolver, typename IterativeSolver>
bool Automatic_solver<DirectSolver, IterativeSolver>::factorize(const Block_sparse_matrix& matrix)
{
  if(!m_is_direct && m_has_failed && m_fits) {
    m_direct = std::make_unique<DirectSolver>();
    m_is_direct = m_direct->analyze_pattern(matrix);
    m_has_failed = m_is_direct;
  }
  return m_is_direct ? m_direct->factorize(matrix) : m_iterative.factorize(matrix);
}

template <typename DirectSolver, typename IterativeSolver>
bool Automatic_solver<DirectSolver, IterativeSolver>::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(m_is_direct)
    return m_direct->solve(b, x);
  const bool solved = m_iterative.solve(b, x);
  m_has_failed = !solved || !m_iterative.converged();
  return solved;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H
