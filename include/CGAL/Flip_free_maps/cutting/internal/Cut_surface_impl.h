// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_IMPL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status measure_cut_surface(Cut_surface& surface, std::string& message)
{
  Eigen::Vector3d low;
  const Status status = normalize_extent(surface.points, low, surface.scale, message);
  if(status != Status::success)
    return status;
  surface.areas.resize(surface.faces.size());
  Matrix<2> rest_inverse;
  for(std::size_t i = 0; i < surface.faces.size(); ++i) {
    const auto& v = surface.faces[i];
    if(!planar_rest_shape(surface.points.col(v[0]), surface.points.col(v[1]), surface.points.col(v[2]), rest_inverse, surface.areas[i])) {
      message = "zero area, or none within double precision, has face number " + std::to_string(i);
      return Status::degenerate_rest_element;
    }
  }
  surface.lengths.resize(surface.edge_halfedge.size());
  for(std::int32_t e = 0; e < surface.number_of_edges(); ++e) {
    const std::int32_t h = surface.edge_halfedge[e];
    surface.lengths[e] = (surface.points.col(surface.target(h)) - surface.points.col(surface.source(h))).norm();
  }
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Status load_cut_surface(const Linked_triangles& triangles, const std::vector<char>& is_seam,
                                                   const std::vector<char>& is_feature, Cut_surface& surface, std::string& message)
{
  surface.faces = triangles.triangles;
  surface.opposite = triangles.opposite;
  surface.points = triangles.points;
  surface.edge_of.assign(surface.opposite.size(), -1);
  for(std::size_t i = 0; i < surface.opposite.size(); ++i) {
    const std::int32_t h = static_cast<std::int32_t>(i), g = surface.opposite[i];
    if(surface.edge_of[i] >= 0)
      continue;
    surface.edge_of[h] = surface.number_of_edges();
    if(g >= 0)
      surface.edge_of[g] = surface.edge_of[h];
    surface.edge_halfedge.push_back(h);
    surface.is_seam.push_back(g >= 0 && is_seam[h]);
    surface.is_feature.push_back(is_feature[h]);
    surface.is_rigid.push_back(triangles.is_diagonal(h));
  }
  return measure_cut_surface(surface, message);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_IMPL_H
