// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_GRADIENT_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_GRADIENT_H

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The symmetric gradient energy psi(s) = 1/2 sum_i s_i^2 - log(s_1 ... s_D) (Stein, Li and Solomon 2022). Its minimum is D/2, at
/// isometries. Its barrier is weak: logarithmic.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Symmetric_gradient
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "symmetric_gradient"
  static const char* name() { return "symmetric_gradient"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return 0.5 * s.squaredNorm() - s.array().log().sum();
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const Eigen::Array<double, D, 1> inverse = s.array().inverse();
    gradient = s.array() - inverse;
    hessian.setZero();
    hessian.diagonal() = 1 + inverse.square();
  }

  /// The Hessian of the convex part of psi: psi is convex in the singular values, so it is the Hessian itself.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& /* s */, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    convex = hessian;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_GRADIENT_H
