// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces in files, as plain arrays. CGAL 5.5's readers are not used: that of PLY crashes on coordinates of integer types, those of
// OFF on files that end early, and all of them allocate whatever a header claims.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_FILE_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_FILE_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace program {

using Image = std::array<double, 2>;
// The images of the corners of each polygon, in the order of its indices; none for a polygon without texture coordinates.
using Corner_images = std::vector<std::vector<Image>>;

// Polygons of any number of corners.
struct Polygon_file
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> polygons; // indices into `points`, all valid
  Corner_images images;                           // as many as polygons if they were asked for; finite
};

// The extension of a name in small letters, with its dot.
std::string small_extension(const std::string& path);

// Reads OFF, OBJ, PLY or STL, as the extension says. Returns the empty string, or the reason of a failure, with a line of the file
// where there is one; `file` and `text` are unchanged then. Coordinates are finite except in PLY. Corners of STL at the same place are
// one point. Texture coordinates are only looked at if they are asked for. `text` receives the content of the file.
std::string read_polygon_file(const std::string& path, Polygon_file& file, bool with_images = false, std::string* text = nullptr);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_FILE_H
