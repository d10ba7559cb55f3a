// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_AMIPS_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_AMIPS_H

#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The isometric energy of AMIPS (Fu, Liu and Guo 2015): the mean of a conformal and a volumetric part, each 2 for an isometry,
/// psi(s) = 1/2 (c + d + 1/d) with d = s_1 ... s_D, c = s_1/s_2 + s_2/s_1 = I_1 / d for D = 2, and
/// c = 1/4 (s_1/s_2 + s_2/s_1) (s_2/s_3 + s_3/s_2) (s_3/s_1 + s_1/s_3) for D = 3, twice the conformal energy of tetrahedra of
/// that paper. Both parts have equal weight. Its minimum is 2, at isometries; a mean of parts that are 1 there is half of it.
///
/// There is no `convex_hessian()`: psi is not convex in the singular values, and its parts are not, either.
///
/// \cgalModels{DistortionEnergy}
struct Amips
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "amips"
  static const char* name() { return "amips"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    double conformal = 1;
    for(int i = 0; i < D; ++i)
      for(int j = i + 1; j < D; ++j)
        conformal *= 0.5 * (s[i] / s[j] + s[j] / s[i]);
    const double d = s.prod();
    return conformal + 0.5 * (d + 1 / d);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    // In u_i = log s_i the energy is prod_{i<j} cosh(u_i - u_j) + cosh(sum_i u_i).
    const auto bounded = [](double x) { return (std::max)(1 / internal::LARGEST_RATIO, (std::min)(x, internal::LARGEST_RATIO)); };
    const double d = bounded(s.prod());
    double conformal = 1;
    Eigen::Matrix<double, D, 1> log_gradient = Eigen::Matrix<double, D, 1>::Zero();
    Eigen::Matrix<double, D, D> log_hessian = Eigen::Matrix<double, D, D>::Zero();
    for(int i = 0; i < D; ++i)
      for(int j = i + 1; j < D; ++j) {
        const double ratio = bounded(s[i] / s[j]), cosh = 0.5 * (ratio + 1 / ratio), tanh = 0.5 * (ratio - 1 / ratio) / cosh;
        conformal *= cosh;
        log_gradient[i] += tanh;
        log_gradient[j] -= tanh;
        const double slope = 1 / (cosh * cosh);
        log_hessian(i, i) += slope;
        log_hessian(j, j) += slope;
        log_hessian(i, j) = log_hessian(j, i) = -slope;
      }
    log_hessian = conformal * (log_hessian + log_gradient * log_gradient.transpose()).eval();
    log_hessian.array() += 0.5 * (d + 1 / d);
    log_gradient *= conformal;
    log_gradient.array() += 0.5 * (d - 1 / d);
    internal::from_logarithms<D>(s, log_gradient, log_hessian, gradient, hessian);
  }

  /// The singular values that `Slim` leads to: the minimiser of psi in each s_i, the others fixed. It is 1 for D = 2, where
  /// psi = 1/2 (s_1 + 1/s_1) (s_2 + 1/s_2), and between the minimisers of both parts for D = 3.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    Eigen::Matrix<double, D, 1> target = Eigen::Matrix<double, D, 1>::Ones();
    if(D == 3)
      for(int i = 0; i < D; ++i) {
        const double product = s[(i + 1) % D] * s[(i + 2) % D];
        target[i] = internal::stretch_minimizer<D>(*this, s, i, std::sqrt(product), 1 / product);
      }
    return target;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_AMIPS_H
