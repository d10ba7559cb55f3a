// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_SIGNED_SVD_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_SIGNED_SVD_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

// One-sided Jacobi: rotates the columns of B pairwise until they are orthogonal, and hands every rotation to `also`. Unlike the
// eigenvalues of B^T B it keeps the small singular values. B must be scaled to about 1.
template <typename AlsoRotate>
void orthogonalize_columns(Matrix<3>& B, AlsoRotate&& also)
{
  constexpr double EPSILON = 4 * std::numeric_limits<double>::epsilon();
  constexpr int MAX_SWEEPS = 30;
  const auto needs_another_visit = [&B, &also](int p, int q) {
    const double a = B.col(p).squaredNorm(), b = B.col(q).squaredNorm(), g = B.col(p).dot(B.col(q));
    if(!(g * g > EPSILON * EPSILON * a * b))
      return false;
    // The smaller of the two angles that make the columns orthogonal: its tangent is y / x.
    const double d = b - a, y = std::copysign(2, d) * g;
    const double x = std::abs(d) + std::sqrt(d * d + y * y);
    const double scale = 1 / std::sqrt(x * x + y * y), c = scale * x, s = scale * y;
    const Vector<3> old = B.col(p);
    B.col(p) = c * old - s * B.col(q);
    B.col(q) = s * old + c * B.col(q);
    also(p, q, c, s);
    // Three rotations as small as this one disturb each other only by products that are below the rounding errors. Small must be
    // both the cosine between the columns and the angle: the latter is large for columns of equal length,
    // the former for unequal ones.
    return g * g > EPSILON * a * b || s * s > EPSILON;
  };
  int good = 0;
  const auto visit = [&](int p, int q) {
    good = needs_another_visit(p, q) ? 0 : good + 1;
    return good < 3;
  };
  for(int sweep = 0; sweep < MAX_SWEEPS && visit(0, 1) && visit(0, 2) && visit(1, 2); ++sweep)
    ;
}

// The factor that brings the squares of squares of the entries into range; mostly 1.
inline double range_factor(const Matrix<3>& J)
{
  const double largest = J.cwiseAbs().maxCoeff();
  return largest > 0 && (largest < 1e-60 || largest > 1e60) ? largest : 1;
}

// The columns by descending length, and whether this permutation is even, that is a rotation.
struct Column_order
{
  std::array<int, 3> column = {{0, 1, 2}};
  bool is_even = true;

  explicit Column_order(const Vector<3>& squared_lengths)
  {
    const auto sort_pair = [&](int i, int j) {
      if(squared_lengths[column[i]] < squared_lengths[column[j]]) {
        std::swap(column[i], column[j]);
        is_even = !is_even;
      }
    };
    sort_pair(0, 1);
    sort_pair(1, 2);
    sort_pair(0, 1);
  }
};

inline void signed_svd(const Matrix<3>& J, Signed_svd<3>& svd)
{
  if(!J.allFinite()) {
    svd.U.setIdentity();
    svd.V.setIdentity();
    svd.s.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const double factor = range_factor(J);
  Matrix<3> B = J / factor, V = Matrix<3>::Identity();
  orthogonalize_columns(B, [&V](int p, int q, double c, double s) {
    const Vector<3> old = V.col(p);
    V.col(p) = c * old - s * V.col(q);
    V.col(q) = s * old + c * V.col(q);
  });
  const Column_order order(B.colwise().squaredNorm().transpose());
  for(int k = 0; k < 3; ++k)
    svd.V.col(k) = V.col(order.column[k]);
  if(!order.is_even)
    svd.V.col(2) *= -1;

  // Columns too short to be normalized have no direction; any one completes the rotation.
  constexpr double SHORTEST = 1e-140;
  const Vector<3> b_0 = B.col(order.column[0]), b_1 = B.col(order.column[1]);
  const double s_0 = b_0.norm(), s_1 = b_1.norm();
  if(s_0 > SHORTEST)
    svd.U.col(0) = b_0 / s_0;
  else
    svd.U.col(0) = Vector<3>::UnitX();
  const Vector<3> rest = b_1 - svd.U.col(0) * svd.U.col(0).dot(b_1);
  const double length = rest.norm();
  if(length > SHORTEST)
    svd.U.col(1) = rest / length;
  else
    svd.U.col(1) = svd.U.col(0).unitOrthogonal();
  svd.U.col(2) = svd.U.col(0).cross(svd.U.col(1));

  const double s_2 = svd.U.col(2).dot(B.col(order.column[2])) * (order.is_even ? 1 : -1);
  svd.s << s_0, s_1, (std::abs(s_2) < s_1 ? s_2 : std::copysign(s_1, s_2));
  svd.s *= factor;
}

inline Vector<3> signed_singular_values(const Matrix<3>& J)
{
  if(!J.allFinite())
    return Vector<3>::Constant(std::numeric_limits<double>::quiet_NaN());
  const double factor = range_factor(J);
  Matrix<3> B = J / factor;
  orthogonalize_columns(B, [](int, int, double, double) {});
  const Vector<3> squared_lengths = B.colwise().squaredNorm().transpose();
  const Column_order order(squared_lengths);
  const double s_0 = std::sqrt(squared_lengths[order.column[0]]), s_1 = std::sqrt(squared_lengths[order.column[1]]);
  const double s_2 = std::sqrt(squared_lengths[order.column[2]]);
  // Rotations keep the determinant; of orthogonal columns it is no difference of large numbers.
  const double determinant = B.col(0).dot(B.col(1).cross(B.col(2)));
  return factor * Vector<3>(s_0, s_1, std::copysign(s_2, determinant));
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_SIGNED_SVD_H
