// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_CONFORMAL_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_CONFORMAL_H

#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The conformal energy of MIPS (Hormann and Greiner 2000): psi(s) = I_1 / d for D = 2 and (I_1 / 3)^(3/2) / d for D = 3, with
/// I_1 = sum_i s_i^2 and d = s_1 ... s_D. Its minimum is 2 for D = 2 and 1 for D = 3, at similarities: it measures the distortion
/// of angles, at any size. The scale of a map is therefore not determined; it remains near that of the start. It is infinite on
/// elements that collapse, except those that shrink to a point in all directions alike.
///
/// There is no `convex_hessian()`: psi is convex in the logarithms of the singular values, not in themselves.
///
/// \cgalModels{DistortionEnergy}
struct Conformal
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "conformal"
  static const char* name() { return "conformal"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    const double mean = internal::isochoric_squares<D>(s).mean();
    return D == 2 ? 2 * mean : mean * std::sqrt(mean);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    // With p_i = s_i^2 / I_1, the derivatives in log s_i are psi q_i with q_i = D p_i - 1.
    const Eigen::Array<double, D, 1> squares = internal::isochoric_squares<D>(s).min(internal::LARGEST_RATIO);
    const double mean = squares.mean();
    const double psi = D == 2 ? 2 * mean : mean * std::sqrt(mean);
    const Eigen::Matrix<double, D, 1> p = squares / squares.sum();
    const Eigen::Matrix<double, D, 1> q = D * p.array() - 1;
    Eigen::Matrix<double, D, D> log_hessian = q * q.transpose() - 2 * D * (p * p.transpose());
    log_hessian.diagonal() += 2 * D * p;
    internal::from_logarithms<D>(s, psi * q, psi * log_hessian, gradient, hessian);
  }

  /// The singular values that `Slim` leads to: all equal to the quadratic mean of the present ones, where every psi_i changes its
  /// sign.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    return Eigen::Matrix<double, D, 1>::Constant(std::sqrt(s.squaredNorm() / D));
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_CONFORMAL_H
