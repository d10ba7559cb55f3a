// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// PLY files as they are: the header, and a walk through all values of the body.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_PLY_TEXT_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_PLY_TEXT_H

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

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
  std::size_t line_begin = 0; // of its declaration in the text
};

struct PLY_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<PLY_property> properties;
  std::size_t line_end = 0; // behind its last declaration in the text
};

inline bool parse_PLY_type(std::string_view word, PLY_type& type)
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

// Numbers of the body, whatever its form.
class PLY_numbers
{
public:
  virtual ~PLY_numbers() = default;
  // Returns whether there was one.
  virtual bool read(PLY_type type, double& value) = 0;
  virtual std::string error() const = 0;
  // Where the last number began and ended in the body.
  virtual std::size_t begin() const = 0;
  virtual std::size_t end() const = 0;
};

class Ascii_PLY_numbers : public PLY_numbers
{
public:
  Ascii_PLY_numbers(std::string_view body, long long lines_before) : m_body(body), m_reader(body), m_lines_before(lines_before) {}

  bool read(PLY_type type, double& value) override
  {
    if(m_reader.at_end())
      return false;
    // What is declared as float is rounded to that.
    float single = 0;
    if(type == PLY_type::float32 && internal::parse_number(m_reader.word(), single) == std::errc())
      value = single;
    else if(internal::parse_number(m_reader.word(), value) != std::errc())
      return false;
    m_begin = m_reader.word().data() - m_body.data();
    m_end = m_begin + m_reader.word().size();
    m_reader.skip_word();
    return true;
  }

  std::string error() const override
  {
    return m_reader.at_end() ? "the file ends too early"
                             : "line " + std::to_string(m_lines_before + m_reader.line()) + ": " + internal::quoted_word(m_reader.word()) +
                                 " is not a number";
  }

  std::size_t begin() const override { return m_begin; }
  std::size_t end() const override { return m_end; }

private:
  std::string_view m_body;
  internal::Word_reader m_reader;
  long long m_lines_before;
  std::size_t m_begin = 0, m_end = 0;
};

class Binary_PLY_numbers : public PLY_numbers
{
public:
  Binary_PLY_numbers(std::string_view body, bool is_big_endian) : m_size(body.size()), m_reader(body, is_big_endian) {}

  bool read(PLY_type type, double& value) override
  {
    m_begin = end();
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

  std::size_t begin() const override { return m_begin; }
  std::size_t end() const override { return m_size - m_reader.left(); }

private:
  std::size_t m_size, m_begin = 0;
  Binary_reader m_reader;
};

class PLY_text
{
public:
  explicit PLY_text(std::string_view text) : m_text(text) {}

  // Returns the empty string, or what is wrong with the header.
  std::string read_header()
  {
    const std::string error = read_lines();
    return error.empty() ? "" : "line " + std::to_string(m_line) + ": " + error;
  }

  const std::vector<PLY_element>& elements() const { return m_elements; }
  bool is_ascii() const { return m_format == "ascii"; }
  bool is_big_endian() const { return m_format == "binary_big_endian"; }
  std::string_view line_end() const { return m_text.substr(m_text.find_first_of("\r\n"), m_line_end); }
  std::size_t body() const { return m_position; }

  // Calls `visit(element, i, property, values, begin, end)` for each property of each item, where the last two are its place in the body.
  // It returns the empty string, or why to stop.
  template <typename Visit>
  std::string for_each_property(Visit&& visit) const
  {
    const std::string_view body = m_text.substr(m_position);
    Ascii_PLY_numbers ascii(body, m_line);
    Binary_PLY_numbers binary(body, is_big_endian());
    PLY_numbers& numbers = is_ascii() ? static_cast<PLY_numbers&>(ascii) : binary;
    std::vector<double> values;
    for(const PLY_element& element : m_elements)
      if(!element.properties.empty())
        for(std::size_t i = 0; i < element.count; ++i)
          for(const PLY_property& property : element.properties) {
            std::size_t begin = 0;
            std::string error = read_property(element, i, property, numbers, values, begin);
            if(error.empty())
              error = visit(element, i, property, values, begin, numbers.end());
            if(!error.empty())
              return error;
          }
    return "";
  }

private:
  static std::string read_property(const PLY_element& element, std::size_t i, const PLY_property& property, PLY_numbers& numbers,
                                   std::vector<double>& values, std::size_t& begin)
  {
    values.clear();
    double value = 0, count = 1;
    if(property.is_list) {
      if(!numbers.read(property.count_type, count))
        return numbers.error();
      begin = numbers.begin();
      if(!(count >= 0) || count != std::floor(count))
        return element.name + " number " + std::to_string(i) + " (from 0) has a list of a length that is no natural number";
    }
    for(double k = 0; k < count; ++k) {
      if(!numbers.read(property.type, value))
        return numbers.error();
      values.push_back(value);
    }
    if(!property.is_list)
      begin = numbers.begin();
    return "";
  }

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

  std::string read_lines()
  {
    if(next_line() != "ply")
      return "a PLY file begins with the line 'ply'";
    while(m_position < m_text.size()) {
      std::vector<std::string_view> words;
      const std::size_t begin = m_position;
      const std::string_view line = next_line();
      for(std::size_t i = line.find_first_not_of(" \t"); i != std::string_view::npos;) {
        const std::size_t end = (std::min)(line.find_first_of(" \t", i), line.size());
        words.push_back(line.substr(i, end - i));
        i = line.find_first_not_of(" \t", end);
      }
      if(words.empty() || words[0] == "comment" || words[0] == "obj_info")
        continue;
      if(words[0] == "end_header")
        return m_format.empty() ? "the header names no format" : "";
      const std::string error = read_declaration(words);
      if(!error.empty())
        return error;
      if(words[0] == "property")
        m_elements.back().properties.back().line_begin = begin;
      if(!m_elements.empty())
        m_elements.back().line_end = m_position;
    }
    return "the header does not end";
  }

  std::string read_declaration(const std::vector<std::string_view>& words)
  {
    const std::size_t n = words.size();
    if(words[0] == "format" && n >= 2) {
      if(!m_format.empty())
        return "the header names a second format";
      m_format = words[1];
      const bool is_known = m_format == "ascii" || m_format == "binary_little_endian" || m_format == "binary_big_endian";
      return is_known ? "" : internal::quoted_word(m_format) + " is no format of PLY files";
    }
    if(words[0] == "element" && n == 3) {
      for(const PLY_element& other : m_elements)
        if(other.name == words[1])
          return "there is a second element of the name " + internal::quoted_word(words[1]);
      m_elements.emplace_back();
      m_elements.back().name = words[1];
      return internal::parse_number(words[2], m_elements.back().count) == std::errc()
               ? ""
               : internal::quoted_word(words[2]) + " is no number of items";
    }
    PLY_property property;
    property.name = words.back();
    property.is_list = n == 5 && words[1] == "list";
    if(words[0] != "property" || (n != 3 && !property.is_list))
      return internal::quoted_word(words[0]) + " and what follows it are no line of a PLY header";
    if(m_elements.empty())
      return "a property precedes all elements";
    if(!parse_PLY_type(words[n - 2], property.type) || (property.is_list && !parse_PLY_type(words[2], property.count_type)))
      return "the type of the property " + internal::quoted_word(words.back()) + " is unknown";
    m_elements.back().properties.push_back(property);
    return "";
  }

  std::string_view m_text;
  std::size_t m_position = 0, m_line_end = 1;
  long long m_line = 0;
  std::string m_format;
  std::vector<PLY_element> m_elements;
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_PLY_TEXT_H
