// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_IMPL_H

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Word_reader::Word_reader(std::string_view text) : m_text(text)
{
  const std::string_view byte_order_mark("\xEF\xBB\xBF");
  if(m_text.substr(0, byte_order_mark.size()) == byte_order_mark)
    m_position = byte_order_mark.size();
  find_word();
}

CGAL_FLIP_FREE_MAPS_INLINE void Word_reader::skip_word()
{
  m_previous_line = m_line;
  m_position += m_word.size();
  find_word();
}

CGAL_FLIP_FREE_MAPS_INLINE void Word_reader::skip_line()
{
  while(is_line_continued())
    skip_word();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Word_reader::read_finite(double& value)
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

CGAL_FLIP_FREE_MAPS_INLINE bool Word_reader::read_integer(long long& value)
{
  if(at_end())
    return fail_at_end();
  if(parse_number(m_word, value) != std::errc())
    return fail_here(quoted_word(m_word) + " is not an integer");
  skip_word();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Word_reader::read_count(std::size_t& count)
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

CGAL_FLIP_FREE_MAPS_INLINE bool Word_reader::fail_at(long long line, const std::string& text)
{
  m_error = "line " + std::to_string(line) + ": " + text;
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Word_reader::fail_at_end()
{
  m_error = "the file ends too early, after line " + std::to_string(m_line);
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE void Word_reader::find_word()
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

CGAL_FLIP_FREE_MAPS_INLINE std::string tetrahedral_mesh_error(const Tetrahedral_mesh& mesh)
{
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    for(const double coordinate : mesh.points[i])
      if(!std::isfinite(coordinate))
        return "point " + std::to_string(i) + " is not finite";
  const std::string error = index_error("tetrahedron", mesh.tetrahedra, mesh.points.size());
  return error.empty() ? index_error("triangle", mesh.triangles, mesh.points.size()) : error;
}

CGAL_FLIP_FREE_MAPS_INLINE void append_coordinates(std::string& text, const std::array<double, 3>& point)
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

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_WORD_READER_IMPL_H
