// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_COMPOSITE_MAJORIZATION_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_COMPOSITE_MAJORIZATION_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/elements/internal/eigenmodes.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// Composite majorization (Shtengel, Poranne, Sorkine-Hornung, Kovalsky and Lipman 2017) in the plane. The singular values are
/// s = |alpha| +- |beta| with linear alpha and beta; the energy h(s) is majorized by the convex part of h and of the norms:
/// G^T (hess h+) G plus nonnegative multiples of hess |alpha| (the twist mode) and hess |beta| (the symmetric mode).
/// With term gathering (equation 18) the multiples are (h_1+h_2)_+ and (h_1-h_2)_+, and for energies that are convex in the
/// singular values, such as the symmetric Dirichlet energy, the result equals `Projected_newton`; without it (equation 17) the
/// derivatives are split one by one, which majorizes more.
///
/// \tparam gather_terms whether equation (18) or (17) is used
///
/// The energy must be a model of `ConvexConcaveEnergy`, or have a member function `bool composite_form<2>(state, form)` that
/// writes the majorizer of another composition, as `Neo_hookean` does with the help of `composite_majorizer()`. D = 2 only.
///
/// \cgalModels{Preconditioner}
template <bool gather_terms = true>
struct Composite_majorization
{
  using Category = Varying_matrix_tag;                                        ///< depends on the current map
  static constexpr bool is_second_order = true;                               ///< full steps are natural
  static constexpr bool is_planar = true;                                     ///< of the plane only
  static const char* name() { return gather_terms ? "cm" : "cm_ungathered"; } ///< "cm" or "cm_ungathered"

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    static_assert(D == 2, "composite majorization is a method of the plane");
    static_assert(
      internal::Has_convex_hessian<Energy, D>::value || internal::Has_composite_form<Energy, D>::value,
      "composite majorization needs an energy with a convex part, a model of ConvexConcaveEnergy, or one with composite_form()");
    if constexpr(internal::Has_composite_form<Energy, D>::value)
      if(energy.template composite_form<D>(state, form))
        return;
    if constexpr(internal::Has_convex_hessian<Energy, D>::value)
      majorize(state, energy, form);
  }

private:
  // Equations (17) and (18).
  template <int D, typename Energy>
  static void majorize(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form)
  {
    energy.template convex_hessian<D>(state.s, state.hessian, form.stretch);
    const double h_0 = state.gradient[0], h_1 = state.gradient[1];
    double symmetric = (std::max)(internal::symmetric_mode(state, 0, 1), 0.);
    double twist = (std::max)(internal::twist_mode(state, 0, 1), 0.);
    if(!gather_terms) {
      // Equation (17) has a pole at equal singular values that does not cancel, and rounds to 0 / 0 close to it. With a floor
      // under the difference it stays finite; it majorizes equation (18) everywhere else.
      const double difference = (std::max)(state.s[0] - state.s[1], 1e-8 * state.s[0]);
      symmetric = (std::max)(symmetric, ((std::max)(h_0, 0.) + (std::max)(-h_1, 0.)) / difference);
      twist = (std::max)(twist, ((std::max)(h_0, 0.) + (std::max)(h_1, 0.)) / (state.s[0] + state.s[1]));
    }
    form.pairs[0].set_modes(symmetric, twist);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_COMPOSITE_MAJORIZATION_H
