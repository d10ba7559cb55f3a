// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_SLICES_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_SLICES_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Consecutive numbers on each rank.
class Slices
{
public:
  Slices() = default;

  // Called by all ranks, each with the size of its slice.
  Slices(const Mpi_world& world, std::size_t size) : m_rank(world.rank()), m_begin(1, 0)
  {
    for(const std::int64_t other : world.gather(std::vector<std::int64_t>(1, static_cast<std::int64_t>(size))))
      m_begin.push_back(m_begin.back() + other);
  }

  // The numbers of all ranks.
  std::int64_t size() const { return m_begin.back(); }

  // The first number of this rank, and those that it has.
  std::int64_t first() const { return m_begin[m_rank]; }
  std::int64_t own_size() const { return m_begin[m_rank + 1] - m_begin[m_rank]; }

  bool is_own(std::int64_t number) const { return number >= m_begin[m_rank] && number < m_begin[m_rank + 1]; }

  // The rank that has a number.
  std::size_t rank_of(std::int64_t number) const
  {
    return static_cast<std::size_t>(std::upper_bound(m_begin.begin(), m_begin.end(), number) - m_begin.begin()) - 1;
  }

private:
  std::size_t m_rank = 0;
  std::vector<std::int64_t> m_begin{0, 0};
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_SLICES_H
