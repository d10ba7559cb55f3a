// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_nodes.h"

#include <cstdint>

namespace program {

namespace {

// The numbers of an array, or those given if there is none.
std::vector<double> numbers(const Json& node, const char* key, std::vector<double> result, const std::string& who)
{
  const Json* value = member(node, key);
  if(value == nullptr)
    return result;
  check(value->is_array() && value->size() == result.size(), who + ": " + key + " has not " + std::to_string(result.size()) + " numbers");
  for(std::size_t i = 0; i < result.size(); ++i) {
    check((*value)[i].is_number(), who + ": " + key + " holds what is no number");
    result[i] = (*value)[i].get<double>();
  }
  return result;
}

Eigen::Affine3d placement_of(const Json& node, const std::string& who)
{
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  if(member(node, "matrix") != nullptr) {
    const std::vector<double> m = numbers(node, "matrix", std::vector<double>(16), who);
    placement.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    return placement;
  }
  const std::vector<double> t = numbers(node, "translation", {0, 0, 0}, who), r = numbers(node, "rotation", {0, 0, 0, 1}, who),
                            s = numbers(node, "scale", {1, 1, 1}, who);
  placement.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  placement.rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
  placement.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return placement;
}

std::string name_of(const Json& object)
{
  const Json* name = member(object, "name");
  return name != nullptr && name->is_string() ? name->get<std::string>() : "";
}

// The placements of all nodes, from the roots down. Each node is below at most one other, or the file is refused.
std::vector<Eigen::Affine3d> placements(const Json& document)
{
  const std::size_t n = list(document, "nodes").size();
  std::vector<Eigen::Affine3d> result(n);
  std::vector<std::size_t> parent(n, n), pending;
  for(std::size_t i = 0; i < n; ++i) {
    const std::string who = "node number " + std::to_string(i) + " (from 0)";
    const Json& node = element(document, "nodes", i, who);
    result[i] = placement_of(node, who);
    for(const Json& child : list(node, "children")) {
      check(child.is_number_unsigned() && child.get<std::uint64_t>() < n, who + " has a child that does not exist");
      check(parent[child.get<std::size_t>()] == n, "node number " + child.dump() + " (from 0) is the child of two nodes");
      parent[child.get<std::size_t>()] = i;
    }
  }
  for(std::size_t i = 0; i < n; ++i)
    if(parent[i] == n)
      pending.push_back(i);
  std::size_t reached = 0;
  for(; !pending.empty(); ++reached) {
    const std::size_t i = pending.back();
    pending.pop_back();
    if(parent[i] != n)
      result[i] = result[parent[i]] * result[i];
    check(result[i].matrix().allFinite(), "node number " + std::to_string(i) + " (from 0) is placed by no finite numbers");
    for(const Json& child : list(document["nodes"][i], "children"))
      pending.push_back(child.get<std::size_t>());
  }
  check(reached == n, "its nodes are their own descendants");
  return result;
}

} // namespace

std::vector<Gltf_instance> gltf_instances(const Json& document)
{
  std::vector<Gltf_instance> instances;
  const Json &nodes = list(document, "nodes"), &meshes = list(document, "meshes");
  const std::vector<Eigen::Affine3d> all = placements(document);
  std::vector<char> is_shown(meshes.size(), 0);
  for(std::size_t i = 0; i < nodes.size(); ++i) {
    if(member(nodes[i], "mesh") == nullptr)
      continue;
    const std::string who = "node number " + std::to_string(i) + " (from 0)";
    const std::size_t mesh = count_of(nodes[i], "mesh", who);
    element(document, "meshes", mesh, who);
    is_shown[mesh] = 1;
    const std::string name = name_of(nodes[i]);
    instances.push_back(
      {mesh, name.empty() ? name_of(meshes[mesh]) : name, member(nodes[i], "skin") != nullptr ? Eigen::Affine3d::Identity() : all[i]});
  }
  for(std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
    if(!is_shown[mesh])
      instances.push_back({mesh, name_of(meshes[mesh]), Eigen::Affine3d::Identity()});
  return instances;
}

} // namespace program
