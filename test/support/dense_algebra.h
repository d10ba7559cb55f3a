// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_DENSE_ALGEBRA_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_DENSE_ALGEBRA_H

// Eigen's decompositions of dense matrices, compiled once for all sizes: each size of its own takes seconds to compile.

#include <Eigen/Core>

namespace test_support {

// Of a symmetric matrix, in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
double smallest_eigenvalue(const Eigen::MatrixXd& symmetric);

// Smallest eigenvalue over the largest absolute one.
double relative_smallest_eigenvalue(const Eigen::MatrixXd& symmetric);

// The symmetric matrix with its eigenvalues changed by a function.
Eigen::MatrixXd with_changed_eigenvalues(const Eigen::MatrixXd& symmetric, double (*f)(double));

// In descending order.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

void decompose(const Eigen::MatrixXd& symmetric, Eigen::VectorXd& values, Eigen::MatrixXd& vectors);
void decompose(const Eigen::MatrixXd& square, Eigen::MatrixXd& U, Eigen::VectorXd& s, Eigen::MatrixXd& V);

// The least squares solution of A X = B that is shortest, whatever the rank.
Eigen::MatrixXd least_squares_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

template <int D>
struct Eigen_decomposition
{
  Eigen::Matrix<double, D, 1> values;
  Eigen::Matrix<double, D, D> vectors;

  explicit Eigen_decomposition(const Eigen::Matrix<double, D, D>& symmetric)
  {
    Eigen::VectorXd l;
    Eigen::MatrixXd Q;
    decompose(symmetric, l, Q);
    values = l;
    vectors = Q;
  }
};

// J = U diag(s) V^T with s >= 0.
template <int D>
struct Singular_value_decomposition
{
  Eigen::Matrix<double, D, D> U, V;
  Eigen::Matrix<double, D, 1> s;

  explicit Singular_value_decomposition(const Eigen::Matrix<double, D, D>& J)
  {
    Eigen::MatrixXd left, right;
    Eigen::VectorXd values;
    decompose(J, left, values, right);
    U = left;
    s = values;
    V = right;
  }
};

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_DENSE_ALGEBRA_H
