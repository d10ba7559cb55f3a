// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A reader for each format: each returns the empty string, or the reason of a failure. They need not check that vertices exist.
// Where no texture coordinates are asked for, or none are there, `images` may stay empty.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_READERS_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_READERS_H

#include "Polygon_file.h"

#include <string>
#include <string_view>

namespace program {

std::string read_OFF(std::string_view text, bool with_images, Polygon_file& file);
std::string read_OBJ(std::string_view text, bool with_images, Polygon_file& file);
std::string read_PLY(std::string_view text, bool with_images, Polygon_file& file);
std::string read_STL(std::string_view text, bool with_images, Polygon_file& file);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_READERS_H
