// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "PLY_text.h"
#include "readers.h"

namespace program {

namespace {

// What the properties of vertices and faces mean.
struct PLY_roles
{
  const PLY_property* coordinates[3] = {};
  const PLY_property* vertex_images[2] = {};
  const PLY_property* corners = nullptr;
  const PLY_property* images = nullptr; // of the corners of a face
};

std::string find_roles(const std::vector<PLY_element>& elements, PLY_roles& roles)
{
  for(const PLY_element& element : elements)
    for(const PLY_property& property : element.properties) {
      const std::string& name = property.name;
      const int c = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : 3;
      const int t = name == "s" || name == "u" || name == "texture_u" ? 0 : name == "t" || name == "v" || name == "texture_v" ? 1 : 2;
      if(element.name == "vertex" && c < 3) {
        if(property.is_list)
          return "the coordinate " + name + " of vertices is a list";
        if(roles.coordinates[c] != nullptr)
          return "vertices have two coordinates " + name;
        roles.coordinates[c] = &property;
      } else if(element.name == "vertex" && t < 2 && !property.is_list)
        roles.vertex_images[t] = &property;
      else if(element.name == "face" && (name == "vertex_indices" || name == "vertex_index")) {
        if(!property.is_list)
          return "the property " + name + " of faces is no list";
        roles.corners = &property;
      } else if(element.name == "face" && name == "texcoord" && property.is_list)
        roles.images = &property;
    }
  for(const PLY_property* coordinate : roles.coordinates)
    if(coordinate == nullptr)
      return "vertices have not the properties x, y and z";
  for(const PLY_element& element : elements)
    if(element.name == "face" && element.count > 0 && roles.corners == nullptr)
      return "faces have no list of the name vertex_indices or vertex_index";
  return "";
}

std::string append_polygon(std::size_t i, const std::vector<double>& values, Polygon_file& file)
{
  std::vector<std::size_t> polygon;
  for(const double value : values) {
    if(!(value >= 0 && value < 4294967296.) || value != std::floor(value))
      return "face number " + std::to_string(i) + " (from 0) names a vertex that does not exist";
    polygon.push_back(static_cast<std::size_t>(value));
  }
  file.polygons.push_back(std::move(polygon));
  return "";
}

std::string finite_error(const char* what, std::size_t i, const std::vector<double>& values)
{
  for(const double value : values)
    if(!std::isfinite(value))
      return std::string("a texture coordinate of ") + what + " number " + std::to_string(i) + " (from 0) is not a finite number";
  return "";
}

// Two numbers for each corner; faces with other lists, as the empty one, have no texture coordinates.
void pair_up(const std::vector<std::vector<double>>& numbers, Polygon_file& file)
{
  file.images.resize(file.polygons.size());
  for(std::size_t i = 0; i < file.polygons.size(); ++i)
    if(numbers[i].size() == 2 * file.polygons[i].size())
      for(std::size_t k = 0; k < file.polygons[i].size(); ++k)
        file.images[i].push_back({numbers[i][2 * k], numbers[i][2 * k + 1]});
}

} // namespace

std::string read_PLY(std::string_view text, bool with_images, Polygon_file& file)
{
  PLY_text ply(text);
  PLY_roles roles;
  std::string error = ply.read_header();
  if(error.empty())
    error = find_roles(ply.elements(), roles);
  if(!error.empty())
    return error;
  const bool has_vertex_images = roles.vertex_images[0] != nullptr && roles.vertex_images[1] != nullptr;
  std::vector<Image> vertex_images;
  std::vector<std::vector<double>> numbers;
  error = ply.for_each_property([&](const PLY_element& element, std::size_t i, const PLY_property& property,
                                    const std::vector<double>& values, std::size_t, std::size_t) -> std::string {
    if(element.name == "vertex") {
      if(&property == &element.properties.front()) {
        file.points.emplace_back();
        vertex_images.emplace_back();
      }
      for(int c = 0; c < 3; ++c)
        if(&property == roles.coordinates[c])
          file.points.back()[c] = values[0];
      for(int c = 0; c < 2; ++c)
        if(with_images && &property == roles.vertex_images[c]) {
          vertex_images.back()[c] = values[0];
          return finite_error("vertex", i, values);
        }
    } else if(&property == roles.corners)
      return append_polygon(i, values, file);
    else if(with_images && &property == roles.images) {
      numbers.push_back(values);
      return finite_error("face", i, values);
    }
    return "";
  });
  if(!error.empty() || !with_images)
    return error;
  if(roles.images != nullptr)
    pair_up(numbers, file);
  else if(has_vertex_images)
    for(const auto& polygon : file.polygons) {
      file.images.emplace_back();
      for(const std::size_t v : polygon)
        file.images.back().push_back(v < vertex_images.size() ? vertex_images[v] : Image());
    }
  return "";
}

} // namespace program
