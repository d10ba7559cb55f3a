// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_HENCKY_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_HENCKY_H

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The Hencky or log-ARAP energy psi(s) = sum_i (log s_i)^2 (Hencky 1928; Rabinovich et al. 2017, Table I). Its minimum is 0, at
/// isometries. It charges stretching by a factor like shrinking by it. Its barrier is weak: the square of a logarithm.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Hencky
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "hencky"
  static const char* name() { return "hencky"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return s.array().log().square().sum();
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const Eigen::Array<double, D, 1> inverse = s.array().inverse(), logarithm = s.array().log();
    gradient = 2 * logarithm * inverse;
    hessian.setZero();
    hessian.diagonal() = 2 * (1 - logarithm) * inverse.square();
  }

  /// The Hessian of the convex part of psi. (log s)^2 is convex up to s = e and concave beyond; its convex part is continued by
  /// the tangent there. A sum of functions of one variable each is split one by one.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& /* s */, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    convex = hessian.cwiseMax(0);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_HENCKY_H
