// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A copy of a matrix to multiply by: one index for each block, where the matrix has one for each entry.
class Symmetric_product
{
public:
  void analyze_pattern(const Block_sparse_matrix& matrix);

  // `false` if the matrix has another pattern than the one analysed.
  bool copy(const Block_sparse_matrix& matrix);

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const;

  Block_sparse_matrix::Index number_of_entries() const { return static_cast<Block_sparse_matrix::Index>(m_values.size()); }

private:
  template <int b>
  void multiply_blocks(const double* x, double* product) const;

  Block_graph m_graph;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Symmetric_product_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_H
