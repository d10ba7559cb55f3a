// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VTU_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VTU_H

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/*!
  Named values for the points or the tetrahedra of a VTU file.
*/
struct VTU_array
{
  /// Name under which a viewer lists the values; letters, digits, spaces, `_`, `-` and `.`, at least one.
  std::string name;

  /// Values per point or tetrahedron: 1 for scalars, 3 for vectors.
  int number_of_components = 1;

  /// The values of the first point or tetrahedron, those of the second, and so on; finite.
  std::vector<double> values;
};

namespace internal {

// Elements of an XML text one after the other, as far as VTU files need it: no entities within attributes, no CDATA.
class XML_scanner
{
public:
  explicit XML_scanner(std::string_view text) : m_text(text) {}

  // Goes to the next tag; false at the end of the text or when it does not end properly, see is_broken().
  bool next()
  {
    for(;;) {
      const std::size_t begin = m_text.find('<', m_end);
      if(begin == std::string_view::npos)
        return false;
      if(m_text.substr(begin, 4) == "<!--") {
        const std::size_t end = m_text.find("-->", begin);
        m_is_broken = end == std::string_view::npos;
        if(m_is_broken)
          return false;
        m_end = end + 3;
        continue;
      }
      const std::size_t end = m_text.find('>', begin);
      m_is_broken = end == std::string_view::npos;
      if(m_is_broken)
        return false;
      m_tag = m_text.substr(begin + 1, end - begin - 1);
      m_end = end + 1;
      if(m_tag.empty() || m_tag.front() == '?' || m_tag.front() == '!')
        continue;
      return true;
    }
  }

  bool is_broken() const { return m_is_broken; }

  // The name, with the slash of a closing tag.
  std::string_view name() const
  {
    std::string_view name = m_tag.substr(0, m_tag.find_first_of(" \t\r\n"));
    if(name.size() > 1 && name.back() == '/')
      name.remove_suffix(1);
    return name;
  }

  // The value of the attribute; empty when there is none.
  std::string_view attribute(std::string_view key) const
  {
    for(std::size_t i = m_tag.find(key); i != std::string_view::npos; i = m_tag.find(key, i + 1)) {
      const bool begins_here = i > 0 && std::string_view(" \t\r\n").find(m_tag[i - 1]) != std::string_view::npos;
      std::size_t j = m_tag.find_first_not_of(" \t\r\n", i + key.size());
      if(!begins_here || j == std::string_view::npos || m_tag[j] != '=')
        continue;
      j = m_tag.find_first_of("\"'", j);
      if(j == std::string_view::npos)
        continue;
      const std::size_t end = m_tag.find(m_tag[j], j + 1);
      if(end != std::string_view::npos)
        return m_tag.substr(j + 1, end - j - 1);
    }
    return std::string_view();
  }

  // The text from here to the next tag.
  std::string_view content() const { return m_text.substr(m_end, m_text.find('<', m_end) - m_end); }

  // The line on which the tag ends, from 1.
  long long line() const { return 1 + std::count(m_text.begin(), m_text.begin() + m_end, '\n'); }

private:
  std::string_view m_text;
  std::string_view m_tag;
  std::size_t m_end = 0;
  bool m_is_broken = false;
};

// Arrays that are not written in words: base64, or bytes of their own behind all elements. Each begins with the number of its bytes.
class VTU_data
{
public:
  VTU_data() = default;

  // `appended` is the text from its tag on, or empty.
  VTU_data(const XML_scanner& file, std::string_view appended)
    : m_is_big_endian(file.attribute("byte_order") == "BigEndian"),
      m_has_long_counts(file.attribute("header_type") == "UInt64"),
      m_is_compressed(!file.attribute("compressor").empty())
  {
    XML_scanner scanner(appended);
    if(appended.empty() || !scanner.next())
      return;
    m_is_raw = scanner.attribute("encoding") == "raw";
    const std::size_t mark = appended.find('_', appended.find('>'));
    m_appended = mark == std::string_view::npos ? std::string_view() : appended.substr(mark + 1);
  }

  // The bytes of an array, without their number.
  std::string read_bytes(const XML_scanner& scanner, std::string& bytes) const
  {
    if(m_is_compressed)
      return "numbers are compressed, which is not supported; write the file without compression";
    std::string_view data = scanner.content();
    const bool is_appended = scanner.attribute("format") == "appended";
    if(is_appended) {
      std::size_t offset = 0;
      if(parse_number(scanner.attribute("offset"), offset) != std::errc() || offset > m_appended.size())
        return "the offset " + quoted_word(scanner.attribute("offset")) + " is not within the appended data";
      data = m_appended.substr(offset);
    } else if(scanner.attribute("format") != "binary")
      return "the format " + quoted_word(scanner.attribute("format")) + " is unknown";
    const std::size_t head = m_has_long_counts ? 8 : 4;
    const bool is_raw = is_appended && m_is_raw;
    const std::string start = is_raw ? std::string(data.substr(0, head)) : decoded(data, head);
    program::Binary_reader reader(start, m_is_big_endian);
    const std::uint64_t count = m_has_long_counts ? reader.read<std::uint64_t>() : reader.read<std::uint32_t>();
    if(reader.has_failed() || count > data.size())
      return "the file ends too early, or the array's number of bytes is wrong";
    bytes = is_raw ? std::string(data.substr(head, count)) : decoded(data, head + count).erase(0, head);
    return bytes.size() == count ? "" : "the file ends too early, or the array's number of bytes is wrong";
  }

  template <typename Number>
  std::string read_numbers(std::string_view type, const std::string& bytes, std::vector<Number>& values) const
  {
    if(type == "Float64")
      append_as<double>(bytes, values);
    else if(type == "Float32")
      append_as<float>(bytes, values);
    else if(type == "Int64")
      append_as<std::int64_t>(bytes, values);
    else if(type == "UInt64")
      append_as<std::uint64_t>(bytes, values);
    else if(type == "Int32")
      append_as<std::int32_t>(bytes, values);
    else if(type == "UInt32")
      append_as<std::uint32_t>(bytes, values);
    else if(type == "Int16")
      append_as<std::int16_t>(bytes, values);
    else if(type == "UInt16")
      append_as<std::uint16_t>(bytes, values);
    else if(type == "Int8")
      append_as<std::int8_t>(bytes, values);
    else if(type == "UInt8")
      append_as<std::uint8_t>(bytes, values);
    else
      return "the type " + quoted_word(type) + " is unknown";
    if constexpr(std::is_same<Number, double>::value)
      for(const double value : values)
        if(!std::isfinite(value))
          return "a number is not finite";
    return "";
  }

private:
  template <typename Stored, typename Number>
  void append_as(const std::string& bytes, std::vector<Number>& values) const
  {
    for(program::Binary_reader reader(bytes, m_is_big_endian); reader.left() >= sizeof(Stored);)
      values.push_back(static_cast<Number>(reader.read<Stored>()));
  }

  // So many bytes of a text in base64. Some programs encode the number of bytes for itself, so that padding stands in the middle.
  static std::string decoded(std::string_view text, std::size_t size)
  {
    static const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int number_of_bits = 0;
    for(std::size_t i = 0; i < text.size() && bytes.size() < size; ++i) {
      if(text[i] == '=') {
        number_of_bits = 0;
        continue;
      }
      const std::size_t digit = digits.find(text[i]);
      if(digit == std::string_view::npos) {
        if(text[i] != ' ' && text[i] != '\t' && text[i] != '\r' && text[i] != '\n')
          break;
        continue;
      }
      bits = bits << 6 | static_cast<std::uint32_t>(digit);
      number_of_bits += 6;
      if(number_of_bits >= 8) {
        number_of_bits -= 8;
        bytes += static_cast<char>(bits >> number_of_bits & 255);
      }
    }
    return bytes;
  }

  bool m_is_big_endian = false, m_has_long_counts = false, m_is_compressed = false, m_is_raw = false;
  std::string_view m_appended;
};

class VTU_reader
{
public:
  // Returns the empty string, or what is wrong with the file.
  std::string read(std::string_view text)
  {
    // Appended data may be any bytes, and nothing but the end follows them.
    const std::size_t appended = text.find("<AppendedData");
    XML_scanner scanner(text.substr(0, appended));
    if(!scanner.next() || scanner.name() != "VTKFile")
      return "the file does not begin with an element 'VTKFile'";
    m_data = VTU_data(scanner, appended == std::string_view::npos ? std::string_view() : text.substr(appended));
    if(scanner.attribute("type") != "UnstructuredGrid")
      return "the file holds " + quoted_word(scanner.attribute("type")) + ", not an 'UnstructuredGrid'";
    while(scanner.next()) {
      const std::string error = read_tag(scanner);
      if(!error.empty())
        return "line " + std::to_string(scanner.line()) + ": " + error;
      if(scanner.name() == "/VTKFile")
        return m_has_piece ? "" : "the file has no element 'Piece'";
    }
    return appended != std::string_view::npos && m_has_piece ? "" : "the file ends too early, without '</VTKFile>'";
  }

  Tetrahedral_mesh& mesh() { return m_mesh; }

private:
  std::string read_tag(const XML_scanner& scanner)
  {
    const std::string_view name = scanner.name();
    if(name == "Points" || name == "Cells")
      m_group = name;
    else if(name == "/Points" || name == "/Cells")
      m_group = std::string_view();
    else if(name == "Piece") {
      long long points = -1, cells = -1;
      if(parse_number(scanner.attribute("NumberOfPoints"), points) != std::errc() || points < 0 ||
         parse_number(scanner.attribute("NumberOfCells"), cells) != std::errc() || cells < 0)
        return "the element 'Piece' does not tell its numbers of points and cells";
      m_has_piece = true;
      m_number_of_points = static_cast<std::size_t>(points);
      m_number_of_cells = static_cast<std::size_t>(cells);
      m_coordinates.clear();
      m_connectivity.clear();
      m_offsets.clear();
      m_types.clear();
    } else if(name == "/Piece")
      return finish_piece();
    else if(name == "DataArray" && !m_group.empty()) {
      const std::string_view array = scanner.attribute("Name");
      if(m_group == "Points")
        return read_array(scanner, "Points", m_coordinates);
      if(array == "connectivity")
        return read_array(scanner, "connectivity", m_connectivity);
      if(array == "offsets")
        return read_array(scanner, "offsets", m_offsets);
      if(array == "types")
        return read_array(scanner, "types", m_types);
    }
    return std::string();
  }

  template <typename Number>
  std::string read_array(const XML_scanner& scanner, const char* name, std::vector<Number>& values) const
  {
    const std::string_view format = scanner.attribute("format");
    const std::string where = std::string("in the array '") + name + "', ";
    values.clear();
    if(format != "ascii") {
      std::string bytes;
      std::string error = m_data.read_bytes(scanner, bytes);
      if(error.empty())
        error = m_data.read_numbers(scanner.attribute("type"), bytes, values);
      return error.empty() ? error : where + error;
    }
    for(Word_reader reader(scanner.content()); !reader.at_end();) {
      bool is_read = false;
      Number value{};
      if constexpr(std::is_same<Number, double>::value)
        is_read = reader.read_finite(value);
      else
        is_read = reader.read_integer(value);
      if(!is_read)
        return where + reader.error();
      values.push_back(value);
    }
    return std::string();
  }

  std::string finish_piece()
  {
    if(m_coordinates.size() / 3 != m_number_of_points || m_coordinates.size() % 3 != 0)
      return "the piece has " + std::to_string(m_coordinates.size()) + " coordinates for " + std::to_string(m_number_of_points) + " points";
    if(m_offsets.size() != m_number_of_cells || m_types.size() != m_number_of_cells)
      return "the piece has " + std::to_string(m_offsets.size()) + " offsets and " + std::to_string(m_types.size()) + " types for " +
             std::to_string(m_number_of_cells) + " cells";
    const std::size_t first = m_mesh.points.size();
    if(first + m_number_of_points > std::size_t((std::numeric_limits<int>::max)()))
      return "too many points";
    for(std::size_t i = 0; i < m_number_of_points; ++i)
      m_mesh.points.push_back({{m_coordinates[3 * i], m_coordinates[3 * i + 1], m_coordinates[3 * i + 2]}});

    long long begin = 0;
    for(std::size_t i = 0; i < m_number_of_cells; ++i) {
      const long long end = m_offsets[i];
      if(end < begin || end > static_cast<long long>(m_connectivity.size()))
        return "the offset of cell " + std::to_string(i) + " is out of range";
      const std::string error = m_types[i] == TETRAHEDRON ? add_cell(i, begin, end, first, m_mesh.tetrahedra)
                                : m_types[i] == TRIANGLE  ? add_cell(i, begin, end, first, m_mesh.triangles)
                                : m_types[i] > TETRAHEDRON
                                  ? "cell " + std::to_string(i) + " is of type " + std::to_string(m_types[i]) + ", no tetrahedron (10)"
                                  : std::string();
      if(!error.empty())
        return error;
      begin = end;
    }
    return std::string();
  }

  template <std::size_t N>
  std::string add_cell(std::size_t i, long long begin, long long end, std::size_t first, std::vector<std::array<int, N>>& cells) const
  {
    if(end - begin != static_cast<long long>(N))
      return "cell " + std::to_string(i) + " has " + std::to_string(end - begin) + " corners, not " + std::to_string(N);
    std::array<int, N> cell;
    for(std::size_t k = 0; k < N; ++k) {
      const long long index = m_connectivity[begin + k];
      if(index < 0 || index >= static_cast<long long>(m_number_of_points))
        return "cell " + std::to_string(i) + " has the point " + std::to_string(index) + ", but there are " +
               std::to_string(m_number_of_points);
      cell[k] = static_cast<int>(index + first);
    }
    cells.push_back(cell);
    return std::string();
  }

  // Types of cells; smaller ones are points, lines and polygons.
  static constexpr long long TRIANGLE = 5;
  static constexpr long long TETRAHEDRON = 10;

  VTU_data m_data;
  Tetrahedral_mesh m_mesh;
  std::string_view m_group;
  bool m_has_piece = false;
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_cells = 0;
  std::vector<double> m_coordinates;
  std::vector<long long> m_connectivity;
  std::vector<long long> m_offsets;
  std::vector<long long> m_types;
};

// Returns the empty string, or what is wrong with the arrays.
inline std::string VTU_arrays_error(const std::vector<VTU_array>& arrays, std::size_t size)
{
  const std::string allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 _-.";
  for(const VTU_array& array : arrays) {
    if(array.name.empty() || array.name.find_first_not_of(allowed) != std::string::npos)
      return quoted_word(array.name) + " is no name for values";
    if(array.number_of_components < 1 || array.values.size() != size * array.number_of_components)
      return "the number of values of '" + array.name + "' is " + std::to_string(array.values.size()) + ", expected " +
             std::to_string(array.number_of_components) + " for each of " + std::to_string(size);
    for(std::size_t i = 0; i < array.values.size(); ++i)
      if(!std::isfinite(array.values[i]))
        return "value " + std::to_string(i) + " of '" + array.name + "' is not finite";
  }
  return std::string();
}

inline void append_VTU_arrays(std::string& text, const char* group, const std::vector<VTU_array>& arrays)
{
  if(arrays.empty())
    return;
  text += std::string("      <") + group + ">\n";
  for(const VTU_array& array : arrays) {
    text += "        <DataArray type=\"Float64\" Name=\"" + array.name + "\" NumberOfComponents=\"" +
            std::to_string(array.number_of_components) + "\" format=\"ascii\">\n";
    for(std::size_t i = 0; i < array.values.size(); ++i) {
      append_number(text, array.values[i]);
      text += (i + 1) % array.number_of_components == 0 ? '\n' : ' ';
    }
    text += "        </DataArray>\n";
  }
  text += std::string("      </") + group + ">\n";
}

} // namespace internal

/*!
  reads points, tetrahedra and triangles from a VTU file (unstructured grid of VTK) whose arrays are in words, in base64 or appended. Several pieces are
  put together; points, lines and other polygons are ignored, as are the arrays of values. The locale has no influence. The
  cost is linear in the size of the file.

  \param path name of the file
  \param mesh receives the mesh; it is not changed if the file cannot be read
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `false` if the file cannot be opened, is no VTU file, has compressed points or cells, ends too early, has
           solid cells that are no tetrahedra, arrays of wrong sizes, coordinates that are not finite or indices out of range
*/
inline bool read_VTU(const std::string& path, Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  return internal::read_mesh_with<internal::VTU_reader>(path, mesh, message);
}

/*!
  writes the points and tetrahedra of a mesh, with values, as a VTU file in ASCII for ParaView. Triangles are not written.

  Numbers are written with as many digits (up to 17) as it takes to read back exactly the same doubles. The cost is linear.

  \param path name of the file; an existing file is replaced
  \param mesh the mesh; its coordinates must be finite and its indices valid
  \param point_data values at the points
  \param cell_data values in the tetrahedra
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `true` if the file was written. An invalid mesh, and arrays with an invalid name,
           of a wrong size or with values that are not finite, are refused before the file is touched.
*/
inline bool write_VTU(const std::string& path, const Tetrahedral_mesh& mesh, const std::vector<VTU_array>& point_data = {},
                      const std::vector<VTU_array>& cell_data = {}, std::string* message = nullptr)
{
  std::string error = internal::tetrahedral_mesh_error(mesh);
  if(error.empty())
    error = internal::VTU_arrays_error(point_data, mesh.points.size());
  if(error.empty())
    error = internal::VTU_arrays_error(cell_data, mesh.tetrahedra.size());
  if(!error.empty())
    return internal::fail(message, "cannot write " + path + ": " + error);

  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                     "  <UnstructuredGrid>\n"
                     "    <Piece NumberOfPoints=\"" +
                     std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.tetrahedra.size()) + "\">\n";
  internal::append_VTU_arrays(text, "PointData", point_data);
  internal::append_VTU_arrays(text, "CellData", cell_data);
  text += "      <Points>\n        <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(const std::array<double, 3>& point : mesh.points) {
    internal::append_coordinates(text, point);
    text += '\n';
  }
  text += "        </DataArray>\n      </Points>\n"
          "      <Cells>\n        <DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for(const std::array<int, 4>& tetrahedron : mesh.tetrahedra) {
    internal::append_numbers(text, tetrahedron);
    text += '\n';
  }
  text += "        </DataArray>\n        <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for(std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    internal::append_number(text, static_cast<long long>(4 * i + 4));
    text += '\n';
  }
  text += "        </DataArray>\n        <DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for(std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    text += "10\n";
  text += "        </DataArray>\n      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
  return internal::write_whole_file(path, text, message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VTU_H
