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

#include <CGAL/Flip_free_maps/report/Outcome.h>

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

// Reads a surface that is to be mapped in one piece. Points at the same place are one if it has several pieces otherwise, which are
// refused; if it `is_strict`, everything but a clean mesh of triangles is.
void read_piece(const std::string& path, bool is_strict, Surface& surface);

// Whether each side of a polygon is that of another one, too, in the other direction.
bool is_closed(const Surface& surface);

// Says what of a surface is not manifold by the numbers of the file, if that is what a function has failed for.
void explain_failure(const Surface& surface, bool is_strict, FFM::Outcome& summary);

// The texture coordinates of a file with the same faces, one pair for each vertex.
std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Surface& surface);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FILES_H
