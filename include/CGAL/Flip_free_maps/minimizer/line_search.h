// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_LINE_SEARCH_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_LINE_SEARCH_H

#include <CGAL/Flip_free_maps/method/Map_options.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// What a line search found.
struct Line_search_result
{
  bool success = false; ///< whether the energy decreases sufficiently
  double step = 0;      ///< the step, 0 without success
  double energy = 0;    ///< the energy there
  int evaluations = 0;  ///< energies computed
};

namespace internal {

// A direction along which nothing collapses for so long is hardly limited by its elements.
constexpr double LARGEST_FIRST_STEP = 1e3;

// Sufficient decrease. Close to a minimum the bound rounds to the energy itself, hence the second test.
inline bool is_sufficient(double energy, double energy_0, double slope, double step, double armijo)
{
  return std::isfinite(energy) && energy <= energy_0 + armijo * step * slope && energy < energy_0;
}

// Plain backtracking from `step` on.
template <typename Energy>
Line_search_result backtrack(Energy&& energy, double energy_0, double slope, double step, const Map_options& options)
{
  Line_search_result result;
  for(; result.evaluations < options.max_line_search_steps && !result.success; step *= options.backtracking) {
    const double e = energy(step);
    ++result.evaluations;
    if(is_sufficient(e, energy_0, slope, step, options.armijo)) {
      result.success = true;
      result.step = step;
      result.energy = e;
    }
  }
  return result;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Finds a step along a descent direction at which the energy has decreased sufficiently (Armijo), never beyond
/// `options.step_fraction` of `largest_step`. It begins at the full step, or at the bound where that is shorter or where
/// `options.begin_with_largest_step` asks for it; goes back by safeguarded quadratic interpolation, from beyond the full step by
/// halves; and, when `extend` is true, goes on beyond an accepted first step while the energy decreases: a projected Hessian
/// overestimates curvature, so its full step is often too short. With `options.backtracking` it only goes back, by that factor. NaN and
/// infinite energies count as too large; the number of evaluations is bounded.
///
/// \tparam Energy a functor: the energy at step a, `double operator()(double a)`; +infinity where an element is not positive
/// \param energy the energy along the direction
/// \param energy_0 the energy at step 0
/// \param slope its derivative there, negative
/// \param largest_step the step at which the first element collapses
/// \param extend whether steps beyond the full one are tried
/// \param options `armijo`, `step_fraction`, `backtracking`, `begin_with_largest_step` and `max_line_search_steps` are used
template <typename Energy>
Line_search_result line_search(Energy&& energy, double energy_0, double slope, double largest_step, bool extend, const Map_options& options)
{
  Line_search_result result;
  const double bound = options.step_fraction * largest_step;
  if(options.backtracking > 0)
    return internal::backtrack(energy, energy_0, slope,
                               options.begin_with_largest_step && std::isfinite(bound) ? bound : (std::min)(1., bound), options);
  const bool begins_with_bound = extend && options.begin_with_largest_step && bound < internal::LARGEST_FIRST_STEP;
  double step = begins_with_bound ? bound : (std::min)(1., bound);
  for(; result.evaluations < options.max_line_search_steps;) {
    const double e = energy(step);
    ++result.evaluations;
    if(internal::is_sufficient(e, energy_0, slope, step, options.armijo)) {
      result.success = true;
      result.step = step;
      result.energy = e;
      break;
    }
    const double minimum = -0.5 * slope * step * step / (e - energy_0 - slope * step);
    if(step > 1) {
      step = (std::max)(1., 0.5 * step);
      continue;
    }
    step = minimum >= 0.1 * step && minimum <= 0.6 * step ? minimum : 0.5 * step;
    extend = false;
  }
  if(!extend || begins_with_bound)
    return result;
  while(result.evaluations < options.max_line_search_steps) {
    // The parabola through both energies with the slope at 0 tells how far the minimum is.
    const double curvature = 2 * (result.energy - energy_0 - slope * result.step) / (result.step * result.step);
    const double minimum = curvature > 0 ? -slope / curvature : 4 * result.step;
    const double next = (std::min)((std::min)(minimum, 4 * result.step), bound);
    if(next < 1.1 * result.step)
      break;
    const double e = energy(next);
    ++result.evaluations;
    if(!(e < result.energy && e <= energy_0 + options.armijo * next * slope))
      break;
    result.step = next;
    result.energy = e;
  }
  return result;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_LINE_SEARCH_H
