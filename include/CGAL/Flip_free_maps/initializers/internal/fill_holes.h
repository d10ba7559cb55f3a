// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <CGAL/number_type_basic.h>

#include <Eigen/LU>

#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Lengths of all holes' borders, in rest shapes.
std::vector<double> perimeters_of_holes(const Simplicial_domain<2>& domain);

// The disk that a surface with holes becomes when they are closed, with what embeddings of disks need: elements, rest shapes and
// the border. A hole of n edges is filled as if it were a regular polygon of its perimeter, by rings of half as many edges each
// and a fan in the middle: a mere fan would leave so few edges across a large hole that it shrinks to a point. The new vertices
// follow those of the surface. Holes of two edges need no triangles: the edges have the same ends, so their images are one.
Simplicial_domain<2> fill_holes(const Simplicial_domain<2>& domain);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/fill_holes_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_H
