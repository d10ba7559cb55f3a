// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_H
#define CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_H

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Splits a text into words between white space; a number sign begins a comment up to the end of the line. Failures to read a
// number leave a sentence in error().
class Word_reader
{
public:
  explicit Word_reader(std::string_view text);

  // Nothing is left.
  bool at_end() const { return m_word.empty(); }

  // The word to be read next.
  std::string_view word() const { return m_word; }

  // The line of word(), from 1, and that of the word before it.
  long long line() const { return m_line; }
  long long previous_line() const { return m_previous_line; }

  // Whether word() exists and is on the line of the word before it.
  bool is_line_continued() const { return !at_end() && m_line == m_previous_line; }

  void skip_word();

  void skip_line();

  bool read_finite(double& value);

  bool read_integer(long long& value);

  // How many items follow; no more than an int can count.
  bool read_count(std::size_t& count);

  bool fail_at(long long line, const std::string& text);

  bool fail_here(const std::string& text) { return fail_at(m_line, text); }

  bool fail_at_end();

  const std::string& error() const { return m_error; }

  // An upper bound for the number of items of so many words that the rest of the text can hold: what a file claims to contain
  // must not decide how much memory is allocated.
  std::size_t possible_items(std::size_t words) const { return (m_text.size() - m_position) / (2 * words) + 1; }

private:
  void find_word();

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r'; }

  std::string_view m_text;
  std::string_view m_word;
  std::size_t m_position = 0;
  long long m_line = 1;
  long long m_previous_line = 0;
  std::string m_error;
};

// Returns the empty string, or which index is not that of a point.
template <std::size_t N>
std::string index_error(const char* name, const std::vector<std::array<int, N>>& elements, std::size_t number_of_points)
{
  for(std::size_t i = 0; i < elements.size(); ++i)
    for(const int index : elements[i])
      if(index < 0 || std::size_t(index) >= number_of_points)
        return std::string(name) + " number " + std::to_string(i) + " (from 0) has the vertex " + std::to_string(index) +
               " (from 0), but there are " + std::to_string(number_of_points) + " points";
  return std::string();
}

// Returns the empty string, or why the mesh cannot be written.
std::string tetrahedral_mesh_error(const Tetrahedral_mesh& mesh);

// Appends the numbers with spaces between them.
template <typename Range>
void append_numbers(std::string& text, const Range& numbers, long long offset = 0)
{
  const char* separator = "";
  for(const auto number : numbers) {
    text += separator;
    append_number(text, static_cast<long long>(number) + offset);
    separator = " ";
  }
}

void append_coordinates(std::string& text, const std::array<double, 3>& point);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/IO/internal/Word_reader_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_H
