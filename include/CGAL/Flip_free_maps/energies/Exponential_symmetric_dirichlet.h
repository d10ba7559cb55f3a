// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_SYMMETRIC_DIRICHLET_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_SYMMETRIC_DIRICHLET_H

#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The exponential symmetric Dirichlet energy psi(s) = exp(k psi_SD(s)), psi_SD the energy of `Symmetric_dirichlet` (Rabinovich
/// et al. 2017, Table I, after the exponential of Fu, Liu and Guo 2015). The larger k, the more the worst elements count. Its
/// minimum is exp(k), at isometries. k refers to an energy psi_SD of 1 for an isometry: it is 2D times the k for the plain sum of
/// s_i^2 + s_i^-2.
///
/// Beyond the exponent 50 the exponential is continued by its Taylor polynomial of second degree, convex and twice
/// differentiable, so that starts of high distortion have a finite energy.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Exponential_symmetric_dirichlet
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "exponential_symmetric_dirichlet"
  static const char* name() { return "exponential_symmetric_dirichlet"; }

  double factor = 1; ///< k, positive

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return internal::tame_exponential(factor * Symmetric_dirichlet().value<D>(s));
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    Symmetric_dirichlet().derivatives<D>(s, gradient, hessian);
    internal::exponentiate_derivatives<D>(factor, Symmetric_dirichlet().value<D>(s), gradient, hessian);
  }

  /// The Hessian of the convex part of psi: an increasing convex function of a convex one is convex, so it is the Hessian itself.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& /* s */, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    convex = hessian;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_SYMMETRIC_DIRICHLET_H
