// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H

#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// `Slim` on elements whose symmetric Dirichlet energy exceeds `threshold` times that of an isometry, `Projected_newton` on the
/// others. That energy chooses whatever energy is minimised: it measures the shape, and other energies have other scales. The
/// second differential of a thin, badly distorted element describes it only nearby: directions that trust it are throttled by
/// that one element for many iterations, while SLIM's proxy leads it to a rotation at once. Near the optimum, where second
/// differentials are right, no element exceeds the threshold. The choice by element and its threshold are this package's own;
/// thresholds from 8 to 30 serve equally well for the symmetric Dirichlet energy.
///
/// \cgalModels{Preconditioner}
struct Slim_newton
{
  using Category = Varying_matrix_tag; ///< depends on the current map
  static constexpr bool is_second_order = true; ///< full steps are natural
  static const char* name() { return "slim_newton"; } ///< "slim_newton"

  double threshold = 20; ///< symmetric Dirichlet energy of an element, in units of an isometry's

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    if(Symmetric_dirichlet().value<D>(state.s) > threshold)
      Slim().form(state, energy, form);
    else
      Projected_newton().form(state, energy, form);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_NEWTON_H
