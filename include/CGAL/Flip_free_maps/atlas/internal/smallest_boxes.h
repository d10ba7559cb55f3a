// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The direction of a side of the smallest rectangle around some points, and of the smallest square; (1, 0) if they are on a line.
Vector<2> direction_of_smallest_box(const Positions<2>& x);
Vector<2> direction_of_smallest_square(const Positions<2>& x);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/smallest_boxes_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_SMALLEST_BOXES_H
