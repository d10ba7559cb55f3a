// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_MACHINE_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_MACHINE_H

#include <CGAL/version.h>

#include <Eigen/Core>

#include <boost/version.hpp>

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <cholmod.h>
#endif
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/version.h>
#endif

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace benchmark_support {

inline std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

// CPU seconds of all threads of the process.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Processor, threads, compiler and the versions of the libraries, in one line.
inline std::string machine()
{
  std::string text = processor() + "; " + std::to_string(std::thread::hardware_concurrency()) + " hardware threads";
#ifdef CGAL_LINKED_WITH_TBB
  text += ", " + std::to_string(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)) + " used";
#else
  text += ", 1 used";
#endif
#if defined(__clang__)
  text += "; Clang " __clang_version__;
#elif defined(__GNUC__)
  text += "; GCC " __VERSION__;
#endif
#ifndef NDEBUG
  text += " with assertions";
#endif
  text += "; CGAL " CGAL_VERSION_STR "; Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
          std::to_string(EIGEN_MINOR_VERSION) + "; Boost " BOOST_LIB_VERSION;
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  text += "; CHOLMOD " + std::to_string(CHOLMOD_MAIN_VERSION) + "." + std::to_string(CHOLMOD_SUB_VERSION) + "." +
          std::to_string(CHOLMOD_SUBSUB_VERSION);
#endif
#ifdef CGAL_LINKED_WITH_TBB
  text += "; oneTBB " + std::to_string(TBB_VERSION_MAJOR) + "." + std::to_string(TBB_VERSION_MINOR);
#endif
  return text;
}

// Forgets the largest resident memory so far, where the system allows it (Linux), so that runs in one process can be told apart.
inline void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

// Gives memory that is not in use back to the system, where that can be asked for (GNU), so that a run does not profit from, or
// is charged with, what the one before it needed.
inline void release_unused_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_MACHINE_H
