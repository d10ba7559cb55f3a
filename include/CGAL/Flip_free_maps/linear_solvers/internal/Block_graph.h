// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_BLOCK_GRAPH_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_BLOCK_GRAPH_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The pattern of a matrix for code that is made for blocks of 1, 2 or 3 rows: the graph of the vertices, lower triangle with
// diagonal by columns, or that of the rows where blocks are larger.
struct Block_graph
{
  using Index = Block_sparse_matrix::Index;

  Block_graph() = default;

  explicit Block_graph(const Block_sparse_matrix& matrix)
  {
    if(matrix.block_size() <= 3) {
      block_size = matrix.block_size();
      columns = matrix.block_column_starts();
      rows = matrix.block_row_indices();
    } else {
      columns = matrix.column_starts();
      rows.assign(matrix.row_indices().begin(), matrix.row_indices().end());
    }
  }

  std::int32_t number_of_vertices() const { return static_cast<std::int32_t>(columns.size()) - 1; }

  // Calls f with the size of the blocks as a constant.
  template <typename F>
  static decltype(auto) with_block_size(int block_size, F&& f)
  {
    if(block_size == 3)
      return f(std::integral_constant<int, 3>());
    if(block_size == 2)
      return f(std::integral_constant<int, 2>());
    return f(std::integral_constant<int, 1>());
  }

  // Calls `f(v, w, block)` for the blocks of a matrix with b rows per block, column by column, each with its diagonal block
  // first: `block[j]` refers to column j of the block in column v and row w. The diagonal block's columns begin with their
  // diagonal entry, so that j is added to the row to be read.
  template <int b, typename F>
  void for_each_block(const std::vector<double>& values, F&& f) const
  {
    const double* first = values.data();
    for(std::int32_t v = 0; v < number_of_vertices(); ++v) {
      const Index others = columns[v + 1] - columns[v] - 1;
      const double* block[b];
      for(int j = 0; j < b; ++j) {
        block[j] = first - j;
        first += b - j + others * b;
      }
      for(Index k = columns[v]; k < columns[v + 1]; ++k) {
        f(v, rows[k], block);
        for(int j = 0; j < b; ++j)
          block[j] += b;
      }
    }
  }

  int block_size = 1;
  std::vector<Index> columns;
  std::vector<std::int32_t> rows;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_BLOCK_GRAPH_H
