// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H

#include <CGAL/Flip_free_maps/internal/available_memory.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// A direct solver while its factor fits into a budget of memory, conjugate gradients beyond it. The factor's size is known after the analysis
/// of the pattern, before memory is taken.
///
/// \tparam DirectSolver must be a model of `SymmetricSparseSolver` that knows the entries of its factor after the analysis
///
/// \cgalModels{SymmetricSparseSolver}
template <typename DirectSolver>
class Automatic_solver
{
public:
  static constexpr bool takes_memory_budget = true; ///< by its constructor

  /// \param memory_budget bytes for the factor; 0 stands for half of the machine's memory
  explicit Automatic_solver(double memory_budget = 0)
    : m_budget(memory_budget > 0 ? memory_budget : 0.5 * internal::physical_memory()), m_direct(std::make_unique<DirectSolver>())
  {}

  /// That of the solver in use.
  std::string name() const { return m_direct != nullptr ? m_direct->name() : m_iterative->name(); }
  /// That of the solver in use.
  std::string ordering() const { return m_direct != nullptr ? m_direct->ordering() : m_iterative->ordering(); }

  /// Analyses the pattern for the direct solver, and chooses.
  bool analyze_pattern(const Block_sparse_matrix& matrix)
  {
    if(m_direct == nullptr)
      m_direct = std::make_unique<DirectSolver>();
    if(m_direct->analyze_pattern(matrix) && ENTRY_BYTES * static_cast<double>(m_direct->factor_entries()) <= m_budget) {
      m_iterative.reset();
      return true;
    }
    m_direct.reset();
    m_iterative = std::make_unique<Conjugate_gradient_solver<>>();
    return m_iterative->analyze_pattern(matrix);
  }

  /// Passed on.
  bool factorize(const Block_sparse_matrix& matrix)
  {
    return m_direct != nullptr ? m_direct->factorize(matrix) : m_iterative->factorize(matrix);
  }

  /// Passed on.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    return m_direct != nullptr ? m_direct->solve(b, x) : m_iterative->solve(b, x);
  }

  /// Iterations of the last solve, 0 for the direct solver.
  int iterations() const { return m_iterative != nullptr ? m_iterative->iterations() : 0; }

  /// That of the solver in use.
  std::int64_t factor_entries() const { return m_direct != nullptr ? m_direct->factor_entries() : m_iterative->factor_entries(); }

private:
  // A value, and what supernodes and work space take in proportion.
  static constexpr double ENTRY_BYTES = 10;

  double m_budget;
  std::unique_ptr<DirectSolver> m_direct; // null while the iterative one is in use
  std::unique_ptr<Conjugate_gradient_solver<>> m_iterative;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_AUTOMATIC_SOLVER_H
