// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "volume_formats.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

using internal::Word_reader;

// Numbers behind those that a line must have. There may be fewer than the header says.
bool read_attributes(Word_reader& reader, std::vector<std::vector<double>>& columns)
{
  for(auto& column : columns) {
    double value = 0;
    if(reader.is_line_continued() && !reader.read_finite(value))
      return false;
    column.push_back(value);
  }
  reader.skip_line();
  return true;
}

// How many numbers follow in each line; no more than there can be.
bool read_number_of_columns(Word_reader& reader, std::vector<std::vector<double>>& columns)
{
  std::size_t number = 0;
  if(reader.is_line_continued() && !reader.read_count(number))
    return false;
  if(number > 1000)
    return reader.fail_here(std::to_string(number) + " attributes are too many");
  columns.resize(columns.size() + number);
  return true;
}

// Integers if all of them are.
Data_array attribute_array(const std::string& name, const std::vector<double>& values)
{
  for(const double value : values)
    if(value != std::floor(value) || std::abs(value) > 1e15)
      return real_array(name, 1, values);
  return integer_array(name, Number_type::int64, {values.begin(), values.end()});
}

// Lines "number x y z ...", numbered consecutively from 0 or 1, which `first` receives.
bool read_points(Word_reader& reader, Volume_file& file, long long& first)
{
  std::size_t count = 0;
  long long dimension = 0;
  const long long header = reader.line();
  std::vector<std::vector<double>> columns;
  if(!reader.read_count(count) || !reader.read_integer(dimension) || !read_number_of_columns(reader, columns))
    return false;
  const std::size_t number_of_attributes = columns.size();
  if(!read_number_of_columns(reader, columns))
    return false;
  if(dimension != 3)
    return reader.fail_at(header, "the dimension is " + std::to_string(dimension) + ", not 3");
  reader.skip_line();
  file.points.reserve((std::min)(count, reader.possible_items(4)));
  for(std::size_t i = 0; i < count; ++i) {
    long long number = 0;
    const long long line = reader.line();
    if(!reader.read_integer(number))
      return false;
    if(i == 0)
      first = number;
    if(first < 0 || first > 1 || number != first + static_cast<long long>(i))
      return reader.fail_at(line, "point " + std::to_string(number) + " where the points are numbered consecutively from 0 or 1");
    std::array<double, 3> point;
    for(double& coordinate : point)
      if(!reader.read_finite(coordinate))
        return false;
    file.points.push_back(point);
    if(!read_attributes(reader, columns))
      return false;
  }
  for(std::size_t k = 0; k < columns.size(); ++k)
    file.point_data.push_back(
      attribute_array(k < number_of_attributes ? "attribute " + std::to_string(k + 1) : std::string(REFERENCE), columns[k]));
  return true;
}

// Lines "number a b c d ..."; the last attribute is the region.
bool read_elements(Word_reader& reader, Volume_file& file, long long first)
{
  std::size_t count = 0;
  long long nodes = 0;
  const long long header = reader.line();
  std::vector<std::vector<double>> columns;
  if(!reader.read_count(count) || !reader.read_integer(nodes) || !read_number_of_columns(reader, columns))
    return false;
  if(nodes == 10) {
    file.foreign_cells["tetrahedra of second order (10 nodes each)"] += count;
    return true;
  }
  if(nodes != 4)
    return reader.fail_at(header, "tetrahedra of " + std::to_string(nodes) + " nodes, not 4");
  reader.skip_line();
  for(std::size_t i = 0; i < count; ++i) {
    long long number = 0;
    if(!reader.read_integer(number))
      return false;
    std::array<int, 4> tetrahedron;
    for(int& index : tetrahedron) {
      long long value = 0;
      const long long line = reader.line();
      if(!reader.read_integer(value))
        return false;
      if(value < first || value - first >= static_cast<long long>(file.points.size()))
        return reader.fail_at(line, "point index " + std::to_string(value) + " is out of range, there are " +
                                      std::to_string(file.points.size()) + " points numbered from " + std::to_string(first));
      index = static_cast<int>(value - first);
    }
    file.cells.add(cell_type::TETRAHEDRON, tetrahedron);
    if(!read_attributes(reader, columns))
      return false;
  }
  for(std::size_t k = 0; k < columns.size(); ++k)
    file.cell_data.push_back(
      attribute_array(k + 1 < columns.size() ? "attribute " + std::to_string(k + 1) : std::string(REGION), columns[k]));
  return true;
}

} // namespace

std::string read_Tetgen_nodes(std::string_view text, Volume_file& file, long long& first)
{
  Word_reader reader(text);
  return read_points(reader, file, first) ? "" : reader.error();
}

std::string read_Tetgen_elements(std::string_view text, Volume_file& file, long long first)
{
  Word_reader reader(text);
  return read_elements(reader, file, first) ? "" : reader.error();
}

std::string Tetgen_nodes(const Volume_file& file)
{
  const Data_array* references = find_array(file.point_data, REFERENCE);
  std::string text = std::to_string(file.points.size()) + (references == nullptr ? " 3 0 0\n" : " 3 0 1\n");
  for(std::size_t i = 0; i < file.points.size(); ++i) {
    internal::append_number(text, static_cast<long long>(i));
    text += ' ';
    internal::append_coordinates(text, file.points[i]);
    if(references != nullptr) {
      text += ' ';
      internal::append_number(text, static_cast<long long>(references->value(i)));
    }
    text += '\n';
  }
  return text;
}

std::string Tetgen_elements(const Volume_file& file)
{
  const Data_array* regions = find_regions(file);
  const auto count = std::count(file.cells.types.begin(), file.cells.types.end(), cell_type::TETRAHEDRON);
  std::string text = std::to_string(count) + (regions == nullptr ? " 4 0\n" : " 4 1\n");
  long long number = 0;
  for(std::size_t i = 0; i < file.cells.size(); ++i)
    if(file.cells.types[i] == cell_type::TETRAHEDRON) {
      internal::append_number(text, number++);
      for(std::size_t k = file.cells.begin(i); k < file.cells.ends[i]; ++k) {
        text += ' ';
        internal::append_number(text, static_cast<long long>(file.cells.nodes[k]));
      }
      if(regions != nullptr) {
        text += ' ';
        internal::append_number(text, static_cast<long long>(regions->integers[i]));
      }
      text += '\n';
    }
  return text;
}

} // namespace program
