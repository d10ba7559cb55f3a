// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "files.h"

#include "repair_polygons.h"

#include "formats/Polygon_file.h"
#include <CGAL/Flip_free_maps/IO/OBJ.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

std::string why_not_manifold(const std::vector<std::vector<std::size_t>>& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> edges; // how many faces use an edge forwards and backwards
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % 3];
      ++(v < w ? edges[{v, w}].first : edges[{w, v}].second);
    }
  bool is_oriented = true;
  for(const auto& edge : edges) {
    if(edge.second.first + edge.second.second > 2)
      return "the edge between vertices " + std::to_string(edge.first.first) + " and " + std::to_string(edge.first.second) +
             " has more than two faces";
    is_oriented = is_oriented && edge.second.first <= 1 && edge.second.second <= 1;
  }
  return is_oriented ? "several sheets of the surface meet at a vertex"
                     : "neighbouring faces are oriented differently: orient them alike first; a Moebius strip cannot be";
}

} // namespace

void read_soup(const std::string& path, std::vector<Kernel::Point_3>& points, std::vector<std::vector<std::size_t>>& polygons)
{
  Polygon_file file;
  const std::string error = read_polygon_file(path, file);
  check(error.empty(), error);
  for(const auto& p : file.points)
    points.emplace_back(p[0], p[1], p[2]);
  polygons = std::move(file.polygons);
}

namespace {

void read_polygons(const std::string& path, Triangles& triangles)
{
  read_soup(path, triangles.points, triangles.polygons);
  if(triangles.polygons.empty())
    throw Failure{Status::empty_mesh, "the file holds no faces"};
}

void make_mesh(Triangles& triangles)
{
  auto& points = triangles.points;
  auto& polygons = triangles.polygons;
  for(std::size_t i = 0; i < polygons.size(); ++i) {
    const auto& polygon = polygons[i];
    const std::string face = "face number " + std::to_string(i);
    if(polygon.size() != 3)
      throw Failure{Status::not_triangular, face + " has " + std::to_string(polygon.size()) + " corners; triangulate the mesh first"};
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Failure{Status::non_manifold, face + " names a vertex twice"};
  }
  for(const auto& p : points)
    if(!is_finite(p))
      throw Failure{Status::non_finite_input, "a coordinate of the mesh is NaN or infinite"};
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Failure{Status::non_manifold, why_not_manifold(polygons)};
  PMP::polygon_soup_to_polygon_mesh(points, polygons, triangles.mesh);
}

} // namespace

void read_triangles(const std::string& path, Triangles& triangles)
{
  read_polygons(path, triangles);
  make_mesh(triangles);
  auto components = triangles.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t number = PMP::connected_components(triangles.mesh, components);
  if(number != 1)
    throw Failure{Status::several_components, "the mesh has " + std::to_string(number) + " components"};
}

void read_surface(const std::string& path, bool repair, Triangles& triangles, std::string& repairs)
{
  read_polygons(path, triangles);
  if(repair)
    repairs = repair_polygons(triangles);
  if(triangles.polygons.empty())
    throw Failure{Status::empty_mesh, "nothing is left after the repair"};
  make_mesh(triangles);
}

namespace {

// A halfedge on the longest border, null on a closed surface. Lengths may be of any magnitude: squares of tiny ones vanish.
Mesh::Halfedge_index longest_border(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  Mesh::Halfedge_index longest = Mesh::null_halfedge();
  double greatest = -1;
  for(const Mesh::Halfedge_index border : borders) {
    double length = 0;
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(border, mesh)) {
      const Kernel::Point_3& p = mesh.point(mesh.source(h));
      const Kernel::Point_3& q = mesh.point(mesh.target(h));
      length += std::hypot(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
    }
    if(length > greatest) {
      longest = border;
      greatest = length;
    }
  }
  return longest;
}

} // namespace

void read_patch(const std::string& path, Patch& patch)
{
  read_triangles(path, patch.triangles);
  patch.border = longest_border(patch.triangles.mesh);
  if(patch.border == Mesh::null_halfedge())
    throw Failure{Status::no_border, "the surface is closed; it must be cut open before it can be flattened"};
  patch.uv = patch.triangles.mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
}

std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Triangles& triangles)
{
  FFM::Textured_mesh given;
  std::string message;
  check(FFM::read_textured_OBJ(path, given, &message), message);
  bool is_same = given.triangles.size() == triangles.polygons.size();
  std::vector<Kernel::Point_2> uv(triangles.points.size(), Kernel::Point_2(0, 0));
  std::vector<int> texture(triangles.points.size(), -1);
  for(std::size_t i = 0; is_same && i < given.triangles.size(); ++i)
    for(int k = 0; k < 3; ++k) {
      const int v = given.triangles[i][k], t = given.texture_triangles[i][k];
      is_same = is_same && v == static_cast<int>(triangles.polygons[i][k]) && t >= 0 && (texture[v] < 0 || texture[v] == t);
      if(is_same) {
        texture[v] = t;
        uv[v] = Kernel::Point_2(given.texture[t][0], given.texture[t][1]);
      }
    }
  check(is_same, path + " does not give the faces of the mesh one pair of texture coordinates per vertex");
  return uv;
}

} // namespace program
