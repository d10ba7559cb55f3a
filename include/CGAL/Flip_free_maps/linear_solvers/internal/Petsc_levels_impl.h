// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_levels.h>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::build(Mat matrix, PetscInt block_size, const Eigen::VectorXd& centred)
{
  m_levels.reset();
  if(m_matrix != matrix) {
    m_matrix = matrix;
    if(!succeeded(PetscObjectGetComm(reinterpret_cast<PetscObject>(matrix), &m_comm)) || MPI_Comm_size(m_comm, &m_ranks) != MPI_SUCCESS ||
       !succeeded(MatGetLocalSize(matrix, &m_rows, nullptr)) || !make_vector(block_size, nullptr, m_right) ||
       !make_vector(block_size, nullptr, m_left))
      return false;
  }
  return tell_rigid_motions(block_size, centred) && make_levels();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::make_vector(PetscInt block_size, const double* entries,
                                                          Petsc_handle<Vec, VecDestroy>& vector) const
{
  if(m_ranks == 1)
    return succeeded(VecCreateSeqWithArray(m_comm, block_size, m_rows, entries, vector.receive()));
  return succeeded(VecCreateMPIWithArray(m_comm, block_size, m_rows, PETSC_DETERMINE, entries, vector.receive()));
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::tell_rigid_motions(PetscInt block_size, const Eigen::VectorXd& centred)
{
  if(block_size == 1 || centred.size() != m_rows)
    return succeeded(MatSetNearNullSpace(m_matrix, nullptr));
  Petsc_handle<Vec, VecDestroy> coordinates;
  Petsc_handle<MatNullSpace, MatNullSpaceDestroy> motions;
  return make_vector(block_size, centred.data(), coordinates) && succeeded(MatNullSpaceCreateRigidBody(coordinates, motions.receive())) &&
         succeeded(MatSetNearNullSpace(m_matrix, motions));
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::make_levels()
{
  const bool made = succeeded(PCCreate(m_comm, m_levels.receive())) && succeeded(PCSetOptionsPrefix(m_levels, "flip_free_maps_")) &&
                    succeeded(PCSetOperators(m_levels, m_matrix, m_matrix)) && succeeded(PCSetType(m_levels, PCGAMG)) &&
                    succeeded(PCGAMGSetType(m_levels, PCGAMGAGG)) && succeeded(PCGAMGSetNSmooths(m_levels, 0)) &&
                    succeeded(PCGAMGSetAggressiveLevels(m_levels, 1)) && succeeded(PCGAMGSetCoarseEqLim(m_levels, COARSEST)) &&
                    // The finest level gets a smoother without need of them; PETSc would estimate them all the same.
                    succeeded(PCGAMGSetUseSAEstEig(m_levels, PETSC_TRUE)) && succeeded(PCGAMGSetEigenvalues(m_levels, 2, 0.1)) &&
                    succeeded(PCSetUp(m_levels)) && choose_smoothers();
  PCFailedReason reason = PC_NOERROR;
  if(made && succeeded(PCGetFailedReason(m_levels, &reason)) && reason == PC_NOERROR)
    return true;
  m_levels.reset();
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::choose_smoothers()
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
  return levels <= 1 || m_ranks > 1 || smooth_by_sweeps(levels - 1);
}

// Symmetric sweeps of Gauss-Seidel before and after the correction. Coarser matrices may have zeros on the diagonal, of aggregates
// that have fewer degrees of freedom than a rigid body.
CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::smooth_by_sweeps(PetscInt level)
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

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_levels::cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(m_levels == nullptr || b.size() != m_rows)
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

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_LEVELS_IMPL_H
