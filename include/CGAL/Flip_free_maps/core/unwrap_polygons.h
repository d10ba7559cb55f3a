// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_H
#define CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/core/configuration.h>
#include <CGAL/Flip_free_maps/core/flatten_disk.h>
#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A surface that is to be unwrapped, as flat arrays.
struct Atlas_request
{
  Polygon_soup surface;
  // Sides that are seams of the caller's, and that seams are to follow.
  std::vector<std::int32_t> seams;
  std::vector<std::int32_t> features;
  // By polygon, those that keep their images, and the images of their corners; nothing if there are none.
  std::vector<char> is_pinned;
  std::vector<std::array<double, 2>> images;

  bool keeps(std::int32_t polygon) const { return !is_pinned.empty() && is_pinned[polygon]; }

  // Whether the numbers that receive the atlas have single precision; the atlas is certified in them.
  bool is_single_precision = false;
};

// The atlas: of each polygon the chart, -1 if it was left out; of each corner the image, and whether the side from it has another
// image than what is across it, or nothing across it.
struct Atlas_result
{
  std::vector<std::int32_t> charts;
  std::vector<std::array<double, 2>> images;
  std::vector<char> seams;
};

// Unwraps. The result is set if the summary is valid.
CGAL_FLIP_FREE_MAPS_CORE_DECLARATION void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options,
                                                          Default_method& method, Atlas_result& result, Unwrap_summary& summary);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_H
