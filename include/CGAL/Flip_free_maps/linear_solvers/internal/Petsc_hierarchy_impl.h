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

#include <cmath>
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
  m_levels.reset();
  return m_entries == matrix.number_of_entries() &&
         Block_graph::with_block_size(m_graph.block_size, [&](auto size) { return fill_values<size>(matrix); }) && make_matrix() &&
         tell_rigid_motions() && make_levels();
}

// Makes PETSc's matrix of the arrays here, or tells it that they have changed.
CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::make_matrix()
{
  if(m_matrix != nullptr) {
    double* values = nullptr;
    return succeeded(MatSeqAIJGetArray(m_matrix, &values)) && succeeded(MatSeqAIJRestoreArray(m_matrix, &values));
  }
  const PetscInt rows = static_cast<PetscInt>(m_rows.size()) - 1, b = m_graph.block_size;
  return succeeded(VecCreateSeqWithArray(PETSC_COMM_SELF, b, rows, nullptr, m_right.receive())) &&
         succeeded(VecCreateSeqWithArray(PETSC_COMM_SELF, b, rows, nullptr, m_left.receive())) &&
         succeeded(
           MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, rows, rows, m_rows.data(), m_columns.data(), m_values.data(), m_matrix.receive())) &&
         succeeded(MatSetBlockSize(m_matrix, b)) && succeeded(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE));
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::tell_rigid_motions()
{
  const int b = m_graph.block_size;
  if(b == 1 || m_positions.size() + 1 != static_cast<Eigen::Index>(m_rows.size()))
    return succeeded(MatSetNearNullSpace(m_matrix, nullptr));
  // Motions around a far point look like translations.
  Eigen::VectorXd centred = m_positions;
  Eigen::Map<Eigen::MatrixXd> points(centred.data(), b, centred.size() / b);
  points.colwise() -= Eigen::VectorXd(points.rowwise().mean());
  Petsc_handle<Vec, VecDestroy> coordinates;
  Petsc_handle<MatNullSpace, MatNullSpaceDestroy> motions;
  return succeeded(
           VecCreateSeqWithArray(PETSC_COMM_SELF, b, static_cast<PetscInt>(centred.size()), centred.data(), coordinates.receive())) &&
         succeeded(MatNullSpaceCreateRigidBody(coordinates, motions.receive())) && succeeded(MatSetNearNullSpace(m_matrix, motions));
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::make_levels()
{
  const bool made = succeeded(PCCreate(PETSC_COMM_SELF, m_levels.receive())) &&
                    succeeded(PCSetOptionsPrefix(m_levels, "flip_free_maps_")) && succeeded(PCSetOperators(m_levels, m_matrix, m_matrix)) &&
                    succeeded(PCSetType(m_levels, PCGAMG)) && succeeded(PCGAMGSetType(m_levels, PCGAMGAGG)) &&
                    succeeded(PCGAMGSetNSmooths(m_levels, 0)) && succeeded(PCGAMGSetAggressiveLevels(m_levels, 1)) &&
                    succeeded(PCGAMGSetCoarseEqLim(m_levels, COARSEST)) &&
                    // The finest level gets a smoother without need of them; PETSc would estimate them all the same.
                    succeeded(PCGAMGSetUseSAEstEig(m_levels, PETSC_TRUE)) && succeeded(PCGAMGSetEigenvalues(m_levels, 2, 0.1)) &&
                    succeeded(PCSetUp(m_levels)) && choose_smoothers();
  PCFailedReason reason = PC_NOERROR;
  if(made && succeeded(PCGetFailedReason(m_levels, &reason)) && reason == PC_NOERROR)
    return true;
  m_levels.reset();
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::choose_smoothers()
{
  PetscInt levels = 0;
  if(!succeeded(PCMGSetCycleType(m_levels, PC_MG_CYCLE_W)) || !succeeded(PCMGGetLevels(m_levels, &levels)))
    return false;
  for(PetscInt level = 1; level < levels; ++level) {
    Mat interpolation = nullptr;
    // Restrictions are transposed interpolations, hence the root. The coarser matrices are those without it.
    if(!succeeded(PCMGGetInterpolation(m_levels, level, &interpolation)) || !succeeded(MatScale(interpolation, std::sqrt(OVERCORRECTION))))
      return false;
  }
  return levels <= 1 || smooth_by_sweeps(levels - 1);
}

// Symmetric sweeps of Gauss-Seidel before and after the correction. Coarser matrices may have zeros on the diagonal, of aggregates
// that have fewer degrees of freedom than a rigid body.
CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::smooth_by_sweeps(PetscInt level)
{
  KSP before = nullptr, after = nullptr;
  if(!succeeded(PCMGGetSmootherDown(m_levels, level, &before)) || !succeeded(PCMGGetSmootherUp(m_levels, level, &after)))
    return false;
  for(KSP smoother : {before, after}) {
    PC sweep = nullptr;
    if(!succeeded(KSPSetOperators(smoother, m_matrix, m_matrix)) || !succeeded(KSPSetType(smoother, KSPRICHARDSON)) ||
       !succeeded(KSPSetNormType(smoother, KSP_NORM_NONE)) ||
       !succeeded(KSPSetTolerances(smoother, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1)) ||
       !succeeded(KSPSetInitialGuessNonzero(smoother, smoother == after ? PETSC_TRUE : PETSC_FALSE)) ||
       !succeeded(KSPGetPC(smoother, &sweep)) || !succeeded(PCSetType(sweep, PCSOR)) ||
       !succeeded(PCSORSetSymmetric(sweep, SOR_LOCAL_SYMMETRIC_SWEEP)))
      return false;
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_hierarchy::cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(m_levels == nullptr || b.size() + 1 != static_cast<Eigen::Index>(m_rows.size()))
    return false;
  x.resize(b.size());
  if(!succeeded(VecPlaceArray(m_right, b.data())) || !succeeded(VecPlaceArray(m_left, x.data())))
    return false;
  const bool applied = succeeded(PCApply(m_levels, m_right, m_left));
  return succeeded(VecResetArray(m_right)) && succeeded(VecResetArray(m_left)) && applied;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_IMPL_H
