// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <queue>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE double Elimination_split::dense_work(std::size_t size)
{
  const double s = static_cast<double>(size);
  return s * s * s;
}

CGAL_FLIP_FREE_MAPS_INLINE double Elimination_split::cost_of(std::priority_queue<Subtree> queue, std::size_t separator_size)
{
  std::array<double, 2> load = {{0, 0}};
  for(; !queue.empty(); queue.pop())
    load[load[1] < load[0] ? 1 : 0] += queue.top().first;
  return (std::max)(load[0], load[1]) + dense_work(separator_size);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_IMPL_H
