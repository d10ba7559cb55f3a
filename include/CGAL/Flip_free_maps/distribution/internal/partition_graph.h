// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A graph in slices: each rank has consecutive vertices, the ranks follow each other.
struct Graph_slice
{
  std::vector<std::int64_t> begin;     // of each vertex' neighbours, with the end
  std::vector<std::int64_t> neighbors; // by their numbers in the whole graph, ascending
  std::vector<std::int32_t> weights;   // of the vertices
};

// The rank that each vertex of the slice goes to, by PT-Scotch where PETSc has it: parts of equal weight with few edges between them.
// The first rank divides the whole graph, which is small beside the matrices of the parts: PT-Scotch on several ranks takes messages as
// they come, and may find other parts each time. `false` on all ranks if it fails. Called by all ranks.
bool partition_graph(const Graph_slice& graph, const Mpi_world& world, std::vector<std::int32_t>& parts);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/internal/partition_graph_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_H
