// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What surrounds snippets of the manual that are no programs: the includes, and the names that the text before them speaks of.

#ifndef FLIP_FREE_MAPS_TEST_DOC_FRAGMENTS_H
#define FLIP_FREE_MAPS_TEST_DOC_FRAGMENTS_H

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace FFM = CGAL::Flip_free_maps;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Uv_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;
using Point_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;

#define SNIPPET(name)                                                                                                                      \
  void name([[maybe_unused]] Mesh& mesh, [[maybe_unused]] Mesh::Halfedge_index border_halfedge, [[maybe_unused]] Uv_map uv,                \
            [[maybe_unused]] Point_map points, [[maybe_unused]] const FFM::Flip_free_map_traits<>& traits,                                 \
            [[maybe_unused]] const FFM::Repair_options& options)

#endif // FLIP_FREE_MAPS_TEST_DOC_FRAGMENTS_H
