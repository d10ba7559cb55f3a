// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {
class Distributed_hierarchy;
} // namespace internal

/// \ingroup PkgFlipFreeMapsWorlds
/// A preconditioner for a matrix of which each rank has the rows of the unknowns that it owns, to be used as
/// `Conjugate_gradient_solver<Distributed_multigrid, Mpi_world>`. A rank gives the matrix of its local unknowns, ghosts included, as it
/// was assembled of its elements; the rows of ghosts, which are not complete, are not read.
///
/// Each rank solves for its unknowns by a cycle of `Petsc_multigrid`, as if the others stood still, and the parts as rigid bodies, with
/// forces between them, are solved for exactly: the sum of both is what is found. PETSc's own multigrid over several ranks would
/// take fewer iterations where there are many of them, but adds up what ranks send in the order in which it arrives, and so finds
/// other bits each time. With one rank it is `Petsc_multigrid`.
///
/// Complexity: on each rank as `Petsc_multigrid`, and the cube of the number of ranks, times 200, for each matrix.
///
/// All ranks call all functions but names and `factor_entries()`, which is for this rank.
///
/// \cgalModels{SymmetricSparseSolver}
class Distributed_multigrid
{
public:
  static constexpr bool takes_positions = true; ///< for the rigid motions

  /// On the ranks of `world`, whose unknowns are numbered when a pattern is analysed.
  explicit Distributed_multigrid(const Mpi_world& world);
  ~Distributed_multigrid();
  Distributed_multigrid(const Distributed_multigrid&) = delete;
  Distributed_multigrid& operator=(const Distributed_multigrid&) = delete;

  /// "PETSc multigrid on each rank"
  std::string name() const { return "PETSc multigrid on each rank"; }
  /// "aggregation"
  std::string ordering() const { return "aggregation"; }

  /// Makes room for the rows of this rank.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// The positions of the owned unknowns.
  void set_positions(const Eigen::VectorXd& positions);

  /// Builds all levels. `false` on all ranks unless all blocks on the diagonal are positive definite.
  bool factorize(const Block_sparse_matrix& matrix);

  /// One cycle with the last hierarchy.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of the rows of this rank.
  std::int64_t factor_entries() const;

private:
  void release();

  Mpi_world m_world;
  std::unique_ptr<internal::Distributed_hierarchy> m_hierarchy;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/Distributed_multigrid_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_H
