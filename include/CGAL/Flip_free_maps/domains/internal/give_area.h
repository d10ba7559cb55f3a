// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Of longest edges: the height up to which a triangle has no area. For atlases, which divide by heights and square them; and for single
// patches, where it is what `planar_rest_shape()` can tell from none.
constexpr double LEAST_HEIGHT = 1e-13, LEAST_HEIGHT_IN_PATCH = 4 * std::numeric_limits<double>::epsilon();

// Why triangles cannot be given an area.
constexpr const char* NO_PLACES_FOR_AREA = "some faces have no area, and are at places that cannot be told apart in double precision";

// Whether a triangle has an area: whether its height is more than `least_height`, and more than what rounding may have made of none.
// Coordinates with sixteen digits are off by some epsilon of their size, and so is the height of a triangle that was meant to have
// none, whatever area its coordinates say.
bool has_area(const Positions<3>& points, const std::array<std::int32_t, 3>& triangle, double least_height = LEAST_HEIGHT);

// Moves vertices of triangles without area a little, so that they become thin ones, which fit to their neighbours: out of the surface,
// where lengths change by the square of the distance. All other points stay. False if points are too near to each other for that.
bool give_area(const std::vector<std::array<std::int32_t, 3>>& triangles, Positions<3>& points, double least_height = LEAST_HEIGHT);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/give_area_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_GIVE_AREA_H
