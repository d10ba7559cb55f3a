// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void weld_points(const Positions<3>& points, std::vector<std::int32_t>& first)
{
  std::vector<std::pair<std::uint64_t, std::int32_t>> order;
  for(std::size_t v = 0; v < first.size(); ++v) {
    if(first[v] < 0)
      continue;
    std::uint64_t hash = 0;
    for(int i = 0; i < 3; ++i) {
      // Adding 0 makes both zeros the same.
      const double c = points(i, v) + 0.;
      std::uint64_t bits;
      std::memcpy(&bits, &c, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    order.emplace_back(hash, static_cast<std::int32_t>(v));
  }
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> different;
  for(std::size_t i = 0; i < order.size(); ++i) {
    if(i == 0 || order[i].first != order[i - 1].first)
      different.clear();
    const std::int32_t v = order[i].second;
    const auto same = std::find_if(different.begin(), different.end(), [&](std::int32_t w) { return points.col(v) == points.col(w); });
    first[v] = same == different.end() ? v : *same;
    if(first[v] == v)
      different.push_back(v);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_IMPL_H
