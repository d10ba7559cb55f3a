// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_MESH_DIVISION_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_MESH_DIVISION_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/distribution/internal/Slices.h>
#include <CGAL/Flip_free_maps/distribution/internal/partition_graph.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The way of a mesh from slices, consecutive points and simplices on each rank, to parts: vertices that a rank owns, the simplices
// around them, and the other vertices of these. All ranks call all functions that are not of one simplex.
template <std::size_t N>
class Mesh_division
{
public:
  using Simplex = std::array<std::int64_t, N>;

  // A simplex with its number among those of all ranks.
  struct Numbered
  {
    std::int64_t number;
    Simplex vertices;

    bool operator<(const Numbered& other) const { return number < other.number; }
    bool operator==(const Numbered& other) const { return number == other.number; }
  };

  explicit Mesh_division(const Mpi_world& world) : m_world(world) {}

  // Divides the mesh, and tells the world. `find_known(at_slices, known, message)` is given the simplices of the vertices in this rank's
  // slice, finds the vertices that all ranks have to know, the same on all of them, and returns a status.
  template <typename FindKnown>
  Status divide(std::size_t points, const std::vector<Simplex>& simplices, FindKnown&& find_known, std::string& message);

  const Slices& slices() const { return m_slices; }

  // The local vertices: those that are owned, ghosts, and those that are to be known.
  const std::vector<std::int64_t>& vertices() const { return m_vertices; }

  // The number of a vertex among the local ones.
  std::int32_t number(std::int64_t vertex) const { return m_numbers.at(vertex); }

  // The local simplices, counted ones first.
  const std::vector<Numbered>& simplices() const { return m_simplices; }

  // Once they are elsewhere.
  void forget_simplices() { m_simplices = {}; }

  // Of columns for the slice of points, those of the local vertices.
  template <int D>
  Positions<D> to_parts(const Positions<D>& slice) const;

  // Sets the columns of the slice of points whose vertices are owned to those of the local vertices.
  template <int D>
  void to_slices(const Positions<D>& part, Positions<D>& slice) const;

private:
  // What the rank that has a vertex in its slice knows of it.
  struct Place
  {
    std::int64_t vertex;
    std::int32_t owner; // -1 if no simplex has the vertex
  };

  static void sort_and_make_unique(std::vector<Numbered>& simplices)
  {
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }

  std::vector<Numbered> at_slices(const std::vector<Simplex>& simplices) const;
  Graph_slice graph_of(const std::vector<Numbered>& simplices) const;
  std::vector<Numbered> at_parts(const std::vector<Numbered>& simplices, const std::vector<std::int32_t>& owners) const;
  std::vector<Place> places_of(const std::vector<std::int64_t>& vertices, const std::vector<std::int32_t>& owners) const;
  std::vector<Mpi_world::Neighbor> neighbors(const std::vector<Place>& ghosts) const;
  void number_vertices(const std::vector<std::int64_t>& known, const std::vector<std::int32_t>& owners);

  void add_vertex(std::int64_t v)
  {
    if(m_numbers.emplace(v, static_cast<std::int32_t>(m_vertices.size())).second)
      m_vertices.push_back(v);
  }

  Mpi_world m_world;
  Slices m_slices;
  std::vector<std::int64_t> m_vertices;
  std::unordered_map<std::int64_t, std::int32_t> m_numbers;
  std::vector<Numbered> m_simplices;
};

template <std::size_t N>
template <typename FindKnown>
Status Mesh_division<N>::divide(std::size_t points, const std::vector<Simplex>& simplices, FindKnown&& find_known, std::string& message)
{
  m_slices = Slices(m_world, points);
  const auto is_vertex = [&](std::int64_t v) { return v >= 0 && v < m_slices.size(); };
  const auto is_simplex = [&](const Simplex& simplex) { return std::all_of(simplex.begin(), simplex.end(), is_vertex); };
  if(m_world.any(!std::all_of(simplices.begin(), simplices.end(), is_simplex))) {
    message = "an element has a vertex that is not among the " + std::to_string(m_slices.size()) + " points";
    return Status::invalid_option;
  }
  m_simplices = at_slices(simplices);
  std::vector<std::int64_t> known;
  const Status status = find_known(m_simplices, known, message);
  if(status != Status::success)
    return status;
  if(!std::all_of(known.begin(), known.end(), is_vertex)) {
    message = "a handle is not among the " + std::to_string(m_slices.size()) + " points";
    return Status::invalid_option;
  }
  const Graph_slice graph = graph_of(m_simplices);
  std::vector<std::int32_t> owners;
  if(!partition_graph(graph, m_world, owners)) {
    message = "the mesh could not be divided into parts";
    return Status::linear_solver_failed;
  }
  m_simplices = at_parts(m_simplices, owners);
  // Vertices without neighbours are those of no simplex.
  for(std::size_t v = 0; v < owners.size(); ++v)
    if(graph.begin[v] == graph.begin[v + 1])
      owners[v] = -1;
  number_vertices(known, owners);
  return Status::success;
}

// The simplices of the vertices in this rank's slice.
template <std::size_t N>
std::vector<typename Mesh_division<N>::Numbered> Mesh_division<N>::at_slices(const std::vector<Simplex>& simplices) const
{
  const Slices numbers(m_world, simplices.size());
  std::vector<std::vector<Numbered>> parts(m_world.size());
  for(std::size_t e = 0; e < simplices.size(); ++e)
    for(std::int64_t v : simplices[e])
      parts[m_slices.rank_of(v)].push_back({numbers.first() + static_cast<std::int64_t>(e), simplices[e]});
  for(auto& part : parts)
    part.erase(std::unique(part.begin(), part.end()), part.end());
  std::vector<Numbered> result;
  for(const auto& part : m_world.exchange(parts))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

// The vertices of the slice with the vertices that they share simplices with.
template <std::size_t N>
Graph_slice Mesh_division<N>::graph_of(const std::vector<Numbered>& simplices) const
{
  const std::size_t n = static_cast<std::size_t>(m_slices.own_size());
  std::vector<std::vector<std::int64_t>> neighbors(n);
  Graph_slice graph;
  graph.weights.assign(n, 0);
  for(const Numbered& simplex : simplices)
    for(std::int64_t v : simplex.vertices)
      if(m_slices.is_own(v)) {
        const std::size_t i = static_cast<std::size_t>(v - m_slices.first());
        ++graph.weights[i];
        for(std::int64_t w : simplex.vertices)
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

// The simplices of the vertices that this rank owns.
template <std::size_t N>
std::vector<typename Mesh_division<N>::Numbered> Mesh_division<N>::at_parts(const std::vector<Numbered>& simplices,
                                                                            const std::vector<std::int32_t>& owners) const
{
  std::vector<std::vector<Numbered>> parts(m_world.size());
  for(const Numbered& simplex : simplices)
    for(std::int64_t v : simplex.vertices)
      if(m_slices.is_own(v))
        parts[owners[v - m_slices.first()]].push_back(simplex);
  for(auto& part : parts)
    part.erase(std::unique(part.begin(), part.end()), part.end());
  std::vector<Numbered> result;
  for(const auto& part : m_world.exchange(parts))
    result.insert(result.end(), part.begin(), part.end());
  sort_and_make_unique(result);
  return result;
}

// Who owns the vertices, in the order in which they are given.
template <std::size_t N>
std::vector<typename Mesh_division<N>::Place> Mesh_division<N>::places_of(const std::vector<std::int64_t>& vertices,
                                                                          const std::vector<std::int32_t>& owners) const
{
  std::vector<std::vector<std::int64_t>> questions(m_world.size());
  for(std::int64_t v : vertices)
    questions[m_slices.rank_of(v)].push_back(v);
  std::vector<std::vector<Place>> answers;
  for(const auto& question : m_world.exchange(questions)) {
    answers.emplace_back();
    for(std::int64_t v : question)
      answers.back().push_back({v, owners[v - m_slices.first()]});
  }
  answers = m_world.exchange(answers);
  std::vector<std::size_t> next(answers.size(), 0);
  std::vector<Place> result;
  for(std::int64_t v : vertices) {
    const std::size_t r = m_slices.rank_of(v);
    result.push_back(answers[r][next[r]++]);
  }
  return result;
}

// Ghosts are sorted by their owners, which learn here whose ghosts their vertices are.
template <std::size_t N>
std::vector<Mpi_world::Neighbor> Mesh_division<N>::neighbors(const std::vector<Place>& ghosts) const
{
  std::vector<std::vector<std::int64_t>> wanted(m_world.size());
  for(const Place& ghost : ghosts)
    wanted[ghost.owner].push_back(ghost.vertex);
  const std::vector<std::vector<std::int64_t>> given = m_world.exchange(wanted);
  std::vector<Mpi_world::Neighbor> result;
  for(int r = 0; r < m_world.size(); ++r) {
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

// Gives the owned vertices, the ghosts, and the known ones elsewhere their numbers, and puts counted simplices first.
template <std::size_t N>
void Mesh_division<N>::number_vertices(const std::vector<std::int64_t>& known, const std::vector<std::int32_t>& owners)
{
  std::vector<std::int64_t> vertices;
  for(const Numbered& simplex : m_simplices)
    vertices.insert(vertices.end(), simplex.vertices.begin(), simplex.vertices.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Place> ghosts;
  for(const Place& place : places_of(vertices, owners))
    if(place.owner == m_world.rank())
      add_vertex(place.vertex);
    else
      ghosts.push_back(place);
  Mpi_world::Part part;
  part.owned_vertices = static_cast<std::int32_t>(m_vertices.size());
  std::sort(ghosts.begin(), ghosts.end(),
            [](const Place& a, const Place& b) { return std::tie(a.owner, a.vertex) < std::tie(b.owner, b.vertex); });
  for(const Place& ghost : ghosts)
    add_vertex(ghost.vertex);
  part.neighbors = neighbors(ghosts);
  for(const Place& place : places_of(known, owners))
    if(place.owner >= 0)
      add_vertex(place.vertex);
  part.global_numbers = m_vertices;

  // The owner of the least vertex counts a simplex.
  const auto is_counted = [&](const Numbered& simplex) {
    return number(*std::min_element(simplex.vertices.begin(), simplex.vertices.end())) < part.owned_vertices;
  };
  const auto others = std::stable_partition(m_simplices.begin(), m_simplices.end(), is_counted);
  part.counted_elements = others - m_simplices.begin();
  m_world.set_part(std::move(part));
}

template <std::size_t N>
template <int D>
Positions<D> Mesh_division<N>::to_parts(const Positions<D>& slice) const
{
  std::vector<std::vector<std::int64_t>> questions(m_world.size());
  for(std::int64_t v : m_vertices)
    questions[m_slices.rank_of(v)].push_back(v);
  std::vector<std::vector<std::array<double, D>>> answers;
  for(const auto& question : m_world.exchange(questions)) {
    answers.emplace_back();
    for(std::int64_t v : question) {
      answers.back().emplace_back();
      std::copy_n(slice.col(v - m_slices.first()).data(), D, answers.back().back().begin());
    }
  }
  answers = m_world.exchange(answers);
  std::vector<std::size_t> next(answers.size(), 0);
  Positions<D> result(D, m_vertices.size());
  for(std::size_t i = 0; i < m_vertices.size(); ++i) {
    const std::size_t r = m_slices.rank_of(m_vertices[i]);
    std::copy_n(answers[r][next[r]++].begin(), D, result.col(i).data());
  }
  return result;
}

template <std::size_t N>
template <int D>
void Mesh_division<N>::to_slices(const Positions<D>& part, Positions<D>& slice) const
{
  std::vector<std::vector<std::pair<std::int64_t, std::array<double, D>>>> places(m_world.size());
  const std::int32_t owned = m_world.owned_vertices(0);
  for(std::int32_t i = 0; i < owned; ++i) {
    places[m_slices.rank_of(m_vertices[i])].emplace_back();
    auto& place = places[m_slices.rank_of(m_vertices[i])].back();
    place.first = m_vertices[i];
    std::copy_n(part.col(i).data(), D, place.second.begin());
  }
  for(const auto& from : m_world.exchange(places))
    for(const auto& [v, place] : from)
      std::copy_n(place.begin(), D, slice.col(v - m_slices.first()).data());
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_MESH_DIVISION_H
