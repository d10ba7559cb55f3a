// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_ACCESSOR_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_ACCESSOR_H

#include "Gltf_container.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace program {

// What glTF calls types of numbers, and what buffer views are for.
inline constexpr std::size_t gltf_byte = 5120, gltf_unsigned_byte = 5121, gltf_short = 5122, gltf_unsigned_short = 5123,
                             gltf_unsigned_int = 5125, gltf_float = 5126;
inline constexpr std::size_t gltf_vertex_data = 34962, gltf_index_data = 34963;

// An array of numbers, vectors or matrices in buffers, all of which is there. Valid as long as the container's buffers are.
class Gltf_accessor
{
public:
  // `who` names its user in messages.
  Gltf_accessor(Gltf_container& container, std::size_t number, const std::string& who);

  std::size_t count() const { return m_count; }
  bool has_data() const { return m_base.data() != nullptr || m_sparse_count > 0; }

  // Whether it has elements of a type, as "VEC3".
  bool is(const std::string& type) const { return m_type == type; }

  // Whether its numbers are natural ones of 1, 2 or 4 bytes.
  bool is_natural() const;

  // All elements as vectors; normalized integers become fractions.
  template <std::size_t N>
  std::vector<std::array<double, N>> vectors() const
  {
    std::vector<std::array<double, N>> result(m_count);
    for(std::size_t i = 0; i < m_count && m_base.data() != nullptr; ++i)
      read(m_base.data() + i * m_stride, N, result[i].data());
    for(std::size_t i = 0; i < m_sparse_count; ++i)
      read(m_sparse_values.data() + i * m_size, N, result[sparse_index(i)].data());
    return result;
  }

  // Adds to the container the same accessor with further elements, which are copies of those given: bit for bit, and sparse if it is
  // sparse. Returns its number.
  std::size_t add_longer(Gltf_container& container, const std::vector<std::uint32_t>& copied) const;

private:
  std::string_view view(Gltf_container& container, const Json& user, std::size_t element_size, std::size_t count,
                        std::size_t& stride) const;
  void read_sparse(Gltf_container& container, const Json& sparse);
  std::size_t sparse_index(std::size_t i) const;
  double number(const char* bytes) const;

  void read(const char* bytes, std::size_t n, double* result) const
  {
    for(std::size_t k = 0; k < n; ++k)
      result[k] = number(bytes + k * m_component_size);
  }

  std::size_t m_number, m_count, m_component, m_component_size, m_size, m_stride = 0;
  bool m_is_normalized;
  std::string m_type, m_who;
  std::string_view m_base; // no data if all elements are 0 but those of the sparse ones
  std::size_t m_sparse_count = 0, m_sparse_component = 0;
  std::string_view m_sparse_indices, m_sparse_values;
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_ACCESSOR_H
