// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_PARALLEL_INVOKE_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_PARALLEL_INVOKE_H

#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_invoke.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Runs both functions, at the same time if the tag allows it and there are threads.
template <typename ConcurrencyTag, typename F, typename G>
void parallel_invoke(F&& f, G&& g)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value) {
    const auto bound = [binding = Deadline::state(), account = Cpu_account::current()](auto& task) {
      return [binding, account, &task] {
        const Task_timer timer(account);
        const Bound_work work(binding);
        task();
      };
    };
    tbb::parallel_invoke(bound(f), bound(g));
    return;
  }
#endif
  f();
  g();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_PARALLEL_INVOKE_H
