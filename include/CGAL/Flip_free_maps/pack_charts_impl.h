// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PACK_CHARTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_PACK_CHARTS_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/pack_charts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Flat_chart> separate_charts(const std::vector<std::array<std::int32_t, 3>>& elements,
                                                                   const Positions<2>& x)
{
  std::vector<std::int32_t> parent(x.cols());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](std::int32_t v) {
    while(parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for(const auto& element : elements)
    for(int k = 0; k < 2; ++k)
      parent[root(element[k + 1])] = root(element[k]);
  std::vector<Flat_chart> charts;
  std::vector<std::int32_t> chart_of_root(x.cols(), -1), number(x.cols(), -1);
  std::vector<std::vector<std::int32_t>> vertices;
  for(std::size_t e = 0; e < elements.size(); ++e) {
    std::int32_t& c = chart_of_root[root(elements[e][0])];
    if(c < 0) {
      c = static_cast<std::int32_t>(charts.size());
      charts.emplace_back();
      vertices.emplace_back();
    }
    std::array<std::int32_t, 3> element;
    for(int k = 0; k < 3; ++k) {
      std::int32_t& v = number[elements[e][k]];
      if(v < 0) {
        v = static_cast<std::int32_t>(vertices[c].size());
        vertices[c].push_back(elements[e][k]);
      }
      element[k] = v;
    }
    charts[c].elements.push_back(element);
    charts[c].faces.push_back(static_cast<std::int32_t>(e));
  }
  for(std::size_t c = 0; c < charts.size(); ++c) {
    charts[c].x.resize(2, vertices[c].size());
    for(std::size_t v = 0; v < vertices[c].size(); ++v)
      charts[c].x.col(v) = x.col(vertices[c][v]);
  }
  return charts;
}

CGAL_FLIP_FREE_MAPS_INLINE void pack_free_charts(std::vector<Flat_chart>& charts, const std::vector<char>& is_pinned,
                                                 const Packing_options& options, const Rounding& rounded, Packing_summary& summary)
{
  const std::size_t all = charts.size();
  Packing_obstacles obstacles;
  std::vector<Flat_chart> free;
  for(Flat_chart& chart : charts)
    if(is_pinned.empty() || std::none_of(chart.faces.begin(), chart.faces.end(), [&](std::int32_t f) { return is_pinned[f]; }))
      free.push_back(std::move(chart));
    else if(!chart.x.allFinite()) {
      summary.status = Status::non_finite_input;
      summary.message = "the images of face number " + std::to_string(chart.faces[0]) + ", which is pinned, are not all finite";
      return;
    } else
      for(const auto& element : chart.elements)
        obstacles.add(chart.x(Eigen::all, element));
  charts.swap(free);
  if(charts.empty()) {
    summary.status = options.is_valid(&summary.message) ? Status::success : Status::invalid_option;
    if(summary.is_valid()) {
      summary.message = "all charts are pinned";
      summary.occupancy = obstacles.area();
    }
  } else
    pack_flat_charts(charts, options, obstacles, rounded, summary);
  summary.charts = static_cast<int>(all);
  summary.pinned_charts = static_cast<int>(all - charts.size());
}

} // namespace internal

CGAL_FLIP_FREE_MAPS_INLINE Packing_summary pack_charts(Textured_mesh& mesh, const Packing_options& options,
                                                       const std::vector<char>& is_pinned)
{
  Packing_summary summary;
  if(!is_pinned.empty() && is_pinned.size() != mesh.triangles.size()) {
    summary.status = Status::invalid_option;
    summary.message = "there are " + std::to_string(mesh.triangles.size()) + " triangles, but " + std::to_string(is_pinned.size()) +
                      " values that say whether they are pinned";
    return summary;
  }
  summary.status = Status::empty_mesh;
  summary.message = "the mesh has no faces";
  if(mesh.triangles.empty())
    return summary;
  internal::Corner_numbers<int> numbers;
  std::vector<std::array<std::int32_t, 3>> elements(mesh.triangles.size());
  for(std::size_t f = 0; f < elements.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      const std::size_t v = static_cast<std::size_t>(mesh.triangles[f][k]);
      const std::size_t t =
        f < mesh.texture_triangles.size() ? static_cast<std::size_t>(mesh.texture_triangles[f][k]) : mesh.texture.size();
      if(v >= mesh.points.size() || t >= mesh.texture.size()) {
        summary.status = Status::invalid_option;
        summary.message = "an index is out of range in face number " + std::to_string(f);
        return summary;
      }
      elements[f][k] = numbers(mesh.triangles[f][k], mesh.texture[t][0], mesh.texture[t][1]);
    }
  Positions<2> x = numbers.positions();
  std::vector<internal::Flat_chart> charts = internal::separate_charts(elements, x);
  internal::pack_free_charts(charts, is_pinned, options, internal::as_rounded_by<std::array<double, 2>>, summary);
  if(!summary.is_valid())
    return summary;
  for(const internal::Flat_chart& chart : charts)
    for(std::size_t e = 0; e < chart.elements.size(); ++e)
      for(int k = 0; k < 3; ++k)
        x.col(elements[chart.faces[e]][k]) = chart.x.col(chart.elements[e][k]);
  mesh.texture.resize(x.cols());
  for(Eigen::Index i = 0; i < x.cols(); ++i)
    mesh.texture[i] = {{x(0, i), x(1, i)}};
  mesh.texture_triangles.assign(elements.begin(), elements.end());
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PACK_CHARTS_IMPL_H
