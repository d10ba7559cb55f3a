// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_hierarchy.h>

#include <Eigen/Cholesky>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::analyze_pattern(const Block_sparse_matrix& matrix)
{
  m_graph = Block_graph(matrix);
  const std::int64_t n = m_graph.number_of_vertices(), b = m_graph.block_size;
  const std::int64_t entries = b * b * (2 * m_graph.columns.back() - n);
  if(n == 0 || entries > PETSC_MAX_INT)
    return false;
  m_entries = matrix.number_of_entries();
  m_before.assign(n, 0);
  for(std::int64_t v = 0; v < n; ++v)
    for(auto k = m_graph.columns[v] + 1; k < m_graph.columns[v + 1]; ++k)
      ++m_before[m_graph.rows[k]];
  m_rows.assign(1, 0);
  m_rows.reserve(n * b + 1);
  for(std::int64_t v = 0; v < n; ++v)
    for(int i = 0; i < b; ++i)
      m_rows.push_back(m_rows.back() + static_cast<PetscInt>(b * (m_before[v] + m_graph.columns[v + 1] - m_graph.columns[v])));
  m_columns.resize(entries);
  m_values.resize(entries);
  Block_graph::with_block_size(m_graph.block_size, [this](auto size) { fill_columns<size>(); });
  return true;
}

template <int b>
void Petsc_hierarchy::fill_columns()
{
  std::vector<std::int32_t> next(m_before.size(), 0);
  for(std::int32_t v = 0; v < m_graph.number_of_vertices(); ++v)
    for(auto k = m_graph.columns[v]; k < m_graph.columns[v + 1]; ++k) {
      const std::int32_t w = m_graph.rows[k];
      for(int i = 0; i < b; ++i)
        for(int j = 0; j < b; ++j) {
          m_columns[m_rows[v * b + i] + (m_before[v] + (k - m_graph.columns[v])) * b + j] = w * b + j;
          if(w != v)
            m_columns[m_rows[w * b + i] + next[w] * b + j] = v * b + j;
        }
      if(w != v)
        ++next[w];
    }
}

// `false` if a block on the diagonal is not positive definite.
template <int b>
bool Petsc_hierarchy::fill_values(const Block_sparse_matrix& matrix)
{
  std::vector<std::int32_t> next(m_before.size(), 0);
  bool is_positive = true;
  std::int32_t column = -1, after = 0;
  m_graph.for_each_block<b>(matrix.values(), [&](std::int32_t v, std::int32_t w, const double* const* block) {
    after = v == column ? after + 1 : 0;
    column = v;
    if(v == w) {
      Eigen::Matrix<double, b, b> diagonal;
      for(int j = 0; j < b; ++j)
        for(int i = j; i < b; ++i)
          diagonal(i, j) = diagonal(j, i) = block[j][i];
      is_positive = is_positive && Eigen::LLT<Eigen::Matrix<double, b, b>>(diagonal).info() == Eigen::Success && diagonal.allFinite();
      for(int i = 0; i < b; ++i)
        for(int j = 0; j < b; ++j)
          m_values[m_rows[v * b + i] + m_before[v] * b + j] = diagonal(i, j);
      return;
    }
    for(int i = 0; i < b; ++i)
      for(int j = 0; j < b; ++j) {
        m_values[m_rows[w * b + i] + next[w] * b + j] = block[j][i];
        m_values[m_rows[v * b + j] + (m_before[v] + after) * b + i] = block[j][i];
      }
    ++next[w];
  });
  return is_positive;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::build(const Block_sparse_matrix& matrix)
{
  m_levels.clear();
  return m_entries == matrix.number_of_entries() &&
         Block_graph::with_block_size(m_graph.block_size, [&](auto size) { return fill_values<size>(matrix); }) && make_matrix() &&
         m_levels.build(m_matrix, m_graph.block_size, centred_positions());
}

// Makes PETSc's matrix of the arrays here, or tells it that they have changed.
CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::make_matrix()
{
  if(m_matrix != nullptr) {
    double* values = nullptr;
    return succeeded(MatSeqAIJGetArray(m_matrix, &values)) && succeeded(MatSeqAIJRestoreArray(m_matrix, &values));
  }
  const PetscInt rows = static_cast<PetscInt>(m_rows.size()) - 1, b = m_graph.block_size;
  return succeeded(
           MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, rows, rows, m_rows.data(), m_columns.data(), m_values.data(), m_matrix.receive())) &&
         succeeded(MatSetBlockSize(m_matrix, b)) && succeeded(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE));
}

CGAL_FLIP_FREE_MAPS_INLINE Eigen::VectorXd Petsc_hierarchy::centred_positions() const
{
  const int b = m_graph.block_size;
  if(b == 1 || m_positions.size() + 1 != static_cast<Eigen::Index>(m_rows.size()))
    return Eigen::VectorXd();
  Eigen::VectorXd centred = m_positions;
  Eigen::Map<Eigen::MatrixXd> points(centred.data(), b, centred.size() / b);
  points.colwise() -= Eigen::VectorXd(points.rowwise().mean());
  return centred;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_IMPL_H
