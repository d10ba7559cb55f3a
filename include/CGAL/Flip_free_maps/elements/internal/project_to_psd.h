// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_PROJECT_TO_PSD_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_PROJECT_TO_PSD_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Replaces the eigenvalues of a symmetric matrix by their positive parts or, when `absolute`, by their absolute values. Matrices
// that are diagonally dominant with a positive diagonal, the common case, are left as they are without computing eigenvalues. Matrices
// of more than three rows are of a size that is known at run time, since the eigenvalues of each size take long to compile.
template <typename Matrix>
void project_to_psd(Matrix& matrix, bool absolute = false)
{
  bool dominant = true;
  for(int i = 0; i < matrix.rows(); ++i)
    dominant = dominant && 2 * matrix(i, i) >= matrix.row(i).cwiseAbs().sum();
  if(dominant)
    return;
  using Eigensystem = Eigen::SelfAdjointEigenSolver<Matrix>;
  Eigensystem eigen;
  if constexpr(Matrix::RowsAtCompileTime == 2 || Matrix::RowsAtCompileTime == 3)
    eigen.computeDirect(matrix);
  else
    eigen.compute(matrix);
  typename Eigensystem::RealVectorType values = eigen.eigenvalues();
  for(double& value : values)
    value = absolute ? std::abs(value) : (std::max)(value, 0.);
  matrix = (eigen.eigenvectors() * values.asDiagonal()).lazyProduct(eigen.eigenvectors().transpose());
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template void project_to_psd(Eigen::Matrix<double, 2, 2>&, bool);
extern template void project_to_psd(Eigen::Matrix<double, 3, 3>&, bool);
extern template void project_to_psd(Eigen::MatrixXd&, bool);
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_PROJECT_TO_PSD_H
