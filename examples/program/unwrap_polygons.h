// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Atlases of polygons.

#ifndef FLIP_FREE_MAPS_PROGRAM_UNWRAP_POLYGONS_H
#define FLIP_FREE_MAPS_PROGRAM_UNWRAP_POLYGONS_H

#include "number_files.h"

#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

enum Seam_edges_tag
{
  seam_edges_tag
};

// The caller's seams, as pairs of indices of points.
template <typename Base>
auto seam_edges(const Vertex_pairs& edges, const Base& base)
{
  return CGAL::Named_function_parameters<Vertex_pairs, Seam_edges_tag, Base>(edges, base);
}

// Unwraps polygons: `uv_of_corners` receives a container of images for each polygon, in the order of its indices. It is left untouched
// if the atlas is not valid.
template <typename PointRange, typename PolygonRange, typename CornerRange, typename NamedParameters>
FFM::Unwrap_summary unwrap(const PointRange& points, const PolygonRange& polygons, CornerRange& uv_of_corners, const NamedParameters& np)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  FFM::Unwrap_summary summary;
  Mesh mesh;
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons)) {
    summary.status = Status::non_manifold;
    summary.message = "sheets of the surface meet at an edge or a vertex, or neighbouring faces are oriented differently";
    return summary;
  }
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  // The halfedges of a polygon are still there, each in a triangle of it, when it is triangulated.
  std::vector<std::vector<Mesh::Halfedge_index>> corners;
  for(const auto face : mesh.faces()) {
    const auto& polygon = polygons[corners.size()];
    corners.emplace_back();
    Mesh::Halfedge_index h = mesh.halfedge(face);
    while(mesh.target(h).idx() != polygon[0])
      h = mesh.next(h);
    for(std::size_t k = 0; k < polygon.size(); ++k, h = mesh.next(h))
      corners.back().push_back(h);
  }
  PMP::triangulate_faces(mesh);
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  for(const auto& edge : CGAL::parameters::get_parameter(np, seam_edges_tag))
    seams[mesh.edge(mesh.halfedge(Vertex(static_cast<Mesh::size_type>(edge.first)), Vertex(static_cast<Mesh::size_type>(edge.second))))] =
      true;
  summary = FFM::unwrap(mesh, uv, FFM::internal::parameter_or(np, FFM::internal::unwrap_options_tag, FFM::Unwrap_options()),
                        FFM::internal::chosen_traits<FFM::Flip_free_map_traits<>>(np), CGAL::parameters::edge_is_constrained_map(seams));
  if(!summary.is_valid())
    return summary;
  uv_of_corners = CornerRange(corners.size());
  for(std::size_t i = 0; i < corners.size(); ++i)
    for(const auto h : corners[i])
      uv_of_corners[i].push_back({uv[h].x(), uv[h].y()});
  return summary;
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_UNWRAP_POLYGONS_H
