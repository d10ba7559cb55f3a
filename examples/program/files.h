// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces from files, checked so that every fault has a name of its own.

#ifndef FLIP_FREE_MAPS_PROGRAM_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_FILES_H

#include "types.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

struct Triangles
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh mesh; // vertex i is point i
};

// Reads polygons of whatever kind from an OFF, OBJ, PLY or STL file.
void read_soup(const std::string& path, std::vector<Kernel::Point_3>& points, std::vector<std::vector<std::size_t>>& polygons);

// Reads and checks a file, so that every fault has a name of its own before the mesh is built.
void read_triangles(const std::string& path, Triangles& triangles);

// The same for any number of components. With `repair`, first removes what makes a mesh unfit: duplicated points and faces, faces
// without area, sheets that meet at a vertex or an edge, different orientations, polygons of more than three corners;
// `repairs` says what it did.
void read_surface(const std::string& path, bool repair, Triangles& triangles, std::string& repairs);

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// A connected surface with a border, and a map of it.
struct Patch
{
  Triangles triangles;
  Mesh::Halfedge_index border; // on the longest border
  UV_map uv;
};

void read_patch(const std::string& path, Patch& patch);

// The texture coordinates of an OBJ with the same faces, one pair for each vertex.
std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Triangles& triangles);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FILES_H
