// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces from files, checked so that every fault has a name of its own.

#ifndef FLIP_FREE_MAPS_PROGRAM_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_FILES_H

#include "formats/Polygon_file.h"
#include "types.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// Polygons of whatever kind, and the text of their file, into which results are written back.
struct Surface
{
  std::string path, text; // no text if the polygons are not those of the file any more
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Corner_images images;             // as many as polygons if they were asked for
  std::vector<std::size_t> objects; // of each polygon; none if all are one
  std::vector<std::string> object_names;
  std::size_t uv_set = 0;         // which texture coordinates of a glTF file the images are
  bool are_objects_apart = false; // whether they are meshes of their own, which touch nowhere
  bool is_transposed = false;     // whether images are (t, s) instead of (s, 1 - t), see formats/gltf/Gltf_surface.h
};

bool is_gltf(const std::string& path);

// Reads an OFF, OBJ, PLY, STL, glTF or GLB file that has faces.
void read_surface(const std::string& path, bool with_images, Surface& surface);

// Checks triangles, so that every fault has a name of its own, and makes a mesh of them whose vertex i is point i.
void make_mesh(const Surface& surface, Mesh& mesh);

struct Triangles : Surface
{
  Mesh mesh;
};

// Both for a connected surface.
void read_triangles(const std::string& path, Triangles& triangles);

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// A connected surface with a border, and a map of it.
struct Patch
{
  Triangles triangles;
  Mesh::Halfedge_index border; // on the longest border
  UV_map uv;
};

void read_patch(const std::string& path, Patch& patch);

// The texture coordinates of a file with the same faces, one pair for each vertex.
std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Triangles& triangles);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FILES_H
