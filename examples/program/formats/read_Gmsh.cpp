// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gmsh_types.h"
#include "Mixed_reader.h"
#include "volume_formats.h"

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

class Gmsh_reader
{
public:
  Gmsh_reader(std::string_view text, Volume_file& file) : m_reader(text), m_file(file) {}

  std::string read()
  {
    if(m_reader.word() != "$MeshFormat")
      return "the file does not begin with '$MeshFormat'";
    if(!read_format())
      return m_reader.error();
    while(!m_reader.peek_word().empty())
      if(!read_section())
        return m_reader.error();
    if(!m_has_points)
      return "the file has no section '$Nodes'";
    m_file.cell_data.push_back(integer_array(REGION, Number_type::int32, std::move(m_regions)));
    m_file.cell_data.push_back(integer_array("entity", Number_type::int32, std::move(m_entities)));
    return "";
  }

private:
  bool read_format()
  {
    const std::string_view version = m_reader.word();
    long long layout = 0, size = 0;
    m_is_new = version == "4.1";
    if(!m_is_new && version != "2" && version.substr(0, 2) != "2.")
      return m_reader.fail("the version " + internal::quoted_word(version) + " is not supported; versions 2 and 4.1 are");
    if(!m_reader.read_integer(Number_type::int32, layout) || !m_reader.read_integer(Number_type::int32, size))
      return false;
    if(layout < 0 || layout > 1 || (size != 8 && (size != 4 || !m_is_new)))
      return m_reader.fail("the layout of numbers is unknown");
    m_is_binary = layout == 1;
    m_size_type = size == 4 ? Number_type::uint32 : Number_type::uint64;
    m_file.encoding = m_is_binary ? Volume_encoding::binary : Volume_encoding::ascii;
    m_file.has_binary_coordinates = m_is_binary;
    if(m_is_binary) {
      std::string_view one;
      m_reader.line();
      if(!m_reader.read_bytes(4, one))
        return false;
      m_file.has_big_endian = Binary_reader(one, true).read<std::int32_t>() == 1;
      if(!m_file.has_big_endian && Binary_reader(one, false).read<std::int32_t>() != 1)
        return m_reader.fail("the order of bytes is unknown");
    }
    return read_end("$EndMeshFormat");
  }

  bool read_section()
  {
    const std::string_view keyword = m_reader.word();
    if(keyword.front() != '$')
      return m_reader.fail("found " + internal::quoted_word(keyword) + " where a section begins");
    if(keyword == "$PhysicalNames")
      return read_names() && read_end("$EndPhysicalNames");
    if(keyword == "$ParametricNodes")
      return m_reader.fail("nodes with parameters are supported in version 4.1 only");
    const bool is_read = keyword == "$Nodes"                  ? begin_numbers() && (m_is_new ? read_point_blocks() : read_points())
                         : keyword == "$Elements"             ? begin_numbers() && (m_is_new ? read_element_blocks() : read_elements())
                         : keyword == "$Entities" && m_is_new ? begin_numbers() && read_entities()
                                                              : true;
    if(!is_read)
      return false;
    m_reader.set_binary(false, m_file.has_big_endian);
    const std::string end = "$End" + std::string(keyword.substr(1));
    if(keyword == "$Nodes" || keyword == "$Elements" || (keyword == "$Entities" && m_is_new))
      return read_end(end);
    return m_reader.skip_past(end) || m_reader.fail("the file ends too early, without " + internal::quoted_word(end));
  }

  bool read_end(std::string_view keyword)
  {
    const std::string_view word = m_reader.word();
    return word == keyword || m_reader.fail("found " + internal::quoted_word(word) + " instead of " + internal::quoted_word(keyword) +
                                            "; the section has more or less items than it says");
  }

  // What follows the line of the keyword. In version 2 a number in words is first.
  bool begin_numbers()
  {
    if(!m_is_new && !m_reader.read_count(m_count))
      return false;
    if(m_is_binary)
      m_reader.line();
    m_reader.set_binary(m_is_binary, m_file.has_big_endian);
    return true;
  }

  bool read_int(long long& value) { return m_reader.read_integer(Number_type::int32, value); }

  bool read_size(std::size_t& value)
  {
    long long number = 0;
    if(!m_reader.read_integer(m_size_type, number))
      return false;
    value = static_cast<std::size_t>(number);
    return number >= 0 || m_reader.fail(std::to_string(number) + " is no number of items");
  }

  bool read_names()
  {
    std::size_t count = 0;
    if(!m_reader.read_count(count))
      return false;
    for(std::size_t i = 0; i < count; ++i) {
      long long dimension = 0, number = 0;
      if(!read_int(dimension) || !read_int(number))
        return false;
      const std::string_view rest = m_reader.line();
      const std::size_t begin = rest.find('"'), end = rest.rfind('"');
      if(begin == end)
        return m_reader.fail("a name is not in quotation marks");
      m_file.groups.push_back({static_cast<int>(dimension), number, std::string(rest.substr(begin + 1, end - begin - 1))});
    }
    return true;
  }

  // The physical groups of the parts of the geometry.
  bool read_entities()
  {
    std::size_t counts[4];
    for(std::size_t& count : counts)
      if(!read_size(count))
        return false;
    for(int dimension = 0; dimension < 4; ++dimension)
      for(std::size_t i = 0; i < counts[dimension]; ++i) {
        long long tag = 0, number = 0;
        double ignored = 0;
        std::size_t count = 0;
        if(!read_int(tag))
          return false;
        for(int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
          if(!m_reader.read_finite(Number_type::float64, ignored))
            return false;
        if(!read_size(count))
          return false;
        for(std::size_t k = 0; k < count; ++k) {
          if(!read_int(number))
            return false;
          m_physical.emplace(std::make_pair(dimension, tag), std::abs(number)); // the first one counts
        }
        if(dimension > 0 && !read_size(count))
          return false;
        for(std::size_t k = 0; dimension > 0 && k < count; ++k)
          if(!read_int(number))
            return false;
      }
    return true;
  }

  bool begin_points(std::size_t count)
  {
    if(m_has_points)
      return m_reader.fail("a second section '$Nodes'");
    m_has_points = true;
    m_file.points.reserve((std::min)(count, m_reader.possible_items(4)));
    m_numbers.reserve((std::min)(count, m_reader.possible_items(4)));
    return true;
  }

  bool add_number(long long number)
  {
    return m_numbers.emplace(number, static_cast<int>(m_numbers.size())).second || m_reader.fail("a second node " + std::to_string(number));
  }

  bool read_point()
  {
    std::array<double, 3> point;
    for(double& coordinate : point) {
      if(!m_reader.read_finite(Number_type::float64, coordinate))
        return false;
      m_file.coordinate_places.push_back(m_reader.last_place());
    }
    m_file.points.push_back(point);
    return true;
  }

  bool read_points()
  {
    if(!begin_points(m_count))
      return false;
    for(std::size_t i = 0; i < m_count; ++i) {
      long long number = 0;
      if(!read_int(number) || !add_number(number) || !read_point())
        return false;
    }
    return true;
  }

  bool read_point_blocks()
  {
    std::size_t blocks = 0, total = 0, low = 0, high = 0;
    if(!read_size(blocks) || !read_size(total) || !read_size(low) || !read_size(high) || !begin_points(total))
      return false;
    for(std::size_t b = 0; b < blocks; ++b) {
      long long dimension = 0, entity = 0, is_parametric = 0, number = 0;
      std::size_t count = 0;
      if(!read_int(dimension) || !read_int(entity) || !read_int(is_parametric) || !read_size(count))
        return false;
      for(std::size_t i = 0; i < count; ++i)
        if(!m_reader.read_integer(m_size_type, number) || !add_number(number))
          return false;
      for(std::size_t i = 0; i < count; ++i) {
        if(!read_point())
          return false;
        double parameter = 0;
        for(int k = 0; is_parametric != 0 && k < dimension && k < 3; ++k)
          if(!m_reader.read_finite(Number_type::float64, parameter))
            return false;
      }
    }
    return m_file.points.size() == total ||
           m_reader.fail(std::to_string(m_file.points.size()) + " nodes where there should be " + std::to_string(total));
  }

  const Gmsh_type* find_type(long long number)
  {
    for(const Gmsh_type& type : GMSH_TYPES)
      if(type.number == number)
        return &type;
    m_reader.fail("elements of Gmsh's type " + std::to_string(number) + " are not supported");
    return nullptr;
  }

  bool read_nodes(const Gmsh_type& type, Number_type number_type, long long region, long long entity)
  {
    m_nodes.clear();
    for(std::size_t k = 0; k < type.number_of_nodes; ++k) {
      long long number = 0;
      if(!m_reader.read_integer(number_type, number))
        return false;
      const auto found = m_numbers.find(number);
      if(found == m_numbers.end())
        return m_reader.fail("there is no node " + std::to_string(number));
      m_nodes.push_back(found->second);
    }
    if(type.cell == 0) {
      if(type.name != nullptr)
        ++m_file.foreign_cells[std::string(type.name) + " (" + std::to_string(type.number_of_nodes) + " nodes each)"];
      return true;
    }
    if(type.cell == cell_type::QUADRATIC_TETRAHEDRON)
      std::swap(m_nodes[8], m_nodes[9]);
    m_file.cells.add(type.cell, m_nodes);
    m_regions.push_back(region);
    m_entities.push_back(entity);
    return true;
  }

  // In binary files elements of the same type and number of tags share the line that tells these.
  bool read_elements()
  {
    for(std::size_t i = 0; i < m_count;) {
      long long number = 0, type_number = 0, followers = 1, tags = 0;
      if(!m_is_binary && !read_int(number))
        return false;
      if(!read_int(type_number))
        return false;
      const Gmsh_type* type = find_type(type_number);
      if(type == nullptr || (m_is_binary && !read_int(followers)) || !read_int(tags))
        return false;
      if(followers < 1 || followers > static_cast<long long>(m_count - i))
        return m_reader.fail("the number of elements is out of range");
      for(; followers > 0; --followers, ++i) {
        long long region = 0, entity = 0, ignored = 0;
        if(m_is_binary && !read_int(number))
          return false;
        for(long long k = 0; k < tags; ++k)
          if(!read_int(k == 0 ? region : k == 1 ? entity : ignored))
            return false;
        if(!read_nodes(*type, Number_type::int32, std::abs(region), entity))
          return false;
      }
    }
    return true;
  }

  bool read_element_blocks()
  {
    std::size_t blocks = 0, total = 0, low = 0, high = 0;
    if(!read_size(blocks) || !read_size(total) || !read_size(low) || !read_size(high))
      return false;
    for(std::size_t b = 0; b < blocks; ++b) {
      long long dimension = 0, entity = 0, type_number = 0, number = 0;
      std::size_t count = 0;
      if(!read_int(dimension) || !read_int(entity) || !read_int(type_number))
        return false;
      const Gmsh_type* type = find_type(type_number);
      if(type == nullptr || !read_size(count))
        return false;
      const auto physical = m_physical.find({static_cast<int>(dimension), entity});
      const long long region = physical == m_physical.end() ? 0 : physical->second;
      for(std::size_t i = 0; i < count; ++i)
        if(!m_reader.read_integer(m_size_type, number) || !read_nodes(*type, m_size_type, region, entity))
          return false;
    }
    return true;
  }

  Mixed_reader m_reader;
  Volume_file& m_file;
  bool m_is_new = false, m_is_binary = false, m_has_points = false;
  Number_type m_size_type = Number_type::uint64;
  std::size_t m_count = 0;
  std::unordered_map<long long, int> m_numbers; // of nodes
  std::map<std::pair<int, long long>, long long> m_physical;
  std::vector<int> m_nodes;
  std::vector<std::int64_t> m_regions, m_entities;
};

} // namespace

std::string read_Gmsh(std::string_view text, Volume_file& file) { return Gmsh_reader(text, file).read(); }

} // namespace program
