// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/internal/Single_thread.h>

#include <petscksp.h>

#include <mutex>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

static_assert(std::is_same<PetscScalar, double>::value, "a PETSc with real numbers of double precision is needed");

// PETSc is called only while one of these lives: one at a time, since PETSc may not be called by two threads at once. The first one
// initialises PETSc, and MPI if need be, unless the program has; what was initialised here is finalised when the program ends.
// PETSc catches no signal then, and prints no error.
class Petsc_scope
{
public:
  Petsc_scope();
  ~Petsc_scope();
  Petsc_scope(const Petsc_scope&) = delete;
  Petsc_scope& operator=(const Petsc_scope&) = delete;

  // Whether PETSc may be called: it may not before it could be initialised, nor after it, or MPI, was finalised.
  static bool is_ready();

private:
  struct Session
  {
    Session();
    ~Session();
    bool is_ours = false;
  };

  static std::mutex& mutex();

  std::lock_guard<std::mutex> m_lock;
  Single_thread m_single_thread;
};

// Whether a call of PETSc succeeded. Exhausted memory is an exception.
inline bool succeeded(PetscErrorCode code)
{
  if(code == PETSC_ERR_MEM)
    throw std::bad_alloc();
  return code == 0;
}

// Owns an object of PETSc, and is emptied within a Petsc_scope.
template <typename Object, PetscErrorCode (*destroy)(Object*)>
class Petsc_handle
{
public:
  Petsc_handle() = default;
  ~Petsc_handle() { reset(); }
  Petsc_handle(const Petsc_handle&) = delete;
  Petsc_handle& operator=(const Petsc_handle&) = delete;

  // The place where a new object is to be put.
  Object* receive()
  {
    reset();
    return &m_object;
  }

  operator Object() const { return m_object; }

  void reset()
  {
    if(m_object != nullptr && Petsc_scope::is_ready())
      static_cast<void>(destroy(&m_object));
    m_object = nullptr;
  }

private:
  Object m_object = nullptr;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_SCOPE_H
