// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_ARAP_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_ARAP_H

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The as-rigid-as-possible energy psi(s) = sum_i (s_i - 1)^2 (Liu et al. 2008): the squared distance of the Jacobian from the
/// rotations. Its minimum is 0, at isometries. It has no barrier: maps are kept free of flips by the bound on the step length
/// alone, and a run may end with elements that are about to collapse.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Arap
{
  /// Collapsed and flipped elements have finite energy.
  static constexpr bool has_barrier = false;

  /// "arap"
  static const char* name() { return "arap"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return (s.array() - 1).square().sum();
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    gradient = 2 * (s.array() - 1);
    hessian = 2 * Eigen::Matrix<double, D, D>::Identity();
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

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_ARAP_H
