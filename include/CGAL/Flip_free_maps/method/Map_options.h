// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_MAP_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_METHOD_MAP_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/internal/option_checks.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// What an observer is told after every accepted step, and once before the first.
struct Iteration_report
{
  int iteration = 0;                       ///< accepted steps so far (0: the start)
  double seconds = 0;                      ///< wall-clock seconds since the minimizer began
  double energy = 0;                       ///< mean energy
  double gradient_norm = 0;                ///< Euclidean norm of the gradient
  double characteristic_gradient_norm = 0; ///< the same over the characteristic gradient
  double step = 0;                         ///< length of the last step, in units of the direction
  double largest_step = 0;                 ///< the step at which the first element would collapse
  int factorizations = 0;                  ///< numeric factorizations so far
  std::int64_t flips = 0;                  ///< elements that are not positively oriented: 0 for energies with a barrier
};

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `Map_minimizer`. All stopping rules are measured on the mesh scaled to total measure 1 with the mean energy
/// E = sum A_e psi(J_e) / sum A_e, so they mean the same on every input. A rule with tolerance 0 is off; the first rule that is
/// met ends the run.
struct Map_options
{
  /// Stop when |grad E| <= tolerance * W * |l|, the characteristic gradient norm of Zhu, Bridson and Kaufman 2018 (Blended Cured
  /// Quasi-Newton, section 6): l is the vector of the measures of the vertices' rest links (perimeters in the plane), and W the least
  /// eigenvalue, beside those that vanish, of the energy's Hessian at the identity, where they take the largest. It depends neither on the mesh's resolution nor on the energy's scale.
  double characteristic_gradient_tolerance = 1e-5;
  /// Stop when |grad E| <= tolerance.
  double gradient_tolerance = 0;
  /// Stop when the relative decrease of the energy is at most this in `stagnation_iterations` steps in a row, or in one step of
  /// length at least 1/2 along a fresh second-order direction that had promised no more than ten times as much: a short step
  /// alone says nothing about convergence, nor does one that went too far. Also stop instead of factorizing again when, after
  /// such a step, the last factorization and the new gradient predict a relative decrease of at most a tenth of this.
  double relative_energy_tolerance = 0;
  /// See `relative_energy_tolerance`.
  int stagnation_iterations = 3;
  /// When false, `relative_energy_tolerance` is a plain rule: one step that changes the energy by no more, relatively, ends the run,
  /// whatever step it was and whatever is predicted (Liu et al. 2018, equation 11 and section 3.6).
  bool careful_stagnation = true;
  /// Stop when the energy is at most this (off by default).
  double target_energy = -std::numeric_limits<double>::infinity();
  /// Stop after this many accepted steps.
  int max_iterations = 5000;
  /// Stop after this many seconds of wall-clock time.
  double max_seconds = std::numeric_limits<double>::infinity();

  /// Step lengths are at most this fraction of the step at which the first element collapses, in (0, 1).
  double step_fraction = 0.95;
  /// Sufficient decrease: E(x + a d) <= E(x) + armijo a grad E . d, in (0, 1/2).
  double armijo = 1e-4;
  /// Most energies evaluated in one line search before it fails.
  int max_line_search_steps = 60;
  /// The factor, in (0, 1), of plain backtracking: the line search begins at the full step, or at the bound where that is shorter
  /// or `begin_with_largest_step` is set, and multiplies by this until the energy decreases sufficiently. 0: by interpolation and
  /// extension, see `line_search()`.
  double backtracking = 0;
  /// Second-order directions may be followed beyond the full step while the energy decreases.
  bool extend_steps = true;
  /// Second-order directions are first followed as far as `step_fraction` allows, also beyond the full step, and back from there
  /// by halves, instead of beginning with the full step. It suits methods that factorize in every iteration: projected Hessians
  /// overestimate curvature, and long steps make up for it;
  /// not those that keep a factorization.
  bool begin_with_largest_step = false;
  /// After a short step that ended at a collapsing element, the vertices of the elements that were about to collapse are moved to
  /// their local optimum, one by one.
  bool free_blocked_vertices = true;
  /// While a factorization is kept for several iterations, the parts of the elements that were deformed most since are renewed in
  /// it, at most one for every fifty vertices: a few thin elements change first, and hold up all others. It takes part only where
  /// a refactorization rule keeps factorizations.
  bool renew_factorization = true;

  /// Energies without a barrier, such as `Arap`, are minimised without regard to flips, which the summary counts. The start may
  /// have flips then. Energies with a barrier take no notice.
  bool allow_flips = false;
  /// Added to the diagonal of the matrix in each iteration, as Claici et al. 2017 do (c = 1e-4 in section 6.2)
  /// against singular matrices.
  double tikhonov = 0;
  /// A minimizer that runs again begins with the factorization of its last run, for maps that change a little between runs.
  bool keep_factorization = false;
  /// Bytes that the factor of the matrix may take; beyond, `Automatic_solver`, which is in the default traits, iterates instead.
  /// 0 stands for half of the machine's memory.
  double memory_budget = 0;

  /// Called before the first and after every accepted step; returning `false` stops the run with a valid map.
  std::function<bool(const Iteration_report&)> observer;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!internal::is_tolerance(characteristic_gradient_tolerance) || !internal::is_tolerance(gradient_tolerance) ||
       !internal::is_tolerance(relative_energy_tolerance))
      return internal::fail(message, "tolerances must be finite and not negative");
    if(!(memory_budget >= 0))
      return internal::fail(message, "memory_budget must not be negative");
    if(stagnation_iterations < 1)
      return internal::fail(message, "stagnation_iterations must be at least 1");
    if(!(step_fraction > 0 && step_fraction < 1))
      return internal::fail(message, "step_fraction must be in (0, 1)");
    if(!(armijo > 0 && armijo < 0.5))
      return internal::fail(message, "armijo must be in (0, 1/2)");
    if(!(backtracking >= 0 && backtracking < 1))
      return internal::fail(message, "backtracking must be in [0, 1)");
    if(!internal::is_tolerance(tikhonov))
      return internal::fail(message, "tikhonov must be finite and not negative");
    if(max_line_search_steps < 1)
      return internal::fail(message, "max_line_search_steps must be at least 1");
    return internal::check_limits(*this, message);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_MAP_OPTIONS_H
