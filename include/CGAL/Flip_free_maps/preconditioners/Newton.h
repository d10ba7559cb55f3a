// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_NEWTON_H

#include <CGAL/Flip_free_maps/elements/internal/eigenmodes.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Hessian of the energy as it is. In iterations in which the linear solver finds it indefinite (Cholesky factorizations do,
/// LDL^T ones need not), or it gives no direction of descent, `Projected_newton` takes its place;
/// `Summary::fallbacks` counts them.
///
/// \cgalModels{Preconditioner}
struct Newton
{
  using Category = Varying_matrix_tag;           ///< depends on the current map
  static constexpr bool is_second_order = true;  ///< full steps are natural
  static const char* name() { return "newton"; } ///< "newton"

  /// Tries the Hessian itself first.
  void begin_iteration(const Iteration_state& /* state */) { m_is_projected = false; }

  /// Whether the Hessian itself is tried in this iteration.
  bool can_retreat() const { return !m_is_projected; }

  /// Projects in this iteration.
  void retreat() { m_is_projected = true; }

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    if(m_is_projected) {
      Projected_newton().form(state, energy, form);
      return;
    }
    form.stretch = state.hessian;
    internal::for_each_pair<D>(
      [&](int p, int i, int j) { form.pairs[p].set_modes(internal::symmetric_mode(state, i, j), internal::twist_mode(state, i, j)); });
  }

private:
  bool m_is_projected = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_NEWTON_H
