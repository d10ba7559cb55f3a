// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_MEMORY_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_MEMORY_H

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Bytes of the machine's memory, or those that this process may take if they are fewer; infinity where the system does not tell.
inline double physical_memory()
{
  double result = std::numeric_limits<double>::infinity();
#ifdef RLIMIT_AS
  rlimit limit;
  if(getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    result = static_cast<double>(limit.rlim_cur);
#endif
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if(pages > 0 && size > 0)
    result = (std::min)(result, static_cast<double>(pages) * static_cast<double>(size));
#endif
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_MEMORY_H
