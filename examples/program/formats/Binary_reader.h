// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_BINARY_READER_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_BINARY_READER_H

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace program {

// Whether this machine has the lowest byte of a number first.
inline bool is_first_byte_lowest()
{
  const unsigned one = 1;
  char first_byte;
  std::memcpy(&first_byte, &one, 1);
  return first_byte == 1;
}

// Numbers from bytes of either order. What is read beyond the end is zero, and has_failed() tells.
class Binary_reader
{
public:
  Binary_reader(std::string_view bytes, bool is_big_endian) : m_bytes(bytes), m_is_big_endian(is_big_endian) {}

  template <typename Number>
  Number read()
  {
    char buffer[sizeof(Number)] = {};
    if(left() < sizeof(Number)) {
      m_has_failed = true;
      m_position = m_bytes.size();
    } else {
      std::memcpy(buffer, m_bytes.data() + m_position, sizeof(Number));
      m_position += sizeof(Number);
      if(m_is_big_endian == is_first_byte_lowest())
        std::reverse(buffer, buffer + sizeof(Number));
    }
    Number result;
    std::memcpy(&result, buffer, sizeof(Number));
    return result;
  }

  std::size_t left() const { return m_bytes.size() - m_position; }
  bool has_failed() const { return m_has_failed; }

private:
  std::string_view m_bytes;
  std::size_t m_position = 0;
  bool m_is_big_endian, m_has_failed = false;
};

// Adds a number in bytes of either order.
template <typename Number>
void append_number_bytes(std::string& text, Number number, bool is_big_endian)
{
  char buffer[sizeof(Number)];
  std::memcpy(buffer, &number, sizeof(Number));
  if(is_big_endian == is_first_byte_lowest())
    std::reverse(buffer, buffer + sizeof(Number));
  text.append(buffer, sizeof(Number));
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_BINARY_READER_H
