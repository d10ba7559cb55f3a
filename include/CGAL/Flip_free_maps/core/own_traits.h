// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_OWN_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_CORE_OWN_TRAITS_H

#include <CGAL/Flip_free_maps/core/unwrap_polygons.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Planar_request.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What the doors call with traits of the caller's own. They are declared beside what is compiled already: traits that derive from
// those of the library must not be taken for them. The definitions come with the headers of the doors' methods.
template <typename Traits>
void solve_planar(const Planar_request& request, Traits& traits, Positions<2>& x, Summary& summary);
template <typename Traits>
bool certify_planar(const Planar_request& request, const Traits& traits, const Positions<2>& written, Summary& summary);
template <typename Traits>
void solve_bijectively(const Planar_request& request, Traits& traits, Positions<2>& x, Summary& summary);
template <typename Traits>
bool certify_injective(const Planar_request& request, const Traits& traits, const Positions<2>& written, Summary& summary);
template <typename Traits>
void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options, Traits& traits, Atlas_result& result,
                     Unwrap_summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_OWN_TRAITS_H
