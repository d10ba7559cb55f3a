// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_H
#define CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/core/configuration.h>
#include <CGAL/Flip_free_maps/core/flatten_disk.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A surface that is to be unwrapped, as flat arrays.
struct Atlas_request
{
  Positions<3> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  // Edges, each by a triangle and the corner that it leads to, that are seams of the caller's, and that seams are to follow.
  std::vector<std::pair<std::int32_t, int>> seams;
  std::vector<std::pair<std::int32_t, int>> features;
  // Whether the numbers that receive the atlas have single precision; the atlas is certified in them.
  bool is_single_precision = false;
};

// The atlas: of each triangle the chart, the images of its corners, and which of its edges (to corner k) are seams.
struct Atlas_result
{
  std::vector<std::int32_t> charts;
  std::vector<std::array<std::array<double, 2>, 3>> images;
  std::vector<std::array<bool, 3>> seams;
};

// Unwraps. The result is set if the summary is valid.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void unwrap_triangles(const Atlas_request& request, const Unwrap_options& options,
                                                           Default_method& method, Atlas_result& result, Unwrap_summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_H
