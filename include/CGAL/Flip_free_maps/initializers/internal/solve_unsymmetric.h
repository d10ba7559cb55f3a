// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_H

#include <CGAL/Flip_free_maps/internal/inline.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Solves with a sparse matrix and two right-hand sides, which are as long as the matrix has rows. `false` if it is singular.
bool solve_unsymmetric(const std::vector<Eigen::Triplet<double>>& matrix, const std::array<Eigen::VectorXd, 2>& right,
                       std::array<Eigen::VectorXd, 2>& left);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/solve_unsymmetric_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_SOLVE_UNSYMMETRIC_H
