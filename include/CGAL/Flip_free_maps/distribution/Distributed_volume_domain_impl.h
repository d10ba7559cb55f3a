// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Distributed_volume_domain.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_volume_domain::load(const Positions<3>& points, const std::vector<Tetrahedron>& tetrahedra,
                                                                  const std::vector<std::int64_t>& handles, std::string& message)
{
  clear();
  m_slices = internal::Slices(world(), static_cast<std::size_t>(points.cols()));
  const auto is_vertex = [&](std::int64_t v) { return v >= 0 && v < m_slices.size(); };
  const auto is_tetrahedron = [&](const Tetrahedron& t) { return std::all_of(t.begin(), t.end(), is_vertex); };
  if(world().any(!std::all_of(tetrahedra.begin(), tetrahedra.end(), is_tetrahedron) ||
                 !std::all_of(handles.begin(), handles.end(), is_vertex))) {
    message = "a tetrahedron or a handle has a vertex that is not among the " + std::to_string(m_slices.size()) + " points";
    return Status::invalid_option;
  }
  std::vector<Numbered> local = at_slices(tetrahedra);
  const internal::Graph_slice graph = graph_of(local);
  std::vector<std::int32_t> owners;
  if(!internal::partition_graph(graph, world(), owners)) {
    message = "the mesh could not be divided into parts";
    return Status::linear_solver_failed;
  }
  local = at_parts(local, owners);
  // Vertices without neighbours are those of no tetrahedron.
  for(std::size_t v = 0; v < owners.size(); ++v)
    if(graph.begin[v] == graph.begin[v + 1])
      owners[v] = -1;
  number_vertices(local, handles, owners);
  const Positions<3> part = to_parts(points);
  return finish([&](std::int64_t v) { return Eigen::Vector3d(part.col(number(v))); }, message);
}

// The tetrahedra of the vertices in this rank's slice.
CGAL_FLIP_FREE_MAPS_INLINE std::vector<Distributed_volume_domain::Numbered> Distributed_volume_domain::at_slices(
  const std::vector<Tetrahedron>& tetrahedra) const
{
  const internal::Slices numbers(world(), tetrahedra.size());
  std::vector<std::vector<Numbered>> parts(world().size());
  for(std::size_t e = 0; e < tetrahedra.size(); ++e)
    for(std::int64_t v : tetrahedra[e])
      parts[m_slices.rank_of(v)].push_back({numbers.first() + static_cast<std::int64_t>(e), tetrahedra[e]});
  for(auto& part : parts)
    part.erase(std::unique(part.begin(), part.end()), part.end());
  std::vector<Numbered> result;
  for(const auto& part : world().exchange(parts))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

// The vertices of the slice with the vertices that they share tetrahedra with.
CGAL_FLIP_FREE_MAPS_INLINE internal::Graph_slice Distributed_volume_domain::graph_of(const std::vector<Numbered>& tetrahedra) const
{
  const std::size_t n = static_cast<std::size_t>(m_slices.own_size());
  std::vector<std::vector<std::int64_t>> neighbors(n);
  internal::Graph_slice graph;
  graph.weights.assign(n, 0);
  for(const Numbered& tetrahedron : tetrahedra)
    for(std::int64_t v : tetrahedron.vertices)
      if(m_slices.is_own(v)) {
        const std::size_t i = static_cast<std::size_t>(v - m_slices.first());
        ++graph.weights[i];
        for(std::int64_t w : tetrahedron.vertices)
          if(w != v)
            neighbors[i].push_back(w);
      }
  graph.begin.assign(1, 0);
  for(auto& others : neighbors) {
    std::sort(others.begin(), others.end());
    graph.neighbors.insert(graph.neighbors.end(), others.begin(), std::unique(others.begin(), others.end()));
    graph.begin.push_back(static_cast<std::int64_t>(graph.neighbors.size()));
    others = {};
  }
  return graph;
}

// The tetrahedra of the vertices that this rank owns.
CGAL_FLIP_FREE_MAPS_INLINE std::vector<Distributed_volume_domain::Numbered> Distributed_volume_domain::at_parts(
  const std::vector<Numbered>& tetrahedra, const std::vector<std::int32_t>& owners) const
{
  std::vector<std::vector<Numbered>> parts(world().size());
  for(const Numbered& tetrahedron : tetrahedra)
    for(std::int64_t v : tetrahedron.vertices)
      if(m_slices.is_own(v))
        parts[owners[v - m_slices.first()]].push_back(tetrahedron);
  for(auto& part : parts)
    part.erase(std::unique(part.begin(), part.end()), part.end());
  std::vector<Numbered> result;
  for(const auto& part : world().exchange(parts))
    result.insert(result.end(), part.begin(), part.end());
  sort_and_make_unique(result);
  return result;
}

// Who owns the vertices, in the order in which they are given.
CGAL_FLIP_FREE_MAPS_INLINE std::vector<Distributed_volume_domain::Place> Distributed_volume_domain::places_of(
  const std::vector<std::int64_t>& vertices, const std::vector<std::int32_t>& owners) const
{
  std::vector<std::vector<std::int64_t>> questions(world().size());
  for(std::int64_t v : vertices)
    questions[m_slices.rank_of(v)].push_back(v);
  std::vector<std::vector<Place>> answers;
  for(const auto& question : world().exchange(questions)) {
    answers.emplace_back();
    for(std::int64_t v : question)
      answers.back().push_back({v, owners[v - m_slices.first()]});
  }
  answers = world().exchange(answers);
  std::vector<std::size_t> next(answers.size(), 0);
  std::vector<Place> result;
  for(std::int64_t v : vertices) {
    const std::size_t r = m_slices.rank_of(v);
    result.push_back(answers[r][next[r]++]);
  }
  return result;
}

// Gives the owned vertices, the ghosts, and the handles elsewhere their numbers, and adds the tetrahedra, counted ones first.
CGAL_FLIP_FREE_MAPS_INLINE void Distributed_volume_domain::number_vertices(std::vector<Numbered>& tetrahedra,
                                                                           const std::vector<std::int64_t>& handles,
                                                                           const std::vector<std::int32_t>& owners)
{
  std::vector<std::int64_t> vertices;
  for(const Numbered& tetrahedron : tetrahedra)
    vertices.insert(vertices.end(), tetrahedron.vertices.begin(), tetrahedron.vertices.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Place> ghosts;
  for(const Place& place : places_of(vertices, owners))
    if(place.owner == world().rank())
      add_vertex(place.vertex);
    else
      ghosts.push_back(place);
  Mpi_world::Part part;
  part.owned_vertices = static_cast<std::int32_t>(this->vertices().size());
  std::sort(ghosts.begin(), ghosts.end(),
            [](const Place& a, const Place& b) { return std::tie(a.owner, a.vertex) < std::tie(b.owner, b.vertex); });
  for(const Place& ghost : ghosts)
    add_vertex(ghost.vertex);
  part.neighbors = neighbors(ghosts);
  for(const Place& handle : places_of(handles, owners))
    if(handle.owner >= 0)
      add_vertex(handle.vertex);
  part.global_numbers = this->vertices();

  // The owner of the least vertex counts a tetrahedron.
  const auto is_counted = [&](const Numbered& tetrahedron) {
    return number(*std::min_element(tetrahedron.vertices.begin(), tetrahedron.vertices.end())) < part.owned_vertices;
  };
  const auto others = std::stable_partition(tetrahedra.begin(), tetrahedra.end(), is_counted);
  part.counted_elements = others - tetrahedra.begin();
  for(const Numbered& tetrahedron : tetrahedra)
    add(tetrahedron.vertices);
  // The worlds share their state.
  Mpi_world(world()).set_part(std::move(part));
}

// Ghosts are sorted by their owners, which learn here whose ghosts their vertices are.
CGAL_FLIP_FREE_MAPS_INLINE std::vector<Mpi_world::Neighbor> Distributed_volume_domain::neighbors(const std::vector<Place>& ghosts) const
{
  std::vector<std::vector<std::int64_t>> wanted(world().size());
  for(const Place& ghost : ghosts)
    wanted[ghost.owner].push_back(ghost.vertex);
  const std::vector<std::vector<std::int64_t>> given = world().exchange(wanted);
  std::vector<Mpi_world::Neighbor> result;
  for(int r = 0; r < world().size(); ++r) {
    if(wanted[r].empty() && given[r].empty())
      continue;
    Mpi_world::Neighbor neighbor;
    neighbor.rank = r;
    for(std::int64_t v : given[r])
      neighbor.owned.push_back(number(v));
    for(std::int64_t v : wanted[r])
      neighbor.ghosts.push_back(number(v));
    result.push_back(std::move(neighbor));
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE Positions<3> Distributed_volume_domain::to_parts(const Positions<3>& slice) const
{
  std::vector<std::vector<std::int64_t>> questions(world().size());
  for(std::int64_t v : vertices())
    questions[m_slices.rank_of(v)].push_back(v);
  std::vector<std::vector<std::array<double, 3>>> answers;
  for(const auto& question : world().exchange(questions)) {
    answers.emplace_back();
    for(std::int64_t v : question) {
      const auto place = slice.col(v - m_slices.first());
      answers.back().push_back({place[0], place[1], place[2]});
    }
  }
  answers = world().exchange(answers);
  std::vector<std::size_t> next(answers.size(), 0);
  Positions<3> result(3, vertices().size());
  for(std::size_t i = 0; i < vertices().size(); ++i) {
    const std::size_t r = m_slices.rank_of(vertices()[i]);
    const std::array<double, 3>& place = answers[r][next[r]++];
    result.col(i) << place[0], place[1], place[2];
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_volume_domain::to_slices(const Positions<3>& part, Positions<3>& slice) const
{
  std::vector<std::vector<std::pair<std::int64_t, std::array<double, 3>>>> places(world().size());
  const std::int32_t owned = world().owned_vertices(domain().number_of_vertices);
  for(std::int32_t i = 0; i < owned; ++i) {
    const std::int64_t v = vertices()[i];
    places[m_slices.rank_of(v)].push_back({v, {part(0, i), part(1, i), part(2, i)}});
  }
  for(const auto& from : world().exchange(places))
    for(const auto& [v, place] : from)
      slice.col(v - m_slices.first()) << place[0], place[1], place[2];
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H
