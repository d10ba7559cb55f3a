// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_DIRICHLET_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_DIRICHLET_H

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The symmetric Dirichlet energy psi(s) = 1/(2D) sum_i (s_i^2 + s_i^-2) (Smith and Schaefer 2015), scaled so that an isometry
/// has energy 1, which is also its minimum (Liu et al. 2018, Table 1). It grows without bound when an element collapses.
/// Other papers' values: 4 times (Claici et al.), 2 times this one (Shtengel et al., Stein et al.) in the plane.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Symmetric_dirichlet
{
  /// Infinite on elements of measure zero.
  static constexpr bool has_barrier = true;

  /// Says that this very class, none that inherits from it, has `values()` and `gradients()`.
  using Vectorized_energy = Symmetric_dirichlet;

  /// "symmetric_dirichlet"
  static const char* name() { return "symmetric_dirichlet"; }

  /// psi at the singular values `s`, all positive.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return terms(Eigen::Array<double, D, 1>(s.array().square())).sum() / (2 * D);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const Eigen::Array<double, D, 1> inverse = s.array().inverse();
    const Eigen::Array<double, D, 1> cube = inverse.cube();
    gradient = slopes(Eigen::Array<double, D, 1>(s.array()), cube) / D;
    hessian.setZero();
    hessian.diagonal() = (1 + 3 * cube * inverse) / D;
  }

  /// psi of several elements at once: `s[i]` holds the i-th singular value of each.
  template <int D, typename Lanes>
  Lanes values(const std::array<Lanes, D>& s) const
  {
    Lanes sum = Lanes::Zero();
    for(const Lanes& s_i : s)
      sum += terms(Lanes(s_i.square()));
    return sum / (2 * D);
  }

  /// Derivatives of psi of several elements at once.
  template <int D, typename Lanes>
  void gradients(const std::array<Lanes, D>& s, std::array<Lanes, D>& gradient) const
  {
    for(int i = 0; i < D; ++i)
      gradient[i] = slopes(s[i], Lanes(s[i].inverse().cube())) / D;
  }

  /// The Hessian of the convex part of psi: psi is convex in the singular values, so it is the Hessian itself.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& /* s */, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    convex = hessian;
  }

private:
  // 2D times what each singular value contributes to psi, and half its derivative, for an array of singular values.
  template <typename Array>
  static Array terms(const Array& squares)
  {
    return squares + squares.inverse();
  }

  template <typename Array>
  static Array slopes(const Array& s, const Array& inverse_cubes)
  {
    return s - inverse_cubes;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_DIRICHLET_H
