// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/elements/internal/eigenmodes.h>
#include <CGAL/Flip_free_maps/elements/internal/project_to_psd.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// What becomes of negative eigenvalues of an element's Hessian.
enum class Eigenvalue_filter
{
  clamp,       ///< they are set to 0
  absolute,    ///< they change their sign (Chen et al. 2024, Stabler Neo-Hookean simulation)
  trust_region ///< either, as the last step tells (Chen et al. 2024, Trust-region eigenvalue filtering)
};

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Hessian of the energy, projected to the positive semidefinite matrices element by element with the analytic eigensystem of
/// isotropic energies (Smith, de Goes and Kim 2019): the stretch block [psi_ij], the symmetric modes
/// (psi_i - psi_j) / (s_i - s_j) and the twist modes (psi_i + psi_j) / (s_i + s_j), with negative eigenvalues filtered.
///
/// Clamping is best near the optimum; absolute values are more careful where the energy is far from convex. With
/// `Eigenvalue_filter::trust_region` eigenvalues are clamped as long as the last decrease of the energy was within
/// `trust_tolerance` of the decrease that the quadratic model predicted, relative to the latter,
/// and their absolute values are taken otherwise.
///
/// \cgalModels{Preconditioner}
struct Projected_newton
{
  using Category = Varying_matrix_tag;                     ///< depends on the current map
  static constexpr bool is_second_order = true;            ///< full steps are natural
  static const char* name() { return "projected_newton"; } ///< "projected_newton"

  Eigenvalue_filter filter = Eigenvalue_filter::clamp; ///< of negative eigenvalues
  double trust_tolerance = 0.01;                       ///< used by `Eigenvalue_filter::trust_region`

  /// Chooses between clamping and absolute values.
  void begin_iteration(const Iteration_state& state)
  {
    m_takes_absolute_values = filter == Eigenvalue_filter::absolute ||
                              (filter == Eigenvalue_filter::trust_region && std::abs(state.model_ratio - 1) > trust_tolerance);
  }

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& /* energy */, Increment_form<D>& form) const
  {
    const auto filtered = [this](double mode) { return m_takes_absolute_values ? std::abs(mode) : (std::max)(mode, 0.); };
    form.stretch = state.hessian;
    internal::project_to_psd(form.stretch, m_takes_absolute_values);
    internal::for_each_pair<D>([&](int p, int i, int j) {
      form.pairs[p].set_modes(filtered(internal::symmetric_mode(state, i, j)), filtered(internal::twist_mode(state, i, j)));
    });
  }

private:
  bool m_takes_absolute_values = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_PROJECTED_NEWTON_H
