// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_MEET_SOFT_POSITIONS_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_MEET_SOFT_POSITIONS_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <cmath>
#include <memory>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsConstraints
/// How weights are raised.
struct Weight_schedule
{
  double tolerance = 1e-6;     ///< largest distance of a vertex from its target, in the domain's units
  double factor = 10;          ///< by which all weights are multiplied between runs, greater than 1
  double largest_factor = 1e9; ///< product of all factors at which to give up
};

/// \ingroup PkgFlipFreeMapsConstraints
/// Raises the weights of soft positions until they are met within a tolerance, as Shtengel et al. 2017 and Liu et al. 2018 do:
/// the map is optimised with the given weights, then again from there with greater ones, and so on.
///
/// \param domain the rest shape
/// \param x the start; on return the result when the summary `is_valid()`, otherwise unchanged
/// \param constraints the soft positions with the weights to begin with, and vertices to be fixed
/// \param residual receives the largest distance of a vertex from its target, in the domain's units
/// \param traits the method and its settings, for each run
/// \param schedule how weights are raised
/// \returns the account of all runs together. When the tolerance was not reached the status is `unreachable_constraints` and `x`
///   unchanged; `residual` then tells how near the last map came. It is `invalid_option` for a schedule that leads nowhere.
template <int D, typename Traits = Flip_free_map_traits<>>
Summary meet_soft_positions(const Simplicial_domain<D>& domain, Positions<D>& x, const Position_constraints<D>& constraints,
                            double& residual, const Traits& traits = Traits(), const Weight_schedule& schedule = Weight_schedule())
{
  Summary summary;
  if(!(schedule.tolerance > 0) || !(schedule.factor > 1) || !std::isfinite(schedule.largest_factor)) {
    summary.message = "a weight schedule needs a positive tolerance, a factor above 1 and a finite largest factor";
    return summary;
  }
  if(!constraints.is_valid(domain.number_of_vertices, &summary.message))
    return summary;
  const auto soft = std::make_shared<Soft_positions<D>>(constraints.soft_positions);
  typename Traits::template Minimizer<D, Traits> minimizer(
    domain, traits, Position_constraints<D>{constraints.fixed_vertices, {}, constraints.sliding_vertices});
  minimizer.add_term(soft);
  Positions<D> y = x;
  for(double factor = 1; factor <= schedule.largest_factor; factor *= schedule.factor) {
    minimizer.minimize(y, summary);
    if(!summary.is_valid())
      return summary;
    residual = soft->residual(y);
    if(residual <= schedule.tolerance) {
      x = y;
      return summary;
    }
    soft->scale_weights(schedule.factor);
  }
  summary.status = Status::unreachable_constraints;
  summary.message = "soft positions were not met within the tolerance at the greatest weights";
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_MEET_SOFT_POSITIONS_H
