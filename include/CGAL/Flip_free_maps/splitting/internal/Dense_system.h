// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_H

#include <Eigen/Core>
#include <Eigen/QR>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Small linear equations, which may depend on each other: the least solution of the least residual is found.
class Dense_system
{
public:
  void factorize(const Eigen::MatrixXd& matrix);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> m_decomposition;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/splitting/internal/Dense_system_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_H
