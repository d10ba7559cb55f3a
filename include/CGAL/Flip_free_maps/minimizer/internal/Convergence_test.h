// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CONVERGENCE_TEST_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CONVERGENCE_TEST_H

#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Current_factorization.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Step_finder.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The stopping rules and limits of Map_minimizer.
template <int D, typename Traits>
class Convergence_test
{
  using Run = Minimizer_run<D>;

public:
  // Keeps references to both.
  Convergence_test(Current_factorization<D, Traits>& factorization, const Step_finder<D, Traits>& steps)
    : m_factorization(factorization), m_steps(steps)
  {}

  // Asks the observer, the stopping rules and the limits, in this order. `factorizes`: whether to go on takes a factorization.
  bool has_ended(Run& run, bool factorizes) const
  {
    const double seconds = wall_seconds() - run.time_begin;
    if(is_stopped(run, seconds))
      return !run.finish(Status::stopped_by_observer, "the observer asked to stop");
    if(run.is_rest_reference) {
      const char* rule = rule_that_holds(run, factorizes);
      if(rule != nullptr)
        return !run.finish(Status::success, rule);
    }
    if(run.iterations() >= run.options.max_iterations)
      return !run.finish(Status::iteration_limit, "the limit of iterations is reached");
    // Clocks differ: what one process sees counts for all.
    const Status late = static_cast<Status>(m_steps.world().maximum(static_cast<int>(deadline_status())));
    return late != Status::success && !run.finish(late, Interruption(late).what());
  }

  // Where the energy is astronomical, by few elements that nearly collapse, small changes of it say nothing. Where it is not, a
  // large gradient says nothing: that of a needle is large as soon as it is not a perfect isometry.
  static bool is_nearly_stationary(const Run& run)
  {
    return run.progress.characteristic_gradient_norm <= 1 || run.progress.rest_energy <= run.energy_of_isometry + ASTRONOMICAL;
  }

private:
  // Whether the observer, or that of another process, wants no more.
  bool is_stopped(const Run& run, double seconds) const
  {
    if(!m_steps.world().any(bool(run.options.observer)))
      return false;
    const Iteration_report now = report(run, seconds);
    return m_steps.world().any(run.options.observer && !run.options.observer(now));
  }

  // The stopping rule that is met, null if none is.
  const char* rule_that_holds(Run& run, bool factorizes) const
  {
    const Minimizer_progress& progress = run.progress;
    const Map_options& options = run.options;
    if(progress.energy <= options.target_energy)
      return "the target energy is reached";
    if(options.gradient_tolerance > 0 && progress.gradient_norm <= options.gradient_tolerance)
      return "the norm of the gradient is within its tolerance";
    if(progress.characteristic_gradient_norm <= options.characteristic_gradient_tolerance)
      return "the characteristic norm of the gradient is within its tolerance";
    if(run.iterations() == 0 || !(options.relative_energy_tolerance > 0))
      return nullptr;
    return options.careful_stagnation                                                  ? careful_rule_of_energy(run, factorizes)
           : std::abs(progress.relative_decrease) <= options.relative_energy_tolerance ? SMALL_DECREASE
                                                                                       : nullptr;
  }

  const char* careful_rule_of_energy(Run& run, bool factorizes) const
  {
    const Minimizer_progress& progress = run.progress;
    const Map_options& options = run.options;
    if(!is_nearly_stationary(run))
      return nullptr;
    const bool is_full_step = progress.fresh && progress.step >= 0.5;
    // A step that goes far beyond the minimum along its direction may decrease the energy by as little as one that ends the run.
    if(progress.relative_decrease <= options.relative_energy_tolerance &&
       (progress.small_decreases >= options.stagnation_iterations ||
        (is_full_step && progress.predicted_decrease <= MODEL_ERROR * options.relative_energy_tolerance)))
      return SMALL_DECREASE;
    if(is_full_step && factorizes && predicts_small_decrease(run, options.relative_energy_tolerance / MODEL_ERROR))
      return "the predicted relative decrease of the energy is within its tolerance";
    return nullptr;
  }

  // Whether the model of the last step, with the gradient of now, predicts a relative decrease of at most `tolerance`: a solve
  // instead of the factorization of an iteration that would only confirm convergence.
  // The norms of the gradients say when it is worth it.
  bool predicts_small_decrease(Run& run, double tolerance) const
  {
    const Minimizer_progress& progress = run.progress;
    const double drop = progress.gradient_norm / progress.last_gradient_norm;
    if(!m_factorization.exists() || !(progress.predicted_decrease * drop * drop <= tolerance) ||
       !m_factorization.solve_as_made(run.gradient, run.direction))
      return false;
    return 0.5 * m_steps.world().dot(run.gradient, run.direction) <= tolerance * std::abs(progress.energy);
  }

  Iteration_report report(const Run& run, double seconds) const
  {
    Iteration_report report;
    report.iteration = run.summary.iterations;
    report.seconds = seconds;
    report.energy = run.progress.rest_energy;
    report.gradient_norm = run.progress.gradient_norm;
    report.characteristic_gradient_norm = run.progress.characteristic_gradient_norm;
    report.step = run.progress.step;
    report.largest_step = run.progress.largest_step;
    report.factorizations = run.summary.factorizations;
    report.flips = m_steps.flips(run.x);
    return report;
  }

  static constexpr const char* SMALL_DECREASE = "the relative decrease of the energy is within its tolerance";
  // Mean energy above that of an isometry from which on a few elements make up most of it.
  static constexpr double ASTRONOMICAL = 10;
  // Preconditioners overestimate curvature, and decreases are predicted too small by such a factor.
  static constexpr double MODEL_ERROR = 10;

  Current_factorization<D, Traits>& m_factorization;
  const Step_finder<D, Traits>& m_steps;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CONVERGENCE_TEST_H
