// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Mixed_reader.h"
#include "VTK_names.h"
#include "volume_formats.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

// Names have other characters than letters as a percent sign and two hexadecimal digits.
std::string decoded_name(std::string_view name)
{
  std::string result;
  for(std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    const std::string_view digits = name[i] == '%' ? name.substr(i + 1, 2) : std::string_view();
    if(digits.size() == 2 && std::from_chars(digits.data(), digits.data() + 2, code, 16).ptr == digits.data() + 2) {
      result += static_cast<char>(code);
      i += 2;
    } else
      result += name[i];
  }
  return result;
}

class VTK_reader
{
public:
  VTK_reader(std::string_view text, Volume_file& file) : m_reader(text), m_file(file) {}

  std::string read()
  {
    if(!read_head())
      return m_reader.error();
    while(!m_reader.peek_word().empty())
      if(!read_section())
        return m_reader.error();
    if(!m_has_points || !m_has_types)
      return std::string("the file ends too early, without ") + (m_has_points ? "CELL_TYPES" : "POINTS");
    return "";
  }

private:
  bool read_head()
  {
    if(m_reader.line().substr(0, 23) != "# vtk DataFile Version ")
      return m_reader.fail("the file does not begin with '# vtk DataFile Version'");
    m_reader.line(); // the title
    const std::string layout = in_small_letters(m_reader.word());
    if(layout != "ascii" && layout != "binary")
      return m_reader.fail("neither ASCII nor BINARY");
    m_is_binary = layout == "binary";
    m_file.encoding = m_is_binary ? Volume_encoding::binary : Volume_encoding::ascii;
    return true;
  }

  bool read_section()
  {
    const std::string keyword = in_small_letters(m_reader.word());
    if(keyword == "dataset") {
      const std::string_view kind = m_reader.word();
      return in_small_letters(kind) == "unstructured_grid" ||
             m_reader.fail("the file holds " + internal::quoted_word(kind) + ", not an 'UNSTRUCTURED_GRID'");
    }
    if(keyword == "points")
      return read_points();
    if(keyword == "cells")
      return read_cells();
    if(keyword == "cell_types")
      return read_types();
    if(keyword == "field")
      return read_field(m_arrays, m_number_of_items);
    if(keyword == "point_data" || keyword == "cell_data")
      return begin_data(keyword == "point_data");
    if(keyword == "metadata") { // to an empty line
      m_reader.line();
      while(!m_reader.peek_word().empty() && !m_reader.line().empty())
        ;
      return true;
    }
    return read_attribute(keyword);
  }

  // Numbers follow the end of the line.
  bool read_values(std::size_t count, Data_array& array)
  {
    if(m_is_binary) {
      m_reader.line();
      m_reader.set_binary(true, true);
    }
    const bool is_read = m_reader.read_values(count, array);
    if(is_read)
      m_reader.set_binary(false, true);
    return is_read;
  }

  bool read_type(Data_array& array)
  {
    const std::string_view name = m_reader.word();
    return old_VTK_type(in_small_letters(name), array.type) ||
           m_reader.fail("the type of numbers " + internal::quoted_word(name) + " is not supported");
  }

  bool read_points()
  {
    std::size_t count = 0;
    Data_array coordinates;
    if(m_has_points)
      return m_reader.fail("a second section POINTS");
    if(!m_reader.read_count(count) || !read_type(coordinates) || !read_values(3 * count, coordinates))
      return false;
    for(std::size_t i = 0; i < 3 * count; ++i)
      if(!std::isfinite(coordinates.value(i)))
        return m_reader.fail("a coordinate of point " + std::to_string(i / 3) + " is not finite");
    for(std::size_t i = 0; i < count; ++i)
      m_file.points.push_back({coordinates.value(3 * i), coordinates.value(3 * i + 1), coordinates.value(3 * i + 2)});
    m_has_points = true;
    return true;
  }

  // Up to version 4 each cell has its number of corners before them; later ones have offsets for all first.
  bool read_cells()
  {
    std::size_t first = 0, second = 0;
    if(!m_file.cells.ends.empty() || m_has_types)
      return m_reader.fail("a second section CELLS, or one behind CELL_TYPES");
    if(!m_reader.read_count(first) || !m_reader.read_count(second))
      return false;
    Data_array numbers;
    numbers.type = Number_type::int32;
    if(m_reader.peek_word().substr(0, 7) != "OFFSETS")
      return read_values(second, numbers) && split_cells(first, numbers.integers);
    Data_array offsets;
    m_reader.word();
    if(!read_type(offsets) || !read_values(first, offsets))
      return false;
    if(in_small_letters(m_reader.word()) != "connectivity")
      return m_reader.fail("no CONNECTIVITY follows OFFSETS");
    if(!read_type(numbers) || !read_values(second, numbers))
      return false;
    if(is_real(offsets.type) || is_real(numbers.type))
      return m_reader.fail("offsets and corners of cells are no integers");
    std::int64_t end = 0;
    for(std::size_t i = 0; i < first; ++i) {
      const bool is_right = i == 0 ? offsets.integers[0] == 0 : offsets.integers[i] >= end;
      end = offsets.integers[i];
      if(!is_right || end > static_cast<std::int64_t>(second))
        return m_reader.fail("the offset of cell " + std::to_string(i) + " is out of range");
      if(i > 0)
        m_file.cells.ends.push_back(static_cast<std::size_t>(end));
    }
    return add_nodes(numbers.integers.begin(), numbers.integers.begin() + end);
  }

  bool split_cells(std::size_t count, const std::vector<std::int64_t>& numbers)
  {
    std::size_t i = 0;
    for(std::size_t cell = 0; cell < count; ++cell) {
      if(i >= numbers.size() || numbers[i] < 0 || numbers[i] > static_cast<std::int64_t>(numbers.size() - i - 1))
        return m_reader.fail("the number of corners of cell " + std::to_string(cell) + " is out of range");
      const auto begin = numbers.begin() + i + 1;
      if(!add_nodes(begin, begin + numbers[i]))
        return false;
      m_file.cells.ends.push_back(m_file.cells.nodes.size());
      i += static_cast<std::size_t>(numbers[i]) + 1;
    }
    return true;
  }

  template <typename Iterator>
  bool add_nodes(Iterator begin, Iterator end)
  {
    for(; begin != end; ++begin) {
      if(*begin < 0 || *begin > (std::numeric_limits<int>::max)())
        return m_reader.fail("there is no point " + std::to_string(*begin));
      m_file.cells.nodes.push_back(static_cast<int>(*begin));
    }
    return true;
  }

  bool read_types()
  {
    Data_array types;
    types.type = Number_type::int32;
    std::size_t count = 0;
    if(!m_reader.read_count(count) || !read_values(count, types))
      return false;
    if(m_has_types || count != m_file.cells.ends.size())
      return m_reader.fail(std::to_string(count) + " types for " + std::to_string(m_file.cells.ends.size()) + " cells");
    m_has_types = true;
    for(const std::int64_t type : types.integers) {
      if(type < 0 || type > 255)
        return m_reader.fail("there is no type " + std::to_string(type) + " of cells");
      m_file.cells.types.push_back(static_cast<std::uint8_t>(type));
    }
    return true;
  }

  bool begin_data(bool is_of_points)
  {
    std::size_t count = 0;
    if(!m_reader.read_count(count))
      return false;
    m_number_of_items = is_of_points ? m_file.points.size() : m_file.cells.ends.size();
    m_arrays = is_of_points ? &m_file.point_data : &m_file.cell_data;
    return count == m_number_of_items || m_reader.fail("values for " + std::to_string(count) + " " + (is_of_points ? "points" : "cells") +
                                                       ", but there are " + std::to_string(m_number_of_items));
  }

  // Any number of arrays with their names; before all data of points and cells they may have any size.
  bool read_field(std::vector<Data_array>* arrays, std::size_t number_of_items)
  {
    std::size_t count = 0;
    m_reader.word(); // the field's name
    if(!m_reader.read_count(count))
      return false;
    for(std::size_t i = 0; i < count; ++i) {
      while(in_small_letters(m_reader.peek_word()) == "metadata")
        if(!read_section())
          return false;
      Data_array array;
      array.name = decoded_name(m_reader.word());
      std::size_t tuples = 0;
      if(!m_reader.read_count(array.number_of_components) || !m_reader.read_count(tuples))
        return false;
      if(array.number_of_components == 0 || (arrays != nullptr && tuples != number_of_items))
        return m_reader.fail("the array " + internal::quoted_word(array.name) + " has " + std::to_string(tuples) + " entries, not " +
                             std::to_string(number_of_items));
      if(in_small_letters(m_reader.peek_word()) == "string") {
        if(!skip_strings(array.number_of_components * tuples))
          return false;
        continue;
      }
      if(!read_type(array) || !read_values(array.number_of_components * tuples, array))
        return false;
      (arrays == nullptr ? m_file.field_data : *arrays).push_back(std::move(array));
    }
    return true;
  }

  // Text is not kept. In words it is a line each; in bytes its length comes first, in 1, 2, 4 or 8 bytes, as the first two bits say.
  bool skip_strings(std::size_t count)
  {
    m_reader.word();
    m_reader.line();
    for(std::size_t i = 0; i < count; ++i) {
      if(!m_is_binary) {
        if(m_reader.line().empty() && m_reader.peek_word().empty())
          return m_reader.fail_at_end();
        continue;
      }
      std::string_view bytes;
      m_reader.set_binary(true, true);
      if(!m_reader.read_bytes(1, bytes))
        return false;
      const unsigned first = static_cast<unsigned char>(bytes[0]);
      std::size_t length = first & 63, more = (std::size_t(1) << (3 - (first >> 6))) - 1;
      if(!m_reader.read_bytes(more, bytes))
        return false;
      for(const char c : bytes)
        length = length << 8 | static_cast<unsigned char>(c);
      if(!m_reader.read_bytes(length, bytes))
        return false;
      m_reader.set_binary(false, true);
    }
    return true;
  }

  // An array with a section of its own, which says what it is.
  bool read_attribute(const std::string& keyword)
  {
    if(keyword == "lookup_table" || keyword == "color_scalars")
      return read_colors(keyword == "color_scalars");
    const auto kind =
      std::find_if(std::begin(VTK_KINDS), std::end(VTK_KINDS), [&](const char* name) { return old_VTK_kind(name) == keyword; });
    if(kind == std::end(VTK_KINDS) || m_arrays == nullptr)
      return m_reader.fail("the section " + internal::quoted_word(keyword) + " is not supported");
    Data_array array;
    array.kind = *kind;
    array.name = decoded_name(m_reader.word());
    array.number_of_components = keyword == "vectors" || keyword == "normals" ? 3 : keyword == "tensors" ? 9 : 1;
    if(keyword == "texture_coordinates" && !m_reader.read_count(array.number_of_components))
      return false;
    if(!read_type(array) || (keyword == "scalars" && !read_scalar_head(array)))
      return false;
    if(array.number_of_components == 0)
      return m_reader.fail("the array " + internal::quoted_word(array.name) + " has no components");
    if(!read_values(array.number_of_components * m_number_of_items, array))
      return false;
    m_arrays->push_back(std::move(array));
    return true;
  }

  // On the line of the type the number of components may follow, and on the next one there is the name of a table.
  bool read_scalar_head(Data_array& array)
  {
    const std::string_view rest = m_reader.peek_line();
    if(rest.find_first_not_of(" \t\r") != std::string_view::npos && !m_reader.read_count(array.number_of_components))
      return false;
    m_reader.line();
    if(in_small_letters(m_reader.word()) != "lookup_table")
      return m_reader.fail("no LOOKUP_TABLE follows SCALARS");
    m_reader.word();
    return true;
  }

  // Bytes in binary files, numbers from 0 to 1 in others. Tables are not kept.
  bool read_colors(bool is_of_items)
  {
    Data_array array;
    array.name = decoded_name(m_reader.word());
    array.type = m_is_binary ? Number_type::uint8 : Number_type::float32;
    std::size_t count = 0;
    if(!m_reader.read_count(count))
      return false;
    if(!is_of_items)
      return read_values(4 * count, array);
    array.number_of_components = count;
    if(count == 0 || m_arrays == nullptr)
      return m_reader.fail("colors of nothing");
    if(!read_values(count * m_number_of_items, array))
      return false;
    m_arrays->push_back(std::move(array));
    return true;
  }

  Mixed_reader m_reader;
  Volume_file& m_file;
  bool m_is_binary = false, m_has_points = false, m_has_types = false;
  std::vector<Data_array>* m_arrays = nullptr; // to which arrays are added; the file's own if null
  std::size_t m_number_of_items = 0;
};

} // namespace

std::string read_VTK(std::string_view text, Volume_file& file) { return VTK_reader(text, file).read(); }

} // namespace program
