// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "files.h"

#include "formats/gltf/Gltf_surface.h"
#include "repair_polygons.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// A vertex whose faces are not one fan, or -1: walking from face to face across the vertex's edges does not reach all of them.
long long pinched_vertex(const std::vector<std::vector<std::size_t>>& polygons)
{
  std::map<std::size_t, std::vector<std::pair<std::size_t, std::size_t>>> fans; // the edges opposite to a vertex
  for(const auto& t : polygons)
    for(std::size_t k = 0; k < 3; ++k)
      fans[t[k]].emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
  for(auto& [vertex, edges] : fans) {
    std::map<std::size_t, std::size_t> next(edges.begin(), edges.end()), previous;
    for(const auto& edge : edges)
      previous[edge.second] = edge.first;
    std::size_t reached = 1;
    std::size_t v = edges[0].second;
    for(; reached < edges.size() && next.count(v) > 0 && v != edges[0].first; v = next[v])
      ++reached;
    if(v != edges[0].first) // the fan is open
      for(v = edges[0].first; reached < edges.size() && previous.count(v) > 0; v = previous[v])
        ++reached;
    if(reached < edges.size())
      return static_cast<long long>(vertex);
  }
  return -1;
}

std::string why_not_manifold(const std::vector<std::vector<std::size_t>>& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> edges; // how many faces use an edge forwards and backwards
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % 3];
      ++(v < w ? edges[{v, w}].first : edges[{w, v}].second);
    }
  const auto name = [](const std::pair<std::size_t, std::size_t>& edge) {
    return "the edge between vertices " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
  };
  const std::pair<std::size_t, std::size_t>* misoriented = nullptr;
  for(const auto& edge : edges) {
    if(edge.second.first + edge.second.second > 2)
      return name(edge.first) + " has more than two faces";
    if(misoriented == nullptr && (edge.second.first > 1 || edge.second.second > 1))
      misoriented = &edge.first;
  }
  if(misoriented != nullptr)
    return "the faces at " + name(*misoriented) + " are oriented differently; a Moebius strip cannot be oriented";
  return "several sheets of the surface meet at vertex number " + std::to_string(pinched_vertex(polygons));
}

} // namespace

bool is_gltf(const std::string& path)
{
  const std::string extension = small_extension(path);
  return extension == ".glb" || extension == ".gltf";
}

namespace {

void read_gltf_surface(const std::string& path, bool with_images, Surface& surface)
{
  std::string message;
  check(FFM::internal::read_whole_file(path, surface.text, &message), message);
  try {
    read_gltf(path, surface.text, with_images, surface);
  } catch(const Failure& failure) {
    throw Failure{failure.status, "cannot read " + path + ": " + failure.message};
  }
}

// The objects of the polygons of an OBJ file, as its lines `o` say. Faces before the first of these are an object without a name.
void find_objects(Surface& surface)
{
  if(surface.text.find("\no ") == std::string::npos && surface.text.compare(0, 2, "o ") != 0)
    return;
  FFM::internal::OBJ_tokenizer tokenizer(surface.text);
  surface.object_names.emplace_back();
  for(std::vector<std::string_view> words; tokenizer.next_line(words);)
    if(!words.empty() && words[0] == "o") {
      // Names may have spaces.
      surface.object_names.emplace_back();
      for(std::size_t k = 1; k < words.size(); ++k)
        surface.object_names.back() += (k > 1 ? " " : "") + std::string(words[k]);
    } else if(!words.empty() && words[0] == "f")
      surface.objects.push_back(surface.object_names.size() - 1);
}

void read_polygons(const std::string& path, bool with_images, Surface& surface)
{
  Polygon_file file;
  const std::string error = read_polygon_file(path, file, with_images, &surface.text);
  check(error.empty(), error);
  for(const auto& p : file.points)
    surface.points.emplace_back(p[0], p[1], p[2]);
  surface.polygons = std::move(file.polygons);
  surface.images = std::move(file.images);
  if(small_extension(path) == ".obj")
    find_objects(surface);
}

} // namespace

void read_surface(const std::string& path, bool with_images, Surface& surface)
{
  surface.path = path;
  if(is_gltf(path))
    read_gltf_surface(path, with_images, surface);
  else
    read_polygons(path, with_images, surface);
  if(surface.polygons.empty())
    throw Failure{Status::empty_mesh, "the file holds no faces"};
}

void make_mesh(const Surface& surface, Mesh& mesh)
{
  for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
    const auto& polygon = surface.polygons[i];
    const std::string face = "face number " + std::to_string(i);
    if(polygon.size() != 3)
      throw Failure{Status::not_triangular, face + " has " + std::to_string(polygon.size()) + " corners, where triangles are wanted"};
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Failure{Status::non_manifold, face + " names a vertex twice"};
  }
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    if(!is_finite(surface.points[v]))
      throw Failure{Status::non_finite_input, "a coordinate of vertex number " + std::to_string(v) + " is NaN or infinite"};
  if(!PMP::is_polygon_soup_a_polygon_mesh(surface.polygons))
    throw Failure{Status::non_manifold, why_not_manifold(surface.polygons)};
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.polygons, mesh);
}

void read_triangles(const std::string& path, Triangles& triangles)
{
  read_surface(path, false, triangles);
  make_mesh(triangles, triangles.mesh);
  auto components = triangles.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t number = PMP::connected_components(triangles.mesh, components);
  if(number != 1)
    throw Failure{Status::several_components, "the mesh has " + std::to_string(number) + " components"};
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
  Surface given;
  read_surface(path, true, given);
  bool is_same = given.polygons == triangles.polygons;
  std::vector<Kernel::Point_2> uv(triangles.points.size(), Kernel::Point_2(0, 0));
  std::vector<char> is_known(triangles.points.size(), 0);
  for(std::size_t i = 0; is_same && i < given.polygons.size(); ++i) {
    is_same = !given.images[i].empty();
    for(std::size_t k = 0; is_same && k < given.polygons[i].size(); ++k) {
      const std::size_t v = given.polygons[i][k];
      const Kernel::Point_2 image(given.images[i][k][0], given.images[i][k][1]);
      is_same = !is_known[v] || uv[v] == image;
      is_known[v] = 1;
      uv[v] = image;
    }
  }
  check(is_same, path + " does not give the faces of the mesh one pair of texture coordinates per vertex");
  return uv;
}

} // namespace program
