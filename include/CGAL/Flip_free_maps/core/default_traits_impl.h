// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_TRAITS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_TRAITS_IMPL_H

#include <CGAL/Flip_free_maps/core/default_traits.h>
#include <CGAL/Flip_free_maps/core/unwrap_polygons_by_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Bijective_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void solve_planar(const Planar_request& request, Flip_free_map_traits<>& method, Positions<2>& x,
                                                      Summary& summary)
{
  solve_planar<Flip_free_map_traits<>>(request, method, x, summary);
}

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION bool certify_planar(const Planar_request& request, const Flip_free_map_traits<>& method,
                                                        const Positions<2>& written, Summary& summary)
{
  return certify_planar<Flip_free_map_traits<>>(request, method, written, summary);
}

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void solve_bijectively(const Planar_request& request, Flip_free_map_traits<>& method, Positions<2>& x,
                                                           Summary& summary)
{
  solve_bijectively<Flip_free_map_traits<>>(request, method, x, summary);
}

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION bool certify_injective(const Planar_request& request, const Flip_free_map_traits<>& method,
                                                           const Positions<2>& written, Summary& summary)
{
  return certify_injective<Flip_free_map_traits<>>(request, method, written, summary);
}

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options,
                                                         Flip_free_map_traits<>& method, Atlas_result& result, Unwrap_summary& summary)
{
  unwrap_polygons<Flip_free_map_traits<>>(request, options, method, result, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_TRAITS_IMPL_H
