// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_BIJECTIVE_MINIMIZER_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_BIJECTIVE_MINIMIZER_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Scaffold.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Minimises the mean energy of a disk with holes among the maps that are injective as a whole, borders included.
//
// The free optimum is taken if it is injective. Otherwise the map begins anew at an injective start and goes freely for as long
// as it stays injective; then what lies outside of it is triangulated and minimised along with it, with a small weight, again and
// again (Jiang, Schaefer and Panozzo 2017). No triangle of the outside flips, so the borders cannot pass through each other; its
// rest shape is always the present one, so it has no say about where the map finally comes to rest.
template <typename Traits>
class Bijective_minimizer
{
  using Minimizer = typename Traits::template Minimizer<2, Traits>;

public:
  // Keeps references to `domain` and `constraints`.
  Bijective_minimizer(const Simplicial_domain<2>& domain, const Traits& traits, const Position_constraints<2>& constraints)
    : m_domain(domain), m_traits(traits), m_constraints(constraints), m_minimizer(domain, traits, constraints)
  {}

  // `x` is the start, and the result if the summary is valid. `keeps_start` says that no other start may be taken instead.
  void minimize(Positions<2>& x, bool keeps_start, Summary& summary)
  {
    const double time_begin = wall_seconds();
    const Positions<2> start = x;
    m_minimizer.minimize(x, summary);
    if(!summary.is_valid() || is_injective(x, summary))
      return;
    const Status ended = summary.status;
    m_is_stopped = ended == Status::stopped_by_observer;
    m_first_iteration = summary.iterations;
    m_time_end = time_begin + m_traits.options.max_seconds;

    x = start;
    if(!is_injective(x, summary) && (keeps_start || !embed(x, summary) || !is_injective(x, summary))) {
      summary.status = Status::not_bijective;
      summary.message = "the map overlaps itself, and so does the start: a map whose border does not cross itself is needed to begin with";
      return;
    }
    const double energy_initial = look(x).energy;
    go_freely(x, summary);
    Summary rest = look(x);
    int small_decreases = 0;
    std::string message;
    Status status = Status::success;
    for(;;) {
      if(rest.status == Status::success) {
        message = rest.message;
        break;
      }
      if(small_decreases >= STAGNATION) {
        message = "the energy hardly decreases without an overlap";
        break;
      }
      const double energy = rest.energy;
      if(has_reached_limit(summary, status, message) || !go_with_scaffold(x, energy, summary, status, message))
        break;
      rest = look(x);
      small_decreases = energy - rest.energy <= tolerance() * energy ? small_decreases + 1 : 0;
    }
    // The account of the result, without the outside.
    m_minimizer.options().max_iterations = 0;
    m_minimizer.options().observer = nullptr;
    m_minimizer.minimize(x, summary);
    summary.energy_initial = energy_initial;
    if(summary.is_valid()) {
      summary.status = status;
      summary.message = message;
      if(!is_injective(x, summary)) {
        summary.status = Status::not_bijective;
        summary.message = "the map overlaps itself";
      }
    }
  }

private:
  // Weight of the outside over the energy of the map, in the beginning.
  static constexpr double WEIGHT = 0.01;
  // Factor of that weight after each triangulation that hindered nothing.
  static constexpr double RELAXATION = 0.5;
  // Below this, borders would come as close to each other as the numbers allow.
  static constexpr double LEAST_WEIGHT = 1e-4;
  // Steps between two tests or two triangulations.
  static constexpr int STEPS = 2;
  // A step that a collapsing triangle ends before this length asks for another triangulation.
  static constexpr double THROTTLED = 0.3;
  // Relative decrease of the energy from one triangulation to the next that counts as none,
  // and how often in a row that ends the run.
  static constexpr double TOLERANCE = 5e-5;
  static constexpr int STAGNATION = 2;

  double tolerance() const
  {
    return m_traits.options.relative_energy_tolerance > 0 ? m_traits.options.relative_energy_tolerance : TOLERANCE;
  }

  bool is_injective(const Positions<2>& x, Summary& summary) const
  {
    const Phase_timer timer(summary.seconds.certify);
    summary.is_bijective = is_bijective(m_domain, x);
    return *summary.is_bijective;
  }

  bool embed(Positions<2>& x, Summary& summary) const
  {
    const Phase_timer timer(summary.seconds.start);
    std::string name, message;
    const Status status =
      Tutte_initializer<typename Traits::Kernel, typename Traits::Linear_solver, typename Traits::Concurrency_tag>(m_traits.start)(
        m_domain, [this] { return m_traits.make_linear_solver(); }, x, name, message);
    if(status == Status::success)
      summary.start = name + ", because the map from this start overlaps itself: " + summary.start;
    return status == Status::success;
  }

  // Energy and gradient of a map.
  Summary look(const Positions<2>& x)
  {
    m_minimizer.options().max_iterations = 0;
    m_minimizer.options().observer = nullptr;
    Summary summary;
    Positions<2> same = x;
    m_minimizer.minimize(same, summary);
    return summary;
  }

  bool has_reached_limit(const Summary& summary, Status& status, std::string& message) const
  {
    if(m_is_stopped) {
      status = Status::stopped_by_observer;
      message = "the observer asked to stop";
    } else if(summary.iterations - m_first_iteration >= m_traits.options.max_iterations) {
      status = Status::iteration_limit;
      message = "the limit of iterations is reached";
    } else if(wall_seconds() >= m_time_end) {
      status = Status::time_limit;
      message = "the limit of time is reached";
    }
    return status != Status::success;
  }

  // Limits of a few steps, and an observer that asks the user's one.
  void set_options(Map_options& options, const Summary& summary, int steps, double energy_outside, bool ends_when_throttled)
  {
    options.max_iterations = (std::min)(steps, m_traits.options.max_iterations - (summary.iterations - m_first_iteration));
    options.max_seconds = (std::max)(0., m_time_end - wall_seconds());
    options.observer = [this, energy_outside, ends_when_throttled, first = summary.iterations](const Iteration_report& report) {
      if(report.iteration == first)
        return true;
      if(m_traits.options.observer) {
        Iteration_report told = report;
        told.energy -= energy_outside;
        m_is_stopped = !m_traits.options.observer(told);
      }
      m_is_throttled = report.step < THROTTLED && report.step >= 0.5 * report.largest_step;
      return !m_is_stopped && !(ends_when_throttled && m_is_throttled);
    };
  }

  void go_freely(Positions<2>& x, Summary& summary)
  {
    Status status = Status::success;
    std::string message;
    int steps = STEPS;
    while(steps > 0 && !has_reached_limit(summary, status, message)) {
      Positions<2> y = x;
      set_options(m_minimizer.options(), summary, steps, 0, false);
      m_minimizer.minimize(y, summary);
      if(!summary.is_valid())
        return;
      if(!is_injective(y, summary)) {
        steps /= 2;
        continue;
      }
      x.swap(y);
      if(summary.converged())
        return;
    }
  }

  // A few steps among triangles outside. False when there is no way on.
  bool go_with_scaffold(Positions<2>& x, double energy, Summary& summary, Status& status, std::string& message)
  {
    Scaffold scaffold;
    {
      const Phase_timer timer(summary.seconds.line_search);
      if(!scaffold.build(m_domain, x)) {
        status = Status::not_bijective;
        message = "the outside of the map could not be triangulated";
        return false;
      }
    }
    const Simplicial_domain<2> extended = scaffold.extend(m_domain, m_weight * energy);
    Position_constraints<2> constraints = m_constraints;
    constraints.fixed_vertices.insert(constraints.fixed_vertices.end(), scaffold.fixed_vertices().begin(), scaffold.fixed_vertices().end());
    Traits traits = m_traits;
    traits.options.characteristic_gradient_tolerance = traits.options.gradient_tolerance = 0;
    traits.options.relative_energy_tolerance = tolerance();
    traits.options.target_energy = -std::numeric_limits<double>::infinity();
    set_options(traits.options, summary, STEPS, m_weight * energy, true);
    Positions<2> y = scaffold.positions();
    Minimizer(extended, traits, constraints).minimize(y, summary);
    if(summary.is_valid()) {
      x = y.leftCols(m_domain.number_of_vertices);
      if(!m_is_throttled)
        m_weight = (std::max)(RELAXATION * m_weight, LEAST_WEIGHT);
      return true;
    }
    // Where borders are as near to each other as numbers can tell, there may be no step.
    if(summary.status == Status::line_search_failed || summary.status == Status::start_not_flip_free) {
      m_weight = WEIGHT;
      return true;
    }
    status = summary.status;
    message = summary.message;
    return false;
  }

  const Simplicial_domain<2>& m_domain;
  const Traits m_traits;
  const Position_constraints<2>& m_constraints;
  Minimizer m_minimizer;
  int m_first_iteration = 0;
  double m_time_end = 0;
  double m_weight = WEIGHT;
  bool m_is_stopped = false;
  bool m_is_throttled = false;
};

// The same as `solve_planar()`, but the map is to be injective as a whole where the request says so.
template <typename Traits>
void solve_bijectively(const Planar_request& request, Traits& traits, Positions<2>& x, Summary& summary)
{
  if(!request.is_bijective) {
    solve_planar(request, traits, x, summary);
    return;
  }
  adapt_to_developable(request.domain, traits);
  if(make_requested_start(request, traits, x, summary))
    Bijective_minimizer<Traits>(request.domain, traits, request.constraints).minimize(x, request.keeps_start, summary);
}

// Whether a map is still injective, where the request says so, in the numbers that the user receives.
template <typename Traits>
bool certify_injective(const Planar_request& request, const Traits&, const Positions<2>& written, Summary& summary)
{
  if(!request.is_bijective)
    return true;
  summary.is_bijective = is_bijective(request.domain, written, &summary.message);
  if(*summary.is_bijective)
    return true;
  summary.status = Status::not_bijective;
  summary.message = "the map overlaps itself when it is converted to the number type of the result: " + summary.message;
  return false;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_BIJECTIVE_MINIMIZER_H
