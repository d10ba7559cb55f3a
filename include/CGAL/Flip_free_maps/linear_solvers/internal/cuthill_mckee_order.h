// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_H

#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The vertices in reverse Cuthill-McKee order (George and Liu 1981, chapter 4): breadth first from a vertex far out, and then all
// backwards. Neighbours get near numbers, and hardly any vertex is eliminated before all of its neighbours, which suits
// factorizations without fill (Duff and Meurant 1989). Vertices that are found together come in scattered order, not by their degree:
// on regular meshes they would go on in one direction all over the mesh, and a factorization without fill is worse across it.
std::vector<std::int32_t> cuthill_mckee_order(const Block_graph& graph);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/cuthill_mckee_order_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_CUTHILL_MCKEE_ORDER_H
