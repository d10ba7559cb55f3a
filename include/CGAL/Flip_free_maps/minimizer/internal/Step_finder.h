// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_STEP_FINDER_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_STEP_FINDER_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Finds steps along directions after which no element is flipped, and has the last word on maps.
template <int D, typename Traits>
class Step_finder
{
  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Run = Minimizer_run<D>;

public:
  // Keeps references to all.
  Step_finder(const Simplicial_domain<D>& domain, const Traits& traits, Map_objective<D, Traits>& objective)
    : m_domain(domain), m_traits(traits), m_objective(objective)
  {}

  const typename World_of<Traits>::type& world() const { return m_objective.world(); }

  bool allows_flips() const { return m_traits.options.allow_flips && !has_barrier(); }

  bool has_barrier() const { return internal::has_barrier(m_traits.energy); }

  std::int64_t flips(const Positions<D>& x) const
  {
    const std::int64_t own = count_flips<Kernel, Tag>(m_domain, m_objective.schedule(), x);
    return static_cast<std::int64_t>(m_objective.world().sum(static_cast<double>(own)));
  }

  // The step along the displacement at which the first element collapses.
  double largest_step(const Run& run) const
  {
    return allows_flips() ? std::numeric_limits<double>::infinity() : m_objective.largest_step(run.x, run.displacement);
  }

  // A step along the displacement after which no element is flipped. Leaves the new positions in `trial`.
  Line_search_result operator()(Run& run, double slope) const
  {
    const Phase_timer timer(run.summary.seconds.line_search);
    Line_search_result found;
    run.progress.largest_step = largest_step(run);
    double largest = run.progress.largest_step;
    // Long steps make up for a model that overestimates curvature, and do harm where it is right.
    Map_options options = run.options;
    if(options.backtracking == 0)
      options.begin_with_largest_step = options.begin_with_largest_step && !(run.progress.model_ratio <= TRUSTED_MODEL);
    // Rounding may leave an element of the accepted candidate collapsed or flipped although its energy was finite; then a
    // shorter step is searched.
    for(int i = 0; i < 10; ++i) {
      found = line_search(
        [&](double step) {
          ask_deadline();
          run.trial = run.x + step * run.displacement;
          return m_objective.energy(m_traits.reference, run.trial);
        },
        run.progress.energy, slope, largest, run.options.extend_steps && m_traits.preconditioner.is_second_order, options);
      run.summary.energy_evaluations += found.evaluations;
      if(!found.success)
        break;
      run.trial = run.x + found.step * run.displacement;
      if(is_certified(run, run.trial))
        break;
      largest = found.step;
      found.success = false;
    }
    return found;
  }

  // After a short step that ends at a collapsing element: moves the vertices that hold up the others.
  void free_blocked_vertices(Run& run, Line_search_result& found) const
  {
    if(!run.options.free_blocked_vertices || !(found.step < THROTTLED) || !(found.step >= 0.5 * run.progress.largest_step))
      return;
    const Phase_timer timer(run.summary.seconds.line_search);
    m_objective.free_blocked_vertices(
      m_traits.reference, run.displacement, BLOCKED * run.progress.largest_step,
      [this](std::int64_t e, const Positions<D>& y) { return is_element_certified(e, y); }, run.trial);
    found.energy = m_objective.energy(m_traits.reference, run.trial);
  }

  // Whether x may follow run.x.
  bool is_certified(Run& run, const Positions<D>& x) const
  {
    const Phase_timer timer(run.summary.seconds.certify);
    return allows_flips() || (flips(x) == 0 && keeps_distance(run.x, x));
  }

private:
  // Energies without a barrier draw elements into their collapse. So close to it that the result would not bear being scaled they
  // come no closer.
  bool keeps_distance(const Positions<D>& before, const Positions<D>& after) const
  {
    if(has_barrier())
      return true;
    const double distance = m_objective.singular_value_range(after).first;
    return distance >= COLLAPSED || distance >= m_objective.singular_value_range(before).first;
  }

  bool is_element_certified(std::int64_t e, const Positions<D>& x) const
  {
    return is_positively_oriented<Kernel>(m_domain.elements[e], x) &&
           (has_barrier() || signed_singular_values(m_domain.jacobian(e, x))[D - 1] >= COLLAPSED);
  }

  // Smallest singular value of elements where no barrier keeps them from collapsing.
  static constexpr double COLLAPSED = 1e-6;
  // A step below THROTTLED that ends at a collapsing element frees the elements that collapse within BLOCKED times its bound.
  static constexpr double THROTTLED = 0.3;
  static constexpr double BLOCKED = 4;
  // Decrease of the energy over the predicted one up to which the quadratic model counts as right.
  static constexpr double TRUSTED_MODEL = 1.1;

  const Simplicial_domain<D>& m_domain;
  const Traits& m_traits;
  Map_objective<D, Traits>& m_objective;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_STEP_FINDER_H
