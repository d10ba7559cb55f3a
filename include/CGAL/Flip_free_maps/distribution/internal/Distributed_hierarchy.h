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
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_levels.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The rows of this rank as a part of a matrix of PETSc, and its coarser versions.
class Distributed_hierarchy
{
public:
  // Finds the place of each block in the rows of this rank, whose columns PETSc wants in the order of all unknowns.
  bool analyze_pattern(const Block_sparse_matrix& matrix, const Mpi_world& world);

  // Of the owned unknowns. Called by all ranks.
  void set_positions(const Eigen::VectorXd& positions, const Mpi_world& world);

  // `false` unless the blocks on the diagonal are positive definite.
  bool fill_values(const Block_sparse_matrix& matrix);

  // Builds all levels. Called by all ranks, within a Petsc_scope.
  bool build(MPI_Comm comm);

  // Called by all ranks, within a Petsc_scope.
  bool cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x) { return m_levels.cycle(b, x); }

  std::int64_t number_of_entries() const { return static_cast<std::int64_t>(m_columns.size()); }

private:
  template <int b>
  bool fill_blocks(const std::vector<double>& values);

  Block_graph m_graph;
  std::int64_t m_entries = -1;             // of the matrix analysed
  std::int32_t m_owned = 0;                // vertices whose rows are here
  std::vector<std::int32_t> m_row_sizes;   // blocks in the rows of each of them
  std::vector<std::int32_t> m_places[2];   // of each block of the graph in the rows of its column's vertex, and of its row's vertex
  std::vector<PetscInt> m_rows, m_columns; // local rows, columns by their numbers among all unknowns
  std::vector<double> m_values;            // only until PETSc has them
  Eigen::VectorXd m_centred;
  Petsc_handle<Mat, MatDestroy> m_matrix;
  Petsc_levels m_levels;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/internal/Distributed_hierarchy_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_DISTRIBUTED_HIERARCHY_H
