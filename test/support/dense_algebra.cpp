// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/dense_algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace test_support {

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

double smallest_eigenvalue(const Eigen::MatrixXd& symmetric) { return eigenvalues(symmetric)[0]; }

double relative_smallest_eigenvalue(const Eigen::MatrixXd& symmetric)
{
  const Eigen::VectorXd values = eigenvalues(symmetric);
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0 ? values[0] / largest : 0;
}

Eigen::MatrixXd with_changed_eigenvalues(const Eigen::MatrixXd& symmetric, double (*f)(double))
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  const Eigen::VectorXd values = eigen.eigenvalues().unaryExpr(f);
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) { return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues(); }

void decompose(const Eigen::MatrixXd& symmetric, Eigen::VectorXd& values, Eigen::MatrixXd& vectors)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  values = eigen.eigenvalues();
  vectors = eigen.eigenvectors();
}

void decompose(const Eigen::MatrixXd& square, Eigen::MatrixXd& U, Eigen::VectorXd& s, Eigen::MatrixXd& V)
{
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(square, Eigen::ComputeFullU | Eigen::ComputeFullV);
  U = svd.matrixU();
  s = svd.singularValues();
  V = svd.matrixV();
}

Eigen::MatrixXd least_squares_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B)
{
  return A.completeOrthogonalDecomposition().solve(B);
}

} // namespace test_support
