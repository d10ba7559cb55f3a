// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_MIXED_READER_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_MIXED_READER_H

#include "Data_array.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace program {

// A file of words and lines whose numbers are words, or bytes between the lines. Failures leave a sentence in error(), with the line
// or the byte.
class Mixed_reader
{
public:
  explicit Mixed_reader(std::string_view text) : m_text(text) {}

  // Numbers are bytes from here on.
  void set_binary(bool is_binary, bool is_big_endian)
  {
    m_is_binary = is_binary;
    m_is_big_endian = is_big_endian;
  }
  bool is_binary() const { return m_is_binary; }
  bool is_big_endian() const { return m_is_big_endian; }

  // The next word, which is empty at the end of the text; peek_word() stays before it.
  std::string_view word();
  std::string_view peek_word() const;

  // The rest of the line, without its end, which is passed.
  std::string_view line();
  std::string_view peek_line() const;

  // Goes behind these characters; false if there are none.
  bool skip_past(std::string_view characters);

  // Goes to a byte that is not before this place.
  bool go_to(long long position);

  // Numbers as words or bytes. A real number must be finite.
  bool read_integer(Number_type type, long long& value);
  bool read_finite(Number_type type, double& value);

  // A number in words, wherever it stands, that counts something.
  bool read_count(std::size_t& count);

  // So many bytes of any kind.
  bool read_bytes(std::size_t count, std::string_view& bytes);

  // So many values for the array.
  bool read_values(std::size_t count, Data_array& array);

  // Where the last number or word began.
  std::size_t last_place() const { return m_last; }

  // An upper bound for the number of items of so many numbers that the rest of the text can hold: what a file claims to contain must
  // not decide how much memory is allocated.
  std::size_t possible_items(std::size_t numbers) const { return (m_text.size() - m_position) / (2 * numbers) + 1; }

  // Leaves a sentence about the last number or word.
  bool fail(const std::string& reason);
  bool fail_at_end();
  const std::string& error() const { return m_error; }

private:
  // Where the next word begins.
  std::size_t next_word() const;

  std::string_view m_text;
  std::size_t m_position = 0, m_last = 0;
  bool m_is_binary = false, m_is_big_endian = false;
  std::string m_error;
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_MIXED_READER_H
