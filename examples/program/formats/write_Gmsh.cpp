// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gmsh_types.h"
#include "volume_formats.h"

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

#include <algorithm>
#include <iterator>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

class Gmsh_writer
{
public:
  explicit Gmsh_writer(bool is_binary) : m_is_binary(is_binary) {}

  std::string text(const Volume_file& file)
  {
    m_text = std::string("$MeshFormat\n2.2 ") + (m_is_binary ? "1 8\n" : "0 8\n");
    if(m_is_binary) {
      append_number_bytes(m_text, std::int32_t(1), false);
      m_text += '\n';
    }
    m_text += "$EndMeshFormat\n";
    if(!file.groups.empty()) {
      m_text += "$PhysicalNames\n" + std::to_string(file.groups.size()) + '\n';
      for(const Named_group& group : file.groups)
        m_text += std::to_string(group.dimension) + ' ' + std::to_string(group.number) + " \"" + group.name + "\"\n";
      m_text += "$EndPhysicalNames\n";
    }
    m_text += "$Nodes\n" + std::to_string(file.points.size()) + '\n';
    for(std::size_t i = 0; i < file.points.size(); ++i)
      add_point(i, file.points[i]);
    m_text += m_is_binary ? "\n$EndNodes\n" : "$EndNodes\n";
    add_elements(file);
    return std::move(m_text);
  }

private:
  void add_point(std::size_t i, const std::array<double, 3>& point)
  {
    if(m_is_binary) {
      append_number_bytes(m_text, static_cast<std::int32_t>(i + 1), false);
      for(const double coordinate : point)
        append_number_bytes(m_text, coordinate, false);
    } else {
      internal::append_number(m_text, static_cast<long long>(i + 1));
      m_text += ' ';
      internal::append_coordinates(m_text, point);
      m_text += '\n';
    }
  }

  // Polygons and other cells that Gmsh does not have are left out.
  void add_elements(const Volume_file& file)
  {
    const Data_array* regions = find_regions(file);
    const Data_array* entities = find_array(file.cell_data, "entity");
    std::vector<std::pair<std::size_t, const Gmsh_type*>> elements;
    for(std::size_t i = 0; i < file.cells.size(); ++i) {
      const auto type = std::find_if(std::begin(GMSH_TYPES), std::end(GMSH_TYPES),
                                     [&](const Gmsh_type& entry) { return entry.cell == file.cells.types[i]; });
      if(type != std::end(GMSH_TYPES))
        elements.emplace_back(i, &*type);
    }
    m_text += "$Elements\n" + std::to_string(elements.size()) + '\n';
    for(std::size_t i = 0; i < elements.size(); ++i) {
      const auto& [cell, type] = elements[i];
      if(m_is_binary && (i == 0 || type != elements[i - 1].second)) {
        const auto is_other = [kind = type](const auto& element) { return element.second != kind; };
        const auto end = std::find_if(elements.begin() + i, elements.end(), is_other);
        add_numbers({type->number, end - elements.begin() - static_cast<std::ptrdiff_t>(i), 2});
      }
      const std::int64_t region = regions == nullptr ? 0 : regions->integers[cell];
      const bool has_entity = entities != nullptr && entities->integers.size() == file.cells.size();
      add_element(file.cells, i, cell, *type, region, has_entity ? entities->integers[cell] : (std::max)(region, std::int64_t(1)));
    }
    m_text += m_is_binary ? "\n$EndElements\n" : "$EndElements\n";
  }

  // In binary files elements that follow each other share their type and number of tags.
  void add_element(const Cells& cells, std::size_t i, std::size_t cell, const Gmsh_type& type, std::int64_t region, std::int64_t entity)
  {
    std::vector<long long> numbers{static_cast<long long>(i + 1)};
    if(!m_is_binary)
      numbers.insert(numbers.end(), {type.number, 2});
    numbers.insert(numbers.end(), {region, entity});
    for(std::size_t k = cells.begin(cell); k < cells.ends[cell]; ++k)
      numbers.push_back(cells.nodes[k] + 1LL);
    if(type.cell == cell_type::QUADRATIC_TETRAHEDRON)
      std::swap(numbers.end()[-1], numbers.end()[-2]);
    add_numbers(numbers);
  }

  void add_numbers(const std::vector<long long>& numbers)
  {
    if(m_is_binary)
      for(const long long number : numbers)
        append_number_bytes(m_text, static_cast<std::int32_t>(number), false);
    else {
      internal::append_numbers(m_text, numbers);
      m_text += '\n';
    }
  }

  bool m_is_binary;
  std::string m_text;
};

} // namespace

std::string Gmsh_text(const Volume_file& file, bool is_binary) { return Gmsh_writer(is_binary).text(file); }

} // namespace program
