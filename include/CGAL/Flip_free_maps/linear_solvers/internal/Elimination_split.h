// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Two sets of vertices that are not adjacent, each in the order of its elimination, and the separator between them, which is
// eliminated last. They are unions of subtrees of the elimination tree (Liu 1990),
// so the order of a whole factorization is kept in each part.
class Elimination_split
{
public:
  // Splits the work of a factorization into parts that are as equal as the tree allows.
  // `order[k]` is the vertex eliminated at place k, and `counts[k]` the entries of its column in the factor of the graph.
  template <typename Integer>
  Elimination_split(const Block_sparse_matrix& matrix, const Integer* order, const Integer* counts)
  {
    const std::int32_t n = static_cast<std::int32_t>(matrix.number_of_vertices());
    const std::vector<std::int32_t> parents = elimination_tree(matrix, order);

    std::vector<double> work(n);
    for(std::int32_t k = 0; k < n; ++k)
      work[k] = static_cast<double>(counts[k]) * counts[k];
    for(std::int32_t k = 0; k < n; ++k)
      if(parents[k] >= 0)
        work[parents[k]] += work[k];
    std::vector<std::vector<std::int32_t>> children(n);
    std::vector<Subtree> roots;
    double total = 0;
    for(std::int32_t k = 0; k < n; ++k) {
      if(parents[k] >= 0) {
        children[parents[k]].push_back(k);
      } else {
        roots.emplace_back(work[k], k);
        total += work[k];
      }
    }

    // From the top of the tree the vertices go to the separator, the largest subtree's root first, as long as that may help.
    std::priority_queue<Subtree> queue(roots.begin(), roots.end());
    std::vector<std::int32_t> removed;
    double best_cost = total;
    std::size_t best_size = 0;
    bool has_branched = roots.size() > 1;
    while(!queue.empty()) {
      if(has_branched) {
        const double cost = cost_of(queue, removed.size());
        if(cost < best_cost) {
          best_cost = cost;
          best_size = removed.size();
        }
      }
      if(queue.top().first < 0.25 * total || dense_work(removed.size()) >= best_cost)
        break;
      const std::int32_t k = queue.top().second;
      queue.pop();
      removed.push_back(k);
      for(std::int32_t child : children[k])
        queue.emplace(work[child], child);
      has_branched = children[k].size() > 1;
    }
    m_gain = best_cost > 0 ? total / best_cost : 1;
    if(m_gain < LEAST_GAIN)
      return;

    // The subtrees below, the largest first, each to the part with less work.
    std::vector<char> part(n, -1);
    for(std::size_t i = 0; i < best_size; ++i)
      part[removed[i]] = SEPARATOR;
    std::vector<Subtree> subtrees;
    for(std::int32_t k = 0; k < n; ++k)
      if(part[k] != SEPARATOR && (parents[k] < 0 || part[parents[k]] == SEPARATOR))
        subtrees.emplace_back(work[k], k);
    std::sort(subtrees.rbegin(), subtrees.rend());
    std::array<double, 2> load = {{0, 0}};
    for(const Subtree& subtree : subtrees) {
      const int lighter = load[1] < load[0] ? 1 : 0;
      part[subtree.second] = static_cast<char>(lighter);
      load[lighter] += subtree.first;
    }
    for(std::int32_t k = n; k-- > 0;)
      if(part[k] < 0)
        part[k] = part[parents[k]];
    for(std::int32_t k = 0; k < n; ++k)
      (part[k] == SEPARATOR ? m_separator : m_parts[part[k]]).push_back(static_cast<std::int32_t>(order[k]));
  }

  // Whether two threads would be well occupied; the parts are empty otherwise.
  bool is_worthwhile() const { return m_gain >= LEAST_GAIN && !m_parts[0].empty() && !m_parts[1].empty(); }

  const std::vector<std::int32_t>& part(int i) const { return m_parts[i]; }
  const std::vector<std::int32_t>& separator() const { return m_separator; }

private:
  using Subtree = std::pair<double, std::int32_t>; // work and root

  static constexpr char SEPARATOR = 2;
  static constexpr double LEAST_GAIN = 1.3;

  // Liu's algorithm with path compression. Returns the parent of each place, -1 for roots.
  template <typename Integer>
  static std::vector<std::int32_t> elimination_tree(const Block_sparse_matrix& matrix, const Integer* order)
  {
    const std::int32_t n = static_cast<std::int32_t>(matrix.number_of_vertices());
    std::vector<std::int32_t> places(n);
    for(std::int32_t k = 0; k < n; ++k)
      places[order[k]] = k;
    const auto& columns = matrix.block_column_starts();
    const auto& rows = matrix.block_row_indices();
    std::vector<std::int64_t> begin(n + 1, 0);
    const auto for_each_edge = [&](auto&& f) {
      for(std::int32_t v = 0; v < n; ++v)
        for(std::int64_t i = columns[v] + 1; i < columns[v + 1]; ++i)
          f((std::min)(places[v], places[rows[i]]), (std::max)(places[v], places[rows[i]]));
    };
    for_each_edge([&](std::int32_t, std::int32_t high) { ++begin[high + 1]; });
    for(std::int32_t k = 0; k < n; ++k)
      begin[k + 1] += begin[k];
    std::vector<std::int32_t> lower(begin[n]);
    {
      std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
      for_each_edge([&](std::int32_t low, std::int32_t high) { lower[next[high]++] = low; });
    }
    std::vector<std::int32_t> parents(n, -1), ancestors(n, -1);
    for(std::int32_t k = 0; k < n; ++k)
      for(std::int64_t i = begin[k]; i < begin[k + 1]; ++i) {
        std::int32_t r = lower[i];
        while(ancestors[r] >= 0 && ancestors[r] != k) {
          const std::int32_t next = ancestors[r];
          ancestors[r] = k;
          r = next;
        }
        if(ancestors[r] < 0)
          ancestors[r] = parents[r] = k;
      }
    return parents;
  }

  // What a separator costs beyond the subtrees: its matrix is dense, and is made, added up and factorized.
  static double dense_work(std::size_t size);

  // The time of two threads, in units of work.
  static double cost_of(std::priority_queue<Subtree> queue, std::size_t separator_size);

  double m_gain = 1;
  std::array<std::vector<std::int32_t>, 2> m_parts;
  std::vector<std::int32_t> m_separator;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_ELIMINATION_SPLIT_H
