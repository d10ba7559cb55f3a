// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/internal/Distributed_hierarchy.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::analyze_pattern(const Block_sparse_matrix& matrix, const Mpi_world& world)
{
  m_graph = Block_graph(matrix);
  m_owned = world.owned_unknowns();
  m_entries = matrix.number_of_entries();
  const std::vector<std::int64_t>& numbers = world.global_unknowns();
  const int b = m_graph.block_size;
  // The blocks of each row: the number of their column among all unknowns, and twice their place in the graph, plus one where they are
  // transposed.
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> blocks(m_owned);
  const std::int32_t n = m_graph.number_of_vertices();
  for(std::int32_t v = 0; v < n; ++v)
    for(std::int64_t k = m_graph.columns[v]; k < m_graph.columns[v + 1]; ++k) {
      const std::int32_t w = m_graph.rows[k];
      if(v < m_owned)
        blocks[v].emplace_back(numbers[w], 2 * k);
      if(w != v && w < m_owned)
        blocks[w].emplace_back(numbers[v], 2 * k + 1);
    }
  for(auto& places : m_places)
    places.assign(m_graph.rows.size(), -1);
  m_row_sizes.resize(m_owned);
  m_rows.assign(1, 0);
  m_columns.clear();
  for(std::int32_t v = 0; v < m_owned; ++v) {
    std::sort(blocks[v].begin(), blocks[v].end());
    m_row_sizes[v] = static_cast<std::int32_t>(blocks[v].size());
    for(std::size_t i = 0; i < blocks[v].size(); ++i)
      m_places[blocks[v][i].second % 2][blocks[v][i].second / 2] = static_cast<std::int32_t>(i);
    if(static_cast<std::int64_t>(m_columns.size()) + b * b * m_row_sizes[v] > PETSC_MAX_INT || (numbers.back() + 1) * b > PETSC_MAX_INT)
      return false;
    for(int i = 0; i < b; ++i) {
      for(const auto& block : blocks[v])
        for(int j = 0; j < b; ++j)
          m_columns.push_back(static_cast<PetscInt>(block.first * b + j));
      m_rows.push_back(static_cast<PetscInt>(m_columns.size()));
    }
    blocks[v] = {};
  }
  m_columns.shrink_to_fit();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_hierarchy::set_positions(const Eigen::VectorXd& positions, const Mpi_world& world)
{
  const int b = m_graph.block_size;
  m_centred = positions;
  if(b == 1)
    return;
  Eigen::Map<Eigen::MatrixXd> points(m_centred.data(), b, m_centred.size() / b);
  const double number = world.sum(static_cast<double>(points.cols()));
  for(int i = 0; i < b; ++i)
    points.row(i).array() -= world.sum(points.row(i).sum()) / number;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::fill_values(const Block_sparse_matrix& matrix)
{
  m_values.resize(m_columns.size());
  return m_entries == matrix.number_of_entries() &&
         Block_graph::with_block_size(m_graph.block_size, [&](auto size) { return fill_blocks<size>(matrix.values()); });
}

template <int b>
bool Distributed_hierarchy::fill_blocks(const std::vector<double>& values)
{
  bool is_positive = true;
  std::int64_t k = -1;
  m_graph.for_each_block<b>(values, [&](std::int32_t v, std::int32_t w, const double* const* block) {
    ++k;
    if(v == w && v < m_owned) {
      Eigen::Matrix<double, b, b> diagonal;
      for(int j = 0; j < b; ++j)
        for(int i = j; i < b; ++i)
          diagonal(i, j) = diagonal(j, i) = block[j][i];
      is_positive = is_positive && Eigen::LLT<Eigen::Matrix<double, b, b>>(diagonal).info() == Eigen::Success && diagonal.allFinite();
      for(int i = 0; i < b; ++i)
        for(int j = 0; j < b; ++j)
          m_values[m_rows[v * b + i] + m_places[0][k] * b + j] = diagonal(i, j);
      return;
    }
    for(int i = 0; i < b; ++i)
      for(int j = 0; j < b; ++j) {
        if(v != w && v < m_owned)
          m_values[m_rows[v * b + j] + m_places[0][k] * b + i] = block[j][i];
        if(v != w && w < m_owned)
          m_values[m_rows[w * b + i] + m_places[1][k] * b + j] = block[j][i];
      }
  });
  return is_positive;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::build(MPI_Comm comm)
{
  m_levels.clear();
  const PetscInt rows = static_cast<PetscInt>(m_rows.size()) - 1, b = m_graph.block_size;
  bool made = true;
  if(m_matrix == nullptr)
    made = succeeded(MatCreateMPIAIJWithArrays(comm, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, m_rows.data(), m_columns.data(),
                                               m_values.data(), m_matrix.receive())) &&
           succeeded(MatSetBlockSize(m_matrix, b)) && succeeded(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE));
  else
    made = succeeded(MatUpdateMPIAIJWithArray(m_matrix, m_values.data()));
  m_values = std::vector<double>();
  return made && m_levels.build(m_matrix, b, m_centred);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_IMPL_H
