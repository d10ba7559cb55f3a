// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {
class Petsc_hierarchy;
} // namespace internal

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The preconditioner of conjugate gradients for large meshes, algebraic multigrid of PETSc (GAMG): vertices are aggregated to
/// fewer and fewer ones that move as rigid bodies (Van&#283;k, Mandel and Brezina 1996), so that iterations hardly grow with the
/// mesh. To be used as `Conjugate_gradient_solver<Petsc_multigrid>`. What it solves for is the result of one W-cycle from zero,
/// which is a symmetric positive definite function of the right-hand side.
///
/// The rigid motions are those of the map that the matrix is made for, constant matrices not excepted: near the rest shape there is
/// no difference, and far from it those of the image are what remains to be found. Without positions, and where blocks do not
/// have a row for each coordinate, only translations are known.
///
/// Aggregates are not smoothed: that would take a third fewer iterations, and four times as long to set up, which is done for
/// every matrix. Instead corrections from coarser levels are lengthened (Braess 1995). The finest level is smoothed by symmetric
/// Gauss-Seidel sweeps, others by Chebyshev polynomials.
///
/// Complexity: linear in the entries of the matrix, each time; memory one and a half times that of the matrix.
///
/// Available when `CGAL_FLIP_FREE_MAPS_USE_PETSC` is defined, with PETSc 3.18 or later. PETSc is initialised when it is needed first, and
/// finalised at the end of the program, unless the program does so. It runs in this process alone, whether or not that was
/// started by MPI; solvers of several threads wait for each other.
///
/// \cgalModels{SymmetricSparseSolver}
class Petsc_multigrid
{
public:
  static constexpr bool takes_positions = true; ///< for the rigid motions

  Petsc_multigrid();
  ~Petsc_multigrid();
  Petsc_multigrid(const Petsc_multigrid&) = delete;
  Petsc_multigrid& operator=(const Petsc_multigrid&) = delete;

  /// "PETSc multigrid"
  std::string name() const { return "PETSc multigrid"; }
  /// "aggregation"
  std::string ordering() const { return "aggregation"; }

  /// Makes room for both triangles of the matrix. `false` if they have more entries than PETSc can count.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// The positions of the vertices that belong to the matrices factorized from now on, in the order of its rows.
  void set_positions(const Eigen::VectorXd& positions);

  /// Builds all levels; the pattern must be the one analysed. `false` unless all blocks on the diagonal are positive definite, and
  /// if PETSc fails.
  bool factorize(const Block_sparse_matrix& matrix);

  /// One cycle with the last hierarchy, which may lead far from a solution with the matrix.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of both triangles.
  std::int64_t factor_entries() const;

private:
  std::unique_ptr<internal::Petsc_hierarchy> m_hierarchy;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_H
