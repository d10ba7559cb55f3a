// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The levels of algebraic multigrid above a matrix of PETSc, on the ranks that have its rows. All functions, and the destructor, need
// a Petsc_scope around them, and are called by all these ranks.
class Petsc_levels
{
public:
  // Builds all levels. `centred` holds the positions of the vertices of this rank's rows, around a place that all ranks have in
  // common: motions around a far point look like translations. Empty where rows are no coordinates. The matrix must live as long.
  bool build(Mat matrix, PetscInt block_size, const Eigen::VectorXd& centred);

  void clear() { m_levels.reset(); }

  // One cycle from zero.
  bool cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x);

private:
  // By which corrections of rigid pieces are lengthened: they are too stiff to bend, and corrections too short.
  static constexpr double OVERCORRECTION = 1.4;
  // Unknowns at which a direct solver takes over.
  static constexpr PetscInt COARSEST = 1000;

  bool make_vector(PetscInt block_size, const double* entries, Petsc_handle<Vec, VecDestroy>& vector) const;
  bool tell_rigid_motions(PetscInt block_size, const Eigen::VectorXd& centred);
  bool make_levels();
  bool choose_smoothers();
  bool smooth_by_sweeps(PetscInt level);

  MPI_Comm m_comm = MPI_COMM_SELF;
  int m_ranks = 1;
  PetscInt m_rows = 0; // of this rank
  Mat m_matrix = nullptr;
  Petsc_handle<Vec, VecDestroy> m_right, m_left;
  Petsc_handle<PC, PCDestroy> m_levels;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_levels_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_H
