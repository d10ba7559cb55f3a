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

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <cmath>
#include <limits>
#include <system_error>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

// Arrays that are not written in words: base64, or bytes of their own behind all elements.
class VTU_bytes
{
public:
  VTU_bytes() = default;

  // `appended` is the text from its tag on, or empty.
  VTU_bytes(const XML_scanner& file, std::string_view appended)
    : m_compressor(file.attribute("compressor")),
      m_is_big_endian(file.attribute("byte_order") == "BigEndian"),
      m_has_long_counts(file.attribute("header_type") == "UInt64")
  {
    XML_scanner scanner(appended);
    if(appended.empty() || !scanner.next())
      return;
    m_is_raw = scanner.attribute("encoding") == "raw";
    const std::size_t mark = appended.find('_', appended.find('>'));
    m_appended = mark == std::string_view::npos ? std::string_view() : appended.substr(mark + 1);
  }

  bool is_big_endian() const { return m_is_big_endian; }

  Volume_encoding encoding(std::string_view format) const
  {
    return format == "ascii"                  ? Volume_encoding::ascii
           : !m_compressor.empty()            ? Volume_encoding::compressed
           : m_is_raw && format == "appended" ? Volume_encoding::binary
                                              : Volume_encoding::base64;
  }

  // The bytes of an array's numbers. Returns the empty string, or what is wrong.
  std::string read(const XML_scanner& scanner, std::string& bytes) const
  {
    std::string_view data = scanner.content();
    const bool is_appended = scanner.attribute("format") == "appended";
    if(is_appended) {
      std::size_t offset = 0;
      if(internal::parse_number(scanner.attribute("offset"), offset) != std::errc() || offset > m_appended.size())
        return "the offset " + internal::quoted_word(scanner.attribute("offset")) + " is not within the appended data";
      data = m_appended.substr(offset);
    } else if(scanner.attribute("format") != "binary")
      return "the format " + internal::quoted_word(scanner.attribute("format")) + " is unknown";
    const bool is_raw = is_appended && m_is_raw;
    return m_compressor.empty() ? read_plain(data, is_raw, bytes) : read_compressed(data, is_raw, bytes);
  }

private:
  static std::string decoded(std::string_view data, bool is_raw, std::size_t size)
  {
    return is_raw ? std::string(data.substr(0, size)) : decode_base64(data, size);
  }

  std::uint64_t read_count(Binary_reader& reader) const
  {
    return m_has_long_counts ? reader.read<std::uint64_t>() : reader.read<std::uint32_t>();
  }

  // Their number and the bytes.
  std::string read_plain(std::string_view data, bool is_raw, std::string& bytes) const
  {
    const std::size_t head = m_has_long_counts ? 8 : 4;
    const std::string start = decoded(data, is_raw, head);
    Binary_reader reader(start, m_is_big_endian);
    const std::uint64_t count = read_count(reader);
    if(reader.has_failed() || count > data.size())
      return TOO_SHORT;
    bytes = decoded(data, is_raw, head + count).erase(0, head);
    return bytes.size() == count ? "" : TOO_SHORT;
  }

  // The number of blocks, the size of a block and of the last one if it differs, the sizes of the compressed blocks, and these.
  std::string read_compressed(std::string_view data, bool is_raw, std::string& bytes) const
  {
    if(m_compressor != "vtkZLibDataCompressor")
      return "numbers are compressed by " + internal::quoted_word(m_compressor) + "; only vtkZLibDataCompressor is supported";
    const std::size_t word = m_has_long_counts ? 8 : 4;
    const std::string start = decoded(data, is_raw, 3 * word);
    Binary_reader start_reader(start, m_is_big_endian);
    const std::uint64_t number = read_count(start_reader), size = read_count(start_reader), last_size = read_count(start_reader);
    if(start_reader.has_failed() || number > data.size() / word)
      return TOO_SHORT;
    std::string header = decoded(data, is_raw, (3 + number) * word);
    Binary_reader reader(header, m_is_big_endian);
    for(int i = 0; i < 3; ++i)
      read_count(reader);
    std::vector<std::size_t> sizes;
    std::size_t total = 0;
    for(std::uint64_t i = 0; i < number; ++i) {
      sizes.push_back(read_count(reader));
      if(reader.has_failed() || sizes.back() > data.size() - total)
        return TOO_SHORT;
      total += sizes.back();
    }
    const std::string all = decoded(data, is_raw, header.size() + total);
    if(all.size() != header.size() + total)
      return TOO_SHORT;
    std::string_view rest = std::string_view(all).substr(header.size());
    for(std::size_t i = 0; i < sizes.size(); ++i) {
      const std::string error = decompress(rest.substr(0, sizes[i]), i + 1 == sizes.size() && last_size != 0 ? last_size : size, bytes);
      if(!error.empty())
        return error;
      rest.remove_prefix(sizes[i]);
    }
    return "";
  }

  static constexpr const char* TOO_SHORT = "the file ends too early, or the array's number of bytes is wrong";

  std::string_view m_compressor, m_appended;
  bool m_is_big_endian = false, m_has_long_counts = false, m_is_raw = false;
};

class VTU_reader
{
public:
  explicit VTU_reader(Volume_file& file) : m_file(file) {}

  std::string read(std::string_view text)
  {
    // Appended data may be any bytes, and nothing but the end follows them.
    const std::size_t appended = text.find("<AppendedData");
    XML_scanner scanner(text.substr(0, appended));
    if(!scanner.next() || scanner.name() != "VTKFile")
      return "the file does not begin with an element 'VTKFile'";
    m_bytes = VTU_bytes(scanner, appended == std::string_view::npos ? std::string_view() : text.substr(appended));
    if(scanner.attribute("type") != "UnstructuredGrid")
      return "the file holds " + internal::quoted_word(scanner.attribute("type")) + ", not an 'UnstructuredGrid'";
    while(scanner.next()) {
      const std::string error = read_tag(scanner);
      if(!error.empty())
        return "line " + std::to_string(scanner.line()) + ": " + error;
      if(scanner.name() == "/VTKFile")
        return m_number_of_pieces > 0 ? "" : "the file has no element 'Piece'";
    }
    return appended != std::string_view::npos && m_number_of_pieces > 0 && !m_is_in_piece ? ""
                                                                                          : "the file ends too early, without '</VTKFile>'";
  }

private:
  struct Piece
  {
    std::size_t number_of_points = 0, number_of_cells = 0;
    Data_array coordinates, connectivity, offsets, types;
    std::vector<Data_array> point_data, cell_data;
  };

  std::string read_tag(const XML_scanner& scanner)
  {
    const std::string_view name = scanner.name();
    if(name == "Points" || name == "Cells" || name == "PointData" || name == "CellData" || name == "FieldData") {
      m_group = name;
      m_kinds.clear();
      for(const char* kind : VTK_KINDS)
        if(!scanner.attribute(kind).empty())
          m_kinds[std::string(scanner.attribute(kind))] = kind;
    } else if(name.substr(0, 1) == "/" && name.substr(1) == m_group)
      m_group = std::string_view();
    else if(name == "Piece") {
      long long points = -1, cells = -1;
      if(internal::parse_number(scanner.attribute("NumberOfPoints"), points) != std::errc() || points < 0 ||
         internal::parse_number(scanner.attribute("NumberOfCells"), cells) != std::errc() || cells < 0)
        return "the element 'Piece' does not tell its numbers of points and cells";
      m_piece = Piece();
      m_piece.number_of_points = static_cast<std::size_t>(points);
      m_piece.number_of_cells = static_cast<std::size_t>(cells);
      m_is_in_piece = true;
    } else if(name == "/Piece") {
      m_is_in_piece = false;
      return finish_piece();
    } else if(name == "DataArray" && !m_group.empty())
      return read_array(scanner);
    return "";
  }

  std::string read_array(const XML_scanner& scanner)
  {
    const std::string_view name = scanner.attribute("Name");
    if(m_group == "Points") {
      m_file.encoding = m_bytes.encoding(scanner.attribute("format"));
      return read_numbers(scanner, "Points", Number_type::float64, m_piece.coordinates);
    }
    if(m_group == "Cells")
      return name == "connectivity" ? read_numbers(scanner, "connectivity", Number_type::int64, m_piece.connectivity)
             : name == "offsets"    ? read_numbers(scanner, "offsets", Number_type::int64, m_piece.offsets)
             : name == "types"      ? read_numbers(scanner, "types", Number_type::uint8, m_piece.types)
                                    : "";
    if(scanner.attribute("type") == "String") // text is not kept
      return "";
    Data_array array;
    array.name = without_entities(name);
    const auto kind = m_kinds.find(std::string(name));
    if(kind != m_kinds.end())
      array.kind = kind->second;
    const std::string_view components = scanner.attribute("NumberOfComponents");
    if(!components.empty() &&
       (internal::parse_number(components, array.number_of_components) != std::errc() || array.number_of_components == 0))
      return "the array " + internal::quoted_word(name) + " has no number of components";
    const std::string error = read_numbers(scanner, array.name, Number_type::float64, array);
    if(!error.empty())
      return error;
    (m_group == "PointData"  ? m_piece.point_data
     : m_group == "CellData" ? m_piece.cell_data
                             : m_file.field_data)
      .push_back(std::move(array));
    return "";
  }

  std::string read_numbers(const XML_scanner& scanner, const std::string& name, Number_type usual, Data_array& array) const
  {
    const std::string where = "in the array " + internal::quoted_word(name) + ", ";
    const std::string_view type = scanner.attribute("type");
    array.reals.clear();
    array.integers.clear();
    array.type = usual;
    if(!type.empty() && !VTU_type(type, array.type))
      return where + "the type " + internal::quoted_word(type) + " is unknown";
    if(scanner.attribute("format") != "ascii") {
      std::string bytes;
      const std::string error = m_bytes.read(scanner, bytes);
      append_bytes(array, bytes, m_bytes.is_big_endian());
      return error.empty() ? "" : where + error;
    }
    for(internal::Word_reader reader(scanner.content()); !reader.at_end(); reader.skip_word()) {
      const std::string error = append_word(array, reader.word());
      if(!error.empty())
        return where + error;
    }
    return "";
  }

  std::string finish_piece()
  {
    const Data_array& coordinates = m_piece.coordinates;
    if(coordinates.size() / 3 != m_piece.number_of_points || coordinates.size() % 3 != 0)
      return "the piece has " + std::to_string(coordinates.size()) + " coordinates for " + std::to_string(m_piece.number_of_points) +
             " points";
    for(std::size_t i = 0; i < coordinates.size(); ++i)
      if(!std::isfinite(coordinates.value(i)))
        return "a coordinate of point " + std::to_string(i / 3) + " is not finite";
    const std::size_t first = m_file.points.size();
    if(first + m_piece.number_of_points > std::size_t((std::numeric_limits<int>::max)()))
      return "too many points";
    for(std::size_t i = 0; i < m_piece.number_of_points; ++i)
      m_file.points.push_back({coordinates.value(3 * i), coordinates.value(3 * i + 1), coordinates.value(3 * i + 2)});
    std::string error = add_cells(static_cast<long long>(first));
    if(error.empty())
      error = add_arrays("points", m_piece.number_of_points, m_piece.point_data, m_file.point_data);
    if(error.empty())
      error = add_arrays("cells", m_piece.number_of_cells, m_piece.cell_data, m_file.cell_data);
    ++m_number_of_pieces;
    return error;
  }

  std::string add_cells(long long first)
  {
    const Data_array &connectivity = m_piece.connectivity, &offsets = m_piece.offsets, &types = m_piece.types;
    if(is_real(connectivity.type) || is_real(offsets.type) || is_real(types.type))
      return "the piece has cells whose indices are no integers";
    if(offsets.size() != m_piece.number_of_cells || types.size() != m_piece.number_of_cells)
      return "the piece has " + std::to_string(offsets.size()) + " offsets and " + std::to_string(types.size()) + " types for " +
             std::to_string(m_piece.number_of_cells) + " cells";
    std::int64_t begin = 0;
    std::vector<int> nodes;
    for(std::size_t i = 0; i < m_piece.number_of_cells; ++i) {
      const std::int64_t end = offsets.integers[i];
      if(end < begin || end > static_cast<std::int64_t>(connectivity.size()))
        return "the offset of cell " + std::to_string(i) + " is out of range";
      nodes.clear();
      for(; begin < end; ++begin) {
        const std::int64_t index = connectivity.integers[begin];
        if(index < 0 || index >= static_cast<std::int64_t>(m_piece.number_of_points))
          return "cell " + std::to_string(i) + " has the point " + std::to_string(index) + ", but there are " +
                 std::to_string(m_piece.number_of_points);
        nodes.push_back(static_cast<int>(index + first));
      }
      if(types.integers[i] < 0 || types.integers[i] > 255)
        return "the type of cell " + std::to_string(i) + " is out of range";
      m_file.cells.add(static_cast<int>(types.integers[i]), nodes);
    }
    return "";
  }

  // Those of another piece follow those that are there.
  std::string add_arrays(const char* what, std::size_t size, std::vector<Data_array>& more, std::vector<Data_array>& all) const
  {
    for(const Data_array& array : more)
      if(array.size() / array.number_of_components != size || array.size() % array.number_of_components != 0)
        return "the array " + internal::quoted_word(array.name) + " has " + std::to_string(array.size()) + " values, not " +
               std::to_string(array.number_of_components) + " for each of " + std::to_string(size) + " " + what;
    if(m_number_of_pieces == 0) {
      all = std::move(more);
      return "";
    }
    const auto is_alike = [](const Data_array& a, const Data_array& b) {
      return a.name == b.name && a.type == b.type && a.number_of_components == b.number_of_components;
    };
    if(!std::equal(all.begin(), all.end(), more.begin(), more.end(), is_alike))
      return std::string("the pieces have different arrays at their ") + what;
    for(std::size_t i = 0; i < all.size(); ++i) {
      all[i].reals.insert(all[i].reals.end(), more[i].reals.begin(), more[i].reals.end());
      all[i].integers.insert(all[i].integers.end(), more[i].integers.begin(), more[i].integers.end());
    }
    return "";
  }

  Volume_file& m_file;
  VTU_bytes m_bytes;
  Piece m_piece;
  std::string_view m_group;
  std::map<std::string, const char*> m_kinds; // what the group's arrays are taken for, by their names
  std::size_t m_number_of_pieces = 0;
  bool m_is_in_piece = false;
};

} // namespace

std::string read_VTU(std::string_view text, Volume_file& file) { return VTU_reader(file).read(text); }

} // namespace program
