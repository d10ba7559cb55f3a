// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_LAPLACIAN_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_LAPLACIAN_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Laplacian of the rest shape: |dJ|^2 times the curvature of the energy at the identity. Its directions are Sobolev
/// gradients; with Nesterov's acceleration it is the quadratic proxy of Kovalsky, Galun and Lipman 2016 (AQP). Its matrix is
/// constant, one factorization serves all iterations.
///
/// \cgalModels{Preconditioner}
struct Laplacian
{
  using Category = Constant_matrix_tag;             ///< factorized once
  static constexpr bool is_second_order = false;    ///< full steps are not natural
  static const char* name() { return "laplacian"; } ///< "laplacian"

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& /* state */, const Energy& energy, Increment_form<D>& form) const
  {
    const double c = internal::curvature_at_identity<D>(energy);
    form.stretch = c * internal::Matrix<D>::Identity();
    for(auto& pair : form.pairs)
      pair.set_modes(c, c);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_LAPLACIAN_H
