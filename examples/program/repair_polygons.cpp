// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "repair_polygons.h"

#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>

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
  surface.objects.clear();
  surface.object_names.clear();
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

Eigen::Vector3d place(const Mesh& mesh, Vertex v)
{
  const Kernel::Point_3& p = mesh.point(v);
  return Eigen::Vector3d(p.x(), p.y(), p.z());
}

// Whether maps can be measured on a face: what is collinear in decimals is not in binary, but the area is rounding.
bool has_area(const Mesh& mesh, Mesh::Face_index face)
{
  Mesh::Halfedge_index h = mesh.halfedge(face);
  Eigen::Matrix2d inverse;
  double area = 0;
  for(int k = 0; k < 3; ++k, h = mesh.next(h))
    if(!FFM::internal::planar_rest_shape(place(mesh, mesh.source(h)), place(mesh, mesh.target(h)), place(mesh, mesh.target(mesh.next(h))),
                                         inverse, area))
      return false;
  return true;
}

// Removes a face by the collapse of its shortest edge or the flip of its longest; at a border it is taken away. `false` if
// nothing of that leaves a surface.
bool remove_thin_face(Mesh& mesh, Mesh::Face_index face)
{
  const auto length = [&](Mesh::Halfedge_index h) { return (place(mesh, mesh.target(h)) - place(mesh, mesh.source(h))).stableNorm(); };
  const Mesh::Halfedge_index h = mesh.halfedge(face);
  const auto range = std::minmax({h, mesh.next(h), mesh.next(mesh.next(h))},
                                 [&](Mesh::Halfedge_index a, Mesh::Halfedge_index b) { return length(a) < length(b); });
  const Mesh::Halfedge_index shortest = range.first, longest = range.second, opposite = mesh.opposite(longest);
  if(length(shortest) <= 1e-12 * length(longest)) {
    if(!CGAL::Euler::does_satisfy_link_condition(mesh.edge(shortest), mesh))
      return false;
    CGAL::Euler::collapse_edge(mesh.edge(shortest), mesh);
    return true;
  }
  if(mesh.is_border(opposite)) {
    CGAL::Euler::remove_face(longest, mesh);
    return true;
  }
  const Vertex v = mesh.target(mesh.next(longest)), w = mesh.target(mesh.next(opposite));
  if(v == w || mesh.halfedge(v, w) != Mesh::null_halfedge())
    return false;
  CGAL::Euler::flip_edge(longest, mesh);
  return true;
}

// Removes faces in which the exact test finds an area, though it has no correct digit. A flip may make another one of its
// neighbour; those that are left after some rounds go round in circles. Returns how many steps it took.
std::size_t remove_thin_faces(Mesh& mesh)
{
  std::size_t removed = 0;
  for(int round = 0; round < 10; ++round) {
    const std::size_t before = removed;
    const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
    for(const Mesh::Face_index face : faces)
      if(!mesh.is_removed(face) && !has_area(mesh, face))
        removed += remove_thin_face(mesh, face);
    if(removed == before)
      break;
  }
  return removed;
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
  const std::size_t thin = remove_thin_faces(mesh);
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
                           (degenerate.size() + thin == 0 ? ""
                                                          : ", " + std::to_string(degenerate.size() + thin) +
                                                              " faces without area were removed by collapsing or flipping their edges") +
                           step(faces_triangulated, polygons.size(), "faces");
  return text.empty() ? "nothing had to be repaired" : "repaired: " + text.substr(2);
}

} // namespace program
