// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CURRENT_FACTORIZATION_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CURRENT_FACTORIZATION_H

#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Renewed_factorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The preconditioner's matrix as it was factorized last: whether it may serve again, and for how long it has.
template <int D, typename Traits>
class Current_factorization
{
  using Run = Minimizer_run<D>;
  using Solver = Robust_solver<typename Traits::Linear_solver>;

public:
  // Keeps references to both.
  Current_factorization(Traits& traits, Map_objective<D, Traits>& objective)
    : m_traits(traits), m_objective(objective), m_linear_solver(traits.make_linear_solver()), m_solver(m_linear_solver)
  {}

  [[nodiscard]] typename Solver::Reporting report_to(Summary& summary) { return m_solver.report_to(summary); }

  // Analyses the pattern of the matrix if that has not been done.
  bool analyze(Summary& summary)
  {
    if(m_is_analyzed)
      return true;
    {
      const Phase_timer timer(summary.seconds.assemble);
      m_objective.build_pattern();
    }
    const auto reporting = m_solver.report_to(summary);
    m_is_analyzed = !m_objective.has_unknowns() || m_solver.analyze_pattern(m_objective.matrix());
    return m_is_analyzed;
  }

  bool is_analyzed() const { return m_is_analyzed; }

  // Nothing of the pattern holds any more.
  void forget_pattern() { m_is_analyzed = m_exists = false; }

  // Whether there is a factorization that may be used.
  bool exists() const { return m_exists; }

  void discard() { m_exists = false; }

  // The factorization may be used for a map it was not made for, if it is one at all.
  void keep_for_other_map(bool keeps)
  {
    m_exists = keeps;
    m_age = (std::max)(m_age, 1);
  }

  // Accepted steps since the factorization.
  int age() const { return m_age; }

  void grow_older() { ++m_age; }

  // Whether the next direction takes a factorization.
  Refactorization next(const Minimizer_progress& progress) const
  {
    if(!m_exists)
      return Refactorization::restart;
    if(is_constant(m_traits.preconditioner) || m_age == 0)
      return Refactorization::none;
    return m_traits.refactorization_rule(m_age, progress.step, progress.relative_decrease);
  }

  // Whether the acceleration needs a matrix that is not the one of the last factorization.
  bool multiplies_by_current_matrix() const { return needs_current_matrix(m_traits.acceleration) && !is_constant(m_traits.preconditioner); }

  // Factorizes the objective's matrix at run.x.
  bool factorize(Run& run)
  {
    m_exists = true;
    m_age = 0;
    m_map = run.x;
    m_renewed.clear();
    give_positions(m_linear_solver, [&]() -> const Eigen::VectorXd& {
      m_objective.gather(run.x, run.unknowns);
      return run.unknowns;
    });
    finish_matrix(run);
    if(can_retreat(m_traits.preconditioner)) {
      if(m_solver.try_to_factorize(m_objective.matrix()))
        return true;
      retreat(run);
      run.differentiate(m_objective, m_traits.reference, true);
      finish_matrix(run);
    }
    return m_solver.factorize(m_objective.matrix(), run.shift);
  }

  // Takes the more careful form of a preconditioner that has one. `false` if it is in use already.
  bool retreat(Run& run)
  {
    if(!can_retreat(m_traits.preconditioner))
      return false;
    internal::retreat(m_traits.preconditioner);
    ++run.summary.fallbacks;
    return true;
  }

  // Makes the assembled matrix regular.
  void finish_matrix(const Run& run)
  {
    Block_sparse_matrix& matrix = m_objective.matrix();
    if(run.options.tikhonov > 0)
      for(Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
        matrix.diagonal(i) += run.options.tikhonov;
    // Translations are in the null space of every preconditioner. Stiffness on one vertex removes them without changing the
    // solution, since the gradient is orthogonal to them.
    if(m_objective.is_rigid_motion_invariant() && m_objective.world().owns_first_unknown())
      for(int i = 0; i < D; ++i)
        matrix.diagonal(i) *= 2;
  }

  // Brings a factorization that is kept up to date where the map has changed most. It needs the matrix that was factorized.
  void renew(const Run& run)
  {
    if(m_age == 0 || !run.options.renew_factorization || is_constant(m_traits.preconditioner) ||
       needs_current_matrix(m_traits.acceleration))
      return;
    const Phase_timer timer(run.summary.seconds.assemble);
    m_renewed.renew(m_objective, m_traits.reference, m_map, run.x);
  }

  // Solves with the factorization, as it was renewed.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& y)
  {
    return m_renewed.solve(
      b, [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) { return m_solver.solve(r, z); }, y);
  }

  // Solves with the factorization as it was made.
  bool solve_as_made(const Eigen::VectorXd& b, Eigen::VectorXd& y) { return m_solver.solve(b, y); }

private:
  Traits& m_traits;
  Map_objective<D, Traits>& m_objective;
  typename Traits::Linear_solver m_linear_solver;
  Solver m_solver;
  Renewed_factorization<D> m_renewed;
  Positions<D> m_map; // that was factorized
  bool m_is_analyzed = false;
  bool m_exists = false;
  int m_age = 0;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CURRENT_FACTORIZATION_H
