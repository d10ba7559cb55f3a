// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <complex>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Lays triangle after triangle in the plane, each next to one that lies there already, the nearest ones to the first triangle
// first. On a developable surface that is the isometry; on others edges that were not crossed are torn,
// which the places of their vertices hide.
void unfold_developable(const Simplicial_domain<2>& domain, Positions<2>& x);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/unfold_developable_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_H
