// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "VTK_names.h"
#include "XML_scanner.h"
#include "packed_bytes.h"
#include "volume_formats.h"

#include "Binary_reader.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

class VTU_writer
{
public:
  explicit VTU_writer(Volume_encoding encoding) : m_encoding(encoding) {}

  std::string text(const Volume_file& file)
  {
    m_text = "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"";
    if(m_encoding == Volume_encoding::compressed)
      m_text += " compressor=\"vtkZLibDataCompressor\"";
    m_text += ">\n  <UnstructuredGrid>\n";
    if(!file.field_data.empty())
      add_arrays("FieldData", file.field_data);
    m_text += "    <Piece NumberOfPoints=\"" + std::to_string(file.points.size()) + "\" NumberOfCells=\"" +
              std::to_string(file.cells.size()) + "\">\n";
    add_arrays("PointData", file.point_data);
    add_arrays("CellData", file.cell_data);
    std::vector<double> coordinates;
    coordinates.reserve(3 * file.points.size());
    for(const auto& point : file.points)
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    add_arrays("Points", {real_array("Points", 3, std::move(coordinates))});
    add_arrays("Cells", cell_arrays(file.cells));
    m_text += "    </Piece>\n  </UnstructuredGrid>\n";
    if(!m_appended.empty())
      m_text += "  <AppendedData encoding=\"raw\">\n_" + m_appended + "\n  </AppendedData>\n";
    return std::move(m_text) + "</VTKFile>\n";
  }

private:
  static std::vector<Data_array> cell_arrays(const Cells& cells)
  {
    return {integer_array("connectivity", Number_type::int32, {cells.nodes.begin(), cells.nodes.end()}),
            integer_array("offsets", Number_type::int64, {cells.ends.begin(), cells.ends.end()}),
            integer_array("types", Number_type::uint8, {cells.types.begin(), cells.types.end()})};
  }

  void add_arrays(const std::string& group, const std::vector<Data_array>& arrays)
  {
    m_text += "      <" + group;
    // Of each kind there is one.
    for(const char* kind : VTK_KINDS) {
      const auto found = std::find_if(arrays.begin(), arrays.end(), [kind](const Data_array& array) { return array.kind == kind; });
      if(found != arrays.end())
        m_text += std::string(" ") + kind + "=\"" + with_entities(found->name) + '"';
    }
    m_text += ">\n";
    for(const Data_array& array : arrays)
      add_array(array, group == "FieldData");
    m_text += "      </" + group + ">\n";
  }

  void add_array(const Data_array& array, bool with_number_of_tuples)
  {
    m_text += "        <DataArray type=\"" + std::string(VTK_type_of(array.type).xml) + "\" Name=\"" + with_entities(array.name) +
              "\" NumberOfComponents=\"" + std::to_string(array.number_of_components) + '"';
    if(with_number_of_tuples)
      m_text += " NumberOfTuples=\"" + std::to_string(array.size() / array.number_of_components) + '"';
    if(m_encoding == Volume_encoding::ascii) {
      m_text += " format=\"ascii\">\n";
      append_as_text(m_text, array);
    } else {
      std::string bytes;
      append_as_bytes(bytes, array, false);
      if(m_encoding == Volume_encoding::binary) {
        m_text += " format=\"appended\" offset=\"" + std::to_string(m_appended.size()) + "\">\n";
        append_number_bytes(m_appended, static_cast<std::uint64_t>(bytes.size()), false);
        m_appended += bytes;
      } else
        m_text += " format=\"binary\">\n" + (m_encoding == Volume_encoding::compressed ? compressed(bytes) : with_size(bytes)) + '\n';
    }
    m_text += "        </DataArray>\n";
  }

  static std::string with_size(const std::string& bytes)
  {
    std::string head;
    append_number_bytes(head, static_cast<std::uint64_t>(bytes.size()), false);
    return encode_base64(head + bytes);
  }

  // Blocks, with what read_VTU.cpp says before them.
  static std::string compressed(const std::string& bytes)
  {
    constexpr std::size_t SIZE = 1 << 16;
    std::vector<std::uint64_t> head{(bytes.size() + SIZE - 1) / SIZE, SIZE, bytes.size() % SIZE};
    std::string blocks, head_bytes;
    for(std::size_t begin = 0; begin < bytes.size(); begin += SIZE) {
      const std::string block = compress(std::string_view(bytes).substr(begin, SIZE));
      head.push_back(block.size());
      blocks += block;
    }
    for(const std::uint64_t number : head)
      append_number_bytes(head_bytes, number, false);
    return encode_base64(head_bytes) + encode_base64(blocks);
  }

  Volume_encoding m_encoding;
  std::string m_text, m_appended;
};

} // namespace

std::string VTU_text(const Volume_file& file, Volume_encoding encoding) { return VTU_writer(encoding).text(file); }

} // namespace program
