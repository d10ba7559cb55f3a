// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/internal/option_checks.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// What an observer of a splitting run is told after every iteration, and once before the first. The `energy` is that of the map
/// if no element is flipped and infinite otherwise; gradient norms, `step` and `largest_step` are not used.
struct Splitting_report : Iteration_report
{
  double primal_error = 0; ///< how far the Jacobians are from their split factors
  double dual_error = 0;   ///< how much the Jacobians moved, times the penalties
};

/// \ingroup PkgFlipFreeMapsSplitting
/// When rotations are kept close to those of the iteration before.
enum class Proximal_rotation
{
  automatic, ///< unless the start has many flipped elements
  on,        ///< always
  off        ///< never
};

/// \ingroup PkgFlipFreeMapsSplitting
/// How elements count in the errors, with |J - R P| and mu |J - previous J| those of an element of measure A.
enum class Splitting_weights
{
  measure, ///< by their measures: the dual error of an element is divided by A, and root mean squares are taken over the mesh.
           ///< Results do not depend on how the mesh is divided into elements
  equal    ///< all alike (Stein et al., equations 14 and 15): square roots of sums of squares, the absolute tolerance times
           ///< the square root of the number of entries of all Jacobians
};

/// \ingroup PkgFlipFreeMapsSplitting
/// Settings of `Splitting_minimizer`. Lengths are measured on the mesh scaled to total measure 1, so settings mean the same on
/// every input.
struct Splitting_options
{
  /// The run converges when no element is flipped and both errors are at most this plus `relative_tolerance` times the size of what
  /// they are errors of: the Jacobians, and the dual variables. How they are measured is `weights`.
  double absolute_tolerance = 1e-6;
  /// See `absolute_tolerance`.
  double relative_tolerance = 1e-5;
  /// How elements count in the errors, and in the comparison that changes penalties.
  Splitting_weights weights = Splitting_weights::measure;
  /// Stop when no element is flipped and the mean energy of the map is at most this (off by default).
  double target_energy = -std::numeric_limits<double>::infinity();
  /// Stop at the first iterate without flipped elements; the start counts.
  bool stop_when_flip_free = false;
  /// Stop when the fewest flipped elements so far have not become fewer for this many iterations; 0 to go on. No rule of the
  /// paper, which goes on: for callers that have another method to try.
  int max_stalled_iterations = 0;
  /// Stop after this many iterations.
  int max_iterations = 5000;
  /// Stop after this many seconds of wall-clock time.
  double max_seconds = std::numeric_limits<double>::infinity();

  /// The factor by which the penalty of an element changes, above 1.
  double penalty_factor = 2.5;
  /// The penalty of an element changes when one of its errors exceeds the other by this factor, at least 1.
  double penalty_ratio = 5;
  /// Penalties are adapted, and the matrix is factorized again, after each of this many first iterations,
  int first_adaptations = 5;
  /// then after this many more, and after intervals that double each time.
  int adaptation_interval = 5;
  /// Intervals that begin with flipped elements do not double beyond this.
  int largest_interval_with_flips = 20;
  /// Whether the penalty of a flipped element rises whatever its errors are: there J = R P matters more than the energy.
  bool raises_penalties_of_flips = true;
  /// Penalties are at most this times the measure of the element: beyond, the sums of the matrix would drown all other elements.
  double largest_penalty = 1e12;
  /// Whether rotations are kept close to those of the iteration before.
  Proximal_rotation proximal_rotation = Proximal_rotation::automatic;

  /// Hand the map to `Map_minimizer` as soon as the splitting ends without flipped elements.
  bool polish = false;
  /// A minimizer that runs again begins with the rotations, stretches, penalties and dual variables of its last run, and with its
  /// factorization, if that led to a valid map: for fixed vertices that move a little between runs.
  bool keep_factorization = false;

  /// Called before the first and after every iteration; returning `false` stops the run,
  /// of `repair_map()` as a whole.
  std::function<bool(const Splitting_report&)> observer;

  /// The scheme as Stein, Li and Solomon 2022 write it (section 6): all elements count alike, and nothing is done about flipped
  /// elements and large penalties.
  static Splitting_options published()
  {
    Splitting_options options;
    options.weights = Splitting_weights::equal;
    options.largest_interval_with_flips = (std::numeric_limits<int>::max)();
    options.raises_penalties_of_flips = false;
    options.largest_penalty = std::numeric_limits<double>::infinity();
    return options;
  }

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!internal::is_tolerance(absolute_tolerance) || !internal::is_tolerance(relative_tolerance))
      return internal::fail(message, "tolerances must be finite and not negative");
    if(!(penalty_factor > 1) || !std::isfinite(penalty_factor))
      return internal::fail(message, "penalty_factor must be finite and above 1");
    if(!(penalty_ratio >= 1) || !std::isfinite(penalty_ratio))
      return internal::fail(message, "penalty_ratio must be finite and at least 1");
    if(max_stalled_iterations < 0)
      return internal::fail(message, "max_stalled_iterations must not be negative");
    if(first_adaptations < 0)
      return internal::fail(message, "first_adaptations must not be negative");
    if(adaptation_interval < 1 || largest_interval_with_flips < 1)
      return internal::fail(message, "adaptation_interval and largest_interval_with_flips must be at least 1");
    if(!(largest_penalty >= 1))
      return internal::fail(message, "largest_penalty must be at least 1");
    return internal::check_limits(*this, message);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_OPTIONS_H
