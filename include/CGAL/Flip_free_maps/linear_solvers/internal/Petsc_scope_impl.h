// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <mutex>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Petsc_scope::Petsc_scope() : m_lock(mutex())
{
  static_cast<void>(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr));
  static const Session session;
}

CGAL_FLIP_FREE_MAPS_INLINE Petsc_scope::~Petsc_scope() { static_cast<void>(PetscPopErrorHandler()); }

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_scope::is_ready()
{
  int mpi_is_over = 0;
  return PetscInitializeCalled && !PetscFinalizeCalled && MPI_Finalized(&mpi_is_over) == MPI_SUCCESS && mpi_is_over == 0;
}

CGAL_FLIP_FREE_MAPS_INLINE Petsc_scope::Session::Session()
{
  int mpi_is_over = 0;
  MPI_Finalized(&mpi_is_over);
  if(PetscInitializeCalled || PetscFinalizeCalled || mpi_is_over != 0)
    return;
  PETSC_MPI_THREAD_REQUIRED = MPI_THREAD_SERIALIZED;
  // Handlers that were set before would be lost, even if those of PETSc were removed again.
  const char* const option = "-no_signal_handler";
  is_ours = PetscOptionsSetValue(nullptr, option, nullptr) == 0 && PetscInitializeNoArguments() == 0;
  if(is_ours)
    static_cast<void>(PetscOptionsClearValue(nullptr, option));
}

CGAL_FLIP_FREE_MAPS_INLINE Petsc_scope::Session::~Session()
{
  if(is_ours && is_ready())
    static_cast<void>(PetscFinalize());
}

CGAL_FLIP_FREE_MAPS_INLINE std::mutex& Petsc_scope::mutex()
{
  static std::mutex mutex;
  return mutex;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_IMPL_H
