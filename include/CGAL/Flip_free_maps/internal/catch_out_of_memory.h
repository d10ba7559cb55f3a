// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_CATCH_OUT_OF_MEMORY_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_CATCH_OUT_OF_MEMORY_H

#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <new>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Calls `run()`; if memory does not suffice, or the time for a valid map, the summary says so.
template <typename Run, typename Summary>
void catch_out_of_memory(Run&& run, Summary& summary)
{
  try {
    run();
  } catch(const std::bad_alloc&) {
    summary.status = Status::out_of_memory;
    summary.message = "memory was exhausted";
  } catch(const Interruption& interruption) {
    summary.status = Status::interrupted;
    summary.message = std::string(interruption.what()) + ", and there is no valid map yet";
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_CATCH_OUT_OF_MEMORY_H
