// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// glTF files with other texture coordinates.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_DOCUMENT_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_DOCUMENT_H

#include "../../files.h"

#include <cstddef>
#include <string>

namespace program {

struct Gltf_request
{
  std::string input, text; // a file that read_gltf() has read
  std::string output;      // the name of the result
  std::size_t uv_set = 0;
  bool checker = false; // for all triangles; otherwise for those without a material
};

// The text with these texture coordinates (s, t), each of which is a float, in single precision. Vertices are doubled where their
// corners have several; all other data of a corner stay, bit for bit. Triangles without images are left alone. Tangents that belong to
// what is replaced are dropped, and the note says so.
std::string with_gltf_images(const Gltf_request& request, const Corner_images& images, std::string& note);

// The text of a new binary file of triangles, with a mesh for each object, in the order of the polygons.
std::string gltf_text(const Surface& triangles);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_DOCUMENT_H
