// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Binary_reader.h"
#include "readers.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

#include <cmath>
#include <cstdint>
#include <map>

namespace program {

namespace {

using CGAL::Flip_free_maps::internal::parse_number;
using CGAL::Flip_free_maps::internal::quoted_word;
using CGAL::Flip_free_maps::internal::Word_reader;

enum class PLY_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

struct PLY_property
{
  std::string name;
  PLY_type type;
  bool is_list = false;
  PLY_type count_type = PLY_type::uint8;
};

struct PLY_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<PLY_property> properties;
};

bool parse_type(std::string_view word, PLY_type& type)
{
  static const std::map<std::string_view, PLY_type> types{
    {"char", PLY_type::int8},     {"int8", PLY_type::int8},       {"uchar", PLY_type::uint8},    {"uint8", PLY_type::uint8},
    {"short", PLY_type::int16},   {"int16", PLY_type::int16},     {"ushort", PLY_type::uint16},  {"uint16", PLY_type::uint16},
    {"int", PLY_type::int32},     {"int32", PLY_type::int32},     {"uint", PLY_type::uint32},    {"uint32", PLY_type::uint32},
    {"float", PLY_type::float32}, {"float32", PLY_type::float32}, {"double", PLY_type::float64}, {"float64", PLY_type::float64}};
  const auto entry = types.find(word);
  if(entry != types.end())
    type = entry->second;
  return entry != types.end();
}

// Numbers of the body, whatever its form. Returns whether there was one.
class PLY_numbers
{
public:
  virtual ~PLY_numbers() = default;
  virtual bool read(PLY_type type, double& value) = 0;
  virtual std::string error() const = 0;
};

class Ascii_numbers : public PLY_numbers
{
public:
  Ascii_numbers(std::string_view body, long long lines_before) : m_reader(body), m_lines_before(lines_before) {}

  bool read(PLY_type type, double& value) override
  {
    if(m_reader.at_end())
      return false;
    // What is declared as float is rounded to that.
    float single = 0;
    if(type == PLY_type::float32 && parse_number(m_reader.word(), single) == std::errc())
      value = single;
    else if(parse_number(m_reader.word(), value) != std::errc())
      return false;
    m_reader.skip_word();
    return true;
  }

  std::string error() const override
  {
    return m_reader.at_end()
             ? "the file ends too early"
             : "line " + std::to_string(m_lines_before + m_reader.line()) + ": " + quoted_word(m_reader.word()) + " is not a number";
  }

private:
  Word_reader m_reader;
  long long m_lines_before;
};

class Binary_numbers : public PLY_numbers
{
public:
  Binary_numbers(std::string_view body, bool is_big_endian) : m_reader(body, is_big_endian) {}

  bool read(PLY_type type, double& value) override
  {
    switch(type) {
    case PLY_type::int8:
      value = m_reader.read<std::int8_t>();
      break;
    case PLY_type::uint8:
      value = m_reader.read<std::uint8_t>();
      break;
    case PLY_type::int16:
      value = m_reader.read<std::int16_t>();
      break;
    case PLY_type::uint16:
      value = m_reader.read<std::uint16_t>();
      break;
    case PLY_type::int32:
      value = m_reader.read<std::int32_t>();
      break;
    case PLY_type::uint32:
      value = m_reader.read<std::uint32_t>();
      break;
    case PLY_type::float32:
      value = m_reader.read<float>();
      break;
    case PLY_type::float64:
      value = m_reader.read<double>();
      break;
    }
    return !m_reader.has_failed();
  }

  std::string error() const override { return "the file ends too early, or its counts are wrong"; }

private:
  Binary_reader m_reader;
};

class PLY_reader
{
public:
  PLY_reader(std::string_view text, Polygon_file& file) : m_text(text), m_file(file) {}

  std::string read()
  {
    std::string error = read_header();
    if(!error.empty())
      return "line " + std::to_string(m_line) + ": " + error;
    error = find_properties();
    if(!error.empty())
      return error;
    Ascii_numbers ascii(m_text.substr(m_position), m_line);
    Binary_numbers binary(m_text.substr(m_position), m_format == "binary_big_endian");
    PLY_numbers& numbers = m_format == "ascii" ? static_cast<PLY_numbers&>(ascii) : binary;
    for(const PLY_element& element : m_elements)
      if(!element.properties.empty())
        for(std::size_t i = 0; i < element.count; ++i) {
          error = read_item(element, i, numbers);
          if(!error.empty())
            return error;
        }
    return "";
  }

private:
  std::string_view next_line()
  {
    const std::size_t end = (std::min)(m_text.find_first_of("\r\n", m_position), m_text.size());
    const std::string_view line = m_text.substr(m_position, end - m_position);
    m_position = end;
    // Bytes of the body may look like ends of lines, hence all lines end as the first one does.
    if(m_line == 0)
      m_line_end = m_text.substr(end, 2) == "\r\n" ? 2 : 1;
    m_position = (std::min)(end + m_line_end, m_text.size());
    ++m_line;
    return line;
  }

  std::string read_header()
  {
    if(next_line() != "ply")
      return "a PLY file begins with the line 'ply'";
    while(m_position < m_text.size()) {
      std::vector<std::string_view> words;
      const std::string_view line = next_line();
      for(std::size_t begin = line.find_first_not_of(" \t"); begin != std::string_view::npos;) {
        const std::size_t end = (std::min)(line.find_first_of(" \t", begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(" \t", end);
      }
      if(words.empty() || words[0] == "comment" || words[0] == "obj_info")
        continue;
      if(words[0] == "end_header")
        return m_format.empty() ? "the header names no format" : "";
      const std::string error = read_declaration(words);
      if(!error.empty())
        return error;
    }
    return "the header does not end";
  }

  std::string read_declaration(const std::vector<std::string_view>& words)
  {
    const std::size_t n = words.size();
    if(words[0] == "format" && n >= 2) {
      m_format = words[1];
      const bool is_known = m_format == "ascii" || m_format == "binary_little_endian" || m_format == "binary_big_endian";
      return is_known ? "" : quoted_word(m_format) + " is no format of PLY files";
    }
    if(words[0] == "element" && n == 3) {
      m_elements.emplace_back();
      m_elements.back().name = words[1];
      return parse_number(words[2], m_elements.back().count) == std::errc() ? "" : quoted_word(words[2]) + " is no number of items";
    }
    PLY_property property;
    property.name = words.back();
    property.is_list = n == 5 && words[1] == "list";
    if(words[0] != "property" || (n != 3 && !property.is_list))
      return quoted_word(words[0]) + " and what follows it are no line of a PLY header";
    if(m_elements.empty())
      return "a property precedes all elements";
    if(!parse_type(words[n - 2], property.type) || (property.is_list && !parse_type(words[2], property.count_type)))
      return "the type of the property " + quoted_word(words.back()) + " is unknown";
    m_elements.back().properties.push_back(property);
    return "";
  }

  // The roles of properties.
  std::string find_properties()
  {
    for(const PLY_element& element : m_elements)
      for(const PLY_property& property : element.properties) {
        const std::size_t c = property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : 3;
        if(element.name == "vertex" && c < 3) {
          if(property.is_list)
            return "the coordinate " + property.name + " of vertices is a list";
          m_coordinates[c] = &property;
        } else if(element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index")) {
          if(!property.is_list)
            return "the property " + property.name + " of faces is no list";
          m_corners = &property;
        }
      }
    for(const PLY_property* coordinate : m_coordinates)
      if(coordinate == nullptr)
        return "vertices have not the properties x, y and z";
    for(const PLY_element& element : m_elements)
      if(element.name == "face" && element.count > 0 && m_corners == nullptr)
        return "faces have no list of the name vertex_indices or vertex_index";
    return "";
  }

  std::string read_item(const PLY_element& element, std::size_t i, PLY_numbers& numbers)
  {
    std::array<double, 3> point{};
    std::vector<std::size_t> polygon;
    for(const PLY_property& property : element.properties) {
      double value = 0, count = 1;
      if(property.is_list && !numbers.read(property.count_type, count))
        return numbers.error();
      if(!(count >= 0) || count != std::floor(count))
        return element.name + " number " + std::to_string(i) + " (from 0) has a list of a length that is no natural number";
      for(double k = 0; k < count; ++k) {
        if(!numbers.read(property.type, value))
          return numbers.error();
        if(&property != m_corners)
          continue;
        if(!(value >= 0 && value < 4294967296.) || value != std::floor(value))
          return "face number " + std::to_string(i) + " (from 0) names a vertex that does not exist";
        polygon.push_back(static_cast<std::size_t>(value));
      }
      for(int c = 0; c < 3; ++c)
        if(&property == m_coordinates[c])
          point[c] = value;
    }
    if(element.name == "vertex")
      m_file.points.push_back(point);
    else if(element.name == "face")
      m_file.polygons.push_back(polygon);
    return "";
  }

  std::string_view m_text;
  Polygon_file& m_file;
  std::size_t m_position = 0, m_line_end = 1;
  long long m_line = 0;
  std::string m_format;
  std::vector<PLY_element> m_elements;
  std::array<const PLY_property*, 3> m_coordinates{};
  const PLY_property* m_corners = nullptr;
};

} // namespace

std::string read_PLY(std::string_view text, Polygon_file& file) { return PLY_reader(text, file).read(); }

} // namespace program
