// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_MEDIT_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IO_MEDIT_IMPL_H

#include <CGAL/Flip_free_maps/IO/Medit.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::string Medit_reader::read(std::string_view text)
{
  Word_reader reader(text);
  if(reader.word() != "MeshVersionFormatted")
    return "line " + std::to_string(reader.line()) + ": the file does not begin with 'MeshVersionFormatted'";
  while(!reader.at_end() && reader.word() != "End")
    if(!read_section(reader))
      return reader.error();
  if(!m_has_points)
    return "the file has no section 'Vertices'";
  // A section may precede the points that it uses.
  std::string error = index_error("tetrahedron", m_mesh.tetrahedra, m_mesh.points.size());
  if(error.empty())
    error = index_error("triangle", m_mesh.triangles, m_mesh.points.size());
  return error;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Medit_reader::read_section(Word_reader& reader)
{
  const std::string_view keyword = reader.word();
  const long long line = reader.line();
  if(keyword == "Dimension") {
    m_is_skipping = false;
    reader.skip_word();
    long long dimension = 0;
    if(!reader.read_integer(dimension))
      return false;
    return dimension == 3 || reader.fail_at(line, "the dimension is " + std::to_string(dimension) + ", not 3");
  }
  if(keyword == "Vertices") {
    if(m_has_points)
      return reader.fail_at(line, "a second section 'Vertices'");
    m_has_points = true;
    m_is_skipping = false;
    reader.skip_word();
    return read_points(reader);
  }
  if(keyword == "Tetrahedra" || keyword == "Triangles") {
    m_is_skipping = false;
    reader.skip_word();
    return keyword == "Tetrahedra" ? read_elements(reader, m_mesh.tetrahedra, m_references.tetrahedra)
                                   : read_elements(reader, m_mesh.triangles, m_references.triangles);
  }
  // Deformed without them, the tetrahedra would part from other elements.
  for(const std::string_view kind : {"Hexahedra", "Prisms", "Pyramids", "TetrahedraP2"})
    if(keyword == kind) {
      m_is_skipping = false;
      reader.skip_word();
      std::size_t count = 0;
      if(!reader.read_count(count))
        return false;
      return count == 0 || reader.fail_at(line, "elements other than tetrahedra are not supported: " + std::string(kind));
    }
  // Other sections are skipped word by word, since no number is a keyword.
  const bool is_keyword = std::isalpha(static_cast<unsigned char>(keyword.front())) != 0;
  if(!is_keyword && !m_is_skipping)
    return reader.fail_here("found " + quoted_word(keyword) + " where a section begins; the section before has more items than it says");
  m_is_skipping = true;
  reader.skip_word();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Medit_reader::read_points(Word_reader& reader)
{
  std::size_t count = 0;
  if(!reader.read_count(count))
    return false;
  m_mesh.points.reserve((std::min)(count, reader.possible_items(3)));
  for(std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> point;
    for(double& coordinate : point)
      if(!reader.read_finite(coordinate))
        return false;
    m_mesh.points.push_back(point);
    if(!read_reference(reader, m_references.points))
      return false;
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Medit_reader::read_reference(Word_reader& reader, std::vector<long long>& references)
{
  double value = 0;
  if(reader.is_line_continued() && !reader.read_finite(value))
    return false;
  references.push_back(std::abs(value) < 1e15 ? static_cast<long long>(value) : 0);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE std::string Medit_text(const Tetrahedral_mesh& mesh, const Medit_references& references)
{
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(mesh.points.size()) + '\n';
  const auto append_reference = [&text](const std::vector<long long>& list, std::size_t i, long long usual) {
    text += ' ';
    append_number(text, i < list.size() ? list[i] : usual);
    text += '\n';
  };
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    append_coordinates(text, mesh.points[i]);
    append_reference(references.points, i, 0);
  }
  const auto append_section = [&](const char* keyword, const auto& elements, const std::vector<long long>& list) {
    if(elements.empty())
      return;
    text += std::string(keyword) + '\n' + std::to_string(elements.size()) + '\n';
    for(std::size_t i = 0; i < elements.size(); ++i) {
      append_numbers(text, elements[i], 1);
      append_reference(list, i, 1);
    }
  };
  append_section("Triangles", mesh.triangles, references.triangles);
  append_section("Tetrahedra", mesh.tetrahedra, references.tetrahedra);
  return text + "End\n";
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool write_Medit(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message)
{
  const std::string error = internal::tetrahedral_mesh_error(mesh);
  if(!error.empty())
    return internal::fail(message, "cannot write " + path + ": " + error);
  return internal::write_whole_file(path, internal::Medit_text(mesh), message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_MEDIT_IMPL_H
