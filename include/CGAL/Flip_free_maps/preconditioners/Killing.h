// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_KILLING_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_KILLING_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// Which measure weights an element of the Killing operator.
enum class Killing_weight
{
  rest_measure,  ///< the element of the rest shape (Claici et al., section 4.2.1: "we integrate over the 3D surface")
  image_measure, ///< the element of the current image: the Killing operator proper, equations (5) and (10)
  stiffness      ///< that of the rest shape, times how much stiffer against stretching the energy is there than at an isometry,
                 ///< if it is stiffer.
                 ///< For steep energies, such as exponential ones; for others the paper's weights need fewer iterations
};

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Killing operator of Claici, Bessmeltsev, Schaefer and Solomon 2017: 1/2 |S + S^T|^2 of the velocity gradient
/// S = dJ J^-1, which vanishes exactly on infinitesimal rigid motions of the current image (equation 4). In the frame of the
/// singular vectors it is 2 sum_i (K_ii / s_i)^2 + sum_{i<j} (K_ij / s_j + K_ji / s_i)^2. Assembled, it is the closed form (5)
/// in the plane and (10) in space. It is scaled so that it equals the Hessian at an isometry,
/// so its full step is the natural one.
///
/// \cgalModels{Preconditioner}
struct Killing
{
  using Category = Varying_matrix_tag;            ///< depends on the current map
  static constexpr bool is_second_order = true;   ///< full steps are natural
  static const char* name() { return "killing"; } ///< "killing"

  Killing_weight weight = Killing_weight::rest_measure; ///< measure of integration

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    double c = 0.5 * internal::curvature_at_identity<D>(energy);
    if(weight == Killing_weight::image_measure)
      c *= state.s.prod();
    else if(weight == Killing_weight::stiffness)
      c = (std::max)(c, 0.5 * (state.hessian.diagonal().array() * state.s.array().square()).maxCoeff());
    form.stretch.setZero();
    form.stretch.diagonal() = 2 * c * state.s.array().square().inverse();
    internal::for_each_pair<D>([&](int p, int i, int j) {
      const double a = 1 / state.s[j], b = 1 / state.s[i];
      form.pairs[p].ij_ij = c * a * a;
      form.pairs[p].ji_ji = c * b * b;
      form.pairs[p].ij_ji = c * a * b;
    });
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_KILLING_H
