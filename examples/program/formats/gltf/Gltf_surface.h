// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces from glTF files.
//
// Texture coordinates (s, t) of glTF have their origin at the upper left. As images they are (t, s): a positive triangle is one that is
// seen from outside, as everywhere in the program, and not a bit is rounded.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_SURFACE_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_SURFACE_H

#include "../../files.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// Reads all triangles, each mesh as an object, and once however many nodes use it. Within a mesh, corners at the same place are one
// point. Meshes have the size and shape in which their first node shows them, but not its place. Images are those of `surface.uv_set`.
void read_gltf(const std::string& path, const std::string& text, bool with_images, Surface& surface);

// The triangles where they are in the scene, those of a mesh for each of its nodes, with the images that they have in the meshes.
Surface gltf_scene(const Surface& surface, const Corner_images& images);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_SURFACE_H
