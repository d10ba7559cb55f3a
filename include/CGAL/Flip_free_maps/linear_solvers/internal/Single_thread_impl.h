// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Single_thread.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#endif

#include <mutex>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Single_thread::Single_thread() : m_openmp_before(openmp().exchange(0))
{
  const std::lock_guard<std::mutex> lock(blas_use().mutex);
  if(blas_use().users++ == 0)
    blas_use().threads_before = blas().exchange(1);
}

CGAL_FLIP_FREE_MAPS_INLINE Single_thread::~Single_thread()
{
  openmp().exchange(m_openmp_before);
  const std::lock_guard<std::mutex> lock(blas_use().mutex);
  if(--blas_use().users == 0)
    blas().exchange(blas_use().threads_before);
}

CGAL_FLIP_FREE_MAPS_INLINE Single_thread::Setting::Setting(const char* setter, const char* getter)
{
#if defined(__unix__) || defined(__APPLE__)
  set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, setter));
  get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, getter));
#else
  static_cast<void>(setter);
  static_cast<void>(getter);
#endif
}

CGAL_FLIP_FREE_MAPS_INLINE int Single_thread::Setting::exchange(int value) const
{
  if(set == nullptr || get == nullptr)
    return value;
  const int before = get();
  if(before != value)
    set(value);
  return before;
}

CGAL_FLIP_FREE_MAPS_INLINE const Single_thread::Setting& Single_thread::openmp()
{
  static const Setting setting("omp_set_max_active_levels", "omp_get_max_active_levels");
  return setting;
}

CGAL_FLIP_FREE_MAPS_INLINE const Single_thread::Setting& Single_thread::blas()
{
  static const Setting setting("openblas_set_num_threads", "openblas_get_num_threads");
  return setting;
}

CGAL_FLIP_FREE_MAPS_INLINE Single_thread::Use& Single_thread::blas_use()
{
  static Use use;
  return use;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_IMPL_H
