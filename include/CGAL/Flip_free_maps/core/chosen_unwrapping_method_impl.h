// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_UNWRAPPING_METHOD_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_UNWRAPPING_METHOD_IMPL_H

#include <CGAL/Flip_free_maps/core/chosen_method.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/core/unwrap_polygons_by_traits.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options,
                                                         Any_map_traits& method, Atlas_result& result, Unwrap_summary& summary)
{
  unwrap_polygons<Any_map_traits>(request, options, method, result, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_UNWRAPPING_METHOD_IMPL_H
