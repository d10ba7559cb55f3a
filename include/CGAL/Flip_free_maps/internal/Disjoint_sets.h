// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_DISJOINT_SETS_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_DISJOINT_SETS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A partition of the numbers 0 to n - 1, at first into single ones. The smallest number of a set stands for it.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n = 0) { assign(n); }

  void assign(std::size_t n)
  {
    m_parents.resize(n);
    std::iota(m_parents.begin(), m_parents.end(), 0);
  }

  // The smallest number of the set of i.
  std::int32_t root(std::int32_t i)
  {
    while(m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  // Unites two sets; false if they are one already.
  bool unite(std::int32_t i, std::int32_t j)
  {
    const std::int32_t a = root(i), b = root(j);
    if(a == b)
      return false;
    m_parents[a < b ? b : a] = a < b ? a : b;
    return true;
  }

private:
  std::vector<std::int32_t> m_parents;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_DISJOINT_SETS_H
