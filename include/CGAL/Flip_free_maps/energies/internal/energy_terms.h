// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TERMS_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TERMS_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Derivatives in the singular values from those in their logarithms.
template <int D>
void from_logarithms(const Vector<D>& s, const Vector<D>& log_gradient, const Matrix<D>& log_hessian, Vector<D>& gradient,
                     Matrix<D>& hessian)
{
  gradient = log_gradient.array() / s.array();
  for(int i = 0; i < D; ++i)
    for(int j = i; j < D; ++j) {
      const double numerator = log_hessian(i, j) - (i == j ? log_gradient[i] : 0);
      hessian(i, j) = hessian(j, i) = numerator / s[i] / s[j];
    }
}

// s_i^2 / d^(2/D): the squares of the singular values after scaling to determinant 1. Roots are taken one by one, since the
// determinant may overflow.
template <int D>
Eigen::Array<double, D, 1> isochoric_squares(const Vector<D>& s)
{
  double mean = 1;
  for(int i = 0; i < D; ++i)
    mean *= D == 2 ? std::sqrt(s[i]) : std::cbrt(s[i]);
  return (s.array() / mean).square();
}

// Largest quotient in derivatives: beyond it they stop to grow, so that they neither overflow nor become NaN.
inline constexpr double LARGEST_RATIO = 1e50;

// exp(t) up to t = EXPONENT, continued by its Taylor polynomial of second degree, which is twice differentiable, convex,
// increasing and does not overflow on starts of high distortion. Next to an element of energy exp(50) ordinary ones are below
// rounding anyway.
inline constexpr double EXPONENT = 50;

inline double tame_exponential(double t)
{
  if(!(t > EXPONENT))
    return std::exp(t);
  const double x = t - EXPONENT;
  return std::exp(EXPONENT) * (1 + x + 0.5 * x * x);
}

// From the value and the derivatives of psi, the derivatives of tame_exponential(factor * psi).
template <int D>
void exponentiate_derivatives(double factor, double value, Vector<D>& gradient, Matrix<D>& hessian)
{
  const double t = factor * value;
  const double second = std::exp((std::min)(t, EXPONENT));
  const double first = second * (1 + (std::min)((std::max)(t - EXPONENT, 0.), LARGEST_RATIO));
  const Matrix<D> product = gradient * gradient.transpose();
  hessian = first * factor * hessian + second * factor * factor * product;
  gradient *= first * factor;
}

// The s_i between two bounds at which psi_i changes its sign from minus to plus, the other singular values fixed.
template <int D, typename Energy>
double stretch_minimizer(const Energy& energy, Vector<D> s, int i, double low, double high)
{
  if(low > high)
    std::swap(low, high);
  const auto slope = [&](double s_i) {
    Vector<D> gradient;
    Matrix<D> hessian;
    s[i] = s_i;
    energy.template derivatives<D>(s, gradient, hessian);
    return gradient[i] * s_i;
  };
  double slope_low = slope(low), slope_high = slope(high);
  if(!(slope_low < 0))
    return low;
  if(!(slope_high > 0))
    return high;
  // Regula falsi with halving of a side that stays (Illinois).
  int side = 0;
  for(int k = 0; k < 100 && high - low > 1e-12 * high; ++k) {
    double middle = (low * slope_high - high * slope_low) / (slope_high - slope_low);
    if(!(middle > low && middle < high) || k % 8 == 7)
      middle = 0.5 * (low + high);
    const double slope_middle = slope(middle);
    if(slope_middle == 0)
      return middle;
    const bool is_low = slope_middle < 0;
    (is_low ? low : high) = middle;
    (is_low ? slope_low : slope_high) = slope_middle;
    if(side == (is_low ? -1 : 1))
      (is_low ? slope_high : slope_low) *= 0.5;
    side = is_low ? -1 : 1;
  }
  return 0.5 * (low + high);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TERMS_H
