// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/cuthill_mckee_order.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Different for different numbers; the factor is 2^32 divided by the golden ratio (Knuth 1998, section 6.4).
inline std::uint32_t scattered(std::int32_t v) { return static_cast<std::uint32_t>(v) * 2654435761u; }

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> cuthill_mckee_order(const Block_graph& graph)
{
  // The neighbours of each vertex, smaller and larger.
  const std::int32_t n = graph.number_of_vertices();
  std::vector<Block_graph::Index> begin(std::size_t(n) + 1, 0);
  const auto for_each_edge = [&graph, n](auto&& f) {
    for(std::int32_t v = 0; v < n; ++v)
      for(Block_graph::Index k = graph.columns[v] + 1; k < graph.columns[v + 1]; ++k)
        f(v, graph.rows[k]);
  };
  for_each_edge([&begin](std::int32_t v, std::int32_t w) {
    ++begin[v + 1];
    ++begin[w + 1];
  });
  for(std::int32_t v = 0; v < n; ++v)
    begin[v + 1] += begin[v];
  std::vector<std::int32_t> neighbors(begin[n]);
  {
    std::vector<Block_graph::Index> next(begin.begin(), begin.end() - 1);
    for_each_edge([&](std::int32_t v, std::int32_t w) {
      neighbors[next[v]++] = w;
      neighbors[next[w]++] = v;
    });
  }

  std::vector<std::int32_t> order;
  order.reserve(n);
  std::vector<char> is_placed(n, 0);
  const auto append_breadth_first = [&](std::int32_t root) {
    std::size_t next = order.size();
    order.push_back(root);
    is_placed[root] = 1;
    for(; next < order.size(); ++next) {
      const std::int32_t v = order[next];
      const std::size_t first = order.size();
      for(Block_graph::Index k = begin[v]; k < begin[v + 1]; ++k)
        if(!is_placed[neighbors[k]]) {
          is_placed[neighbors[k]] = 1;
          order.push_back(neighbors[k]);
        }
      std::sort(order.begin() + first, order.end(), [](std::int32_t a, std::int32_t b) { return scattered(a) < scattered(b); });
    }
  };
  for(std::int32_t v = 0; v < n; ++v)
    if(!is_placed[v]) {
      // What is found last lies far out.
      const std::size_t first = order.size();
      append_breadth_first(v);
      const std::int32_t root = order.back();
      for(std::size_t i = first; i < order.size(); ++i)
        is_placed[order[i]] = 0;
      order.resize(first);
      append_breadth_first(root);
    }
  std::reverse(order.begin(), order.end());
  return order;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_IMPL_H
