// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {
class Petsc_factor;
} // namespace internal

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// The Cholesky factorization of MUMPS (Amestoy, Duff, L'Excellent and Koster 2001), as PETSc offers it.
///
/// Available when `CGAL_FLIP_FREE_MAPS_USE_PETSC` is defined, with a PETSc that has MUMPS; the analysis fails without. See
/// `Petsc_multigrid` for how PETSc is used.
///
/// \cgalModels{SymmetricSparseSolver}
class Petsc_direct_solver
{
public:
  Petsc_direct_solver();
  ~Petsc_direct_solver();
  Petsc_direct_solver(const Petsc_direct_solver&) = delete;
  Petsc_direct_solver& operator=(const Petsc_direct_solver&) = delete;

  /// "mumps"
  std::string name() const { return "mumps"; }
  /// MUMPS chooses by the matrix.
  std::string ordering() const { return "mumps"; }

  /// Computes the ordering and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  /// Factorizes; the pattern must be the one analysed. `false` when the matrix is not positive definite.
  bool factorize(const Block_sparse_matrix& matrix);

  /// Solves for one right-hand side with the last factorization.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Entries of the factor, known after the first factorization.
  std::int64_t factor_entries() const;

private:
  std::unique_ptr<internal::Petsc_factor> m_factor;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_direct_solver_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_H
