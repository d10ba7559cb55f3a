// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The triangles of a glTF file.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_MESHES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_MESHES_H

#include "Gltf_accessor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace program {

// The vertices of all primitives that have the same attributes, in one mesh or in several.
struct Gltf_vertices
{
  Json attributes, targets; // accessors by semantics; targets of morphing
  std::string who;          // the first primitive, for messages
  std::size_t count = 0;
};

// The triangles of a primitive.
struct Gltf_primitive
{
  std::size_t mesh, number;           // in its mesh
  std::size_t vertices;               // which
  std::vector<std::uint32_t> corners; // three for each triangle
  std::string who;
};

struct Gltf_meshes
{
  std::vector<Gltf_vertices> vertices;
  std::vector<Gltf_primitive> primitives; // all that consist of triangles, in the order of the file
};

// Checks all accessors of these primitives.
Gltf_meshes read_meshes(Gltf_container& container);

// The name of the set of texture coordinates that has a number, as "TEXCOORD_0".
std::string texture_semantics(std::size_t uv_set);

// The texture coordinates of a set for each vertex; none if the set does not exist.
std::vector<std::array<double, 2>> texture_coordinates(Gltf_container& container, const Gltf_vertices& vertices, std::size_t uv_set);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_MESHES_H
