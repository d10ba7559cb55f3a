// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_TETGEN_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_TETGEN_FILES_H

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Lines "number x y z ...", numbered consecutively from 0 or 1, which `first` receives.
inline bool read_tetgen_points(Word_reader& reader, std::vector<std::array<double, 3>>& points, long long& first)
{
  std::size_t count = 0;
  long long dimension = 0;
  const long long header = reader.line();
  if(!reader.read_count(count) || !reader.read_integer(dimension))
    return false;
  if(dimension != 3)
    return reader.fail_at(header, "the dimension is " + std::to_string(dimension) + ", not 3");
  reader.skip_line();
  points.reserve((std::min)(count, reader.possible_items(4)));
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
    points.push_back(point);
    reader.skip_line();
  }
  return true;
}

// Lines "number a b c d ..."; elements of second order have more nodes, which follow the corners.
inline bool read_tetgen_elements(Word_reader& reader, std::size_t number_of_points, long long first,
                                 std::vector<std::array<int, 4>>& tetrahedra)
{
  std::size_t count = 0;
  long long nodes = 0;
  const long long header = reader.line();
  if(!reader.read_count(count) || !reader.read_integer(nodes))
    return false;
  if(nodes != 4 && nodes != 10)
    return reader.fail_at(header, "tetrahedra of " + std::to_string(nodes) + " nodes, not 4 or 10");
  reader.skip_line();
  tetrahedra.reserve((std::min)(count, reader.possible_items(5)));
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
      if(value < first || value - first >= static_cast<long long>(number_of_points))
        return reader.fail_at(line, "point index " + std::to_string(value) + " is out of range, there are " +
                                      std::to_string(number_of_points) + " points numbered from " + std::to_string(first));
      index = static_cast<int>(value - first);
    }
    tetrahedra.push_back(tetrahedron);
    reader.skip_line();
  }
  return true;
}

// The names of both files, given the name of one of them.
inline std::pair<std::string, std::string> tetgen_file_names(const std::string& path)
{
  std::filesystem::path node(path), element(path);
  return {node.replace_extension(".node").string(), element.replace_extension(".ele").string()};
}

} // namespace internal

/*!
  reads a tetrahedral mesh from the pair of files `name.node` and `name.ele` of TetGen.

  Points are numbered from 0 or 1, which the first point tells. Attributes, markers, comments and the inner nodes of tetrahedra
  of second order are ignored; the mesh has no triangles. The cost is linear in the size of the files.

  \param path name of one of the files; its extension is replaced to get both names
  \param mesh receives the mesh; it is not changed if a file cannot be read
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `false` if one of the files cannot be opened or ends too early, or has a coordinate that is not a finite number or an
           index that is out of range
*/
inline bool read_Tetgen_files(const std::string& path, Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  const auto [node_path, element_path] = internal::tetgen_file_names(path);
  Tetrahedral_mesh result;
  long long first = 0;
  std::string text;
  if(!internal::read_whole_file(node_path, text, message))
    return false;
  internal::Word_reader nodes(text);
  if(!internal::read_tetgen_points(nodes, result.points, first))
    return internal::fail(message, "cannot read " + node_path + ": " + nodes.error());
  if(!internal::read_whole_file(element_path, text, message))
    return false;
  internal::Word_reader elements(text);
  if(!internal::read_tetgen_elements(elements, result.points.size(), first, result.tetrahedra))
    return internal::fail(message, "cannot read " + element_path + ": " + elements.error());
  mesh = std::move(result);
  return internal::succeed(message);
}

/*!
  writes a tetrahedral mesh as the pair of files `name.node` and `name.ele` of TetGen, numbered from 0. Triangles are not
  written. Numbers have as many digits (up to 17) as it takes to read back exactly the same doubles.

  \param path name of one of the files; its extension is replaced to get both names, and existing files are replaced
  \param mesh the mesh; its coordinates must be finite and its indices valid
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `true` if both files were written. An invalid mesh is refused before a file is touched.
*/
inline bool write_Tetgen_files(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  const std::string error = internal::tetrahedral_mesh_error(mesh);
  if(!error.empty())
    return internal::fail(message, "cannot write " + path + ": " + error);

  std::string nodes = std::to_string(mesh.points.size()) + " 3 0 0\n";
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    internal::append_number(nodes, static_cast<long long>(i));
    nodes += ' ';
    internal::append_coordinates(nodes, mesh.points[i]);
    nodes += '\n';
  }
  std::string elements = std::to_string(mesh.tetrahedra.size()) + " 4 0\n";
  for(std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    internal::append_number(elements, static_cast<long long>(i));
    elements += ' ';
    internal::append_numbers(elements, mesh.tetrahedra[i]);
    elements += '\n';
  }
  const auto [node_path, element_path] = internal::tetgen_file_names(path);
  return internal::write_whole_file(node_path, nodes, message) && internal::write_whole_file(element_path, elements, message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_TETGEN_FILES_H
