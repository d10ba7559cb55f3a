// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/solve_unsymmetric.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <Eigen/SparseLU>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool solve_unsymmetric(const std::vector<Eigen::Triplet<double>>& matrix,
                                                  const std::array<Eigen::VectorXd, 2>& right, std::array<Eigen::VectorXd, 2>& left)
{
  const Eigen::Index size = right[0].size();
  Eigen::SparseMatrix<double> compressed(size, size);
  compressed.setFromTriplets(matrix.begin(), matrix.end());
  ask_deadline();
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(compressed);
  if(solver.info() != Eigen::Success)
    return false;
  for(int c = 0; c < 2; ++c)
    left[c] = solver.solve(right[c]);
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_IMPL_H
