// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_SIGNED_SVD_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_SIGNED_SVD_H

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

// J = U diag(s) V^T with rotations U and V, s descending, only the last s may be negative.
template <int D>
struct Signed_svd
{
  Matrix<D> U;
  Matrix<D> V;
  Vector<D> s;
};

// Singular values in the plane. With alpha = (a+d, c-b)/2 and beta = (a-d, c+b)/2 the singular values are |alpha| +- |beta|; the
// difference cancels for thin triangles, so the smaller one comes from the determinant.
inline Vector<2> signed_singular_values(const Matrix<2>& J)
{
  const double alpha_x = J(0, 0) + J(1, 1), alpha_y = J(1, 0) - J(0, 1);
  const double beta_x = J(0, 0) - J(1, 1), beta_y = J(1, 0) + J(0, 1);
  const double alpha = std::sqrt(alpha_x * alpha_x + alpha_y * alpha_y);
  const double beta = std::sqrt(beta_x * beta_x + beta_y * beta_y);
  const double s_0 = 0.5 * (alpha + beta);
  if(!(s_0 > 0))
    return Vector<2>::Zero();
  return Vector<2>(s_0, J.determinant() / s_0);
}

inline void signed_svd(const Matrix<2>& J, Signed_svd<2>& svd)
{
  // As complex numbers alpha = |alpha| e^{i(u-v)} and beta = |beta| e^{i(u+v)}, where U and V rotate by u and v: two half angles
  // without trigonometry.
  const double alpha_x = J(0, 0) + J(1, 1), alpha_y = J(1, 0) - J(0, 1);
  const double beta_x = J(0, 0) - J(1, 1), beta_y = J(1, 0) + J(0, 1);
  const double alpha = std::sqrt(alpha_x * alpha_x + alpha_y * alpha_y);
  const double beta = std::sqrt(beta_x * beta_x + beta_y * beta_y);
  const double p_x = alpha > 0 ? alpha_x / alpha : 1, p_y = alpha > 0 ? alpha_y / alpha : 0;
  const double q_x = beta > 0 ? beta_x / beta : p_x, q_y = beta > 0 ? beta_y / beta : p_y;
  // e^{2iv} = q conj(p)
  const double c_2 = q_x * p_x + q_y * p_y, s_2 = q_y * p_x - q_x * p_y;
  double c, s;
  if(c_2 >= 0) {
    c = std::sqrt(0.5 * (1 + c_2));
    s = s_2 / (2 * c);
  } else {
    s = std::copysign(std::sqrt(0.5 * (1 - c_2)), s_2);
    c = s_2 / (2 * s);
  }
  svd.V << c, -s, s, c;
  // e^{iu} = p e^{iv}
  const double u_x = p_x * c - p_y * s, u_y = p_x * s + p_y * c;
  svd.U << u_x, -u_y, u_y, u_x;
  const double s_0 = 0.5 * (alpha + beta);
  svd.s << s_0, (s_0 > 0 ? J.determinant() / s_0 : 0);
}

inline void signed_svd(const Matrix<3>& J, Signed_svd<3>& svd)
{
  // Eigen leaves the result of other matrices undefined.
  if(!J.allFinite()) {
    svd.U.setIdentity();
    svd.V.setIdentity();
    svd.s.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  Eigen::JacobiSVD<Matrix<3>, Eigen::NoQRPreconditioner> jacobi(J, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.U = jacobi.matrixU();
  svd.V = jacobi.matrixV();
  svd.s = jacobi.singularValues();
  if(svd.U.determinant() < 0) {
    svd.U.col(2) *= -1;
    svd.s[2] *= -1;
  }
  if(svd.V.determinant() < 0) {
    svd.V.col(2) *= -1;
    svd.s[2] *= -1;
  }
}

inline Vector<3> signed_singular_values(const Matrix<3>& J)
{
  Signed_svd<3> svd;
  signed_svd(J, svd);
  return svd.s;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_SIGNED_SVD_H
