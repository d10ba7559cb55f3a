// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ADAPTIVE_PRECONDITIONER_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ADAPTIVE_PRECONDITIONER_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim_newton.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The default: `Slim_newton`, or `Killing` where an isometry is within reach. `parameterize()` chooses the latter for
/// developable surfaces, see `Flip_free_map_traits::adapt_to_developable_surface()`.
///
/// \cgalModels{Preconditioner}
struct Adaptive_preconditioner
{
  using Category = Varying_matrix_tag;             ///< depends on the current map
  static constexpr bool is_second_order = true;    ///< full steps are natural
  static const char* name() { return "adaptive"; } ///< "adaptive"

  Slim_newton slim_newton;   ///< used in general
  Killing killing;           ///< used where an isometry is within reach
  bool uses_killing = false; ///< which of them is used
  int patience = 30;         ///< iterations after which the Killing operator, not having done, is given up

  /// Chooses for the next iteration.
  void begin_iteration(const Iteration_state& state)
  {
    uses_killing = uses_killing && state.iteration < patience;
    if(!uses_killing)
      slim_newton.begin_iteration(state);
  }

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    if(uses_killing)
      killing.form(state, energy, form);
    else
      slim_newton.form(state, energy, form);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ADAPTIVE_PRECONDITIONER_H
