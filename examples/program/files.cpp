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
#include <CGAL/Flip_free_maps/domains/internal/Joined_polygons.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Polygons = std::vector<std::vector<std::size_t>>;

// A vertex whose faces are not one fan, or -1: walking from face to face across the vertex's edges does not reach all of them.
long long pinched_vertex(const Polygons& polygons)
{
  std::map<std::size_t, std::vector<std::pair<std::size_t, std::size_t>>> fans; // the neighbours of a vertex in its faces
  for(const auto& polygon : polygons)
    for(std::size_t k = 0, n = polygon.size(); k < n; ++k)
      fans[polygon[k]].emplace_back(polygon[(k + 1) % n], polygon[(k + n - 1) % n]);
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

std::string why_not_manifold(const Polygons& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> edges; // how many faces use an edge forwards and backwards
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % polygon.size()];
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
  const long long vertex = pinched_vertex(polygons);
  return vertex < 0 ? "" : "several sheets of the surface meet at vertex number " + std::to_string(vertex);
}

// The polygons by their indices, as the functions for arrays join them unless they are strict. Returns the number of pieces.
std::size_t join(const Surface& surface, bool is_strict, Polygons& joined)
{
  FFM::internal::Polygon_soup soup;
  std::string message;
  const Status status = FFM::internal::read_polygon_soup(surface.points, surface.polygons, soup, message);
  if(status != Status::success)
    throw Failure{status, message};
  FFM::internal::Joined_polygons polygons(soup);
  if(!is_strict) {
    polygons.join();
    polygons.remove_repeated();
  }
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    joined.emplace_back(soup.vertices.begin() + soup.first_corners[p], soup.vertices.begin() + soup.first_corners[p + 1]);
  return polygons.number_of_pieces();
}

void check_points(const Surface& surface)
{
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    if(!is_finite(surface.points[v]))
      throw Failure{Status::non_finite_input, "a coordinate of vertex number " + std::to_string(v) + " is NaN or infinite"};
}

void check_triangles(const Surface& surface)
{
  for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
    const auto& polygon = surface.polygons[i];
    const std::string face = "face number " + std::to_string(i);
    if(polygon.size() != 3)
      throw Failure{Status::not_triangular, face + " has " + std::to_string(polygon.size()) + " corners, where triangles are wanted"};
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Failure{Status::non_manifold, face + " names a vertex twice"};
  }
  check_points(surface);
  if(!PMP::is_polygon_soup_a_polygon_mesh(surface.polygons))
    throw Failure{Status::non_manifold, why_not_manifold(surface.polygons)};
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
  check_triangles(surface);
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.polygons, mesh);
}

void read_piece(const std::string& path, bool is_strict, Surface& surface)
{
  read_surface(path, false, surface);
  if(is_strict)
    check_triangles(surface);
  else
    check_points(surface);
  Polygons joined;
  const std::size_t pieces = join(surface, is_strict, joined);
  if(pieces > 1)
    throw Failure{Status::several_components, "the mesh has " + std::to_string(pieces) + " components"};
}

bool is_closed(const Surface& surface)
{
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for(const auto& polygon : surface.polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k)
      sides.emplace(polygon[k], polygon[(k + 1) % polygon.size()]);
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return sides.count({side.second, side.first}) > 0; });
}

void explain_failure(const Surface& surface, bool is_strict, FFM::Outcome& summary)
{
  if(summary.status != Status::non_manifold)
    return;
  Polygons joined;
  join(surface, is_strict, joined);
  const std::string reason = why_not_manifold(joined);
  if(!reason.empty())
    summary.message = reason;
}

std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Surface& surface)
{
  Surface given;
  read_surface(path, true, given);
  bool is_same = given.polygons == surface.polygons;
  std::vector<Kernel::Point_2> uv(surface.points.size(), Kernel::Point_2(0, 0));
  std::vector<char> is_known(surface.points.size(), 0);
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
