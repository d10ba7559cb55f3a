// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_H
#define CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_H

#include <CGAL/Flip_free_maps/core/flatten_disk.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The same as `solve_planar()`, but the map is to be injective as a whole where the request says so.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void solve_bijectively(const Planar_request& request, Default_method& method, Positions<2>& x,
                                                            Summary& summary);

// Whether a map is injective, where the request says so, as it will be written.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION bool certify_injective(const Planar_request& request, const Default_method& method,
                                                            const Positions<2>& written, Summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_H
