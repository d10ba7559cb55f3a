// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_VERTEX_SPACE_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_VERTEX_SPACE_NEWTON_H

#include <CGAL/Flip_free_maps/preconditioners/Newton.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// Projected Newton as it was before analytic eigensystems, and as Shtengel et al. 2017 compare with: the eigenvalues of each
/// element's matrix on the displacements of its vertices, 6 x 6 for triangles and 12 x 12 for tetrahedra, are clamped (Teran et
/// al. 2005). It depends on the shape of the element at rest, which `Projected_newton` does not,
/// and an eigenvalue decomposition per element is slow.
///
/// \cgalModels{Preconditioner}
struct Vertex_space_newton
{
  using Category = Varying_matrix_tag;                        ///< depends on the current map
  static constexpr bool is_second_order = true;               ///< full steps are natural
  static constexpr bool clamps_element_matrices = true;       ///< the form itself may be indefinite
  static const char* name() { return "vertex_space_newton"; } ///< "vertex_space_newton"

  /// Writes the form for one element, before its matrix is clamped: the Hessian.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    Newton().form(state, energy, form);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_VERTEX_SPACE_NEWTON_H
