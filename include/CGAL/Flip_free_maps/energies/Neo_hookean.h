// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_NEO_HOOKEAN_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_NEO_HOOKEAN_H

#include <CGAL/Flip_free_maps/elements/composite_majorizer.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_terms.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The Neo-Hookean energy psi(s) = mu/2 (I_1 / d^(2/D) - D) + kappa/2 (d - 1)^2, with I_1 = sum_i s_i^2 and d = s_1 ... s_D: for
/// D = 2 the one of Shtengel et al. 2017, equation 26, for D = 3 the usual one of a compressible material. Its minimum is 0, at
/// isometries. It is infinite on elements that collapse, except those that shrink to a point in all directions alike, whose
/// energy is kappa/2. That paper models rubber by mu / kappa = 0.002.
///
/// There is no `convex_hessian()`: the convex-concave decomposition of that paper is one in the Frobenius norm and the
/// determinant, not in the singular values. `composite_form()` has it.
///
/// \cgalModels{DistortionEnergy}
struct Neo_hookean
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "neo_hookean"
  static const char* name() { return "neo_hookean"; }

  double mu = 1;    ///< resistance to shear, positive
  double kappa = 1; ///< resistance to changes of area or volume, positive

  /// That of a material which for small strains is linearly elastic with these constants: in space, or in the plane that of a body
  /// which cannot leave it (plane strain).
  ///
  /// \param young Young's modulus, positive
  /// \param poisson Poisson's ratio, in (-1, 1/2)
  /// \param dimension 2 or 3
  static Neo_hookean of_material(double young, double poisson, int dimension)
  {
    Neo_hookean energy;
    energy.mu = young / (2 * (1 + poisson));
    // The bulk modulus, lambda + 2 mu / D.
    energy.kappa = young * poisson / ((1 + poisson) * (1 - 2 * poisson)) + 2 * energy.mu / dimension;
    return energy;
  }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    const double change = s.prod() - 1;
    return 0.5 * mu * (internal::isochoric_squares<D>(s).sum() - D) + 0.5 * kappa * change * change;
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const Eigen::Matrix<double, D, 1> squares = internal::isochoric_squares<D>(s).min(internal::LARGEST_RATIO);
    const double mean = squares.mean(), d = (std::min)(s.prod(), internal::LARGEST_RATIO);
    Eigen::Matrix<double, D, 1> log_gradient = mu * (squares.array() - mean) + kappa * (d - 1) * d;
    Eigen::Matrix<double, D, D> log_hessian;
    for(int i = 0; i < D; ++i)
      for(int j = 0; j < D; ++j)
        log_hessian(i, j) = 2 * mu * ((i == j ? squares[i] : 0) + (mean - (squares[i] + squares[j])) / D) + kappa * (2 * d - 1) * d;
    internal::from_logarithms<D>(s, log_gradient, log_hessian, gradient, hessian);
  }

  /// The singular values that `Slim` leads to: the minimiser of psi in each s_i, the others fixed; psi is convex in s_i. It is
  /// between the minimisers of both terms.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    Eigen::Matrix<double, D, 1> target;
    for(int i = 0; i < D; ++i) {
      Eigen::Matrix<double, D, 1> others = s;
      others[i] = 0;
      const double conformal = others.norm() / std::sqrt(D - 1.), volumetric = s[i] / s.prod();
      target[i] = internal::stretch_minimizer<D>(*this, s, i, conformal, volumetric);
    }
    return target;
  }

  /// The composition below exists in the plane.
  template <int D>
  static constexpr bool has_composite_form = D == 2;

  /// What `Composite_majorization` takes: psi = h(u, v) with the Frobenius norm u and the determinant v of J, and the convex
  /// function h(u, v) = mu/2 (u^2 / v - 2) + kappa/2 (v - 1)^2 (Shtengel et al. 2017, section 4). u is convex, and v is the
  /// difference of the convex functions |alpha|^2 and |beta|^2, where s = |alpha| +- |beta|. Always true.
  template <int D>
  bool composite_form(const Element_state<D>& state, Increment_form<D>& form) const
  {
    static_assert(D == 2, "a composition for the plane");
    const Eigen::Vector2d& s = state.s;
    const double u = s.norm(), v = s.prod();
    const Eigen::Vector2d h_gradient(mu * u / v, kappa * (v - 1) - 0.5 * mu * u * u / (v * v));
    Eigen::Matrix2d h_hessian;
    h_hessian << mu / v, -mu * u / (v * v), -mu * u / (v * v), mu * u * u / (v * v * v) + kappa;

    std::array<Inner_function<2>, 2> inner;
    inner[0].gradient = s / u;
    inner[0].convex.stretch = (Eigen::Matrix2d::Identity() - inner[0].gradient * inner[0].gradient.transpose()) / u;
    inner[0].convex.pairs[0].set_modes(1 / u, 1 / u);
    inner[0].concave.stretch.setZero();
    inner[1].gradient = Eigen::Vector2d(s[1], s[0]);
    inner[1].convex.stretch << 0.5, 0.5, 0.5, 0.5;
    inner[1].convex.pairs[0].set_modes(0, 1);
    inner[1].concave.stretch << 0.5, -0.5, -0.5, 0.5;
    inner[1].concave.pairs[0].set_modes(1, 0);
    composite_majorizer<2, 2>(h_gradient, h_hessian, inner, form);
    return true;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_NEO_HOOKEAN_H
