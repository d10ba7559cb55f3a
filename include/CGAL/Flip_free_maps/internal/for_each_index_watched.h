// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_WATCHED_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_WATCHED_H

#include <CGAL/Flip_free_maps/internal/for_each_index.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <chrono>
#include <cstddef>
#include <future>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Calls f(i) for i in [0, n), in parallel when the tag allows it, TBB is linked and there are several threads: on others than the
// calling one, which calls `watch()` every few hundredths of a second meanwhile. When that throws, the exception comes out after all
// calls have ended. Otherwise all run on the calling thread, which does not call `watch()`: calls can do that themselves.
template <typename ConcurrencyTag, typename F, typename Watch>
void for_each_index_watched(std::size_t n, F&& f, Watch&& watch)
{
#ifdef CGAL_LINKED_WITH_TBB
  const int threads = tbb::this_task_arena::max_concurrency();
  if(std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value && n > 1 && threads > 1 &&
     tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1) {
    // The caller's bound on the number of threads holds for the new one, too. Leaving this scope waits for it.
    std::future<void> work = std::async(std::launch::async, [&] {
      tbb::task_arena arena(threads);
      arena.execute([&] { for_each_index<ConcurrencyTag>(n, f); });
    });
    while(work.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
      watch();
    work.get();
    return;
  }
#else
  static_cast<void>(watch);
#endif
  for(std::size_t i = 0; i < n; ++i)
    f(i);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_WATCHED_H
