// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_accessor.h"

#include "../Binary_reader.h"

#include <algorithm>
#include <cstring>

namespace program {

namespace {

// In bytes; 0 for a type that does not exist.
std::size_t component_size(std::size_t type)
{
  return type == gltf_byte || type == gltf_unsigned_byte     ? 1
         : type == gltf_short || type == gltf_unsigned_short ? 2
         : type == gltf_unsigned_int || type == gltf_float   ? 4
                                                             : 0;
}

// Columns of matrices begin at multiples of four bytes.
std::size_t element_size(const std::string& type, std::size_t component)
{
  const auto matrix = [&](std::size_t n) { return n * ((n * component + 3) / 4 * 4); };
  return type == "SCALAR" ? component
         : type == "VEC2" ? 2 * component
         : type == "VEC3" ? 3 * component
         : type == "VEC4" ? 4 * component
         : type == "MAT2" ? matrix(2)
         : type == "MAT3" ? matrix(3)
         : type == "MAT4" ? matrix(4)
                          : 0;
}

bool is_natural_type(std::size_t component)
{
  return component == gltf_unsigned_byte || component == gltf_unsigned_short || component == gltf_unsigned_int;
}

template <typename Number>
Number read_number(const char* bytes)
{
  return Binary_reader(std::string_view(bytes, sizeof(Number)), false).read<Number>();
}

void append_index(std::string& bytes, std::size_t value, std::size_t size)
{
  for(std::size_t k = 0; k < size; ++k)
    bytes += static_cast<char>(value >> 8 * k & 255);
}

} // namespace

bool Gltf_accessor::is_natural() const { return is_natural_type(m_component) && !m_is_normalized; }

Gltf_accessor::Gltf_accessor(Gltf_container& container, std::size_t number, const std::string& who) : m_number(number)
{
  const Json& accessor = element(container.json, "accessors", number, who);
  m_who = who + ", accessor number " + std::to_string(number) + " (from 0)";
  m_count = count_of(accessor, "count", m_who);
  m_component = count_of(accessor, "componentType", m_who);
  m_component_size = component_size(m_component);
  const Json* type = member(accessor, "type");
  m_type = type != nullptr && type->is_string() ? type->get<std::string>() : "";
  m_size = element_size(m_type, m_component_size);
  check(m_size > 0 && m_count > 0, m_who + " has an unknown type, or no elements");
  const Json* normalized = member(accessor, "normalized");
  m_is_normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
  if(member(accessor, "bufferView") != nullptr)
    m_base = view(container, accessor, m_size, m_count, m_stride);
  if(const Json* sparse = member(accessor, "sparse"))
    read_sparse(container, *sparse);
  // What no data stand for needs no memory before it is read.
  check(m_count <= container.size(), m_who + " claims " + std::to_string(m_count) + " elements, more than the file has bytes");
}

std::string_view Gltf_accessor::view(Gltf_container& container, const Json& user, std::size_t size, std::size_t count,
                                     std::size_t& stride) const
{
  const Json& view = element(container.json, "bufferViews", count_of(user, "bufferView", m_who), m_who);
  if(const Json* extensions = member(view, "extensions"))
    for(const char* compression : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      check(member(*extensions, compression) == nullptr,
            m_who + " is compressed by " + compression + ", which is not read; meshopt's gltfpack -noq decompresses such files");
  const std::size_t begin = count_of(view, "byteOffset", m_who, 0), length = count_of(view, "byteLength", m_who);
  const std::size_t offset = count_of(user, "byteOffset", m_who, 0);
  stride = count_of(view, "byteStride", m_who, size);
  const std::string_view buffer = container.buffer(count_of(view, "buffer", m_who));
  check(begin <= buffer.size() && length <= buffer.size() - begin, m_who + " has a buffer view that leaves its buffer");
  check(stride >= size && stride <= 65535, m_who + " has a buffer view with a wrong byteStride");
  check(offset <= length && size <= length - offset && (count - 1) <= (length - offset - size) / stride,
        m_who + " leaves its buffer view, which has " + std::to_string(length) + " bytes");
  return buffer.substr(begin + offset, (count - 1) * stride + size);
}

void Gltf_accessor::read_sparse(Gltf_container& container, const Json& sparse)
{
  const Json *indices = member(sparse, "indices"), *values = member(sparse, "values");
  check(indices != nullptr && values != nullptr, m_who + " is sparse without indices or values");
  m_sparse_count = count_of(sparse, "count", m_who);
  m_sparse_component = count_of(*indices, "componentType", m_who);
  const std::size_t size = component_size(m_sparse_component);
  check(m_sparse_count > 0 && m_sparse_count <= m_count && is_natural_type(m_sparse_component),
        m_who + " has a wrong count or type of sparse elements");
  std::size_t stride;
  m_sparse_indices = view(container, *indices, size, m_sparse_count, stride);
  check(stride == size, m_who + " has sparse indices that are interleaved");
  m_sparse_values = view(container, *values, m_size, m_sparse_count, stride);
  check(stride == m_size, m_who + " has sparse values that are interleaved");
  bool is_rising = sparse_index(m_sparse_count - 1) < m_count;
  for(std::size_t i = 1; i < m_sparse_count; ++i)
    is_rising = is_rising && sparse_index(i - 1) < sparse_index(i);
  check(is_rising, m_who + " has sparse indices that are too large, or do not rise");
}

std::size_t Gltf_accessor::sparse_index(std::size_t i) const
{
  const std::size_t size = component_size(m_sparse_component);
  const char* bytes = m_sparse_indices.data() + i * size;
  return size == 1 ? read_number<std::uint8_t>(bytes) : size == 2 ? read_number<std::uint16_t>(bytes) : read_number<std::uint32_t>(bytes);
}

double Gltf_accessor::number(const char* bytes) const
{
  const double divisor = m_is_normalized ? 1 : 0;
  const auto fraction = [&](double value, double largest) { return divisor == 0 ? value : (std::max)(value / largest, -1.); };
  switch(m_component) {
  case gltf_byte:
    return fraction(read_number<std::int8_t>(bytes), 127);
  case gltf_unsigned_byte:
    return fraction(read_number<std::uint8_t>(bytes), 255);
  case gltf_short:
    return fraction(read_number<std::int16_t>(bytes), 32767);
  case gltf_unsigned_short:
    return fraction(read_number<std::uint16_t>(bytes), 65535);
  case gltf_unsigned_int:
    return read_number<std::uint32_t>(bytes);
  default:
    return static_cast<double>(read_number<float>(bytes));
  }
}

std::size_t Gltf_accessor::add_longer(Gltf_container& container, const std::vector<std::uint32_t>& copied) const
{
  Json accessor = list(container.json, "accessors")[m_number];
  accessor["count"] = m_count + copied.size();
  if(m_base.data() != nullptr) {
    // Data of vertices begin at multiples of four bytes.
    const std::size_t stride = (m_size + 3) / 4 * 4;
    std::string bytes((m_count + copied.size()) * stride, '\0');
    for(std::size_t i = 0; i < m_count + copied.size(); ++i)
      std::memcpy(&bytes[i * stride], m_base.data() + (i < m_count ? i : copied[i - m_count]) * m_stride, m_size);
    accessor["bufferView"] = container.add_view(bytes, stride == m_size ? 0 : stride, gltf_vertex_data);
    accessor.erase("byteOffset");
  }
  if(m_sparse_count > 0) {
    std::vector<std::uint32_t> numbers;
    for(std::size_t i = 0; i < m_sparse_count; ++i)
      numbers.push_back(static_cast<std::uint32_t>(sparse_index(i)));
    std::string indices, values(m_sparse_values);
    for(const std::uint32_t v : numbers)
      append_index(indices, v, 4);
    std::size_t count = m_sparse_count;
    for(std::size_t i = 0; i < copied.size(); ++i) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), copied[i]);
      if(found == numbers.end() || *found != copied[i])
        continue;
      append_index(indices, m_count + i, 4);
      values += m_sparse_values.substr(static_cast<std::size_t>(found - numbers.begin()) * m_size, m_size);
      ++count;
    }
    Json& sparse = accessor["sparse"];
    sparse["count"] = count;
    sparse["indices"]["bufferView"] = container.add_view(indices);
    sparse["indices"]["componentType"] = gltf_unsigned_int;
    sparse["values"]["bufferView"] = container.add_view(values);
    sparse["indices"].erase("byteOffset");
    sparse["values"].erase("byteOffset");
  }
  container.json["accessors"].push_back(accessor);
  return container.json["accessors"].size() - 1;
}

} // namespace program
