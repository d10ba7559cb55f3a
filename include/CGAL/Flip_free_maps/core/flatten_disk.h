// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_H
#define CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_H

#include <CGAL/Flip_free_maps/core/configuration.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/Start_options.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Planar_request.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The default method with its settings, for those who bring no traits.
struct Default_method
{
  Map_options options;
  Start_options start;
};

// Flattens a disk.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void solve_planar(const Planar_request& request, Default_method& method, Positions<2>& x,
                                                       Summary& summary);

// Certifies a map as it will be written, and counts its flips.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION bool certify_planar(const Planar_request& request, const Default_method& method,
                                                         const Positions<2>& written, Summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_FLATTEN_DISK_H
