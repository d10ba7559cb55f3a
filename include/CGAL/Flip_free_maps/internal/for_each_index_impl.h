// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_IMPL_H

#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
CGAL_FLIP_FREE_MAPS_INLINE void call_in_parallel(std::size_t n, void (*call)(void*, std::size_t), void* f)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n),
                    [call, f, account = Cpu_account::current()](const tbb::blocked_range<std::size_t>& range) {
                      const Task_timer timer(account);
                      for(std::size_t i = range.begin(); i != range.end(); ++i)
                        call(f, i);
                    });
}
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_IMPL_H
