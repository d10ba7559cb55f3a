// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_surface.h"

#include "Gltf_meshes.h"
#include "Gltf_nodes.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace program {

namespace {

using Place = std::array<double, 3>;

// Numbers the points of one mesh after the other.
class Mesh_points
{
public:
  Mesh_points(Gltf_container& container, const Gltf_meshes& meshes, Surface& surface)
    : m_container(container), m_meshes(meshes), m_surface(surface), m_places(meshes.vertices.size()), m_numbers(meshes.vertices.size())
  {}

  // The number of the point of a vertex.
  std::size_t operator()(const Gltf_primitive& primitive, std::uint32_t vertex)
  {
    if(primitive.mesh != m_mesh) {
      m_mesh = primitive.mesh;
      m_known.clear();
    }
    auto& numbers = m_numbers[primitive.vertices];
    if(numbers.empty())
      load(primitive.vertices);
    auto& [mesh, number] = numbers[vertex];
    if(mesh == m_mesh)
      return number;
    mesh = m_mesh;
    const Place& p = m_places[primitive.vertices][vertex];
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Failure{Status::non_finite_input,
                    primitive.who + ": the position of vertex " + std::to_string(vertex) + " (from 0) is NaN or infinite"};
    const auto entry = m_known.emplace(p, m_surface.points.size());
    if(entry.second)
      m_surface.points.emplace_back(p[0], p[1], p[2]);
    number = entry.first->second;
    return number;
  }

private:
  void load(std::size_t vertices)
  {
    const Gltf_vertices& all = m_meshes.vertices[vertices];
    m_places[vertices] = Gltf_accessor(m_container, count_of(all.attributes, "POSITION", all.who), all.who).vectors<3>();
    for(Place& p : m_places[vertices])
      for(double& coordinate : p)
        coordinate += 0.; // one zero
    m_numbers[vertices].assign(all.count, {no_mesh, 0});
  }

  static constexpr std::size_t no_mesh = static_cast<std::size_t>(-1);

  Gltf_container& m_container;
  const Gltf_meshes& m_meshes;
  Surface& m_surface;
  std::size_t m_mesh = no_mesh;
  std::vector<std::vector<Place>> m_places;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> m_numbers; // of vertices: for which mesh, and which point
  std::unordered_map<Place, std::size_t, boost::hash<Place>> m_known;
};

void add_polygons(Gltf_container& container, const Gltf_meshes& meshes, Surface& surface)
{
  Mesh_points number(container, meshes, surface);
  for(const Gltf_primitive& primitive : meshes.primitives)
    for(std::size_t i = 0; i < primitive.corners.size(); i += 3) {
      surface.objects.push_back(primitive.mesh);
      surface.polygons.emplace_back();
      for(std::size_t k = 0; k < 3; ++k)
        surface.polygons.back().push_back(number(primitive, primitive.corners[i + k]));
    }
}

void add_images(Gltf_container& container, const Gltf_meshes& meshes, Surface& surface)
{
  std::vector<std::vector<Image>> coordinates;
  for(const Gltf_vertices& vertices : meshes.vertices)
    coordinates.push_back(texture_coordinates(container, vertices, surface.uv_set));
  for(const Gltf_primitive& primitive : meshes.primitives)
    for(std::size_t i = 0; i < primitive.corners.size(); i += 3) {
      surface.images.emplace_back();
      for(std::size_t k = 0; k < 3 && !coordinates[primitive.vertices].empty(); ++k) {
        const Image& st = coordinates[primitive.vertices][primitive.corners[i + k]];
        if(!std::isfinite(st[0]) || !std::isfinite(st[1]))
          throw Failure{Status::non_finite_input, primitive.who + ": a texture coordinate of vertex " +
                                                    std::to_string(primitive.corners[i + k]) + " (from 0) is NaN or infinite"};
        surface.images.back().push_back({st[1], st[0]});
      }
    }
}

// Gives each mesh the shape in which its first node shows it. A mirrored one keeps its orientation: lengths are what counts.
void shape(const std::vector<Gltf_instance>& instances, Surface& surface)
{
  std::vector<Eigen::Matrix3d> shapes(surface.object_names.size(), Eigen::Matrix3d::Zero());
  for(const Gltf_instance& instance : instances) {
    Eigen::Matrix3d& matrix = shapes[instance.mesh];
    if(!matrix.isZero(0))
      continue;
    matrix = instance.placement.linear();
    const double determinant = matrix.determinant(), size = matrix.norm();
    if(determinant < 0)
      matrix = -matrix;
    // What a node collapses is seen by no one, and may be as it is.
    if(!(std::abs(determinant) > 1e-12 * size * size * size) || !std::isfinite(size))
      matrix.setIdentity();
  }
  std::vector<char> is_done(surface.points.size(), 0);
  for(std::size_t i = 0; i < surface.polygons.size(); ++i)
    for(const std::size_t v : surface.polygons[i])
      if(!std::exchange(is_done[v], 1) && !shapes[surface.objects[i]].isIdentity(0)) {
        const Kernel::Point_3& p = surface.points[v];
        const Eigen::Vector3d q = shapes[surface.objects[i]] * Eigen::Vector3d(p.x(), p.y(), p.z());
        surface.points[v] = Kernel::Point_3(q[0], q[1], q[2]);
      }
}

} // namespace

void read_gltf(const std::string& path, const std::string& text, bool with_images, Surface& surface)
{
  Gltf_container container(path, text);
  const Gltf_meshes meshes = read_meshes(container);
  const std::vector<Gltf_instance> instances = gltf_instances(container.json);
  surface.is_transposed = surface.are_objects_apart = true;
  surface.object_names.resize(list(container.json, "meshes").size());
  for(const Gltf_instance& instance : instances)
    if(surface.object_names[instance.mesh].empty())
      surface.object_names[instance.mesh] = instance.name;
  add_polygons(container, meshes, surface);
  if(with_images)
    add_images(container, meshes, surface);
  shape(instances, surface);
}

Surface gltf_scene(const Surface& surface, const Corner_images& images)
{
  Gltf_container container(surface.path, surface.text);
  const Gltf_meshes meshes = read_meshes(container);
  Surface once, scene;
  add_polygons(container, meshes, once);
  std::vector<std::vector<std::size_t>> polygons_of(list(container.json, "meshes").size());
  for(std::size_t i = 0; i < once.objects.size(); ++i)
    polygons_of[once.objects[i]].push_back(i);
  for(const Gltf_instance& instance : gltf_instances(container.json)) {
    const bool is_mirrored = instance.placement.linear().determinant() < 0;
    check((scene.polygons.size() + polygons_of[instance.mesh].size()) / 16 <= container.size(),
          "its nodes show so many triangles that they are no surface for one file: " + surface.path);
    std::unordered_map<std::size_t, std::size_t> numbers;
    for(const std::size_t i : polygons_of[instance.mesh]) {
      scene.polygons.emplace_back();
      for(const std::size_t v : once.polygons[i]) {
        const auto entry = numbers.emplace(v, scene.points.size());
        if(entry.second) {
          const Kernel::Point_3& p = once.points[v];
          const Eigen::Vector3d q = instance.placement * Eigen::Vector3d(p.x(), p.y(), p.z());
          scene.points.emplace_back(q[0], q[1], q[2]);
        }
        scene.polygons.back().push_back(entry.first->second);
      }
      scene.images.push_back(images[i]);
      if(is_mirrored) {
        std::reverse(scene.polygons.back().begin(), scene.polygons.back().end());
        std::reverse(scene.images.back().begin(), scene.images.back().end());
      }
      scene.objects.push_back(scene.object_names.size());
    }
    scene.object_names.push_back(instance.name);
  }
  scene.is_transposed = surface.is_transposed;
  scene.are_objects_apart = true;
  return scene;
}

} // namespace program
