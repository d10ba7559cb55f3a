// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_PATH_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_PATH_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Current_factorization.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Handle_groups.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Step_finder.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Leads the fixed vertices to their targets. In each round the quadratic model is minimised with the fixed vertices at their
// targets, or part of the way to them; the map goes in that direction half as far as it could without a flip,
// and is then optimised a little.
template <int D, typename Traits>
class Handle_path
{
  using Run = Minimizer_run<D>;
  using World = typename World_of<Traits>::type;

public:
  // Keeps references to all.
  Handle_path(const Simplicial_domain<D>& domain, const Traits& traits, Map_objective<D, Traits>& objective,
              Current_factorization<D, Traits>& factorization, const Step_finder<D, Traits>& steps)
    : m_traits(traits),
      m_objective(objective),
      m_factorization(factorization),
      m_steps(steps),
      m_groups(domain, [&objective](std::int32_t v) { return objective.is_fixed(v); })
  {
    if constexpr(!World::is_sequential)
      m_groups.join(objective.world());
  }

  // Goes the whole way. `optimize(run)` iterates until run.options end it. Where the way is blocked, or a limit ends the run on it,
  // the run is finished, and the result `false`.
  template <typename Optimize>
  bool follow(Run& run, const Positions<D>& targets, Optimize&& optimize)
  {
    const Map_options options = run.options;
    carry(run, targets);
    for(int round = 0; round < MAX_ROUNDS; ++round) {
      bool is_last = false;
      Positions<D> handles = Positions<D>::Zero(D, run.x.cols());
      if(!m_groups.next_displacement(run.x, targets, handles, is_last))
        return run.finish(Status::non_finite_input, "a target is NaN or infinite");
      if((handles.array() == 0).all()) {
        run.options = options;
        return true;
      }
      const bool reuses = m_factorization.exists() && round == 0 && options.keep_factorization;
      if(!find_displacement(run, handles, reuses))
        return false;
      bool arrives = false;
      if(!advance(run, targets, is_last, arrives))
        return false;
      // The matrix is one of an earlier map now.
      m_factorization.keep_for_other_map(reuses);
      if(arrives)
        continue;
      relax(run, options, optimize);
      if(run.summary.status == Status::stopped_by_observer || run.summary.status == Status::time_limit)
        return false;
      if(!run.summary.is_valid())
        return run.summary.status == Status::linear_solver_failed || run.summary.status == Status::invalid_option
                 ? false
                 : run.finish(Status::unreachable_constraints,
                              "the run ended before the fixed vertices reached their positions: " + std::string(run.summary.message));
    }
    return run.finish(Status::unreachable_constraints,
                      "the fixed vertices did not reach their positions in " + std::to_string(MAX_ROUNDS) + " rounds");
  }

private:
  // Moves the whole shape with handles that move as a rigid body, unless a part of it is to stay in its place.
  void carry(Run& run, const Positions<D>& targets)
  {
    if(m_objective.has_sliding_vertices() || !m_groups.carry(run.x, targets, run.trial))
      return;
    // What several processes compute may differ in the last bit.
    if constexpr(!World::is_sequential) {
      m_objective.world().update_ghosts(run.trial);
      m_groups.share(m_objective.world(), run.trial);
    }
    if(!m_steps.is_certified(run, run.trial))
      return;
    run.x.swap(run.trial);
    run.measure(m_objective, m_traits.reference);
    m_factorization.discard();
  }

  // The displacement of all vertices that minimises the quadratic model when the fixed vertices are displaced by `handles`.
  bool find_displacement(Run& run, const Positions<D>& handles, bool reuses)
  {
    if(!m_objective.has_unknowns()) {
      run.displacement = handles;
      return true;
    }
    Eigen::VectorXd product;
    m_objective.multiply(m_traits.reference, run.x, handles, product);
    run.differentiate(m_objective, m_traits.reference, !reuses);
    if(!m_objective.terms_keep_to_stencils())
      return run.finish(Status::invalid_option, m_objective.FOREIGN_BLOCK);
    if((!reuses && !m_factorization.factorize(run)) ||
       !m_factorization.solve_as_made(Eigen::VectorXd(run.gradient + product), run.direction))
      return run.finish(Status::linear_solver_failed, "no direction was found while the fixed vertices moved");
    m_objective.spread(-run.direction, run.displacement);
    run.displacement += handles;
    return true;
  }

  // Goes along the displacement as far as elements allow it.
  bool advance(Run& run, const Positions<D>& targets, bool is_last, bool& arrives) const
  {
    const double largest = m_steps.largest_step(run);
    double step = 0.5 * largest >= 1 ? 1 : 0.5 * largest;
    for(;; step *= 0.5) {
      ask_deadline();
      run.trial = run.x + step * run.displacement;
      // The vertices arrive exactly.
      arrives = step == 1 && is_last;
      if(arrives)
        m_groups.place(targets, run.trial);
      if(std::isfinite(m_objective.energy(m_traits.reference, run.trial)) && m_steps.is_certified(run, run.trial))
        break;
      if(step < SHORTEST_ROUND)
        return run.finish(Status::unreachable_constraints, "no path without flips leads to the positions of the fixed vertices");
    }
    run.x.swap(run.trial);
    run.measure(m_objective, m_traits.reference);
    return true;
  }

  template <typename Optimize>
  void relax(Run& run, const Map_options& options, Optimize&& optimize)
  {
    run.options = options;
    run.options.max_iterations = run.iterations() + STEPS_PER_ROUND;
    run.options.relative_energy_tolerance = 0.01;
    run.progress.relative_decrease = std::numeric_limits<double>::infinity();
    run.progress.small_decreases = 0;
    run.retries = 0;
    m_factorization.discard();
    optimize(run);
  }

  // Rounds, iterations between them, and the shortest part of the rest of the way.
  static constexpr int MAX_ROUNDS = 300;
  static constexpr int STEPS_PER_ROUND = 4;
  static constexpr double SHORTEST_ROUND = 1e-8;

  const Traits& m_traits;
  Map_objective<D, Traits>& m_objective;
  Current_factorization<D, Traits>& m_factorization;
  const Step_finder<D, Traits>& m_steps;
  Handle_groups<D> m_groups;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_PATH_H
