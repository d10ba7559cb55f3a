// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_CLOSEST_ROTATION_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_CLOSEST_ROTATION_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Geometry>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The orthogonal Procrustes problem: the rotation R with the greatest <R, M>. R is the guess on entry, and stays where every
// rotation is as good as another.
inline void closest_rotation(const Matrix<2>& M, Matrix<2>& R)
{
  const double c = M(0, 0) + M(1, 1), s = M(1, 0) - M(0, 1);
  const double norm = std::sqrt(c * c + s * s);
  if(!(norm > 0))
    return;
  const double inverse = 1 / norm;
  R << c * inverse, -s * inverse, s * inverse, c * inverse;
}

// In space by Newton's method on the rotations, which takes two or three steps from the rotation of the iteration before. A
// stationary R is the maximum, and not a saddle, if and only if tr(S) I - S is positive definite for the symmetric S = R^T M;
// when it is not, or not clearly, the singular value decomposition decides.
inline void closest_rotation(const Matrix<3>& M, Matrix<3>& R)
{
  constexpr int MAX_STEPS = 6;
  constexpr double DEFINITE = 1e-6;

  for(int step = 0; step < MAX_STEPS; ++step) {
    const Matrix<3> S = R.transpose() * M;
    const Vector<3> a(S(2, 1) - S(1, 2), S(0, 2) - S(2, 0), S(1, 0) - S(0, 1));
    // tr(S) I - S = L diag(d) L^T
    const double b00 = S(1, 1) + S(2, 2), b11 = S(0, 0) + S(2, 2), b22 = S(0, 0) + S(1, 1);
    const double b10 = -0.5 * (S(1, 0) + S(0, 1)), b20 = -0.5 * (S(2, 0) + S(0, 2)), b21 = -0.5 * (S(2, 1) + S(1, 2));
    const double bound = DEFINITE * (std::abs(b00) + std::abs(b11) + std::abs(b22));
    if(!(b00 > bound))
      break;
    const double l10 = b10 / b00, l20 = b20 / b00;
    const double d1 = b11 - l10 * b10;
    if(!(d1 > bound))
      break;
    const double l21 = (b21 - l20 * b10) / d1;
    const double d2 = b22 - l20 * b20 - l21 * l21 * d1;
    if(!(d2 > bound))
      break;
    const double y1 = a[1] - l10 * a[0], y2 = a[2] - l20 * a[0] - l21 * y1;
    Vector<3> w;
    w[2] = y2 / d2;
    w[1] = y1 / d1 - l21 * w[2];
    w[0] = a[0] / b00 - l10 * w[1] - l20 * w[2];

    // The Cayley transform of the increment w.
    const double squared = w.squaredNorm();
    if(!(squared < 4))
      break;
    const Vector<3> k = 0.5 * w;
    const double f = 2 / (1 + 0.25 * squared);
    Matrix<3> C;
    C << 1 - f * (k[1] * k[1] + k[2] * k[2]), f * (k[0] * k[1] - k[2]), f * (k[0] * k[2] + k[1]), f * (k[0] * k[1] + k[2]),
      1 - f * (k[0] * k[0] + k[2] * k[2]), f * (k[1] * k[2] - k[0]), f * (k[0] * k[2] - k[1]), f * (k[1] * k[2] + k[0]),
      1 - f * (k[0] * k[0] + k[1] * k[1]);
    R = (R * C).eval();
    if(squared < 1e-14) {
      // Rounding errors of many products are removed before they add up.
      const Matrix<3> correction = 1.5 * Matrix<3>::Identity() - 0.5 * (R.transpose() * R);
      R = (R * correction).eval();
      return;
    }
  }
  Signed_svd<3> svd;
  signed_svd(M, svd);
  if(svd.s.allFinite())
    R = svd.U * svd.V.transpose();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_CLOSEST_ROTATION_H
