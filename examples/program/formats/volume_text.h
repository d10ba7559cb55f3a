// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_TEXT_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_TEXT_H

#include <array>
#include <string>
#include <vector>

namespace program {

// The text of a Medit file, which read_Medit() has read, with other points: references and all other sections stay byte for byte.
std::string Medit_with_points(const std::string& text, const std::vector<std::array<double, 3>>& points);

// The text of a file `.node`, which read_Tetgen_files() has read, with other points: attributes and markers stay.
std::string Tetgen_with_points(const std::string& text, const std::vector<std::array<double, 3>>& points);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_TEXT_H
