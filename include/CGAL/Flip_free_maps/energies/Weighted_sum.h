// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_WEIGHTED_SUM_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_WEIGHTED_SUM_H

#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>

#include <Eigen/Core>

#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// A weighted sum of two energies, psi(s) = w_1 psi_1(s) + w_2 psi_2(s); for more than two, an energy may be a sum itself.
///
/// \tparam Energy1 must be a model of `DistortionEnergy`
/// \tparam Energy2 must be a model of `DistortionEnergy`
///
/// \cgalModels{DistortionEnergy,ConvexConcaveEnergy if both energies are models of it}
template <typename Energy1, typename Energy2>
struct Weighted_sum
{
  /// Whether one of them has a barrier. Its weight must then be positive.
  static constexpr bool has_barrier = Energy1::has_barrier || Energy2::has_barrier;

  /// "weighted_sum"
  static const char* name() { return "weighted_sum"; }

  Energy1 first;            ///< psi_1
  Energy2 second;           ///< psi_2
  double first_weight = 1;  ///< w_1, not negative
  double second_weight = 1; ///< w_2, not negative

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return first_weight * first.template value<D>(s) + second_weight * second.template value<D>(s);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    Eigen::Matrix<double, D, 1> second_gradient;
    Eigen::Matrix<double, D, D> second_hessian;
    first.template derivatives<D>(s, gradient, hessian);
    second.template derivatives<D>(s, second_gradient, second_hessian);
    gradient = first_weight * gradient + second_weight * second_gradient;
    hessian = first_weight * hessian + second_weight * second_hessian;
  }

  /// The Hessian of the convex part of psi, the sum of both. Only when both energies have one.
  template <int D, typename First = Energy1, typename Second = Energy2>
  std::enable_if_t<internal::Has_convex_hessian<First, D>::value && internal::Has_convex_hessian<Second, D>::value> convex_hessian(
    const Eigen::Matrix<double, D, 1>& s, const Eigen::Matrix<double, D, D>& /* hessian */, Eigen::Matrix<double, D, D>& convex) const
  {
    convex = first_weight * convex_part<D>(first, s) + second_weight * convex_part<D>(second, s);
  }

  /// The singular values that `Slim` leads to: where psi_i changes its sign between those of both energies.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    Eigen::Matrix<double, D, 1> target = internal::slim_target<D>(first, s);
    const Eigen::Matrix<double, D, 1> other = internal::slim_target<D>(second, s);
    for(int i = 0; i < D; ++i)
      if(target[i] != other[i])
        target[i] = internal::stretch_minimizer<D>(*this, s, i, target[i], other[i]);
    return target;
  }

private:
  template <int D, typename Energy>
  static Eigen::Matrix<double, D, D> convex_part(const Energy& energy, const Eigen::Matrix<double, D, 1>& s)
  {
    Eigen::Matrix<double, D, 1> gradient;
    Eigen::Matrix<double, D, D> hessian, convex;
    energy.template derivatives<D>(s, gradient, hessian);
    energy.template convex_hessian<D>(s, hessian, convex);
    return convex;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_WEIGHTED_SUM_H
