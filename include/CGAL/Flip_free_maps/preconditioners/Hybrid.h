// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_HYBRID_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_HYBRID_H

#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// One preconditioner while distortion is extreme, another from then on: the hybrid solver of progressive parameterizations (Liu,
/// Ye, Ni and Fu 2018, section 3.5). The change takes place, for the rest of the run, as soon as 99 % of the elements have a
/// symmetric Dirichlet energy of at most `bound`, or the last step changed the energy by less than a tenth.
///
/// \tparam First used far from the optimum. <b>Default:</b> \code Slim \endcode
/// \tparam Second used afterwards. The paper takes composite majorization,
///   which equals the default for the symmetric Dirichlet energy.
///         <b>Default:</b> \code Projected_newton \endcode
///
/// \cgalModels{Preconditioner}
template <typename First = Slim, typename Second = Projected_newton>
struct Hybrid
{
  static_assert(!internal::Has_retreat<First>::value && !internal::Has_retreat<Second>::value &&
                  !internal::Clamps_element_matrices<First>::value && !internal::Clamps_element_matrices<Second>::value,
                "Hybrid passes on neither retreats nor clamps");

  using Category = Varying_matrix_tag;                                                       ///< depends on the current map
  static constexpr bool is_second_order = First::is_second_order && Second::is_second_order; ///< whether full steps are natural
  static const char* name() { return "hybrid"; }                                             ///< "hybrid"

  First first;                    ///< used far from the optimum
  Second second;                  ///< used near it
  double bound = 60;              ///< symmetric Dirichlet energy of an element that is not distorted too much, K in the paper
  double smallest_decrease = 0.1; ///< a step that changes the energy by less, relatively, asks for the change

  /// Changes over when it is time, and informs the one in use.
  void begin_iteration(const Iteration_state& state)
  {
    if(state.iteration == 0)
      m_has_changed = false;
    m_has_changed = m_has_changed || std::abs(state.relative_decrease) < smallest_decrease || state.distorted_fraction(bound) <= 0.01;
    if(m_has_changed)
      internal::begin_iteration(second, state);
    else
      internal::begin_iteration(first, state);
  }

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    if(m_has_changed)
      second.form(state, energy, form);
    else
      first.form(state, energy, form);
  }

private:
  bool m_has_changed = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_HYBRID_H
