// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_NODES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_NODES_H

#include "Gltf_container.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// A node that shows a mesh.
struct Gltf_instance
{
  std::size_t mesh;
  std::string name;
  Eigen::Affine3d placement; // in the scene; the identity if bones move the mesh
};

// In the order of the nodes; meshes that no node shows come last, as they are.
std::vector<Gltf_instance> gltf_instances(const Json& document);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_NODES_H
