// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_AIGERMAN_ISOMETRIC_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_AIGERMAN_ISOMETRIC_H

#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The isometric distortion of Aigerman, Poranne and Lipman 2014, max(s_1, 1/s_D), in a smooth form: the power mean
/// psi(s) = (1/(2D) sum_i (s_i^p + s_i^-p))^(1/p). It is at most the maximum and at least (2D)^(-1/p) times it.
/// Its minimum is 1, at isometries, as that of the maximum.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Aigerman_isometric
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "aigerman_isometric"
  static const char* name() { return "aigerman_isometric"; }

  double exponent = 8; ///< p, at least 1

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    // With the largest power taken out of the sum nothing overflows.
    const Eigen::Array<double, D, 1> logarithm = s.array().log();
    const double largest = logarithm.abs().maxCoeff();
    const double sum = (exponent * (logarithm - largest)).exp().sum() + (-exponent * (logarithm + largest)).exp().sum();
    return std::exp(largest + std::log(sum / (2 * D)) / exponent);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const Eigen::Array<double, D, 1> logarithm = s.array().log();
    const double largest = logarithm.abs().maxCoeff();
    const Eigen::Array<double, D, 1> up = (exponent * (logarithm - largest)).exp();
    const Eigen::Array<double, D, 1> down = (-exponent * (logarithm + largest)).exp();
    const double sum = up.sum() + down.sum();
    const double psi = (std::min)(std::exp(largest + std::log(sum / (2 * D)) / exponent), internal::LARGEST_RATIO);
    const Eigen::Array<double, D, 1> a = up / sum, b = down / sum, q = a - b;
    gradient = psi * q / s.array();
    for(int i = 0; i < D; ++i)
      for(int j = i; j < D; ++j)
        hessian(i, j) = hessian(j, i) = psi * (1 - exponent) * (q[i] * q[j]) / s[i] / s[j];
    // The diagonal without cancellation: a and b of all singular values add up to 1.
    for(int i = 0; i < D; ++i) {
      double others = 0;
      for(int j = 0; j < D; ++j)
        others += j == i ? 0 : a[j] + b[j];
      const double diagonal = (exponent - 1) * (a[i] * (others + 3 * b[i]) - b[i] * b[i]) + (exponent + 1) * b[i];
      hessian(i, i) = psi * diagonal / s[i] / s[i];
    }
  }

  /// The Hessian of the convex part of psi: a norm of positive convex functions is convex, so it is the Hessian itself.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& /* s */, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    convex = hessian;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_AIGERMAN_ISOMETRIC_H
