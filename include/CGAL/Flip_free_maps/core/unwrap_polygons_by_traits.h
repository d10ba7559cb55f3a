// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_BY_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_BY_TRAITS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_atlas_by_traits.h>
#include <CGAL/Flip_free_maps/core/pinned_polygons.h>
#include <CGAL/Flip_free_maps/core/unwrap_polygons.h>
#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/internal/name_faces_without_area.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The same with traits of the caller's, and rounded to the numbers that receive the atlas.
template <typename Traits>
void unwrap_polygons_as(const Rounding& rounded, const Atlas_request& request, const Unwrap_options& options, const Traits& traits,
                        Atlas_result& result, Unwrap_summary& summary)
{
  const double begin = wall_seconds();
  const Deadline deadline(options.max_seconds);
  const Polygon_soup& soup = request.surface;
  summary.faces = soup.number_of_polygons();
  summary.status = check_pinned_polygons(request, options, summary.message);
  if(summary.status != Status::success)
    return;
  const std::vector<char>& is_pinned = request.is_pinned;
  summary.pinned_faces = std::count(is_pinned.begin(), is_pinned.end(), 1);
  const Packing_obstacles obstacles = pinned_obstacles(request);
  Surface_view view;
  const bool is_any_free = summary.pinned_faces == 0 || summary.pinned_faces < summary.faces;
  if(is_any_free)
    summary.status = view.load(soup, options.strict, summary.message, is_pinned);
  if(summary.status != Status::success)
    return;
  const Linked_triangles& triangles = view.triangles();
  Chart_atlas_by_traits<Traits> atlas(triangles, begin, traits, options, summary);
  if(!is_any_free) {
    if(!atlas.has_valid_options())
      return;
    result.charts.assign(soup.number_of_polygons(), -1);
    result.images.resize(soup.number_of_corners());
    result.seams.resize(soup.number_of_corners());
    keep_pinned_polygons(request, result);
    summary.message = "all faces are pinned";
    // Of nothing that is mapped.
    summary.flips = summary.seam_edges = 0;
    summary.energy = summary.scale = 1;
    summary.seam_length = 0;
    summary.occupancy = obstacles.area();
    summary.seconds = wall_seconds() - begin;
    return;
  }
  atlas.avoid(obstacles);
  for(const std::int32_t side : request.seams)
    if(view.halfedge_of_side(side) >= 0)
      atlas.mark_seam(view.halfedge_of_side(side));
  for(const std::int32_t side : request.features)
    if(view.halfedge_of_side(side) >= 0)
      atlas.mark_feature(view.halfedge_of_side(side));
  const bool is_done = atlas.run(rounded);
  if(is_done) {
    std::vector<std::int32_t> chart_of(triangles.triangles.size());
    std::vector<std::array<double, 2>> images(3 * triangles.triangles.size());
    for(std::size_t c = 0; c < atlas.charts().size(); ++c) {
      const Flat_chart& chart = atlas.charts()[c];
      for(std::size_t e = 0; e < chart.faces.size(); ++e) {
        chart_of[chart.faces[e]] = static_cast<std::int32_t>(c);
        for(int k = 0; k < 3; ++k)
          images[3 * chart.faces[e] + k] = {{chart.x(0, chart.elements[e][k]), chart.x(1, chart.elements[e][k])}};
      }
    }
    result.charts.assign(soup.number_of_polygons(), -1);
    for(std::size_t f = 0; f < chart_of.size(); ++f)
      result.charts[triangles.polygons[f]] = chart_of[f];
    result.images.resize(soup.number_of_corners());
    result.seams.resize(soup.number_of_corners());
    for(std::int32_t c = 0; c < soup.number_of_corners(); ++c) {
      // Where there is no triangle, any place is as good as any other.
      result.images[c] = images[(std::max)(view.triangle_corner(c), 0)];
      result.seams[c] = view.halfedge_of_side(c) < 0 || atlas.is_seam(view.halfedge_of_side(c));
    }
    keep_pinned_polygons(request, result);
    atlas.finish();
  }
  summary.parted_edges = view.number_of_parted_edges();
  name_faces_without_area(view.polygons_without_area(), summary);
  summary.seconds = wall_seconds() - begin;
}

template <typename Traits>
void unwrap_polygons(const Atlas_request& request, const Unwrap_options& options, Traits& traits, Atlas_result& result,
                     Unwrap_summary& summary)
{
  const auto run = [&] {
    if(request.is_single_precision)
      unwrap_polygons_as(as_rounded_by<std::array<float, 2>>, request, options, traits, result, summary);
    else
      unwrap_polygons_as(as_rounded_by<std::array<double, 2>>, request, options, traits, result, summary);
  };
  catch_out_of_memory(run, summary);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_UNWRAP_POLYGONS_BY_TRAITS_H
