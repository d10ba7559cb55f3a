// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_PROJECT_TO_PSD_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_PROJECT_TO_PSD_H

#include <CGAL/Flip_free_maps/internal/Signed_svd.h>

#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Sets the negative eigenvalues of a symmetric matrix to zero; matrices that are diagonally dominant with a positive diagonal,
// the common case, are left as they are without computing eigenvalues.
template <int D>
void project_to_psd(Matrix<D>& matrix)
{
  bool dominant = true;
  for(int i = 0; i < D; ++i)
    dominant = dominant && 2 * matrix(i, i) >= matrix.row(i).cwiseAbs().sum();
  if(dominant)
    return;
  Eigen::SelfAdjointEigenSolver<Matrix<D>> eigen;
  eigen.computeDirect(matrix);
  const Vector<D> clamped = eigen.eigenvalues().cwiseMax(0);
  matrix = eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_PROJECT_TO_PSD_H
