// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_meshes.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace program {

namespace {

const std::size_t triangle_list = 4, triangle_strip = 5, triangle_fan = 6;

std::vector<std::uint32_t> triangle_list_of(std::vector<std::uint32_t> indices, std::size_t mode, const std::string& who)
{
  if(mode == triangle_list) {
    check(indices.size() % 3 == 0, who + " has " + std::to_string(indices.size()) + " indices, which is no multiple of 3");
    return indices;
  }
  std::vector<std::uint32_t> corners;
  for(std::size_t i = 0; i + 2 < indices.size(); ++i)
    if(mode == triangle_fan)
      corners.insert(corners.end(), {indices[i + 1], indices[i + 2], indices[0]});
    else
      corners.insert(corners.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  return corners;
}

class Meshes_reader
{
public:
  explicit Meshes_reader(Gltf_container& container) : m_container(container) {}

  Gltf_meshes read()
  {
    const std::size_t number_of_meshes = list(m_container.json, "meshes").size();
    for(std::size_t mesh = 0; mesh < number_of_meshes; ++mesh) {
      const std::string who = "mesh number " + std::to_string(mesh) + " (from 0)";
      const Json& primitives = list(element(m_container.json, "meshes", mesh, who), "primitives");
      for(std::size_t i = 0; i < primitives.size(); ++i)
        read_primitive(mesh, i, primitives[i], "primitive number " + std::to_string(i) + " of " + who);
    }
    return std::move(m_meshes);
  }

private:
  void read_primitive(std::size_t mesh, std::size_t number, const Json& primitive, const std::string& who)
  {
    check(primitive.is_object(), who + " is no object");
    const std::size_t mode = count_of(primitive, "mode", who, triangle_list);
    check(mode <= triangle_fan, who + " has an unknown mode");
    const Json* attributes = member(primitive, "attributes");
    check(attributes != nullptr && attributes->is_object(), who + " has no attributes");
    // Points and lines have no image, and neither has what lies nowhere.
    if(mode < triangle_list || member(*attributes, "POSITION") == nullptr)
      return;
    if(const Json* extensions = member(primitive, "extensions"))
      check(member(*extensions, "KHR_draco_mesh_compression") == nullptr,
            who +
              " is compressed by KHR_draco_mesh_compression, which is not read; Blender and gltf-transform write such files without it");
    Gltf_primitive result;
    result.mesh = mesh;
    result.number = number;
    result.who = who;
    result.vertices = read_vertices(*attributes, list(primitive, "targets"), who);
    result.corners = triangle_list_of(read_indices(primitive, m_meshes.vertices[result.vertices].count, who), mode, who);
    m_meshes.primitives.push_back(std::move(result));
  }

  std::size_t read_vertices(const Json& attributes, const Json& targets, const std::string& who)
  {
    const auto entry = m_numbers.emplace(attributes.dump() + targets.dump(), m_meshes.vertices.size());
    if(!entry.second)
      return entry.first->second;
    Gltf_vertices vertices;
    vertices.attributes = attributes;
    vertices.targets = targets;
    vertices.who = who;
    const Gltf_accessor positions(m_container, count_of(attributes, "POSITION", who), who);
    check(positions.is("VEC3") && positions.has_data(), who + " has positions that are no vectors with three numbers, or without data");
    vertices.count = positions.count();
    claim(vertices.count, who);
    check_accessors(attributes, vertices.count, who);
    for(const Json& target : targets)
      check_accessors(target, vertices.count, who);
    m_meshes.vertices.push_back(std::move(vertices));
    return entry.first->second;
  }

  void check_accessors(const Json& accessors, std::size_t count, const std::string& who)
  {
    check(accessors.is_object(), who + " has attributes or targets that are no objects");
    for(const auto& [semantics, number] : accessors.items()) {
      const std::string what = who + ", " + semantics;
      const auto entry = m_counts.emplace(count_of(accessors, semantics.c_str(), what), 0);
      if(entry.second)
        entry.first->second = Gltf_accessor(m_container, entry.first->first, what).count();
      check(entry.first->second == count,
            what + " has " + std::to_string(entry.first->second) + " elements, and its positions are " + std::to_string(count));
    }
  }

  std::vector<std::uint32_t> read_indices(const Json& primitive, std::size_t number_of_vertices, const std::string& who)
  {
    std::vector<std::uint32_t> indices;
    if(member(primitive, "indices") == nullptr) {
      claim(number_of_vertices, who);
      for(std::size_t i = 0; i < number_of_vertices; ++i)
        indices.push_back(static_cast<std::uint32_t>(i));
      return indices;
    }
    const Gltf_accessor accessor(m_container, count_of(primitive, "indices", who), who + ", indices");
    check(accessor.is("SCALAR") && accessor.is_natural(), who + " has indices that are no natural numbers");
    claim(accessor.count(), who);
    for(const auto& index : accessor.vectors<1>()) {
      if(!(index[0] < static_cast<double>(number_of_vertices)))
        throw Failure{Status::file_error, who + " names the vertex " + std::to_string(std::llround(index[0])) + " (from 0), but has " +
                                            std::to_string(number_of_vertices)};
      indices.push_back(static_cast<std::uint32_t>(index[0]));
    }
    return indices;
  }

  // Files may use the same numbers many times, for variants of a shape.
  void claim(std::size_t number, const std::string& who)
  {
    m_claimed += number;
    check(m_claimed / 16 <= m_container.size() && m_claimed < static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()),
          who + " and those before it name the same data so often that " + std::to_string(m_claimed) + " vertices and corners result");
  }

  Gltf_container& m_container;
  Gltf_meshes m_meshes;
  std::map<std::string, std::size_t> m_numbers; // of vertices, by their attributes
  std::map<std::size_t, std::size_t> m_counts;  // of the accessors that are checked
  std::size_t m_claimed = 0;
};

} // namespace

Gltf_meshes read_meshes(Gltf_container& container) { return Meshes_reader(container).read(); }

std::string texture_semantics(std::size_t uv_set) { return "TEXCOORD_" + std::to_string(uv_set); }

std::vector<std::array<double, 2>> texture_coordinates(Gltf_container& container, const Gltf_vertices& vertices, std::size_t uv_set)
{
  const std::string name = texture_semantics(uv_set);
  if(member(vertices.attributes, name.c_str()) == nullptr)
    return {};
  const Gltf_accessor accessor(container, count_of(vertices.attributes, name.c_str(), vertices.who), vertices.who + ", " + name);
  check(accessor.is("VEC2"), vertices.who + " has texture coordinates that are no pairs");
  return accessor.vectors<2>();
}

} // namespace program
