// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_ANY_LINEAR_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_ANY_LINEAR_SOLVER_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// A linear solver that is chosen at run time. It can be moved, not copied.
///
/// \cgalModels{SymmetricSparseSolver}
class Any_linear_solver
{
public:
  static constexpr bool takes_positions = true; ///< for the solvers that take them

  /// Holds a new solver of the given type: `Any_linear_solver::make<Eigen_simplicial_solver>()`. It may use `memory_budget` bytes
  /// if it takes such a budget.
  template <typename Solver>
  static Any_linear_solver make(double memory_budget = 0)
  {
    return Any_linear_solver(std::make_unique<Model<Solver>>(memory_budget));
  }

  /// Passed on.
  std::string name() const { return m_solver->name(); }
  /// Passed on.
  std::string ordering() const { return m_solver->ordering(); }
  /// Passed on.
  bool analyze_pattern(const Block_sparse_matrix& matrix) { return m_solver->analyze_pattern(matrix); }
  /// Passed on to a solver that takes them.
  void set_positions(const Eigen::VectorXd& positions) { m_solver->set_positions(positions); }
  /// Passed on.
  bool factorize(const Block_sparse_matrix& matrix) { return m_solver->factorize(matrix); }
  /// Passed on.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) { return m_solver->solve(b, x); }
  /// Passed on.
  std::int64_t factor_entries() const { return m_solver->factor_entries(); }
  /// Passed on, 0 for direct solvers.
  int iterations() const { return m_solver->iterations(); }

private:
  struct Base
  {
    virtual ~Base() = default;
    virtual std::string name() const = 0;
    virtual std::string ordering() const = 0;
    virtual bool analyze_pattern(const Block_sparse_matrix& matrix) = 0;
    virtual void set_positions(const Eigen::VectorXd& positions) = 0;
    virtual bool factorize(const Block_sparse_matrix& matrix) = 0;
    virtual bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) = 0;
    virtual std::int64_t factor_entries() const = 0;
    virtual int iterations() const = 0;
  };

  template <typename Solver>
  struct Model final : Base
  {
    explicit Model(double memory_budget) : solver(internal::make_solver<Solver>(memory_budget)) {}

    std::string name() const override { return solver.name(); }
    std::string ordering() const override { return solver.ordering(); }
    bool analyze_pattern(const Block_sparse_matrix& matrix) override { return solver.analyze_pattern(matrix); }
    void set_positions(const Eigen::VectorXd& positions) override
    {
      internal::give_positions(solver, [&]() -> const Eigen::VectorXd& { return positions; });
    }
    bool factorize(const Block_sparse_matrix& matrix) override { return solver.factorize(matrix); }
    bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) override { return solver.solve(b, x); }
    std::int64_t factor_entries() const override { return solver.factor_entries(); }
    int iterations() const override { return internal::inner_iterations(solver); }

    Solver solver;
  };

  explicit Any_linear_solver(std::unique_ptr<Base> solver) : m_solver(std::move(solver)) {}

  std::unique_ptr<Base> m_solver;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_ANY_LINEAR_SOLVER_H
