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
#include <cmath>
#include <cstddef>
#include <limits>
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
  explicit Word_reader(std::string_view text) : m_text(text)
  {
    const std::string_view byte_order_mark("\xEF\xBB\xBF");
    if(m_text.substr(0, byte_order_mark.size()) == byte_order_mark)
      m_position = byte_order_mark.size();
    find_word();
  }

  // Nothing is left.
  bool at_end() const { return m_word.empty(); }

  // The word to be read next.
  std::string_view word() const { return m_word; }

  // The line of word(), from 1, and that of the word before it.
  long long line() const { return m_line; }
  long long previous_line() const { return m_previous_line; }

  // Whether word() exists and is on the line of the word before it.
  bool is_line_continued() const { return !at_end() && m_line == m_previous_line; }

  void skip_word()
  {
    m_previous_line = m_line;
    m_position += m_word.size();
    find_word();
  }

  void skip_line()
  {
    while(is_line_continued())
      skip_word();
  }

  bool read_finite(double& value)
  {
    if(at_end())
      return fail_at_end();
    const std::errc status = parse_number(m_word, value);
    if(status == std::errc::result_out_of_range)
      return fail_here(quoted_word(m_word) + " is not in the range of double precision numbers");
    if(status != std::errc())
      return fail_here(quoted_word(m_word) + " is not a number");
    if(!std::isfinite(value))
      return fail_here(quoted_word(m_word) + " is not a finite number");
    skip_word();
    return true;
  }

  bool read_integer(long long& value)
  {
    if(at_end())
      return fail_at_end();
    if(parse_number(m_word, value) != std::errc())
      return fail_here(quoted_word(m_word) + " is not an integer");
    skip_word();
    return true;
  }

  // How many items follow; no more than an int can count.
  bool read_count(std::size_t& count)
  {
    long long value = 0;
    const long long line = m_line;
    if(!read_integer(value))
      return false;
    if(value < 0 || value > (std::numeric_limits<int>::max)())
      return fail_at(line, std::to_string(value) + " is no number of items");
    count = static_cast<std::size_t>(value);
    return true;
  }

  bool fail_at(long long line, const std::string& text)
  {
    m_error = "line " + std::to_string(line) + ": " + text;
    return false;
  }

  bool fail_here(const std::string& text) { return fail_at(m_line, text); }

  bool fail_at_end()
  {
    m_error = "the file ends too early, after line " + std::to_string(m_line);
    return false;
  }

  const std::string& error() const { return m_error; }

  // An upper bound for the number of items of so many words that the rest of the text can hold: what a file claims to contain
  // must not decide how much memory is allocated.
  std::size_t possible_items(std::size_t words) const { return (m_text.size() - m_position) / (2 * words) + 1; }

private:
  void find_word()
  {
    bool is_comment = false;
    for(; m_position < m_text.size(); ++m_position) {
      const char c = m_text[m_position];
      if(c == '\n' || (c == '\r' && !(m_position + 1 < m_text.size() && m_text[m_position + 1] == '\n'))) {
        is_comment = false;
        ++m_line;
      } else if(c == '#')
        is_comment = true;
      else if(!is_comment && !is_space(c))
        break;
    }
    std::size_t end = m_position;
    while(end < m_text.size() && !is_space(m_text[end]) && m_text[end] != '#')
      ++end;
    m_word = m_text.substr(m_position, end - m_position);
  }

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
inline std::string tetrahedral_mesh_error(const Tetrahedral_mesh& mesh)
{
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    for(const double coordinate : mesh.points[i])
      if(!std::isfinite(coordinate))
        return "point " + std::to_string(i) + " is not finite";
  const std::string error = index_error("tetrahedron", mesh.tetrahedra, mesh.points.size());
  return error.empty() ? index_error("triangle", mesh.triangles, mesh.points.size()) : error;
}

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

inline void append_coordinates(std::string& text, const std::array<double, 3>& point)
{
  for(int k = 0; k < 3; ++k) {
    if(k > 0)
      text += ' ';
    append_number(text, point[k]);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_H
