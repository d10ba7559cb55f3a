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
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

bool is_finite(const Kernel::Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

namespace {

// Returns how many polygons have no triangulation by their shape, as those that cross themselves: they become fans.
std::size_t triangulate(Mesh& mesh)
{
  PMP::triangulate_faces(mesh);
  std::size_t fans = 0;
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(const Mesh::Face_index face : faces) {
    Mesh::Halfedge_index h = mesh.halfedge(face);
    fans += mesh.next(mesh.next(mesh.next(h))) != h;
    while(mesh.next(mesh.next(mesh.next(h))) != h)
      h = CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  }
  return fans;
}

// Gives the surface the points and faces of a mesh, which are not those of its file any more.
void replace_polygons(const Mesh& mesh, Surface& surface)
{
  surface.text.clear();
  surface.images.clear();
  surface.points.clear();
  surface.polygons.clear();
  for(const Vertex v : mesh.vertices())
    surface.points.push_back(mesh.point(v));
  for(const auto face : mesh.faces()) {
    surface.polygons.emplace_back();
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      surface.polygons.back().push_back(v);
  }
}

} // namespace

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
  // Two sides of a sheet are no duplicates of each other.
  PMP::repair_polygon_soup(points, polygons, CGAL::parameters::require_same_orientation(true));
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
  const std::size_t fans = triangulate(mesh);
  const std::size_t faces_triangulated = mesh.number_of_faces();
  std::vector<Mesh::Face_index> degenerate;
  PMP::degenerate_faces(mesh, std::back_inserter(degenerate));
  PMP::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  replace_polygons(mesh, surface);
  // Diagonals of two polygons may be one edge.
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    PMP::orient_polygon_soup(points, polygons);
  const auto step = [](std::size_t before, std::size_t after, const std::string& what) {
    return before == after ? "" : ", " + what + " (" + std::to_string(before) + " -> " + std::to_string(after) + ")";
  };
  const std::string text = step(polygons_before, finite_polygons, "faces with coordinates that are not finite were removed") +
                           step(points_before, points_merged, "equal and unused points were removed") +
                           step(finite_polygons, polygons_merged, "duplicated and collapsed faces were removed") +
                           (reversed == 0 ? "" : ", " + std::to_string(reversed) + " faces were turned over") +
                           step(points_merged, points_split, "points of several sheets were doubled") +
                           step(polygons_merged, faces_triangulated, "polygons were triangulated") +
                           (fans == 0 ? "" : ", " + std::to_string(fans) + " of them as fans, since they cross themselves") +
                           (degenerate.empty() ? ""
                                               : ", " + std::to_string(degenerate.size()) +
                                                   " faces without area were removed by collapsing or flipping their edges") +
                           step(faces_triangulated, polygons.size(), "faces");
  return text.empty() ? "nothing had to be repaired" : "repaired: " + text.substr(2);
}

} // namespace program
