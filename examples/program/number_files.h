// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files with numbers in lines: seams, fixed vertices, soft positions. A number sign begins a comment, and vertices have the numbers
// that they have in the file of the mesh, from 0.

#ifndef FLIP_FREE_MAPS_PROGRAM_NUMBER_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_NUMBER_FILES_H

#include "Atlas.h"
#include "files.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace program {

struct Number_row
{
  std::string where; // for messages: the file and the line
  std::vector<double> numbers;
};

// The lines that are neither empty nor comments.
std::vector<Number_row> read_number_rows(const std::string& path, std::size_t per_row);

// The vertex that the number `k` of a row names.
std::size_t vertex_of(const Number_row& row, std::size_t k, std::size_t number_of_vertices);

// Reads the numbers of faces; all faces of their islands are pinned.
std::vector<char> read_pinned_faces(const std::string& path, const Surface& surface, const Atlas& atlas);

using Vertex_pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// The edges in a file with two vertices per line.
Vertex_pairs read_seams(const std::string& path, const Surface& surface);

// The edges to which two polygons give different images.
Vertex_pairs seams_of_images(const Surface& surface);

// The same edges after a repair, which renumbers vertices and doubles some, but moves none.
Vertex_pairs repaired_seams(const Vertex_pairs& seams, const std::vector<Kernel::Point_3>& points, const Surface& repaired);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_NUMBER_FILES_H
