// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A solid in a file, with all that the file says of it.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILE_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILE_H

#include "Data_array.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace program {

// Kinds of cells by their numbers in VTK; the order of nodes is VTK's, too.
namespace cell_type {
constexpr int VERTEX = 1, POLY_VERTEX = 2, LINE = 3, POLY_LINE = 4, TRIANGLE = 5, STRIP = 6, POLYGON = 7, PIXEL = 8, QUAD = 9,
              TETRAHEDRON = 10, QUADRATIC_LINE = 21, QUADRATIC_TRIANGLE = 22, QUADRATIC_QUAD = 23, QUADRATIC_TETRAHEDRON = 24,
              BIQUADRATIC_QUAD = 28;
} // namespace cell_type

// The edges of a tetrahedron in whose middles the nodes 4 to 9 of one of second order lie.
constexpr std::array<std::array<int, 2>, 6> TETRAHEDRON_EDGES{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

// Cells of any kinds, one after the other.
struct Cells
{
  std::vector<std::uint8_t> types;
  std::vector<std::size_t> ends; // of each cell's nodes
  std::vector<int> nodes;

  std::size_t size() const { return types.size(); }
  std::size_t begin(std::size_t cell) const { return cell == 0 ? 0 : ends[cell - 1]; }

  template <typename Nodes>
  void add(int type, const Nodes& cell)
  {
    types.push_back(static_cast<std::uint8_t>(type));
    nodes.insert(nodes.end(), cell.begin(), cell.end());
    ends.push_back(nodes.size());
  }
};

// Points or cells of one number, with a name.
struct Named_group
{
  int dimension = 3; // of its cells
  std::int64_t number = 0;
  std::string name;
};

// How a file lays out its numbers.
enum class Volume_encoding
{
  ascii,
  binary,
  base64,
  compressed
};

// Arrays in which regions of cells and references of points are kept, whatever the format calls them.
constexpr const char* REGION = "region";
constexpr const char* REFERENCE = "reference";

struct Volume_file
{
  std::vector<std::array<double, 3>> points;
  Cells cells;
  std::map<std::string, std::size_t> foreign_cells; // how many solid elements there are of each kind that is not mapped
  std::vector<Data_array> point_data, cell_data, field_data;
  std::vector<Named_group> groups;

  // To write the file back with other points: its text, and where it has their coordinates, unless the format is written anew.
  std::string path, text, element_text; // TetGen has a second file
  std::vector<std::size_t> coordinate_places;
  bool has_binary_coordinates = false, has_big_endian = false;
  Volume_encoding encoding = Volume_encoding::ascii;
};

// The tetrahedra of a file.
struct Solid
{
  CGAL::Flip_free_maps::Tetrahedral_mesh mesh; // with all points
  std::vector<std::size_t> cells;              // the number of each tetrahedron's cell
  bool has_second_order = false;
};

// How many nodes a cell of the type has; 0 if any number will do.
std::size_t number_of_nodes(int type);

// Returns the empty string, or which cell has a wrong node or a wrong number of them.
std::string cells_error(const Volume_file& file);

// Returns the empty string, or the kinds and numbers of elements that are not mapped. Tetrahedra of second order are taken by their
// corners if asked for.
std::string take_solid(const Volume_file& file, bool with_second_order, Solid& solid);

// Puts the nodes in the middles of edges of second order tetrahedra there.
void center_mid_nodes(const Cells& cells, std::vector<std::array<double, 3>>& points);

// A file of a mesh that comes from elsewhere.
Volume_file make_volume_file(const CGAL::Flip_free_maps::Tetrahedral_mesh& mesh);

// The array of the cells that tells their regions, or null: the one named so here, or as other programs do.
const Data_array* find_regions(const Volume_file& file);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILE_H
