// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Solids of files, and what a map does to them as arrays for viewers.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMANDS_SOLID_FIELDS_H
#define FLIP_FREE_MAPS_PROGRAM_COMMANDS_SOLID_FIELDS_H

#include "../types.h"

#include "../formats/Volume_file.h"
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace program {

// A solid and its file; one that is made here has a file without a name.
struct Solid_input
{
  Volume_file file;
  Solid solid;
};

// Fails if the file cannot be read or has elements that are not mapped.
Solid_input read_solid(const std::string& path, bool with_second_order);

// The energy of each tetrahedron by its signed singular values in a map.
double distortion_of(const Eigen::Vector3d& singular_values);

// The signed singular values of each tetrahedron of the user's mesh, descending: those of a map may come from another mesh with the
// same numbers.
std::vector<Eigen::Vector3d> singular_values_of(const FFM::Simplicial_domain<3>& domain, const FFM::Tetrahedral_domain& numbers,
                                                const std::vector<Kernel::Point_3>& points);

// Adds to the arrays of `file`, whose points are still those before the map: at the points `displacement`, `handle` and `boundary`
// (1 or 0), in the cells `symmetric_dirichlet_energy`, `volume_ratio` and `singular_values`. Triangles have the values of the first
// tetrahedron that they bound, and other cells 0.
void add_solid_fields(const Solid& solid, const std::vector<Eigen::Vector3d>& singular_values,
                      const std::vector<std::array<double, 3>>& points, const std::vector<std::size_t>& handles, Volume_file& file);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMANDS_SOLID_FIELDS_H
