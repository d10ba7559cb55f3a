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
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::analyze_pattern(const Block_sparse_matrix& matrix)
{
  const std::int32_t owned = m_world.owned_unknowns();
  std::vector<std::array<std::int32_t, 2>> pairs;
  for(std::int32_t v = 0; v < owned; ++v)
    for(auto k = matrix.block_column_starts()[v] + 1; k < matrix.block_column_starts()[v + 1]; ++k)
      if(matrix.block_row_indices()[k] < owned)
        pairs.push_back({v, matrix.block_row_indices()[k]});
  m_own.build_pattern(owned, matrix.block_size(), pairs);
  m_centred.resize(0);
  m_levels = std::make_unique<Petsc_hierarchy>();
  return !m_world.any(owned > 0 && !m_levels->analyze_pattern(m_own));
}

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_hierarchy::set_positions(const Eigen::VectorXd& positions)
{
  const int b = m_own.block_size();
  m_levels->set_positions(positions);
  m_centred = positions;
  Eigen::Map<Eigen::MatrixXd> points(m_centred.data(), b, m_centred.size() / b);
  const double number = m_world.sum(static_cast<double>(points.cols()));
  for(int i = 0; i < b; ++i)
    points.row(i).array() -= m_world.sum(points.row(i).sum()) / number;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::build(const Block_sparse_matrix& matrix)
{
  Block_graph::with_block_size(m_own.block_size(), [&](auto size) { copy_blocks<size>(matrix); });
  bool is_built = true;
  if(m_own.rows() > 0) {
    const Petsc_scope scope;
    is_built = scope.is_ready() && m_levels->build(m_own);
  }
  if(m_world.any(!is_built))
    return false;
  if(m_world.size() > 1) {
    make_modes();
    build_coarse_system(matrix);
  }
  return true;
}

// Owned unknowns come first, and rows are ascending: the blocks of owned ones are the first of each column.
template <int b>
void Distributed_hierarchy::copy_blocks(const Block_sparse_matrix& matrix)
{
  m_own.set_zero();
  for(std::int32_t v = 0; v < m_own.number_of_vertices(); ++v)
    for(auto k = m_own.block_column_starts()[v]; k < m_own.block_column_starts()[v + 1]; ++k) {
      const std::int32_t w = m_own.block_row_indices()[k], slot = static_cast<std::int32_t>(k - m_own.block_column_starts()[v]);
      Eigen::Matrix<double, b, b> block;
      matrix.get_block(v, w, slot, block);
      m_own.add_block(v, w, slot, block);
    }
}

// Translations, and rotations around the middle of the mesh where rows are coordinates.
CGAL_FLIP_FREE_MAPS_INLINE void Distributed_hierarchy::make_modes()
{
  const int b = m_own.block_size();
  const bool rotates = m_world.any(m_centred.size() > 0) && (b == 2 || b == 3);
  const Eigen::VectorXd places = m_world.with_ghosts(rotates ? m_centred : Eigen::VectorXd(Eigen::VectorXd::Zero(m_own.rows())));
  m_modes.setZero(places.size(), rotates ? b * (b + 1) / 2 : b);
  for(Eigen::Index row = 0; row < places.size(); row += b) {
    int mode = b;
    for(int i = 0; i < b; ++i)
      m_modes(row + i, i) = 1;
    for(int i = 0; rotates && i < b; ++i)
      for(int j = i + 1; j < b; ++j, ++mode) {
        m_modes(row + i, mode) = -places[row + j];
        m_modes(row + j, mode) = places[row + i];
      }
  }
}

// The matrix between the motions of all parts: this rank forms the rows of its own, with the ghosts moving as their owners do.
CGAL_FLIP_FREE_MAPS_INLINE void Distributed_hierarchy::build_coarse_system(const Block_sparse_matrix& matrix)
{
  const Eigen::Index modes = m_modes.cols(), owned = m_own.rows(), size = modes * m_world.size();
  const int b = m_own.block_size();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(modes, size);
  const auto add = [&](int rank, Eigen::Index first, Eigen::Index number) {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(m_modes.rows(), modes);
    moved.middleRows(first, number) = m_modes.middleRows(first, number);
    const Eigen::MatrixXd forces = matrix.lower().selfadjointView<Eigen::Lower>() * moved;
    rows.middleCols(modes * rank, modes) += m_modes.topRows(owned).transpose() * forces.topRows(owned);
  };
  add(m_world.rank(), 0, owned);
  for(const auto& ghosts : m_world.ghosts_of_unknowns())
    add(ghosts.rank, Eigen::Index(b) * ghosts.first, Eigen::Index(b) * ghosts.number);
  const std::vector<double> all = m_world.gather(std::vector<double>(rows.data(), rows.data() + rows.size()));
  Eigen::MatrixXd system(size, size);
  for(int r = 0; r < m_world.size(); ++r)
    system.middleRows(modes * r, modes) = Eigen::Map<const Eigen::MatrixXd>(all.data() + r * modes * size, modes, size);
  // A part without unknowns has motions that move nothing.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (system + system.transpose()));
  const double vanishing = 1e-12 * eigen.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd inverses = eigen.eigenvalues().unaryExpr([vanishing](double value) { return value > vanishing ? 1 / value : 0.; });
  m_coarse = eigen.eigenvectors() * inverses.asDiagonal() * eigen.eigenvectors().transpose();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_hierarchy::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  bool is_solved = true;
  x.setZero(b.size());
  if(m_own.rows() > 0) {
    const Petsc_scope scope;
    is_solved = scope.is_ready() && m_levels->cycle(b, x) && x.allFinite();
  }
  if(m_world.any(!is_solved))
    return false;
  if(m_world.size() == 1)
    return true;
  const Eigen::Index modes = m_modes.cols();
  const auto own = m_modes.topRows(b.size());
  const Eigen::VectorXd forces = own.transpose() * b;
  const std::vector<double> all = m_world.gather(std::vector<double>(forces.data(), forces.data() + modes));
  const Eigen::Map<const Eigen::VectorXd> right(all.data(), static_cast<Eigen::Index>(all.size()));
  x += own * (m_coarse.middleRows(modes * m_world.rank(), modes) * right);
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_IMPL_H
