// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
// Calls call(f, i) for i in [0, n), in parallel. The scheduler's templates are instantiated here only, not for each f.
void call_in_parallel(std::size_t n, void (*call)(void*, std::size_t), void* f);
#endif

// Calls f(i) for i in [0, n): in parallel when the tag allows it and TBB is linked.
template <typename ConcurrencyTag, typename F>
void for_each_index(std::size_t n, F&& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value) {
    using Function = std::remove_reference_t<F>;
    if(n > 1) {
      call_in_parallel(
        n, [](void* g, std::size_t i) { (*static_cast<Function*>(g))(i); }, const_cast<void*>(static_cast<const void*>(&f)));
      return;
    }
  }
#endif
  for(std::size_t i = 0; i < n; ++i)
    f(i);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/internal/for_each_index_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_FOR_EACH_INDEX_H
