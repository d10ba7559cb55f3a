// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_compaction.h"

#include <algorithm>

namespace program {

namespace {

using References = std::vector<Json*>;

void add(Json& object, const char* key, References& result)
{
  if(member(object, key) != nullptr)
    result.push_back(&object[key]);
}

void add_all(Json& object, References& result)
{
  for(auto& [key, value] : object.items())
    result.push_back(&value);
}

template <typename Visit>
void for_each_in(Json& object, const char* key, Visit&& visit)
{
  if(!list(object, key).empty())
    for(Json& element : object[key])
      visit(element);
}

References accessor_references(Json& document)
{
  References result;
  for_each_in(document, "meshes", [&](Json& mesh) {
    for_each_in(mesh, "primitives", [&](Json& primitive) {
      add(primitive, "indices", result);
      if(member(primitive, "attributes") != nullptr)
        add_all(primitive["attributes"], result);
      for_each_in(primitive, "targets", [&](Json& target) { add_all(target, result); });
    });
  });
  for_each_in(document, "skins", [&](Json& skin) { add(skin, "inverseBindMatrices", result); });
  for_each_in(document, "animations", [&](Json& animation) {
    for_each_in(animation, "samplers", [&](Json& sampler) {
      add(sampler, "input", result);
      add(sampler, "output", result);
    });
  });
  return result;
}

References view_references(Json& document)
{
  References result;
  for_each_in(document, "accessors", [&](Json& accessor) {
    add(accessor, "bufferView", result);
    if(member(accessor, "sparse") != nullptr)
      for(const char* key : {"indices", "values"})
        if(member(accessor["sparse"], key) != nullptr)
          add(accessor["sparse"][key], "bufferView", result);
  });
  for_each_in(document, "images", [&](Json& image) { add(image, "bufferView", result); });
  return result;
}

bool is_harmless(const std::string& extension)
{
  for(const char* beginning : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_mesh_quantization", "EXT_texture_", "MSFT_texture_"})
    if(extension.compare(0, std::string(beginning).size(), beginning) == 0)
      return true;
  return false;
}

bool has_other_extensions(const Json& value)
{
  if(const Json* extensions = member(value, "extensions"))
    for(const auto& entry : extensions->items())
      if(!is_harmless(entry.key()))
        return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), has_other_extensions);
}

// Which of some elements are in use. What is no number of an element refers to nothing.
std::vector<char> used(const References& references, std::size_t size)
{
  std::vector<char> result(size, 0);
  for(const Json* reference : references)
    if(reference->is_number_unsigned() && reference->get<std::size_t>() < size)
      result[reference->get<std::size_t>()] = 1;
  return result;
}

// Those that were in use and are not any more.
std::vector<char> abandoned(const std::vector<char>& before, const std::vector<char>& after)
{
  std::vector<char> result(after.size(), 0);
  for(std::size_t i = 0; i < before.size(); ++i)
    result[i] = before[i] && !after[i];
  return result;
}

void renumber(const References& references, const std::vector<char>& is_removed)
{
  std::vector<std::size_t> numbers;
  std::size_t next = 0;
  for(const char removed : is_removed)
    numbers.push_back(removed ? next : next++);
  for(Json* reference : references)
    if(reference->is_number_unsigned() && reference->get<std::size_t>() < numbers.size())
      *reference = numbers[reference->get<std::size_t>()];
}

} // namespace

Gltf_compaction::Gltf_compaction(Gltf_container& container)
  : m_container(container),
    m_had_accessors(used(accessor_references(container.json), list(container.json, "accessors").size())),
    m_had_views(used(view_references(container.json), list(container.json, "bufferViews").size()))
{}

void Gltf_compaction::finish(const std::string& path)
{
  Json& json = m_container.json;
  if(has_other_extensions(json))
    return;
  References references = accessor_references(json);
  const std::vector<char> accessors = abandoned(m_had_accessors, used(references, list(json, "accessors").size()));
  renumber(references, accessors);
  Json left = Json::array();
  for(std::size_t i = 0; i < accessors.size(); ++i)
    if(!accessors[i])
      left.push_back(std::move(json["accessors"][i]));
  if(!accessors.empty())
    json["accessors"] = std::move(left);
  references = view_references(json);
  const std::vector<char> views = abandoned(m_had_views, used(references, list(json, "bufferViews").size()));
  renumber(references, views);
  m_container.remove_views(views, path);
}

} // namespace program
