// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_IMPL_H

#include <CGAL/Flip_free_maps/core/pinned_polygons.h>
#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status check_pinned_polygons(const Atlas_request& request, const Unwrap_options& options, std::string& message)
{
  if(request.is_pinned.empty())
    return Status::success;
  if(!options.pack) {
    message = "faces are pinned to places among packed charts; packing must not be off";
    return Status::invalid_option;
  }
  const Polygon_soup& soup = request.surface;
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    for(std::int32_t c = soup.first_corners[p]; request.is_pinned[p] && c < soup.first_corners[p + 1]; ++c)
      if(!std::isfinite(request.images[c][0]) || !std::isfinite(request.images[c][1])) {
        message = "the image of corner " + std::to_string(c - soup.first_corners[p]) + " of face number " + std::to_string(p) +
                  ", which is pinned, is NaN or infinite";
        return Status::non_finite_input;
      }
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Packing_obstacles pinned_obstacles(const Atlas_request& request)
{
  Packing_obstacles obstacles;
  const Polygon_soup& soup = request.surface;
  for(std::size_t p = 0; p < request.is_pinned.size(); ++p) {
    const std::int32_t first = soup.first_corners[p], n = soup.first_corners[p + 1] - first;
    if(!request.is_pinned[p] || n == 0)
      continue;
    Positions<2> polygon(2, n);
    for(std::int32_t k = 0; k < n; ++k)
      polygon.col(k) << request.images[first + k][0], request.images[first + k][1];
    obstacles.add(polygon);
  }
  return obstacles;
}

CGAL_FLIP_FREE_MAPS_INLINE void keep_pinned_polygons(const Atlas_request& request, Atlas_result& result)
{
  if(request.is_pinned.empty())
    return;
  const Polygon_soup& soup = request.surface;
  const auto for_each_side = [&](auto&& visit) {
    for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
      for(std::int32_t c = soup.first_corners[p]; request.is_pinned[p] && c < soup.first_corners[p + 1]; ++c)
        visit(c, soup.next(p, c));
  };
  std::vector<std::int32_t> place(soup.points.cols(), -1);
  for_each_side([&](std::int32_t c, std::int32_t) { place[soup.vertices[c]] = soup.vertices[c]; });
  weld_points(soup.points, place);
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::pair<std::int32_t, std::int32_t>>> sides;
  const auto places = [&](std::int32_t c, std::int32_t d) { return std::make_pair(place[soup.vertices[c]], place[soup.vertices[d]]); };
  for_each_side([&](std::int32_t c, std::int32_t next) { sides[places(c, next)].emplace_back(c, next); });
  for_each_side([&](std::int32_t c, std::int32_t next) {
    result.images[c] = request.images[c];
    const auto others = sides.find(places(next, c));
    result.seams[c] = 1;
    if(others != sides.end())
      for(const auto& other : others->second)
        if(request.images[other.first] == request.images[next] && request.images[other.second] == request.images[c])
          result.seams[c] = 0;
  });
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_PINNED_POLYGONS_IMPL_H
