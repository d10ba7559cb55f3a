// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "repair_polygons.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

bool is_finite(const Kernel::Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

std::string repair_polygons(Surface& surface)
{
  auto& points = surface.points;
  auto& polygons = surface.polygons;
  const std::size_t points_before = points.size(), polygons_before = polygons.size();
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                [&](const std::vector<std::size_t>& polygon) {
                                  return !std::all_of(polygon.begin(), polygon.end(), [&](std::size_t v) { return is_finite(points[v]); });
                                }),
                 polygons.end());
  const std::size_t finite_polygons = polygons.size();
  PMP::remove_isolated_points_in_polygon_soup(points, polygons);
  PMP::repair_polygon_soup(points, polygons);
  const std::size_t points_merged = points.size(), polygons_merged = polygons.size();
  std::vector<Kernel::Point_3> first_corners;
  for(const auto& polygon : polygons)
    first_corners.push_back(points[polygon[0]]);
  PMP::orient_polygon_soup(points, polygons);
  const std::size_t points_split = points.size();
  std::size_t reversed = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    reversed += points[polygons[i][0]] != first_corners[i];
  Mesh mesh;
  if(!polygons.empty())
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  const std::size_t faces_triangulated = mesh.number_of_faces();
  PMP::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  surface.text.clear();
  surface.images.clear();
  points.clear();
  polygons.clear();
  for(const Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(const auto face : mesh.faces()) {
    polygons.emplace_back();
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      polygons.back().push_back(v);
  }
  const auto step = [](std::size_t before, std::size_t after, const std::string& what) {
    return before == after ? "" : ", " + what + " (" + std::to_string(before) + " -> " + std::to_string(after) + ")";
  };
  const std::string text = step(polygons_before, finite_polygons, "faces with coordinates that are not finite were removed") +
                           step(points_before, points_merged, "equal and unused points were removed") +
                           step(finite_polygons, polygons_merged, "duplicated and collapsed faces were removed") +
                           (reversed == 0 ? "" : ", " + std::to_string(reversed) + " faces were turned over") +
                           step(points_merged, points_split, "points of several sheets were doubled") +
                           step(polygons_merged, faces_triangulated, "polygons were triangulated") +
                           step(faces_triangulated, polygons.size(), "faces without area were removed");
  return text.empty() ? "nothing had to be repaired" : "repaired: " + text.substr(2);
}

} // namespace program
