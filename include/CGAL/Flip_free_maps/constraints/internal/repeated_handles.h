// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_REPEATED_HANDLES_H
#define CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_REPEATED_HANDLES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Pairs of entries that name the same vertex, such that all entries of a vertex are equal if those of each pair are.
inline std::vector<std::pair<std::size_t, std::size_t>> repeated_handles(const std::vector<std::int32_t>& handles)
{
  std::vector<std::size_t> order(handles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&handles](std::size_t a, std::size_t b) { return handles[a] < handles[b]; });
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for(std::size_t i = 1; i < order.size(); ++i)
    if(handles[order[i]] == handles[order[i - 1]])
      result.emplace_back(order[i - 1], order[i]);
  return result;
}

// What is said of a vertex that is to be at two places.
constexpr const char* TWO_TARGETS = "a handle is given twice, with different targets";

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_REPEATED_HANDLES_H
