// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Binary_reader.h"
#include "Mixed_reader.h"
#include "volume_formats.h"

#include <CGAL/Flip_free_maps/IO/Medit.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

// Keywords of binary files, with the number of corners and the cell where they are elements.
struct Medit_keyword
{
  int number;
  const char* name;
  std::size_t number_of_nodes;
  int cell;
};

constexpr int DIMENSION = 3, VERTICES = 4, TRIANGLES = 6, TETRAHEDRA = 8, END = 54;

constexpr Medit_keyword KEYWORDS[] = {{5, "Edges", 2, cell_type::LINE},
                                      {TRIANGLES, "Triangles", 3, cell_type::TRIANGLE},
                                      {7, "Quadrilaterals", 4, cell_type::QUAD},
                                      {TETRAHEDRA, "Tetrahedra", 4, cell_type::TETRAHEDRON},
                                      {9, "Prisms", 6, 0},
                                      {10, "Hexahedra", 8, 0},
                                      {30, "TetrahedraP2", 10, 0},
                                      {49, "Pyramids", 5, 0}};

class Medit_binary_reader
{
public:
  Medit_binary_reader(std::string_view text, Volume_file& file) : m_reader(text), m_file(file) {}

  std::string read()
  {
    if(!read_head())
      return m_reader.error();
    bool is_at_end = false;
    while(!is_at_end)
      if(!read_section(is_at_end))
        return m_reader.error();
    if(!m_has_points)
      return "the file has no section 'Vertices'";
    m_file.point_data.push_back(integer_array(REFERENCE, Number_type::int64, std::move(m_references)));
    m_file.cell_data.push_back(integer_array(REGION, Number_type::int64, std::move(m_regions)));
    return "";
  }

private:
  bool read_head()
  {
    m_reader.set_binary(true, false);
    long long one = 0;
    if(!m_reader.read_integer(Number_type::int32, one))
      return false;
    m_file.has_big_endian = one == 1 << 24;
    if(one != 1 && !m_file.has_big_endian)
      return m_reader.fail("the file is not a binary Medit file");
    m_reader.set_binary(true, m_file.has_big_endian);
    if(!m_reader.read_integer(Number_type::int32, m_version))
      return false;
    m_file.encoding = Volume_encoding::binary;
    // In single precision, which version 1 has, the certificate of a map is lost; such files are written anew.
    m_file.has_binary_coordinates = m_version > 1;
    return (m_version >= 1 && m_version <= 4) || m_reader.fail("the version " + std::to_string(m_version) + " is not supported");
  }

  Number_type int_type() const { return m_version < 4 ? Number_type::int32 : Number_type::int64; }
  bool read_int(long long& value) { return m_reader.read_integer(int_type(), value); }

  // Each section tells where the next one begins.
  bool read_section(bool& is_at_end)
  {
    long long keyword = 0, next = 0, count = 0;
    if(!m_reader.read_integer(Number_type::int32, keyword))
      return false;
    is_at_end = keyword == END;
    if(is_at_end)
      return true;
    if(!m_reader.read_integer(m_version < 3 ? Number_type::int32 : Number_type::int64, next))
      return false;
    if(keyword == DIMENSION) {
      if(!m_reader.read_integer(Number_type::int32, count))
        return false;
      if(count != 3)
        return m_reader.fail("the dimension is " + std::to_string(count) + ", not 3");
    } else if(keyword == VERTICES) {
      if(!read_int(count) || !read_points(count))
        return false;
    } else
      for(const Medit_keyword& entry : KEYWORDS)
        if(entry.number == keyword && (!read_int(count) || !read_elements(entry, count)))
          return false;
    return m_reader.go_to(next) || m_reader.fail("the next section begins at byte " + std::to_string(next) + ", which is not behind here");
  }

  bool read_points(long long count)
  {
    const Number_type real = m_version == 1 ? Number_type::float32 : Number_type::float64;
    if(m_has_points || count < 0 || count > (std::numeric_limits<int>::max)())
      return m_reader.fail(m_has_points ? "a second section 'Vertices'" : std::to_string(count) + " is no number of items");
    m_has_points = true;
    for(long long i = 0; i < count; ++i) {
      std::array<double, 3> point;
      for(double& coordinate : point) {
        if(!m_reader.read_finite(real, coordinate))
          return false;
        if(m_file.has_binary_coordinates)
          m_file.coordinate_places.push_back(m_reader.last_place());
      }
      m_file.points.push_back(point);
      long long reference = 0;
      if(!read_int(reference))
        return false;
      m_references.push_back(reference);
    }
    return true;
  }

  bool read_elements(const Medit_keyword& keyword, long long count)
  {
    if(keyword.cell == 0) {
      if(count > 0)
        m_file.foreign_cells[std::string(keyword.name) + " (" + std::to_string(keyword.number_of_nodes) + " nodes each)"] += count;
      return true;
    }
    std::vector<int> nodes(keyword.number_of_nodes);
    for(long long i = 0; i < count; ++i) {
      long long value = 0;
      for(int& node : nodes) {
        if(!read_int(value))
          return false;
        if(value < 1 || value > (std::numeric_limits<int>::max)())
          return m_reader.fail("there is no vertex " + std::to_string(value));
        node = static_cast<int>(value - 1);
      }
      if(!read_int(value))
        return false;
      m_file.cells.add(keyword.cell, nodes);
      m_regions.push_back(value);
    }
    return true;
  }

  Mixed_reader m_reader;
  Volume_file& m_file;
  long long m_version = 0;
  bool m_has_points = false;
  std::vector<std::int64_t> m_references, m_regions;
};

// A reference of a point or an element, which other formats may not have.
long long reference_of(const Data_array* array, std::size_t i, long long usual)
{
  return array != nullptr && !is_real(array->type) && i < array->integers.size() ? array->integers[i] : usual;
}

// Of version 2, or of version 3 if it has more bytes than numbers of 32 bits can count.
std::string binary_text(const Volume_file& file, bool is_long)
{
  std::string text;
  const auto add = [&](long long number) { append_number_bytes(text, static_cast<std::int32_t>(number), false); };
  const auto begin = [&](int keyword, std::size_t size) {
    add(keyword);
    const std::size_t next = size == 0 ? 0 : text.size() + (is_long ? 8 : 4) + size;
    if(is_long)
      append_number_bytes(text, static_cast<std::int64_t>(next), false);
    else
      add(static_cast<long long>(next));
  };
  add(1);
  add(is_long ? 3 : 2);
  begin(DIMENSION, 4);
  add(3);
  begin(VERTICES, 4 + file.points.size() * 28);
  add(static_cast<long long>(file.points.size()));
  const Data_array *references = find_array(file.point_data, REFERENCE), *regions = find_regions(file);
  for(std::size_t i = 0; i < file.points.size(); ++i) {
    for(const double coordinate : file.points[i])
      append_number_bytes(text, coordinate, false);
    add(reference_of(references, i, 0));
  }
  for(const Medit_keyword& keyword : KEYWORDS) {
    const auto number = std::count(file.cells.types.begin(), file.cells.types.end(), keyword.cell);
    if(keyword.cell == 0 || number == 0)
      continue;
    begin(keyword.number, 4 + number * 4 * (keyword.number_of_nodes + 1));
    add(number);
    for(std::size_t i = 0; i < file.cells.size(); ++i)
      if(file.cells.types[i] == keyword.cell) {
        for(std::size_t k = file.cells.begin(i); k < file.cells.ends[i]; ++k)
          add(file.cells.nodes[k] + 1LL);
        add(reference_of(regions, i, 1));
      }
  }
  begin(END, 0);
  return text;
}

} // namespace

std::string read_Medit_text(std::string_view text, Volume_file& file)
{
  internal::Medit_reader reader;
  const std::string error = reader.read(text);
  if(!error.empty())
    return error;
  file = make_volume_file(reader.mesh());
  const auto& references = reader.references();
  std::vector<std::int64_t> regions(references.triangles.begin(), references.triangles.end());
  regions.insert(regions.end(), references.tetrahedra.begin(), references.tetrahedra.end());
  file.point_data.push_back(integer_array(REFERENCE, Number_type::int64, {references.points.begin(), references.points.end()}));
  file.cell_data.push_back(integer_array(REGION, Number_type::int64, std::move(regions)));
  return "";
}

std::string Medit_text(const Volume_file& file)
{
  CGAL::Flip_free_maps::Tetrahedral_mesh mesh;
  internal::Medit_references references;
  mesh.points = file.points;
  const Data_array *of_points = find_array(file.point_data, REFERENCE), *regions = find_regions(file);
  for(std::size_t i = 0; i < file.points.size(); ++i)
    references.points.push_back(reference_of(of_points, i, 0));
  for(std::size_t i = 0; i < file.cells.size(); ++i) {
    const int* nodes = file.cells.nodes.data() + file.cells.begin(i);
    if(file.cells.types[i] == cell_type::TRIANGLE) {
      mesh.triangles.push_back({nodes[0], nodes[1], nodes[2]});
      references.triangles.push_back(reference_of(regions, i, 1));
    } else if(file.cells.types[i] == cell_type::TETRAHEDRON) {
      mesh.tetrahedra.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
      references.tetrahedra.push_back(reference_of(regions, i, 1));
    }
  }
  return internal::Medit_text(mesh, references);
}

std::string read_Medit_binary(std::string_view text, Volume_file& file) { return Medit_binary_reader(text, file).read(); }

std::string Medit_binary(const Volume_file& file)
{
  const std::size_t bytes = 28 * file.points.size() + 8 * file.cells.nodes.size();
  return binary_text(file, bytes > std::size_t((std::numeric_limits<std::int32_t>::max)()));
}

} // namespace program
