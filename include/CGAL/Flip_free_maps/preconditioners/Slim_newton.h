// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H

#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// `Slim` on elements whose symmetric Dirichlet energy exceeds `threshold` times that of an isometry, `Projected_newton` on the
/// others. That energy chooses whatever energy is minimised: it measures the shape, and other energies have other scales. The
/// second differential of a thin, badly distorted element describes it only nearby: directions that trust it are throttled by
/// that one element for many iterations, while SLIM's proxy leads it to a rotation at once. Near the optimum, where second
/// differentials are right, no element exceeds the threshold, on most surfaces. The choice by element and its threshold are this
/// package's own; thresholds from 8 to 30 serve equally well for the symmetric Dirichlet energy.
///
/// A long closed tube with one open end has no map without great distortion. Rotations are no targets for its elements, and
/// directions that lead there are throttled at a hundredth of a step, while those of the second differential are good for full
/// steps. So `Projected_newton` serves all elements while more than `largest_fraction` of them exceed the threshold although the
/// energy decreases slowly. That is looked at after 1, 2, 4, 8, ... steps. (At most 0.5 % of the elements of other surfaces
/// exceed it then, and 8 % to 70 % of those of tubes.)
///
/// \cgalModels{Preconditioner}
struct Slim_newton
{
  using Category = Varying_matrix_tag;                ///< depends on the current map
  static constexpr bool is_second_order = true;       ///< full steps are natural
  static const char* name() { return "slim_newton"; } ///< "slim_newton"

  double threshold = 20;          ///< symmetric Dirichlet energy of an element, in units of an isometry's
  double largest_fraction = 0.02; ///< of elements that exceed it, in a map that is hardly improved by a step any more
  double smallest_decrease = 0.1; ///< relative decrease of the energy by a step that improves a map much

  /// Finds out whether great distortion is here to stay.
  void begin_iteration(const Iteration_state& state)
  {
    const bool is_power_of_two = (state.iteration & (state.iteration - 1)) == 0;
    if(state.iteration == 0)
      m_is_distorted_throughout = false;
    else if(is_power_of_two)
      m_is_distorted_throughout = state.relative_decrease < smallest_decrease && state.distorted_fraction(threshold) > largest_fraction;
  }

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    if(!m_is_distorted_throughout && Symmetric_dirichlet().value<D>(state.s) > threshold)
      Slim().form(state, energy, form);
    else
      Projected_newton().form(state, energy, form);
  }

private:
  bool m_is_distorted_throughout = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H
