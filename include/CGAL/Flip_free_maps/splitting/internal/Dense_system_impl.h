// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_IMPL_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/splitting/internal/Dense_system.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Dense_system::factorize(const Eigen::MatrixXd& matrix) { m_decomposition.compute(matrix); }

CGAL_FLIP_FREE_MAPS_INLINE Eigen::VectorXd Dense_system::solve(const Eigen::VectorXd& right) const { return m_decomposition.solve(right); }

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_INTERNAL_DENSE_SYSTEM_IMPL_H
