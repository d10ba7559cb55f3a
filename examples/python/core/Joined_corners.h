// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Meshes whose vertices are joined from the corners of polygons.

#ifndef FLIP_FREE_MAPS_PYTHON_JOINED_CORNERS_H
#define FLIP_FREE_MAPS_PYTHON_JOINED_CORNERS_H

#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace python {

namespace FFM = CGAL::Flip_free_maps;

// What files and graphics cards want of a surface with seams: vertices of which each has one point and one image. Corners that
// share both are one vertex; vertices have the order in which corners meet them.
template <typename Number>
struct Joined_corners
{
  using Image = std::array<Number, 2>;

  std::vector<std::int64_t> vertices; // which point each has
  std::vector<std::int64_t> faces;    // the vertices of one polygon after another
  std::vector<Image> uv;

  // `images[f][k]` is the image of corner k of polygon f.
  template <typename PolygonRange, typename Corners>
  void join(const PolygonRange& polygons, std::size_t number_of_points, const Corners& images)
  {
    // The vertices of a point form a chain, most of which are short.
    std::vector<std::int64_t> first(number_of_points, -1), next;
    for(std::size_t f = 0; f < polygons.size(); ++f) {
      const auto& polygon = polygons[f];
      for(std::size_t k = 0; k < FFM::internal::number_of_corners(polygon); ++k) {
        const std::int64_t point = polygon[k];
        const Image& image = images[f][k];
        std::int64_t v = first[point];
        while(v >= 0 && uv[v] != image)
          v = next[v];
        if(v < 0) {
          v = static_cast<std::int64_t>(vertices.size());
          vertices.push_back(point);
          uv.push_back(image);
          next.push_back(first[point]);
          first[point] = v;
        }
        faces.push_back(v);
      }
    }
  }
};

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_JOINED_CORNERS_H
