// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_REFACTORIZATION_RULES_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_REFACTORIZATION_RULES_H

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// What a refactorization rule asks for.
enum class Refactorization
{
  none,    ///< keep the factorization
  refresh, ///< factorize; what the acceleration knows of earlier steps still holds
  restart  ///< factorize, and let the acceleration forget
};

/// \ingroup PkgFlipFreeMapsAccelerations
/// Factorizes a varying preconditioner in every iteration.
///
/// \cgalModels{RefactorizationRule}
struct Every_iteration
{
  /// What to do now, `age` accepted steps after the last factorization. `last_step` is the length of the last step in units of
  /// its direction, `relative_decrease` that of the energy.
  Refactorization operator()(int /* age */, double /* last_step */, double /* relative_decrease */) const
  {
    return Refactorization::refresh;
  }
};

/// \ingroup PkgFlipFreeMapsAccelerations
/// Keeps a factorization for several steps once the map is near the optimum: not after a step that was throttled, nor after one
/// that decreased the energy much, since the map then differs too much from the one that was factorized.
///
/// \cgalModels{RefactorizationRule}
struct On_demand
{
  int largest_age = 30;           ///< steps per factorization
  double shortest_step = 0.01;    ///< a shorter last step asks for a restart
  double largest_decrease = 0.03; ///< so does a greater relative decrease of the energy

  /// What to do now, see `Every_iteration`.
  Refactorization operator()(int age, double last_step, double relative_decrease) const
  {
    if(last_step < shortest_step || relative_decrease > largest_decrease)
      return Refactorization::restart;
    return age >= largest_age ? Refactorization::refresh : Refactorization::none;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_REFACTORIZATION_RULES_H
