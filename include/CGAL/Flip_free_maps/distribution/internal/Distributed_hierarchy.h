// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_hierarchy.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The levels of this rank's unknowns among themselves, and above them the rigid motions of all parts as unknowns of a small dense
// system. All functions are called by all ranks.
class Distributed_hierarchy
{
public:
  explicit Distributed_hierarchy(const Mpi_world& world) : m_world(world) {}

  bool analyze_pattern(const Block_sparse_matrix& matrix);

  // Of the owned unknowns.
  void set_positions(const Eigen::VectorXd& positions);

  // `false` on all ranks unless the blocks on the diagonal are positive definite. Needs a Petsc_scope only within.
  bool build(const Block_sparse_matrix& matrix);

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  // Called within a Petsc_scope, by any rank.
  void release() { m_levels.reset(); }

  std::int64_t number_of_entries() const { return m_levels != nullptr ? m_levels->number_of_entries() : 0; }

private:
  template <int b>
  void copy_blocks(const Block_sparse_matrix& matrix);

  void make_modes();
  void build_coarse_system(const Block_sparse_matrix& matrix);

  Mpi_world m_world;
  Block_sparse_matrix m_own; // the rows and columns of owned unknowns
  std::unique_ptr<Petsc_hierarchy> m_levels;
  Eigen::VectorXd m_centred; // positions of owned unknowns
  Eigen::MatrixXd m_modes;   // the rigid motions at all local unknowns
  Eigen::MatrixXd m_coarse;  // the inverse of the small system
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/internal/Distributed_hierarchy_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_H
