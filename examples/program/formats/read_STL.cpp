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

using CGAL::Flip_free_maps::internal::quoted_word;
using CGAL::Flip_free_maps::internal::Word_reader;

// STL has no shared vertices: corners at the same place are one point.
class STL_points
{
public:
  explicit STL_points(Polygon_file& file) : m_file(file) {}

  std::size_t number(const std::array<double, 3>& point)
  {
    const auto entry = m_numbers.emplace(point, m_file.points.size());
    if(entry.second)
      m_file.points.push_back(point);
    return entry.first->second;
  }

private:
  Polygon_file& m_file;
  std::map<std::array<double, 3>, std::size_t> m_numbers;
};

// Several solids are one surface.
std::string read_ascii_STL(std::string_view text, Polygon_file& file)
{
  STL_points points(file);
  bool is_in_facet = false;
  for(Word_reader reader(text); !reader.at_end();) {
    const std::string_view word = reader.word();
    const long long line = reader.line();
    reader.skip_word();
    if(word == "facet") {
      is_in_facet = true;
      file.polygons.emplace_back();
      reader.skip_line();
    } else if(word == "vertex") {
      if(!is_in_facet)
        return "line " + std::to_string(line) + ": a vertex outside of facets";
      std::array<double, 3> point;
      for(double& coordinate : point)
        if(!reader.read_finite(coordinate))
          return reader.error();
      file.polygons.back().push_back(points.number(point));
    } else if(word == "endfacet") {
      if(!is_in_facet || file.polygons.back().size() < 3)
        return "line " + std::to_string(line) + ": the facet has not three vertices";
      is_in_facet = false;
    } else if(word == "solid" || word == "endsolid" || word == "outer" || word == "endloop" || word == "color")
      reader.skip_line();
    else
      return "line " + std::to_string(line) + ": " + quoted_word(word) + " is no keyword of STL files";
  }
  return is_in_facet ? "the file ends within a facet" : "";
}

std::string read_binary_STL(std::string_view text, Polygon_file& file)
{
  STL_points points(file);
  Binary_reader reader(text.substr(80), false);
  const std::uint32_t facets = reader.read<std::uint32_t>();
  if(facets > reader.left() / 50)
    return "the file claims " + std::to_string(facets) + " facets, but ends after " + std::to_string(reader.left() / 50);
  for(std::uint32_t i = 0; i < facets; ++i) {
    for(int k = 0; k < 3; ++k)
      reader.read<float>(); // the normal
    file.polygons.emplace_back();
    for(int k = 0; k < 3; ++k) {
      std::array<double, 3> point;
      for(double& coordinate : point) {
        coordinate = reader.read<float>();
        if(!std::isfinite(coordinate))
          return "a coordinate of facet number " + std::to_string(i) + " (from 0) is not a finite number";
      }
      file.polygons.back().push_back(points.number(point));
    }
    reader.read<std::uint16_t>();
  }
  return "";
}

} // namespace

std::string read_STL(std::string_view text, bool, Polygon_file& file)
{
  // Headers of binary files may begin with "solid", too; their length tells.
  const bool is_long_enough = text.size() >= 84;
  const std::size_t facets = is_long_enough ? Binary_reader(text.substr(80), false).read<std::uint32_t>() : 0;
  const bool has_exact_length = is_long_enough && text.size() == 84 + 50 * facets;
  const std::string_view first_word = Word_reader(text.substr(0, 80)).word();
  if(!has_exact_length && first_word == "solid")
    return read_ascii_STL(text, file);
  return is_long_enough ? read_binary_STL(text, file) : "it begins with " + quoted_word(first_word) + ", hence it is not an STL file";
}

} // namespace program
