// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "VTK_names.h"
#include "volume_formats.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

// Version 4.2, which all programs read: later ones have another layout of cells.
class VTK_writer
{
public:
  explicit VTK_writer(bool is_binary) : m_is_binary(is_binary) {}

  std::string text(const Volume_file& file)
  {
    m_text = std::string("# vtk DataFile Version 4.2\nwritten by flip_free_maps\n") + (m_is_binary ? "BINARY" : "ASCII") +
             "\nDATASET UNSTRUCTURED_GRID\n";
    if(!file.field_data.empty())
      add_field(file.field_data);
    m_text += "POINTS " + std::to_string(file.points.size()) + " double\n";
    std::vector<double> coordinates;
    coordinates.reserve(3 * file.points.size());
    for(const auto& point : file.points)
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    add_values(real_array("", 3, std::move(coordinates)));
    const Cells& cells = file.cells;
    m_text += "CELLS " + std::to_string(cells.size()) + " " + std::to_string(cells.size() + cells.nodes.size()) + '\n';
    add_cells(cells);
    m_text += "CELL_TYPES " + std::to_string(cells.size()) + '\n';
    add_values(integer_array("", Number_type::int32, {cells.types.begin(), cells.types.end()}));
    add_data("POINT_DATA", file.points.size(), file.point_data);
    add_data("CELL_DATA", cells.size(), file.cell_data);
    return std::move(m_text);
  }

private:
  void add_values(const Data_array& array)
  {
    if(m_is_binary) {
      append_as_bytes(m_text, array, true);
      m_text += '\n';
    } else
      append_as_text(m_text, array);
  }

  // Each with its number of corners before them, in a line of its own.
  void add_cells(const Cells& cells)
  {
    Data_array line;
    line.type = Number_type::int32;
    for(std::size_t i = 0; i < cells.size(); ++i) {
      line.integers.assign(1, static_cast<std::int64_t>(cells.ends[i] - cells.begin(i)));
      line.integers.insert(line.integers.end(), cells.nodes.begin() + cells.begin(i), cells.nodes.begin() + cells.ends[i]);
      line.number_of_components = line.integers.size();
      if(m_is_binary)
        append_as_bytes(m_text, line, true);
      else
        append_as_text(m_text, line);
    }
    if(m_is_binary)
      m_text += '\n';
  }

  void add_data(const char* section, std::size_t size, const std::vector<Data_array>& arrays)
  {
    if(arrays.empty())
      return;
    m_text += std::string(section) + ' ' + std::to_string(size) + '\n';
    std::vector<Data_array> others;
    for(const Data_array& array : arrays)
      if(has_section(array))
        add_section(array);
      else
        others.push_back(array);
    if(!others.empty())
      add_field(others);
  }

  // Whether the array can be what it is taken for.
  static bool has_section(const Data_array& array)
  {
    const std::size_t components = array.number_of_components;
    return array.kind == "Vectors" || array.kind == "Normals" ? components == 3
           : array.kind == "Tensors"                          ? components == 9
           : array.kind == "Scalars"                          ? components <= 4
           : array.kind == "TCoords"                          ? components <= 3
                                                              : !array.kind.empty() && components == 1;
  }

  void add_section(const Data_array& array)
  {
    std::string section = old_VTK_kind(array.kind);
    std::transform(section.begin(), section.end(), section.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    const std::string components = ' ' + std::to_string(array.number_of_components);
    const std::string type = ' ' + std::string(VTK_type_of(array.type).old);
    m_text += section + ' ' + encoded_name(array.name) + (array.kind == "TCoords" ? components + type : type) +
              (array.kind == "Scalars" ? components + "\nLOOKUP_TABLE default\n" : "\n");
    add_values(array);
  }

  void add_field(const std::vector<Data_array>& arrays)
  {
    m_text += "FIELD FieldData " + std::to_string(arrays.size()) + '\n';
    for(const Data_array& array : arrays) {
      m_text += encoded_name(array.name) + ' ' + std::to_string(array.number_of_components) + ' ' +
                std::to_string(array.size() / array.number_of_components) + ' ' + std::string(VTK_type_of(array.type).old) + '\n';
      add_values(array);
    }
  }

  // See decoded_name() of the reader.
  static std::string encoded_name(const std::string& name)
  {
    const char* digits = "0123456789ABCDEF";
    std::string result;
    for(const char c : name)
      if(c > ' ' && c <= '~' && c != '%' && c != '"')
        result += c;
      else
        result += {'%', digits[static_cast<unsigned char>(c) >> 4], digits[static_cast<unsigned char>(c) & 15]};
    return result.empty() ? "unnamed" : result;
  }

  bool m_is_binary;
  std::string m_text;
};

} // namespace

std::string VTK_text(const Volume_file& file, bool is_binary) { return VTK_writer(is_binary).text(file); }

} // namespace program
