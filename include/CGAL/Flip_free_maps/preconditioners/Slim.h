// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H

#include <CGAL/Flip_free_maps/preconditioners/Increment_form.h>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The reweighted proxy of SLIM (Rabinovich, Poranne, Panozzo and Sorkine-Hornung 2017): 2 |W dJ|^2 with
/// W = U diag(w) U^T, w_i^2 = psi_i / (2 (s_i - 1)). Its minimiser from J is the one of |W (J - R)|^2 with R the nearest rotation,
/// whose gradient is that of the energy. It is the method of choice far from the optimum. For energies with psi_i = 0 at
/// s_i = 1 for every i.
///
/// \cgalModels{Preconditioner}
struct Slim
{
  using Category = Varying_matrix_tag; ///< depends on the current map
  static constexpr bool is_second_order = true; ///< full steps are natural
  static const char* name() { return "slim"; } ///< "slim"

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& /* energy */, Increment_form<D>& form) const
  {
    internal::Vector<D> w;
    for(int i = 0; i < D; ++i) {
      const double difference = state.s[i] - 1;
      // Close to 1 the quotient loses digits to rounding; its limit is the second derivative.
      w[i] = std::abs(difference) > 1e-7 ? state.gradient[i] / difference : state.hessian(i, i);
      w[i] = std::abs(w[i]);
    }
    form.stretch = w.asDiagonal();
    internal::for_each_pair<D>([&](int p, int i, int j) {
      form.pairs[p].ij_ij = w[i];
      form.pairs[p].ji_ji = w[j];
      form.pairs[p].ij_ji = 0;
    });
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H
