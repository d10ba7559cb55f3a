// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SOLVE_PLANAR_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SOLVE_PLANAR_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/initializers/internal/make_start.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/parallel_invoke.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Planar_request.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Relative decrease of the energy in an iteration at which a map is rough.
constexpr double ROUGH = 1e-3;

// Minimises, but stops where a rough map is hopeless.
template <typename Traits>
void minimize_unless_hopeless(const Planar_request& request, Map_minimizer<2, Traits>& minimizer, Positions<2>& x, Summary& summary)
{
  if(request.is_hopeless) {
    Map_options& options = minimizer.options();
    const Map_options given = options;
    options.relative_energy_tolerance = (std::max)(options.relative_energy_tolerance, ROUGH);
    minimizer.minimize(x, summary);
    if(summary.status != Status::success || request.is_hopeless(x))
      return;
    options = given;
    options.max_iterations = (std::max)(0, given.max_iterations - summary.iterations);
    options.keep_factorization = true;
  }
  minimizer.minimize(x, summary);
}

// Others know of no rough maps.
template <typename Minimizer>
void minimize_unless_hopeless(const Planar_request&, Minimizer& minimizer, Positions<2>& x, Summary& summary)
{
  minimizer.minimize(x, summary);
}

// Makes a start by `start()`, which tells whether it succeeded, and minimises. The pattern of the matrix does not depend on the
// start, so both are found at the same time; but not where the start may be the solution.
template <typename Traits, typename Start>
void start_and_minimize(const Planar_request& request, const Traits& traits, Start&& start, Positions<2>& x, Summary& summary)
{
  typename Traits::template Minimizer<2, Traits> minimizer(request.domain, traits, request.constraints);
  bool is_started = false;
  if(traits.start.unfold) {
    is_started = start();
  } else {
    Summary analysis;
    parallel_invoke<typename Traits::Concurrency_tag>([&] { is_started = start(); }, [&] { minimizer.analyze(analysis); });
    summary.seconds.analyze += analysis.seconds.analyze;
    summary.seconds.assemble += analysis.seconds.assemble;
  }
  if(is_started)
    minimize_unless_hopeless(request, minimizer, x, summary);
}

// Makes the start that is asked for. Returns whether there is one.
template <typename Traits>
bool make_requested_start(const Planar_request& request, const Traits& traits, Positions<2>& x, Summary& summary)
{
  const Phase_timer timer(summary.seconds.start);
  summary.status = request.make_start ? request.make_start(x, summary.start, summary.message)
                                      : make_start(request.domain, traits, x, summary.start, summary.message);
  return summary.status == Status::success;
}

// Flattens a disk by the method of `traits`, which are adapted to the surface before. The image may overlap itself:
// flips are all that matters.
template <typename Traits>
void solve_planar(const Planar_request& request, Traits& traits, Positions<2>& x, Summary& summary)
{
  adapt_to_developable(request.domain, traits);
  start_and_minimize(
    request, traits, [&] { return make_requested_start(request, traits, x, summary); }, x, summary);
}

// Certifies a map as it will be written, and counts its flips.
template <typename Traits>
bool certify_planar(const Planar_request& request, const Traits&, const Positions<2>& written, Summary& summary)
{
  return certify_flips<typename Traits::Kernel>(request.domain, written, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SOLVE_PLANAR_H
