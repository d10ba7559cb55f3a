// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_AMIPS_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_AMIPS_H

#include <CGAL/Flip_free_maps/energies/Amips.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The exponential of AMIPS (Fu, Liu and Guo 2015): psi(s) = exp(k psi_A(s)), psi_A the energy of `Amips`. The larger k, the more
/// the worst elements count. Its minimum is exp(2k), at isometries. k refers to an energy psi_A of 2 for an isometry: it is half
/// the factor of a mean of parts that are 1 there.
///
/// Beyond the exponent 50 the exponential is continued by its Taylor polynomial of second degree, convex and twice
/// differentiable, so that starts of high distortion have a finite energy. There is no `convex_hessian()`, as for `Amips`.
///
/// \cgalModels{DistortionEnergy}
struct Exponential_amips
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "exponential_amips"
  static const char* name() { return "exponential_amips"; }

  double factor = 1; ///< k, positive

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return internal::tame_exponential(factor * Amips().value<D>(s));
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    Amips().derivatives<D>(s, gradient, hessian);
    internal::exponentiate_derivatives<D>(factor, Amips().value<D>(s), gradient, hessian);
  }

  /// The singular values that `Slim` leads to: those of `Amips`, since the exponential is increasing.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    return Amips().slim_target<D>(s);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_EXPONENTIAL_AMIPS_H
