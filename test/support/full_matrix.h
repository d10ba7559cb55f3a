// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_FULL_MATRIX_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_FULL_MATRIX_H

// Preconditioners' forms as dense D^2 x D^2 matrices on vec(dJ), columns of dJ stacked.

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

template <int D>
using Full_matrix = Eigen::Matrix<double, D * D, D * D>;

template <int D>
using Full_vector = Eigen::Matrix<double, D * D, 1>;

template <int D>
Full_vector<D> vec(const Eigen::Matrix<double, D, D>& m)
{
  return Eigen::Map<const Full_vector<D>>(m.data());
}

// In the frame of the singular vectors: acts on vec(K).
template <int D>
Full_matrix<D> matrix_in_frame(const FFM::Increment_form<D>& form)
{
  const auto at = [](int i, int j) { return j * D + i; };
  Full_matrix<D> full = Full_matrix<D>::Zero();
  for(int i = 0; i < D; ++i)
    for(int j = 0; j < D; ++j)
      full(at(i, i), at(j, j)) = form.stretch(i, j);
  int p = 0;
  for(int i = 0; i < D; ++i)
    for(int j = i + 1; j < D; ++j, ++p) {
      full(at(i, j), at(i, j)) = form.pairs[p].ij_ij;
      full(at(j, i), at(j, i)) = form.pairs[p].ji_ji;
      full(at(i, j), at(j, i)) = full(at(j, i), at(i, j)) = form.pairs[p].ij_ji;
    }
  return full;
}

// vec(U^T dJ V) = to_frame * vec(dJ)
template <int D>
Full_matrix<D> to_frame(const FFM::internal::Signed_svd<D>& svd)
{
  Full_matrix<D> result;
  for(int k = 0; k < D * D; ++k) {
    Eigen::Matrix<double, D, D> unit = Eigen::Matrix<double, D, D>::Zero();
    unit.data()[k] = 1;
    result.col(k) = vec<D>(svd.U.transpose() * unit * svd.V);
  }
  return result;
}

template <int D, typename Energy>
FFM::Element_state<D> state_at(const Eigen::Matrix<double, D, 1>& s, const Energy& energy)
{
  FFM::Element_state<D> state;
  state.s = s;
  energy.template derivatives<D>(state.s, state.gradient, state.hessian);
  return state;
}

template <int D, typename Preconditioner, typename Energy>
Full_matrix<D> frame_matrix(const Preconditioner& preconditioner, const Energy& energy, const Eigen::Matrix<double, D, 1>& s)
{
  FFM::Increment_form<D> form;
  preconditioner.form(state_at<D>(s, energy), energy, form);
  return matrix_in_frame<D>(form);
}

template <int D, typename Preconditioner, typename Energy>
Full_matrix<D> full_matrix(const Preconditioner& preconditioner, const Energy& energy, const Eigen::Matrix<double, D, D>& J)
{
  FFM::internal::Signed_svd<D> svd;
  FFM::internal::signed_svd(J, svd);
  const Full_matrix<D> turn = to_frame<D>(svd);
  return turn.transpose() * frame_matrix<D>(preconditioner, energy, svd.s) * turn;
}

// Second differences, of fourth order, of a function of the Jacobian.
template <int D, typename Value>
Eigen::MatrixXd hessian_by_differences(const Value& value, const Eigen::Matrix<double, D, D>& J)
{
  const double h = 1e-3 * J.inverse().norm() * J.determinant() / std::pow(J.norm(), D - 1);
  Eigen::MatrixXd hessian(D * D, D * D);
  const auto moved = [&](int i, int j, double a, double b) {
    Eigen::Matrix<double, D, D> m = J;
    m.data()[i] += a * h;
    m.data()[j] += b * h;
    return value(m);
  };
  for(int i = 0; i < D * D; ++i)
    for(int j = 0; j < D * D; ++j) {
      const auto mixed = [&](double k) {
        return (moved(i, j, k, k) - moved(i, j, k, -k) - moved(i, j, -k, k) + moved(i, j, -k, -k)) / (4 * k * k);
      };
      hessian(i, j) = (4 * mixed(1) - mixed(2)) / (3 * h * h);
    }
  return hessian;
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_FULL_MATRIX_H
