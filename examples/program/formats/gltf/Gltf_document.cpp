// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_document.h"

#include "Gltf_compaction.h"
#include "Gltf_meshes.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace program {

namespace {

template <typename Number>
void append_bytes(std::string& bytes, Number number)
{
  static_assert(sizeof(Number) == 4);
  std::uint32_t bits;
  std::memcpy(&bits, &number, 4);
  for(int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(bits >> shift & 255);
}

std::size_t add_accessor(Gltf_container& container, Json accessor)
{
  container.json["accessors"].push_back(std::move(accessor));
  return container.json["accessors"].size() - 1;
}

// The smallest type that holds them; the greatest number of each has a meaning of its own.
std::size_t add_indices(Gltf_container& container, const std::vector<std::uint32_t>& indices, std::size_t number_of_vertices)
{
  const std::size_t size = number_of_vertices <= 255 ? 1 : number_of_vertices <= 65535 ? 2 : 4;
  std::string bytes;
  bytes.reserve(indices.size() * size);
  for(const std::uint32_t index : indices)
    for(std::size_t k = 0; k < size; ++k)
      bytes += static_cast<char>(index >> 8 * k & 255);
  return add_accessor(container, {{"bufferView", container.add_view(bytes, 0, gltf_index_data)},
                                  {"componentType", size == 1   ? gltf_unsigned_byte
                                                    : size == 2 ? gltf_unsigned_short
                                                                : gltf_unsigned_int},
                                  {"count", indices.size()},
                                  {"type", "SCALAR"}});
}

// Which set of texture coordinates the normal map of a primitive's material has.
std::size_t set_of_normals(const Json& document, const Json& primitive, const std::string& who)
{
  if(member(primitive, "material") == nullptr)
    return 0;
  const Json* texture = member(element(document, "materials", count_of(primitive, "material", who), who), "normalTexture");
  if(texture == nullptr)
    return 0;
  const std::size_t set = count_of(*texture, "texCoord", who, 0);
  const Json* extensions = member(*texture, "extensions");
  const Json* transform = extensions == nullptr ? nullptr : member(*extensions, "KHR_texture_transform");
  return transform == nullptr ? set : count_of(*transform, "texCoord", who, set);
}

// The images of some vertices, and the vertices that are doubled for them.
class Vertex_images
{
public:
  explicit Vertex_images(std::size_t number_of_vertices, const std::vector<Image>& old) : m_is_set(number_of_vertices, 0), images(old)
  {
    has_changed = old.empty();
    images.resize(number_of_vertices, Image{0, 0});
  }

  // The vertex with this image, in the place of one of the file.
  std::uint32_t operator()(std::uint32_t vertex, const Image& image)
  {
    has_changed = has_changed || images[vertex] != image;
    if(!m_is_set[vertex]) {
      m_is_set[vertex] = 1;
      images[vertex] = image;
    }
    if(images[vertex] == image)
      return vertex;
    const auto entry = m_doubles.emplace(std::make_tuple(vertex, image[0], image[1]), static_cast<std::uint32_t>(images.size()));
    if(entry.second) {
      images.push_back(image);
      copied.push_back(vertex);
    }
    return entry.first->second;
  }

private:
  std::vector<char> m_is_set;
  std::unordered_map<std::tuple<std::uint32_t, double, double>, std::uint32_t, boost::hash<std::tuple<std::uint32_t, double, double>>>
    m_doubles;

public:
  std::vector<Image> images;         // those of the doubled ones last
  std::vector<std::uint32_t> copied; // of which vertex they are doubles
  bool has_changed;
};

class Gltf_writer
{
public:
  Gltf_writer(const Gltf_request& request, const Corner_images& images)
    : m_request(request),
      m_images(images),
      m_container(request.input, request.text),
      m_meshes(read_meshes(m_container)),
      m_semantics(texture_semantics(request.uv_set))
  {}

  std::string write(std::string& note)
  {
    Gltf_compaction compaction(m_container);
    for(std::size_t i = 0, first = 0; i < m_meshes.primitives.size(); ++i) {
      m_first.push_back(first);
      first += m_meshes.primitives[i].corners.size() / 3;
    }
    std::vector<std::vector<std::size_t>> primitives_of(m_meshes.vertices.size());
    for(std::size_t i = 0; i < m_meshes.primitives.size(); ++i)
      if(has_images(i))
        primitives_of[m_meshes.primitives[i].vertices].push_back(i);
    for(std::size_t v = 0; v < primitives_of.size(); ++v)
      if(!primitives_of[v].empty())
        replace(m_meshes.vertices[v], primitives_of[v]);
    add_checkerboard();
    compaction.finish(m_request.output);
    note = m_note;
    return m_container.written(m_request.output);
  }

private:
  Json& primitive(std::size_t i)
  {
    const Gltf_primitive& p = m_meshes.primitives[i];
    return m_container.json["meshes"][p.mesh]["primitives"][p.number];
  }

  bool has_images(std::size_t i) const
  {
    const std::size_t triangles = m_meshes.primitives[i].corners.size() / 3;
    for(std::size_t t = 0; t < triangles; ++t)
      if(!m_images[m_first[i] + t].empty())
        return true;
    return false;
  }

  // Gives vertices their images in all primitives that have them.
  void replace(const Gltf_vertices& vertices, const std::vector<std::size_t>& primitives)
  {
    Vertex_images images(vertices.count, texture_coordinates(m_container, vertices, m_request.uv_set));
    std::vector<std::vector<std::uint32_t>> corners;
    for(const std::size_t i : primitives) {
      corners.push_back(m_meshes.primitives[i].corners);
      for(std::size_t c = 0; c < corners.back().size(); ++c) {
        const auto& image = m_images[m_first[i] + c / 3];
        if(!image.empty())
          corners.back()[c] = images(corners.back()[c], image[c % 3]);
      }
    }
    if(!images.has_changed)
      return;
    bool drops_tangents = false;
    for(const std::size_t i : primitives)
      drops_tangents = drops_tangents || set_of_normals(m_container.json, primitive(i), vertices.who) == m_request.uv_set;
    m_longer.clear();
    Json attributes = longer(vertices.attributes, images.copied, drops_tangents, vertices.who);
    const std::size_t accessor = add_images(images.images);
    for(std::size_t set = 0; set <= m_request.uv_set; ++set)
      if(set == m_request.uv_set || member(attributes, texture_semantics(set).c_str()) == nullptr) {
        attributes[texture_semantics(set)] = accessor;
        if(set < m_request.uv_set)
          say("where there was no " + texture_semantics(set) + ", it is the same as " + m_semantics);
      }
    Json targets = Json::array();
    for(const Json& target : vertices.targets)
      targets.push_back(longer(target, images.copied, drops_tangents, vertices.who));
    for(Json& target : targets)
      if(target.empty()) // which must not be
        target["POSITION"] = add_zeros(images.images.size());
    for(std::size_t n = 0; n < primitives.size(); ++n) {
      Json& edited = primitive(primitives[n]);
      edited["attributes"] = attributes;
      if(!targets.empty())
        edited["targets"] = targets;
      if(images.copied.empty())
        continue;
      edited.erase("mode");
      edited["indices"] = add_indices(m_container, corners[n], images.images.size());
    }
  }

  // Accessors with the doubled vertices, and without what is replaced or dropped.
  Json longer(const Json& accessors, const std::vector<std::uint32_t>& copied, bool drops_tangents, const std::string& who)
  {
    Json result = Json::object();
    for(const auto& [semantics, number] : accessors.items()) {
      if(semantics == m_semantics)
        continue;
      if(semantics == "TANGENT" && drops_tangents) {
        say("tangents are dropped, since they belong to the former " + m_semantics);
        continue;
      }
      result[semantics] = number;
      if(copied.empty())
        continue;
      const std::size_t old = count_of(accessors, semantics.c_str(), who);
      const auto entry = m_longer.emplace(old, 0);
      if(entry.second)
        entry.first->second = Gltf_accessor(m_container, old, who).add_longer(m_container, copied);
      result[semantics] = entry.first->second;
    }
    return result;
  }

  std::size_t add_images(const std::vector<Image>& images)
  {
    std::string bytes;
    bytes.reserve(8 * images.size());
    for(const Image& image : images)
      for(const double coordinate : image)
        append_bytes(bytes, static_cast<float>(coordinate));
    return add_accessor(m_container, {{"bufferView", m_container.add_view(bytes, 0, gltf_vertex_data)},
                                      {"componentType", gltf_float},
                                      {"count", images.size()},
                                      {"type", "VEC2"}});
  }

  std::size_t add_zeros(std::size_t count)
  {
    const Json zero = {0, 0, 0};
    return add_accessor(m_container, {{"componentType", gltf_float}, {"count", count}, {"type", "VEC3"}, {"min", zero}, {"max", zero}});
  }

  void add_checkerboard()
  {
    std::size_t material = std::numeric_limits<std::size_t>::max();
    for(std::size_t i = 0; i < m_meshes.primitives.size(); ++i) {
      if(!has_images(i) || (!m_request.checker && member(primitive(i), "material") != nullptr))
        continue;
      if(material == std::numeric_limits<std::size_t>::max())
        material = add_checkerboard_material();
      primitive(i)["material"] = material;
    }
  }

  std::size_t add_checkerboard_material()
  {
    std::array<double, 2> low{}, high{};
    for(const auto& corners : m_images)
      for(const Image& image : corners)
        for(int c = 0; c < 2; ++c) {
          low[c] = (std::min)(low[c], image[c]);
          high[c] = (std::max)(high[c], image[c]);
        }
    const auto choice = FFM::internal::choose_checkerboard((std::max)(high[0] - low[0], high[1] - low[1]));
    Json& json = m_container.json;
    const auto add = [&](const char* key, Json object) {
      list(json, key);
      json[key].push_back(std::move(object));
      return json[key].size() - 1;
    };
    const std::size_t view = m_container.add_view(FFM::internal::checkerboard_PNG(1024 / choice.squares * choice.squares, choice.squares));
    const std::size_t image = add("images", {{"name", "checkerboard"}, {"mimeType", "image/png"}, {"bufferView", view}});
    Json texture = {{"index", add("textures", {{"source", image}})}};
    if(m_request.uv_set != 0)
      texture["texCoord"] = m_request.uv_set;
    if(choice.pattern_scale != 1) {
      texture["extensions"]["KHR_texture_transform"]["scale"] = {choice.pattern_scale, choice.pattern_scale};
      const Json& used = list(json, "extensionsUsed");
      if(std::find(used.begin(), used.end(), Json("KHR_texture_transform")) == used.end())
        json["extensionsUsed"].push_back("KHR_texture_transform");
    }
    return add("materials", {{"name", "checkerboard"}, {"pbrMetallicRoughness", {{"baseColorTexture", texture}, {"metallicFactor", 0}}}});
  }

  // Once.
  void say(const std::string& what)
  {
    if(m_note.find(what) == std::string::npos)
      m_note += (m_note.empty() ? "" : "; ") + what;
  }

  const Gltf_request& m_request;
  const Corner_images& m_images;
  Gltf_container m_container;
  Gltf_meshes m_meshes;
  std::string m_semantics, m_note;
  std::vector<std::size_t> m_first;            // triangle of each primitive
  std::map<std::size_t, std::size_t> m_longer; // accessors that are made for the vertices at hand, by the old ones
};

} // namespace

std::string with_gltf_images(const Gltf_request& request, const Corner_images& images, std::string& note)
{
  return Gltf_writer(request, images).write(note);
}

namespace {

// The points of an object in single precision, numbered as its polygons name them, with their box.
class Object_points
{
public:
  explicit Object_points(const std::vector<Kernel::Point_3>& points) : m_points(points) {}

  std::uint32_t operator()(std::size_t v)
  {
    const auto entry = m_numbers.emplace(v, static_cast<std::uint32_t>(m_numbers.size()));
    for(int c = 0; entry.second && c < 3; ++c) {
      const float x = static_cast<float>(m_points[v][c]);
      if(!std::isfinite(x))
        throw Failure{Status::result_not_representable,
                      "vertex number " + std::to_string(v) + " has a coordinate that single precision, which glTF has, cannot hold"};
      append_bytes(m_bytes, x);
      const bool is_first = m_numbers.size() == 1;
      m_low[c] = is_first ? x : (std::min)(m_low[c], x);
      m_high[c] = is_first ? x : (std::max)(m_high[c], x);
    }
    return entry.first->second;
  }

  std::size_t size() const { return m_numbers.size(); }

  std::size_t add(Gltf_container& container) const
  {
    return add_accessor(container, {{"bufferView", container.add_view(m_bytes, 0, gltf_vertex_data)},
                                    {"componentType", gltf_float},
                                    {"count", m_numbers.size()},
                                    {"type", "VEC3"},
                                    {"min", m_low},
                                    {"max", m_high}});
  }

private:
  const std::vector<Kernel::Point_3>& m_points;
  std::unordered_map<std::size_t, std::uint32_t> m_numbers;
  std::string m_bytes;
  std::array<float, 3> m_low{}, m_high{};
};

} // namespace

std::string gltf_text(const Surface& triangles)
{
  Gltf_container container("", R"({"asset": {"version": "2.0", "generator": "flip_free_maps"}, "scene": 0, "scenes": [{"nodes": []}]})");
  Json& json = container.json;
  for(std::size_t begin = 0, end = 0; begin < triangles.polygons.size(); begin = end) {
    Object_points number(triangles.points);
    std::vector<std::uint32_t> corners;
    for(; end < triangles.polygons.size() && (triangles.objects.empty() || triangles.objects[end] == triangles.objects[begin]); ++end)
      for(const std::size_t v : triangles.polygons[end])
        corners.push_back(number(v));
    Json primitive = {{"attributes", {{"POSITION", number.add(container)}}}, {"indices", add_indices(container, corners, number.size())}};
    Json mesh = Json::object(), node = {{"mesh", list(json, "meshes").size()}};
    const std::string name = triangles.objects.empty() ? "" : triangles.object_names[triangles.objects[begin]];
    if(!name.empty())
      mesh["name"] = node["name"] = name;
    mesh["primitives"].push_back(primitive);
    json["scenes"][0]["nodes"].push_back(list(json, "nodes").size());
    json["meshes"].push_back(mesh);
    json["nodes"].push_back(node);
  }
  return container.written("new.glb");
}

} // namespace program
