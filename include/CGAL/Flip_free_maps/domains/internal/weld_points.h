// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Replaces the numbers of points by that of the first at the same place; points whose entry is negative are left out. Both zeros
// are the same.
void weld_points(const Positions<3>& points, std::vector<std::int32_t>& first);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/weld_points_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WELD_POINTS_H
