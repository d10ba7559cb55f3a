// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The reweighted proxy of SLIM (Rabinovich, Poranne, Panozzo and Sorkine-Hornung 2017): 2 |W dJ|^2 with
/// W = U diag(w) U^T, w_i^2 = psi_i / (2 (s_i - t_i)). Its minimiser from J is the one of |W (J - U diag(t) V^T)|^2, whose
/// gradient is that of the energy. It is the method of choice far from the optimum.
///
/// The target singular values t are all 1, so that the target is the nearest rotation, unless the energy has a member function
/// `Vector slim_target<D>(const Vector& s) const`, with `Vector` for `Eigen::Matrix<double, D, 1>`: energies whose psi_i is not 0
/// at s_i = 1 need it (Table I of that paper). psi_i must have the sign of s_i - t_i; the minimiser of psi in s_i, the other
/// singular values fixed, is always a good choice. Where s_i is t_i the quotient is replaced by a row sum of the Hessian, which
/// is its limit for separable energies and a bound for others.
///
/// Weights are taken absolutely, and are not smaller than 1e-6 times the curvature of the energy at the identity, for
/// energies that do not depend on all singular values, or grow very slowly: the matrix stays positive definite.
///
/// \cgalModels{Preconditioner}
struct Slim
{
  using Category = Varying_matrix_tag;          ///< depends on the current map
  static constexpr bool is_second_order = true; ///< full steps are natural
  static const char* name() { return "slim"; }  ///< "slim"

  /// Writes the form for one element.
  template <int D, typename Energy>
  void form(const Element_state<D>& state, const Energy& energy, Increment_form<D>& form) const
  {
    const internal::Vector<D> target = internal::slim_target<D>(energy, state.s);
    const double smallest = 1e-6 * internal::curvature_at_identity<D>(energy);
    internal::Vector<D> w;
    for(int i = 0; i < D; ++i) {
      const double difference = state.s[i] - target[i];
      // Close to the target the quotient loses digits to rounding.
      const double weight =
        std::abs(difference) > 1e-7 * target[i] ? std::abs(state.gradient[i] / difference) : state.hessian.row(i).cwiseAbs().sum();
      w[i] = (std::min)((std::max)(smallest, weight), LARGEST_WEIGHT);
    }
    form.stretch = w.asDiagonal();
    internal::for_each_pair<D>([&](int p, int i, int j) {
      form.pairs[p].ij_ij = w[i];
      form.pairs[p].ji_ji = w[j];
      form.pairs[p].ij_ji = 0;
    });
  }

private:
  static constexpr double LARGEST_WEIGHT = 1e150; // squares of it are finite
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_SLIM_H
