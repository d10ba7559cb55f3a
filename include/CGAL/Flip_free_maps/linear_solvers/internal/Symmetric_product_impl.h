// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Symmetric_product.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Symmetric_product::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_graph = Block_graph(matrix);
  m_values.resize(matrix.number_of_entries());
}

CGAL_FLIP_FREE_MAPS_INLINE bool Symmetric_product::copy(const Block_sparse_matrix& matrix)
{
  if(m_values.size() != matrix.values().size())
    return false;
  std::copy(matrix.values().begin(), matrix.values().end(), m_values.begin());
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Symmetric_product::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const
{
  product.setZero(x.size());
  Block_graph::with_block_size(m_graph.block_size, [&](auto b) { multiply_blocks<b>(x.data(), product.data()); });
}

template <int b>
void Symmetric_product::multiply_blocks(const double* x, double* product) const
{
  m_graph.template for_each_block<b>(m_values, [x, product](std::int32_t v, std::int32_t w, const double* const* block) {
    const double* from_v = x + std::size_t(v) * b;
    const double* from_w = x + std::size_t(w) * b;
    double* to_v = product + std::size_t(v) * b;
    double* to_w = product + std::size_t(w) * b;
    if(v == w) {
      for(int j = 0; j < b; ++j) {
        to_v[j] += block[j][j] * from_v[j];
        for(int i = j + 1; i < b; ++i) {
          to_v[i] += block[j][i] * from_v[j];
          to_v[j] += block[j][i] * from_v[i];
        }
      }
      return;
    }
    // Sums that are no memory are free of stores that might change what is read next.
    double at_v[b], sum_v[b] = {};
    for(int j = 0; j < b; ++j)
      at_v[j] = from_v[j];
    for(int i = 0; i < b; ++i) {
      const double at_w = from_w[i];
      double sum_w = to_w[i];
      for(int j = 0; j < b; ++j) {
        sum_w += block[j][i] * at_v[j];
        sum_v[j] += block[j][i] * at_w;
      }
      to_w[i] = sum_w;
    }
    for(int j = 0; j < b; ++j)
      to_v[j] += sum_v[j];
  });
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SYMMETRIC_PRODUCT_IMPL_H
