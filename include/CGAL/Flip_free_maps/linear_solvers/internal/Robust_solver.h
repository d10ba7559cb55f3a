// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ROBUST_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ROBUST_SOLVER_H

#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <algorithm>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A linear solver that does not give up: when the factorization fails, Eigen's LDL^T is tried on the same matrix, then a growing
// multiple of the diagonal is added. All work is entered into the Summary of the innermost Reporting that lives.
template <typename LinearSolver>
class Robust_solver
{
public:
  // As long as this lives, work is entered into a summary of the caller's, which need not live longer.
  class Reporting
  {
  public:
    Reporting(Robust_solver& solver, Summary& summary) : m_solver(solver), m_before(solver.m_summary)
    {
      m_solver.m_summary = &summary;
      m_solver.report();
    }

    ~Reporting() { m_solver.m_summary = m_before; }

    Reporting(const Reporting&) = delete;
    Reporting& operator=(const Reporting&) = delete;

  private:
    Robust_solver& m_solver;
    Summary* m_before;
  };

  explicit Robust_solver(LinearSolver& solver) : m_solver(solver) {}

  Robust_solver(const Robust_solver&) = delete;
  Robust_solver& operator=(const Robust_solver&) = delete;

  [[nodiscard]] Reporting report_to(Summary& summary) { return Reporting(*this, summary); }

  // May be called again, for another matrix.
  bool analyze_pattern(const Block_sparse_matrix& matrix)
  {
    ask_deadline();
    const Phase_timer timer(m_summary->seconds.analyze);
    m_fallback.reset();
    m_fallback_is_current = false;
    if(!m_solver.analyze_pattern(matrix) && !analyze_fallback(matrix))
      return false;
    report();
    return true;
  }

  // Factorizes the matrix as it is, once.
  bool try_to_factorize(const Block_sparse_matrix& matrix)
  {
    ask_deadline();
    ask_deadline();
    const Phase_timer timer(m_summary->seconds.factorize, &m_summary->factorize_cpu_seconds);
    ++m_summary->factorizations;
    m_fallback_is_current = false;
    return m_solver.factorize(matrix);
  }

  // Adds `shift` times the diagonal and factorizes.
  bool factorize(Block_sparse_matrix& matrix, double shift)
  {
    add_to_diagonal(matrix, shift);
    if(factorize_once(matrix))
      return true;
    for(double s = (std::max)(1e-8, 10 * shift); s <= 1e4; s *= 10) {
      add_to_diagonal(matrix, s);
      if(factorize_once(matrix))
        return true;
    }
    return false;
  }

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    ask_deadline();
    const Phase_timer timer(m_summary->seconds.solve);
    ++m_summary->linear_solves;
    if(m_fallback_is_current)
      return m_fallback->solve(b, x);
    const bool solved = m_solver.solve(b, x);
    m_summary->inner_iterations += inner_iterations(m_solver);
    return solved;
  }

private:
  void report()
  {
    m_summary->linear_solver = m_solver.name();
    m_summary->ordering = m_solver.ordering();
    m_summary->factor_entries = m_solver.factor_entries();
    if(m_fallback != nullptr)
      m_summary->linear_solver += ", then " + m_fallback->name();
  }

  bool analyze_fallback(const Block_sparse_matrix& matrix)
  {
    // A solver of the whole matrix is none of its parts.
    if constexpr(Has_part_of_matrix<LinearSolver>::value)
      return false;
    if(m_fallback == nullptr) {
      m_fallback = std::make_unique<Eigen_simplicial_solver>();
      if(!m_fallback->analyze_pattern(matrix))
        return false;
    }
    return true;
  }

  bool factorize_once(const Block_sparse_matrix& matrix)
  {
    if(try_to_factorize(matrix)) {
      report();
      return true;
    }
    {
      const Phase_timer timer(m_summary->seconds.analyze);
      if(!analyze_fallback(matrix))
        return false;
    }
    const Phase_timer timer(m_summary->seconds.factorize, &m_summary->factorize_cpu_seconds);
    ++m_summary->factorizations;
    m_fallback_is_current = m_fallback->factorize(matrix);
    report();
    return m_fallback_is_current;
  }

  static void add_to_diagonal(Block_sparse_matrix& matrix, double shift)
  {
    for(Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
      matrix.diagonal(i) *= 1 + shift;
  }

  LinearSolver& m_solver;
  Summary m_unread; // takes what nobody asked for
  Summary* m_summary = &m_unread;
  std::unique_ptr<Eigen_simplicial_solver> m_fallback;
  bool m_fallback_is_current = false;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ROBUST_SOLVER_H
