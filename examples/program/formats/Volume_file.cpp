// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Volume_file.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

// Solid cells of VTK that are no tetrahedra, with the numbers of their nodes; 0 for any number.
struct Solid_kind
{
  int type;
  const char* name;
  int number_of_nodes;
};

constexpr Solid_kind SOLID_KINDS[] = {{11, "voxels", 8},
                                      {12, "hexahedra", 8},
                                      {13, "wedges", 6},
                                      {14, "pyramids", 5},
                                      {15, "pentagonal prisms", 10},
                                      {16, "hexagonal prisms", 12},
                                      {25, "hexahedra of second order", 20},
                                      {26, "wedges of second order", 15},
                                      {27, "pyramids of second order", 13},
                                      {29, "hexahedra of second order", 27},
                                      {32, "wedges of second order", 18},
                                      {41, "convex point sets", 0},
                                      {42, "polyhedra", 0},
                                      {71, "Lagrange tetrahedra", 0},
                                      {72, "Lagrange hexahedra", 0},
                                      {73, "Lagrange wedges", 0},
                                      {78, "Bezier tetrahedra", 0},
                                      {79, "Bezier hexahedra", 0}};

// The name of a kind of cell that is neither a tetrahedron nor flat; empty for those.
std::string foreign_kind(int type)
{
  for(const Solid_kind& kind : SOLID_KINDS)
    if(kind.type == type)
      return std::string(kind.name) +
             (kind.number_of_nodes > 0 ? " (" + std::to_string(kind.number_of_nodes) + " nodes each)" : std::string());
  const bool is_known = (type >= cell_type::VERTEX && type <= cell_type::TETRAHEDRON) ||
                        (type >= cell_type::QUADRATIC_LINE && type <= cell_type::QUADRATIC_TETRAHEDRON) ||
                        type == cell_type::BIQUADRATIC_QUAD;
  return is_known ? "" : "cells of VTK's type " + std::to_string(type);
}

} // namespace

std::size_t number_of_nodes(int type)
{
  switch(type) {
  case cell_type::VERTEX:
    return 1;
  case cell_type::LINE:
    return 2;
  case cell_type::TRIANGLE:
  case cell_type::QUADRATIC_LINE:
    return 3;
  case cell_type::PIXEL:
  case cell_type::QUAD:
  case cell_type::TETRAHEDRON:
    return 4;
  case cell_type::QUADRATIC_TRIANGLE:
    return 6;
  case cell_type::QUADRATIC_QUAD:
    return 8;
  case cell_type::BIQUADRATIC_QUAD:
    return 9;
  case cell_type::QUADRATIC_TETRAHEDRON:
    return 10;
  default:
    return 0;
  }
}

std::string cells_error(const Volume_file& file)
{
  for(std::size_t i = 0; i < file.cells.size(); ++i) {
    const std::size_t begin = file.cells.begin(i), end = file.cells.ends[i], wanted = number_of_nodes(file.cells.types[i]);
    if(wanted > 0 && end - begin != wanted)
      return "cell " + std::to_string(i) + " (from 0) has " + std::to_string(end - begin) + " corners, not " + std::to_string(wanted);
    for(std::size_t k = begin; k < end; ++k)
      if(file.cells.nodes[k] < 0 || static_cast<std::size_t>(file.cells.nodes[k]) >= file.points.size())
        return "cell " + std::to_string(i) + " (from 0) has the point " + std::to_string(file.cells.nodes[k]) +
               " (from 0), but there are " + std::to_string(file.points.size());
  }
  return "";
}

std::string take_solid(const Volume_file& file, bool with_second_order, Solid& solid)
{
  std::map<std::string, std::size_t> foreign = file.foreign_cells;
  std::size_t number_of_second_order = 0;
  for(const int type : file.cells.types) {
    const std::string kind = foreign_kind(type);
    if(!kind.empty())
      ++foreign[kind];
    number_of_second_order += type == cell_type::QUADRATIC_TETRAHEDRON;
  }
  if(!foreign.empty()) {
    std::string list;
    for(const auto& [kind, number] : foreign)
      list += (list.empty() ? "" : ", ") + std::to_string(number) + " " + kind;
    return "the file has elements other than tetrahedra, which are not supported: " + list;
  }
  if(number_of_second_order > 0 && !with_second_order)
    return "the file has " + std::to_string(number_of_second_order) +
           " tetrahedra of second order (10 nodes each); --second-order maps them by their corners";

  solid = Solid();
  solid.mesh.points = file.points;
  solid.has_second_order = number_of_second_order > 0;
  for(std::size_t i = 0; i < file.cells.size(); ++i) {
    const int type = file.cells.types[i], *nodes = file.cells.nodes.data() + file.cells.begin(i);
    if(type == cell_type::TRIANGLE)
      solid.mesh.triangles.push_back({nodes[0], nodes[1], nodes[2]});
    if(type != cell_type::TETRAHEDRON && type != cell_type::QUADRATIC_TETRAHEDRON)
      continue;
    solid.mesh.tetrahedra.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
    solid.cells.push_back(i);
  }
  return "";
}

void center_mid_nodes(const Cells& cells, std::vector<std::array<double, 3>>& points)
{
  for(std::size_t i = 0; i < cells.size(); ++i)
    if(cells.types[i] == cell_type::QUADRATIC_TETRAHEDRON) {
      const int* nodes = cells.nodes.data() + cells.begin(i);
      for(std::size_t k = 0; k < TETRAHEDRON_EDGES.size(); ++k)
        for(int c = 0; c < 3; ++c)
          points[nodes[4 + k]][c] = points[nodes[TETRAHEDRON_EDGES[k][0]]][c] / 2 + points[nodes[TETRAHEDRON_EDGES[k][1]]][c] / 2;
    }
}

Volume_file make_volume_file(const CGAL::Flip_free_maps::Tetrahedral_mesh& mesh)
{
  Volume_file file;
  file.points = mesh.points;
  for(const auto& triangle : mesh.triangles)
    file.cells.add(cell_type::TRIANGLE, triangle);
  for(const auto& tetrahedron : mesh.tetrahedra)
    file.cells.add(cell_type::TETRAHEDRON, tetrahedron);
  return file;
}

const Data_array* find_regions(const Volume_file& file)
{
  for(const char* name : {REGION, "medit:ref", "gmsh:physical", "tetgen:ref", "material", "MaterialIds", "CellEntityIds"}) {
    const Data_array* array = find_array(file.cell_data, name);
    if(array != nullptr && array->number_of_components == 1 && !is_real(array->type))
      return array;
  }
  return nullptr;
}

} // namespace program
