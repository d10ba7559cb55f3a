// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CHECK_DERIVATIVES_H
#define CGAL_FLIP_FREE_MAPS_CHECK_DERIVATIVES_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// Relative errors of the derivatives of an energy.
struct Derivative_report
{
  double gradient_error = 0; ///< of the gradient, compared with differences of values
  double hessian_error = 0;  ///< of the Hessian, compared with differences of gradients
};

/// \ingroup PkgFlipFreeMapsEnergies
/// Compares the derivatives of an energy with central differences of fourth order. Errors of right derivatives are about 1e-9,
/// those of wrong ones about 1; where psi changes very fast, a smaller step helps. NaN anywhere makes an error NaN.
///
/// \tparam D dimension, 2 or 3
/// \param energy a model of `DistortionEnergy`
/// \param s positive singular values, best all different, and not 1, where mistakes may cancel
/// \param step relative to each singular value, less than 0.5
/// \returns the norm of the difference, relative to the larger of both norms; for the gradient, which may vanish, to that plus
///   what it changes by in a step
template <int D, typename Energy>
Derivative_report check_derivatives(const Energy& energy, const Eigen::Matrix<double, D, 1>& s, double step = 1e-4)
{
  typedef Eigen::Matrix<double, D, 1> Vector;
  typedef Eigen::Matrix<double, D, D> Matrix;
  Vector gradient, differences;
  Matrix hessian, hessian_differences, unused;
  energy.template derivatives<D>(s, gradient, hessian);
  for(int i = 0; i < D; ++i) {
    double values[4];
    Vector gradients[4];
    const double h = step * s[i];
    for(int k = 0; k < 4; ++k) {
      Vector moved = s;
      moved[i] += (k < 2 ? k - 2 : k - 1) * h;
      values[k] = energy.template value<D>(moved);
      energy.template derivatives<D>(moved, gradients[k], unused);
    }
    differences[i] = (8 * (values[2] - values[1]) - (values[3] - values[0])) / (12 * h);
    hessian_differences.col(i) = (8 * (gradients[2] - gradients[1]) - (gradients[3] - gradients[0])) / (12 * h);
  }
  const auto quotient = [](double error, double scale) { return error == 0 ? 0 : error / scale; };
  const double hessian_norm = (std::max)(hessian.norm(), hessian_differences.norm());
  Derivative_report report;
  report.gradient_error =
    quotient((gradient - differences).norm(), (std::max)(gradient.norm(), differences.norm()) + step * s.maxCoeff() * hessian_norm);
  report.hessian_error = quotient((hessian - hessian_differences).norm(), hessian_norm);
  return report;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CHECK_DERIVATIVES_H
