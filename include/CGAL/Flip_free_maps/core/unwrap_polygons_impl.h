// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_IMPL_H

#include <CGAL/Flip_free_maps/core/unwrap_polygons_by_traits.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options,
                                                         Default_method& method, Atlas_result& result, Unwrap_summary& summary)
{
  Flip_free_map_traits<> traits;
  traits.options = method.options;
  traits.start = method.start;
  unwrap_polygons(request, options, traits, result, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_IMPL_H
