// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_BY_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_BY_TRAITS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_atlas.h>
#include <CGAL/Flip_free_maps/core/unwrap_triangles.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The same with traits of the caller's. `Point` has the precision of the numbers that receive the atlas.
template <typename Point, typename Traits>
void unwrap_triangles_as(const Atlas_request& request, const Unwrap_options& options, const Traits& traits, Atlas_result& result,
                         Unwrap_summary& summary)
{
  Chart_atlas<Traits> atlas(traits, options, summary);
  if(!atlas.load(request.points, request.triangles))
    return;
  for(const auto& [face, corner] : request.seams)
    atlas.mark_seam(face, corner);
  for(const auto& [face, corner] : request.features)
    atlas.mark_feature(face, corner);
  if(!atlas.template run<Point>())
    return;
  const std::size_t size = request.triangles.size();
  result.charts.assign(size, -1);
  result.images.resize(size);
  result.seams.resize(size);
  for(std::size_t c = 0; c < atlas.charts().size(); ++c) {
    const Flat_chart& chart = atlas.charts()[c];
    for(std::size_t e = 0; e < chart.faces.size(); ++e) {
      result.charts[chart.faces[e]] = static_cast<std::int32_t>(c);
      for(int k = 0; k < 3; ++k)
        result.images[chart.faces[e]][k] = {chart.x(0, chart.elements[e][k]), chart.x(1, chart.elements[e][k])};
    }
  }
  for(std::size_t f = 0; f < size; ++f)
    for(int k = 0; k < 3; ++k)
      result.seams[f][k] = atlas.is_seam(static_cast<std::int32_t>(f), k);
  atlas.finish();
}

template <typename Traits>
void unwrap_triangles(const Atlas_request& request, const Unwrap_options& options, Traits& traits, Atlas_result& result,
                      Unwrap_summary& summary)
{
  const auto run = [&] {
    if(request.is_single_precision)
      unwrap_triangles_as<std::array<float, 2>>(request, options, traits, result, summary);
    else
      unwrap_triangles_as<std::array<double, 2>>(request, options, traits, result, summary);
  };
  catch_out_of_memory(run, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_TRIANGLES_BY_TRAITS_H
