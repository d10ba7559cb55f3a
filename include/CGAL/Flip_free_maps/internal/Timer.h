// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_TIMER_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_TIMER_H

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

#include <chrono>
#include <ctime>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

inline double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// CPU seconds of all threads of the process.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Adds the time of its scope to a sum.
class Phase_timer
{
public:
  explicit Phase_timer(double& wall, double* cpu = nullptr)
    : m_wall(wall), m_cpu(cpu), m_wall_begin(wall_seconds()), m_cpu_begin(cpu != nullptr ? cpu_seconds() : 0)
  {}
  ~Phase_timer()
  {
    m_wall += wall_seconds() - m_wall_begin;
    if(m_cpu != nullptr)
      *m_cpu += cpu_seconds() - m_cpu_begin;
  }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;

private:
  double& m_wall;
  double* m_cpu;
  double m_wall_begin;
  double m_cpu_begin;
};

// Peak resident memory of the process in MiB, -1 where the system does not tell.
inline double peak_memory_mb()
{
#if defined(__unix__) || defined(__APPLE__)
  rusage usage;
  if(getrusage(RUSAGE_SELF, &usage) == 0) {
#ifdef __APPLE__
    return usage.ru_maxrss / (1024. * 1024.);
#else
    return usage.ru_maxrss / 1024.;
#endif
  }
#endif
  return -1;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_TIMER_H
