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

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Replaces the eigenvalues of a symmetric matrix by their positive parts or, when `absolute`, by their absolute values. Matrices
// that are diagonally dominant with a positive diagonal, the common case, are left as they are without computing eigenvalues.
template <int N>
void project_to_psd(Eigen::Matrix<double, N, N>& matrix, bool absolute = false)
{
  bool dominant = true;
  for(int i = 0; i < N; ++i)
    dominant = dominant && 2 * matrix(i, i) >= matrix.row(i).cwiseAbs().sum();
  if(dominant)
    return;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen;
  if constexpr(N <= 3)
    eigen.computeDirect(matrix);
  else
    eigen.compute(matrix);
  Eigen::Matrix<double, N, 1> values = eigen.eigenvalues();
  values = values.cwiseMax(absolute ? Eigen::Matrix<double, N, 1>(-values) : Eigen::Matrix<double, N, 1>::Zero());
  matrix = eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template void project_to_psd<2>(Eigen::Matrix<double, 2, 2>&, bool);
extern template void project_to_psd<3>(Eigen::Matrix<double, 3, 3>&, bool);
extern template void project_to_psd<6>(Eigen::Matrix<double, 6, 6>&, bool);
extern template void project_to_psd<12>(Eigen::Matrix<double, 12, 12>&, bool);
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_PROJECT_TO_PSD_H
