// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_BASE_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_BASE_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Core>

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What `Incomplete_factor` offers whatever the size of the blocks.
class Incomplete_factor_base
{
public:
  virtual ~Incomplete_factor_base() = default;

  // Whether a shift was found that makes all pivots positive.
  virtual bool factorize(const Block_sparse_matrix& matrix) = 0;

  // Solves with the factors.
  virtual void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) = 0;

  // Entries of the factor off its diagonal blocks, and of these.
  virtual std::int64_t entries() const = 0;

  // The multiple of the diagonal that was added.
  double shift() const { return m_shift; }

protected:
  double m_shift = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_BASE_H
