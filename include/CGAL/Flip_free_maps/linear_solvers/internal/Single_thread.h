// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_H

#include <mutex>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// CHOLMOD and MUMPS start threads of OpenMP for small loops inside a factorization, and OpenBLAS threads of its own for small
// products: on large meshes, waiting for them costs more than they bring, and sums of BLAS would depend on their number. Both
// libraries are looked up at run time, because which ones serve the solvers is only known then.
class Single_thread
{
public:
  Single_thread();
  ~Single_thread();
  Single_thread(const Single_thread&) = delete;
  Single_thread& operator=(const Single_thread&) = delete;

private:
  // A number that some library keeps.
  struct Setting
  {
    void (*set)(int) = nullptr;
    int (*get)() = nullptr;

    Setting(const char* setter, const char* getter);

    // Sets the value; the result is the one before.
    int exchange(int value) const;
  };

  // Each thread has its own.
  static const Setting& openmp();

  // One for the process, so the last of several users restores it.
  static const Setting& blas();
  struct Use
  {
    std::mutex mutex;
    int users = 0;
    int threads_before = 1;
  };
  static Use& blas_use();

  int m_openmp_before;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Single_thread_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SINGLE_THREAD_H
