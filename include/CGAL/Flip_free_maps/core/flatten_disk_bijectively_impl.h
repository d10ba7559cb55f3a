// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_IMPL_H

#include <CGAL/Flip_free_maps/core/flatten_disk_bijectively.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Bijective_minimizer.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION void solve_bijectively(const Planar_request& request, Default_method& method, Positions<2>& x,
                                                           Summary& summary)
{
  Flip_free_map_traits<> traits;
  traits.options = method.options;
  traits.start = method.start;
  solve_bijectively(request, traits, x, summary);
}

CGAL_FLIP_FREE_MAPS_CORE_DEFINITION bool certify_injective(const Planar_request& request, const Default_method&,
                                                           const Positions<2>& written, Summary& summary)
{
  return certify_injective(request, Flip_free_map_traits<>(), written, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_BIJECTIVELY_IMPL_H
