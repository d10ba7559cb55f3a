// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_H
#define CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_H

#include <CGAL/Flip_free_maps/atlas/internal/Packing_obstacles.h>
#include <CGAL/Flip_free_maps/core/unwrap_polygons.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether what is pinned has images and can be packed around.
Status check_pinned_polygons(const Atlas_request& request, const Unwrap_options& options, std::string& message);

Packing_obstacles pinned_obstacles(const Atlas_request& request);

// Writes their images, and which of their sides are seams: those across which no other one has the same images.
void keep_pinned_polygons(const Atlas_request& request, Atlas_result& result);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/pinned_polygons_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_H
