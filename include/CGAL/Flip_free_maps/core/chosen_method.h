// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_METHOD_H
#define CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_METHOD_H

#include <CGAL/Flip_free_maps/core/own_traits.h>
#include <CGAL/Flip_free_maps/core/unwrap_polygons.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Planar_request.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What the doors call with a method that was chosen at run time, compiled once.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void solve_planar(const Planar_request& request, Any_map_traits& method, Positions<2>& x,
                                                       Summary& summary);
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION bool certify_planar(const Planar_request& request, const Any_map_traits& method,
                                                         const Positions<2>& written, Summary& summary);
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void solve_bijectively(const Planar_request& request, Any_map_traits& method, Positions<2>& x,
                                                            Summary& summary);
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION bool certify_injective(const Planar_request& request, const Any_map_traits& method,
                                                            const Positions<2>& written, Summary& summary);
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options,
                                                          Any_map_traits& method, Atlas_result& result, Unwrap_summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_METHOD_H
