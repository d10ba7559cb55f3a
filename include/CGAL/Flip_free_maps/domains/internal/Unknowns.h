// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_UNKNOWNS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_UNKNOWNS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Numbers the vertices that are not fixed, in their order: the unknowns of linear systems.
class Unknowns
{
public:
  Unknowns() = default;

  Unknowns(std::int32_t number_of_vertices, const std::vector<std::int32_t>& fixed) { assign(number_of_vertices, fixed); }

  void assign(std::int32_t number_of_vertices, const std::vector<std::int32_t>& fixed)
  {
    m_numbers.assign(number_of_vertices, 0);
    for(std::int32_t v : fixed)
      m_numbers[v] = -1;
    m_size = 0;
    for(std::int32_t& number : m_numbers)
      if(number == 0)
        number = m_size++;
  }

  // Vertices that are not fixed.
  std::int32_t size() const { return m_size; }

  std::int32_t number_of_vertices() const { return static_cast<std::int32_t>(m_numbers.size()); }

  bool is_fixed(std::int32_t v) const { return m_numbers[v] < 0; }

  // The number of a vertex among the unknowns, -1 for a fixed one.
  std::int32_t operator[](std::int32_t v) const { return m_numbers[v]; }

  const std::vector<std::int32_t>& numbers() const { return m_numbers; }

  // The same for several vertices.
  template <std::size_t N>
  std::array<std::int32_t, N> of(std::array<std::int32_t, N> vertices) const
  {
    for(std::int32_t& v : vertices)
      v = m_numbers[v];
    return vertices;
  }

  template <std::size_t N>
  std::vector<std::array<std::int32_t, N>> of(std::vector<std::array<std::int32_t, N>> stencils) const
  {
    for(auto& stencil : stencils)
      stencil = of(stencil);
    return stencils;
  }

  // Calls f(v, number) for the vertices that are not fixed.
  template <typename F>
  void for_each(F&& f) const
  {
    for(std::int32_t v = 0; v < number_of_vertices(); ++v)
      if(m_numbers[v] >= 0)
        f(v, m_numbers[v]);
  }

private:
  std::vector<std::int32_t> m_numbers;
  std::int32_t m_size = 0;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_UNKNOWNS_H
