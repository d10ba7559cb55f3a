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
/// Factorizes a varying preconditioner in every iteration.
///
/// \cgalModels{RefactorizationRule}
struct Every_iteration
{
  /// Whether to factorize now, `age` accepted steps after the last factorization; `last_step` is the length of the last step.
  bool operator()(int /* age */, double /* last_step */) const { return true; }
};

/// \ingroup PkgFlipFreeMapsAccelerations
/// Keeps a factorization for a number of steps, but not beyond a throttled one: the map then differs too much from the one that was
/// factorized.
///
/// \cgalModels{RefactorizationRule}
struct Every_n_iterations
{
  int number_of_iterations = 15; ///< steps per factorization
  double shortest_step = 0.1;    ///< a shorter last step asks for a new factorization

  /// Whether to factorize now, `age` accepted steps after the last factorization; `last_step` is the length of the last step.
  bool operator()(int age, double last_step) const
  {
    return age >= number_of_iterations || last_step < shortest_step;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_REFACTORIZATION_RULES_H
