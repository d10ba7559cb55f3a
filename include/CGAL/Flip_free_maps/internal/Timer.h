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

#include <atomic>
#include <chrono>
#include <ctime>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

inline double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// CPU seconds of the calling thread; of all threads of the process where the system does not tell them apart.
inline double thread_cpu_seconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time;
  if(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// CPU seconds that tasks in other threads have spent for the work of one, in which it is the current account.
class Cpu_account
{
public:
  // That of the calling thread, null if nobody asks.
  static Cpu_account*& current()
  {
    static thread_local Cpu_account* account = nullptr;
    return account;
  }

  double seconds() const { return m_seconds; }

  void add(double seconds)
  {
    double before = m_seconds;
    while(!m_seconds.compare_exchange_weak(before, before + seconds)) {}
  }

private:
  std::atomic<double> m_seconds{0};
};

// Enters the time of its scope, a task, into an account, unless it is entered already.
class Task_timer
{
public:
  explicit Task_timer(Cpu_account* account)
    : m_account(account), m_before(Cpu_account::current()), m_begin(account != m_before ? thread_cpu_seconds() : 0)
  {
    Cpu_account::current() = account;
  }

  ~Task_timer()
  {
    Cpu_account::current() = m_before;
    if(m_account == m_before)
      return;
    const double seconds = thread_cpu_seconds() - m_begin;
    if(m_account != nullptr)
      m_account->add(seconds);
    // Who waits for tasks of his own may be given those of others.
    if(m_before != nullptr)
      m_before->add(-seconds);
  }

  Task_timer(const Task_timer&) = delete;
  Task_timer& operator=(const Task_timer&) = delete;

private:
  Cpu_account* m_account;
  Cpu_account* m_before;
  double m_begin;
};

// Adds the time of its scope to a sum, and the CPU time, with that of the tasks that the scope starts, to another one.
class Phase_timer
{
public:
  explicit Phase_timer(double& wall, double* cpu = nullptr)
    : m_wall(wall), m_cpu(cpu), m_wall_begin(wall_seconds()), m_account(Cpu_account::current())
  {
    if(m_cpu == nullptr)
      return;
    if(m_account == nullptr)
      Cpu_account::current() = &m_own_account;
    m_cpu_begin = cpu_seconds();
  }
  ~Phase_timer()
  {
    m_wall += wall_seconds() - m_wall_begin;
    if(m_cpu == nullptr)
      return;
    *m_cpu += cpu_seconds() - m_cpu_begin;
    Cpu_account::current() = m_account;
  }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;

private:
  double cpu_seconds() const { return thread_cpu_seconds() + (m_account != nullptr ? m_account : &m_own_account)->seconds(); }

  double& m_wall;
  double* m_cpu;
  double m_wall_begin;
  double m_cpu_begin = 0;
  Cpu_account* m_account; // of a larger scope
  Cpu_account m_own_account;
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
