// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_LARGEST_FLIP_FREE_STEP_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_LARGEST_FLIP_FREE_STEP_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

// Products of coordinates must neither vanish nor overflow: both matrices are scaled to 1, and the step is scaled back.
template <typename Matrix, typename Step>
double scaled_step(const Matrix& edges, const Matrix& increment, Step&& step)
{
  const double size = edges.cwiseAbs().maxCoeff(), speed = increment.cwiseAbs().maxCoeff();
  if(speed == 0)
    return std::numeric_limits<double>::infinity();
  return step(Matrix(edges / size), Matrix(increment / speed)) * (size / speed);
}

// For elements of moderate size; see below.
inline double step_of_triangle(const Eigen::Matrix2d& edges, const Eigen::Matrix2d& increment)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double c = edges.determinant();
  const double b =
    edges(0, 0) * increment(1, 1) + increment(0, 0) * edges(1, 1) - edges(0, 1) * increment(1, 0) - increment(0, 1) * edges(1, 0);
  const double a = increment.determinant();
  const double discriminant = b * b - 4 * a * c;
  if(!(discriminant >= 0))
    return infinity;
  const double root = std::sqrt(discriminant);
  if(b <= 0) {
    // Either the quadratic opens upwards and this is the smaller of two positive roots, or it is the only positive one.
    const double denominator = root - b;
    return denominator > 0 ? 2 * c / denominator : infinity;
  }
  return a < 0 ? (b + root) / (-2 * a) : infinity;
}

// Smallest positive root of c_0 + c_1 a + c_2 a^2 + c_3 a^3 with c_0 > 0, infinity when there is none. The cubic is cut at its
// extrema into monotone pieces; the first that ends at or below zero brackets the root, which bisection then encloses from below.
inline double smallest_positive_root(double c_0, double c_1, double c_2, double c_3)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto value = [=](double a) { return ((c_3 * a + c_2) * a + c_1) * a + c_0; };

  double knots[2];
  int number_of_knots = 0;
  {
    // Extrema: 3 c_3 a^2 + 2 c_2 a + c_1 = 0, by the quadratic formula that does not cancel.
    const double discriminant = c_2 * c_2 - 3 * c_3 * c_1;
    if(discriminant >= 0) {
      const double q = -(c_2 + std::copysign(std::sqrt(discriminant), c_2));
      const double candidates[2] = {q != 0 ? c_1 / q : infinity, c_3 != 0 ? q / (3 * c_3) : infinity};
      for(double candidate : candidates)
        if(candidate > 0 && std::isfinite(candidate))
          knots[number_of_knots++] = candidate;
      if(number_of_knots == 2 && knots[0] > knots[1])
        std::swap(knots[0], knots[1]);
    }
  }

  double low = 0, high = infinity;
  for(int k = 0; k < number_of_knots && high == infinity; ++k) {
    if(value(knots[k]) <= 0)
      high = knots[k];
    else
      low = knots[k];
  }
  if(high == infinity) {
    // Beyond the last extremum the sign at infinity decides.
    const double leading = c_3 != 0 ? c_3 : (c_2 != 0 ? c_2 : c_1);
    if(!(leading < 0))
      return infinity;
    // Cauchy's bound on the roots, approached by doubling so that the bracket stays tight.
    high = low > 0 ? 2 * low : 1;
    for(int i = 0; i < 1100 && value(high) > 0; ++i)
      high *= 2;
    if(!(value(high) <= 0))
      return infinity;
  }
  for(int i = 0; i < 1100; ++i) {
    const double middle = 0.5 * (low + high);
    if(middle <= low || middle >= high)
      break;
    (value(middle) > 0 ? low : high) = middle;
  }
  return low;
}

inline double step_of_tetrahedron(const Eigen::Matrix3d& edges, const Eigen::Matrix3d& increment)
{
  const auto mixed = [](const Eigen::Matrix3d& x, const Eigen::Matrix3d& y) {
    return y.col(0).dot(x.col(1).cross(x.col(2))) + y.col(1).dot(x.col(2).cross(x.col(0))) + y.col(2).dot(x.col(0).cross(x.col(1)));
  };
  return internal::smallest_positive_root(edges.determinant(), mixed(edges, increment), mixed(increment, edges), increment.determinant());
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// The smallest a > 0 with det(edges + a increment) = 0 for a triangle, `infinity` when there is none: the step at which a
/// positively oriented triangle collapses (Smith and Schaefer 2015, section 3.3). The determinant is a quadratic in a; its root
/// is taken in the form that does not cancel, without absolute thresholds, so that tiny triangles are judged like large ones.
///
/// \pre `edges` has a positive determinant
inline double largest_flip_free_step(const Eigen::Matrix2d& edges, const Eigen::Matrix2d& increment)
{
  return internal::scaled_step(edges, increment, internal::step_of_triangle);
}

/// \ingroup PkgFlipFreeMapsRef
/// The smallest a > 0 with det(edges + a increment) = 0 for a tetrahedron, `infinity` when there is none. The determinant is a
/// cubic in a, whose smallest positive root is bracketed between its extrema and bisected; degenerate leading coefficients need
/// no special treatment.
///
/// \pre `edges` has a positive determinant
inline double largest_flip_free_step(const Eigen::Matrix3d& edges, const Eigen::Matrix3d& increment)
{
  return internal::scaled_step(edges, increment, internal::step_of_tetrahedron);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_LARGEST_FLIP_FREE_STEP_H
