// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H

#include <CGAL/Flip_free_maps/preconditioners/Increment_form.h>
#include <CGAL/Flip_free_maps/internal/project_to_psd.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

// Eigenvalue of the symmetric mode of a pair, with its limit at equal singular values.
template <int D>
double symmetric_mode(const Element_state<D>& state, int i, int j)
{
  const double difference = state.s[i] - state.s[j];
  if(std::abs(difference) > 1e-6 * (std::abs(state.s[i]) + std::abs(state.s[j])))
    return (state.gradient[i] - state.gradient[j]) / difference;
  return 0.5 * (state.hessian(i, i) + state.hessian(j, j)) - state.hessian(i, j);
}

template <int D>
double twist_mode(const Element_state<D>& state, int i, int j)
{
  return (state.gradient[i] + state.gradient[j]) / (state.s[i] + state.s[j]);
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Hessian of the energy, projected to the positive semidefinite matrices element by element with the analytic eigensystem of
/// isotropic energies (Smith, de Goes and Kim 2019): the stretch block [psi_ij], the symmetric modes
/// (psi_i - psi_j) / (s_i - s_j) and the twist modes (psi_i + psi_j) / (s_i + s_j), negative eigenvalues set to zero.
///
/// \cgalModels{Preconditioner}
struct Projected_newton
{
  using Category = Varying_matrix_tag; ///< depends on the current map
  static constexpr bool is_second_order = true; ///< full steps are natural
  static const char* name() { return "newton"; } ///< "newton"

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& /* energy */, Increment_form<D>& form) const
  {
    form.stretch = state.hessian;
    internal::project_to_psd(form.stretch);
    internal::for_each_pair<D>([&](int p, int i, int j) {
      form.pairs[p].set_modes((std::max)(internal::symmetric_mode(state, i, j), 0.),
                              (std::max)(internal::twist_mode(state, i, j), 0.));
    });
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H
