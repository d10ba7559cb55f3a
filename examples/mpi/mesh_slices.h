// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The part of a file that one rank reads, and writes.

#ifndef FLIP_FREE_MAPS_MPI_MESH_SLICES_H
#define FLIP_FREE_MAPS_MPI_MESH_SLICES_H

#include <mpi.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

// What is wrong with a file, as a sentence.
struct File_failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

using Place = std::array<double, 3>;

// Consecutive points and tetrahedra of a mesh.
struct Solid_slice
{
  std::vector<Place> points;
  std::vector<std::array<std::int64_t, 4>> tetrahedra;
};

// Reads a slice of a Medit file in ASCII (dimension 3), in which each point and each tetrahedron has a line of its own: of n slices the
// one with number `rank`. The whole file is looked through, and nothing of the other slices is kept.
Solid_slice read_solid_slice(const std::string& path, int rank, int size);

// Consecutive points and triangles of a mesh.
struct Surface_slice
{
  std::vector<Place> points;
  std::vector<std::array<std::int64_t, 3>> triangles;
};

// The same of an OFF file in ASCII.
Surface_slice read_surface_slice(const std::string& path, int rank, int size);

// The handles of a file with a line `vertex x y z` for each, vertices numbered from 0. A number sign begins a comment.
std::vector<std::pair<std::int64_t, Place>> read_vertex_handles(const std::string& path);

// The first rank writes the slices of all, one after the other. Called by all ranks.
void write_solid_slices(const std::string& path, const Solid_slice& slice, MPI_Comm comm);

// The same for an OBJ file with a slice of texture coordinates, one for each point.
void write_surface_slices(const std::string& path, const Surface_slice& slice, const std::vector<std::array<double, 2>>& uv, MPI_Comm comm);

} // namespace program

#endif // FLIP_FREE_MAPS_MPI_MESH_SLICES_H
