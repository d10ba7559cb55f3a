// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_BLOCK_SPARSE_MATRIX_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_BLOCK_SPARSE_MATRIX_H

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// A symmetric sparse matrix with one b x b block per pair of adjacent vertices, of which the lower triangle is stored by
/// columns: row and column b v + i belong to coordinate i of vertex v. Every column begins with its diagonal entry and has its
/// rows in ascending order, the form that CHOLMOD (`stype` -1) and Eigen (`Lower`) take without a copy. The graph of the vertices
/// is kept beside it, since orderings are computed on it.
class Block_sparse_matrix
{
public:
  /// Type of column starts and row indices: 64 bits, since factors of large meshes have more than 2^31 entries.
  using Index = std::int64_t;

  /// Builds the pattern in which the vertices of each stencil are pairwise adjacent, with all entries zero. Negative numbers
  /// stand for vertices that are no unknowns, and are passed over.
  /// \tparam Stencils a range of arrays of vertex numbers
  template <typename Stencils>
  void build_pattern(std::int32_t number_of_vertices, int block_size, const Stencils& stencils)
  {
    build_pattern(number_of_vertices, block_size, stencils, std::vector<std::vector<std::int32_t>>());
  }

  /// The same for the stencils of both ranges.
  template <typename Stencils, typename OtherStencils>
  void build_pattern(std::int32_t number_of_vertices, int block_size, const Stencils& stencils, const OtherStencils& other_stencils)
  {
    m_block_size = block_size;
    const std::size_t n = number_of_vertices;

    // A counting sort of all pairs (smaller, larger), then each vertex' larger neighbours sorted and made unique.
    std::vector<Index> begin(n + 1, 0);
    const auto count = [&](std::int32_t low, std::int32_t) { ++begin[low + 1]; };
    for_each_pair(stencils, count);
    for_each_pair(other_stencils, count);
    for(std::size_t v = 0; v < n; ++v)
      begin[v + 1] += begin[v];
    std::vector<std::int32_t> neighbors(begin[n]);
    {
      std::vector<Index> next(begin.begin(), begin.end() - 1);
      const auto enter = [&](std::int32_t low, std::int32_t high) { neighbors[next[low]++] = high; };
      for_each_pair(stencils, enter);
      for_each_pair(other_stencils, enter);
    }
    m_block_columns.assign(n + 1, 0);
    m_block_rows.clear();
    m_block_rows.reserve(n + neighbors.size() / 2 + 1);
    for(std::size_t v = 0; v < n; ++v) {
      const auto first = neighbors.begin() + begin[v], last = neighbors.begin() + begin[v + 1];
      std::sort(first, last);
      m_block_rows.push_back(static_cast<std::int32_t>(v));
      m_block_rows.insert(m_block_rows.end(), first, std::unique(first, last));
      m_block_columns[v + 1] = static_cast<Index>(m_block_rows.size());
    }
    m_block_rows.shrink_to_fit();

    const int b = block_size;
    m_columns.assign(n * b + 1, 0);
    m_rows.clear();
    m_rows.reserve(m_block_rows.size() * b * b);
    for(std::size_t v = 0; v < n; ++v)
      for(int j = 0; j < b; ++j) {
        for(int i = j; i < b; ++i)
          m_rows.push_back(static_cast<Index>(v) * b + i);
        for(Index k = m_block_columns[v] + 1; k < m_block_columns[v + 1]; ++k)
          for(int i = 0; i < b; ++i)
            m_rows.push_back(static_cast<Index>(m_block_rows[k]) * b + i);
        m_columns[v * b + j + 1] = static_cast<Index>(m_rows.size());
      }
    m_rows.shrink_to_fit();
    m_values.assign(m_rows.size(), 0.);
  }

  /// The place of the block of vertices v and w among the blocks of column min(v, w), to be handed to `add_block()`; -1 if the
  /// pattern has no such block.
  std::int32_t slot(std::int32_t v, std::int32_t w) const
  {
    if(v > w)
      std::swap(v, w);
    const auto first = m_block_rows.begin() + m_block_columns[v], last = m_block_rows.begin() + m_block_columns[v + 1];
    const auto found = std::lower_bound(first, last, w);
    return found != last && *found == w ? static_cast<std::int32_t>(found - first) : -1;
  }

  /// Adds `block(i, j)` to row i of vertex v and column j of vertex w, and its transpose to the mirrored block; for v = w only
  /// the lower triangle of the block is read. Adding to blocks of different columns from several threads is safe.
  template <typename Block>
  void add_block(std::int32_t v, std::int32_t w, std::int32_t slot, const Block& block)
  {
    const int b = m_block_size;
    if(v == w) {
      for(int j = 0; j < b; ++j) {
        double* column = m_values.data() + m_columns[std::size_t(w) * b + j];
        for(int i = j; i < b; ++i)
          column[i - j] += block(i, j);
      }
      return;
    }
    const std::size_t low = v < w ? v : w;
    for(int j = 0; j < b; ++j) {
      double* column = m_values.data() + m_columns[low * b + j] + (b - j) + (slot - 1) * b;
      if(w < v)
        for(int i = 0; i < b; ++i)
          column[i] += block(i, j);
      else
        for(int i = 0; i < b; ++i)
          column[i] += block(j, i);
    }
  }

  /// Reads what `add_block()` adds to; for v = w only the lower triangle of `block` is written.
  template <typename Block>
  void get_block(std::int32_t v, std::int32_t w, std::int32_t slot, Block& block) const
  {
    const int b = m_block_size;
    if(v == w) {
      for(int j = 0; j < b; ++j) {
        const double* column = m_values.data() + m_columns[std::size_t(w) * b + j];
        for(int i = j; i < b; ++i)
          block(i, j) = column[i - j];
      }
      return;
    }
    const std::size_t low = v < w ? v : w;
    for(int j = 0; j < b; ++j) {
      const double* column = m_values.data() + m_columns[low * b + j] + (b - j) + (slot - 1) * b;
      for(int i = 0; i < b; ++i)
        (w < v ? block(i, j) : block(j, i)) = column[i];
    }
  }

  /// Sets all entries to zero.
  void set_zero() { std::fill(m_values.begin(), m_values.end(), 0.); }

  /// Diagonal entry i.
  double& diagonal(std::size_t i) { return m_values[m_columns[i]]; }
  /// Diagonal entry i.
  double diagonal(std::size_t i) const { return m_values[m_columns[i]]; }

  /// Rows per block.
  int block_size() const { return m_block_size; }
  /// Number of blocks of rows.
  Index number_of_vertices() const { return static_cast<Index>(m_block_columns.size()) - 1; }
  /// Number of rows.
  Index rows() const { return static_cast<Index>(m_columns.size()) - 1; }
  /// Number of stored entries.
  Index number_of_entries() const { return static_cast<Index>(m_values.size()); }

  /// Starts of the columns among `row_indices()` and `values()`.
  const std::vector<Index>& column_starts() const { return m_columns; }
  /// Rows of the stored entries.
  const std::vector<Index>& row_indices() const { return m_rows; }
  /// Stored entries.
  const std::vector<double>& values() const { return m_values; }
  /// The graph of the vertices, lower triangle with diagonal: starts of its columns.
  const std::vector<Index>& block_column_starts() const { return m_block_columns; }
  /// The graph of the vertices: rows.
  const std::vector<std::int32_t>& block_row_indices() const { return m_block_rows; }

  /// The lower triangle as a matrix of Eigen that refers to this matrix' arrays.
  Eigen::Map<const Eigen::SparseMatrix<double, Eigen::ColMajor, Index>> lower() const
  {
    return {rows(), rows(), number_of_entries(), m_columns.data(), m_rows.data(), m_values.data()};
  }

private:
  template <typename Stencils, typename F>
  static void for_each_pair(const Stencils& stencils, F&& f)
  {
    for(const auto& stencil : stencils)
      for(std::size_t a = 0; a < stencil.size(); ++a)
        for(std::size_t b = a + 1; b < stencil.size(); ++b)
          if(stencil[a] >= 0 && stencil[b] >= 0 && stencil[a] != stencil[b])
            f((std::min)(stencil[a], stencil[b]), (std::max)(stencil[a], stencil[b]));
  }

  int m_block_size = 0;
  std::vector<Index> m_block_columns;
  std::vector<std::int32_t> m_block_rows;
  std::vector<Index> m_columns;
  std::vector<Index> m_rows;
  std::vector<double> m_values;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_BLOCK_SPARSE_MATRIX_H
