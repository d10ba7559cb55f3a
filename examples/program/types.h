// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What all files of the program share.

#ifndef FLIP_FREE_MAPS_PROGRAM_TYPES_H
#define FLIP_FREE_MAPS_PROGRAM_TYPES_H

#include "Failure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace program {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_TYPES_H
