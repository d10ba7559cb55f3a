// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Distributed_disk.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_disk::load(const Positions<3>& points, const std::vector<Triangle>& triangles,
                                                         std::string& message)
{
  m_division = Division(m_world);
  m_domain = Simplicial_domain<2>();
  const internal::Slices slices(m_world, static_cast<std::size_t>(points.cols()));
  const auto find_known = [&](const auto& at_slices, std::vector<std::int64_t>& known, std::string& why) {
    const Status status = find_border(at_slices, slices, why);
    known = m_border;
    return status;
  };
  const Status status = m_division.divide(static_cast<std::size_t>(points.cols()), triangles, find_known, message);
  if(status != Status::success)
    return status;
  m_domain.number_of_vertices = static_cast<std::int32_t>(m_division.vertices().size());
  for(const auto& triangle : m_division.simplices()) {
    m_domain.elements.emplace_back();
    std::transform(triangle.vertices.begin(), triangle.vertices.end(), m_domain.elements.back().begin(),
                   [this](std::int64_t v) { return m_division.number(v); });
  }
  m_division.forget_simplices();
  for(std::int64_t v : m_border)
    m_domain.border.push_back(m_division.number(v));
  if(internal::count_components(m_domain.elements, m_domain.number_of_vertices, m_world) > 1) {
    message = "the surface has several connected components";
    return Status::several_components;
  }
  if(m_euler_characteristic != 1) {
    message = "the surface has handles, or sheets that meet at a vertex: it is not a disk";
    return Status::not_a_disk;
  }
  return measure(m_division.to_parts(points), message);
}

// The border edges, by the ranks that have the lesser vertex of an edge in their slice, and so all triangles around it.
CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_disk::find_border(const std::vector<Division::Numbered>& triangles,
                                                                const internal::Slices& slices, std::string& message)
{
  struct Side
  {
    std::array<std::int64_t, 2> edge; // ascending
    bool is_forward;
    bool operator<(const Side& other) const { return edge != other.edge ? edge < other.edge : is_forward < other.is_forward; }
    bool operator==(const Side& other) const { return edge == other.edge && is_forward == other.is_forward; }
  };
  std::vector<Side> sides;
  std::vector<std::int64_t> vertices;
  double faces = 0;
  bool is_manifold = true;
  for(const auto& triangle : triangles)
    for(int k = 0; k < 3; ++k) {
      const std::int64_t a = triangle.vertices[k], b = triangle.vertices[(k + 1) % 3];
      is_manifold = is_manifold && a != b;
      if(slices.is_own((std::min)(a, b)))
        sides.push_back({{(std::min)(a, b), (std::max)(a, b)}, a < b});
      if(slices.is_own(a))
        vertices.push_back(a);
      faces += slices.is_own(a) && a == *std::min_element(triangle.vertices.begin(), triangle.vertices.end()) ? 1 : 0;
    }
  std::sort(sides.begin(), sides.end());
  std::sort(vertices.begin(), vertices.end());
  const auto number = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  is_manifold = is_manifold && std::adjacent_find(sides.begin(), sides.end()) == sides.end();
  std::vector<std::array<std::int64_t, 2>> edges;
  double all_edges = 0;
  for(std::size_t i = 0; i < sides.size(); ++i, ++all_edges) {
    if(i + 1 < sides.size() && sides[i + 1].edge == sides[i].edge)
      ++i;
    else
      edges.push_back(sides[i].is_forward ? sides[i].edge : std::array<std::int64_t, 2>{sides[i].edge[1], sides[i].edge[0]});
  }
  m_euler_characteristic = m_world.sum(static_cast<double>(number) - all_edges + faces);
  if(m_world.sum(faces) == 0) {
    message = "the mesh has no faces";
    return Status::empty_mesh;
  }
  if(m_world.any(!is_manifold)) {
    message = "two faces have an edge in the same direction, or a face has a vertex twice";
    return Status::non_manifold;
  }
  return join_border(m_world.gather(edges), message);
}

CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_disk::join_border(const std::vector<std::array<std::int64_t, 2>>& edges, std::string& message)
{
  m_border.clear();
  std::map<std::int64_t, std::int64_t> next;
  for(const auto& edge : edges)
    if(!next.emplace(edge[0], edge[1]).second) {
      message = "several sheets of the surface meet at a vertex";
      return Status::non_manifold;
    }
  if(next.empty()) {
    message = "the surface is closed";
    return Status::no_border;
  }
  std::int64_t v = next.begin()->first;
  do {
    m_border.push_back(v);
    v = next[v];
  } while(v != m_border.front() && m_border.size() < edges.size());
  if(v == m_border.front() && m_border.size() == edges.size())
    return Status::success;
  message = "the surface has several borders: over several processes a disk has no holes";
  return Status::not_a_disk;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_disk::measure(Positions<3> points, std::string& message)
{
  if(m_world.any(!points.allFinite())) {
    message = "a coordinate of the mesh is NaN or infinite";
    return Status::non_finite_input;
  }
  // Halves, since the extent may overflow. The border is known to all ranks, so that none is without vertices.
  Eigen::Vector3d low = points.rowwise().minCoeff() / 2, high = points.rowwise().maxCoeff() / 2;
  for(int i = 0; i < 3; ++i) {
    low[i] = m_world.minimum(low[i]);
    high[i] = -m_world.minimum(-high[i]);
  }
  const double extent = 2 * (high - low).maxCoeff();
  if(!(extent > 0) || !std::isfinite(extent)) {
    message = extent > 0 ? "the extent of the mesh exceeds the range of double precision" : "all vertices of the mesh coincide";
    return extent > 0 ? Status::non_finite_input : Status::degenerate_rest_element;
  }
  points = ((points / 2).colwise() - low) / (extent / 2);
  const std::size_t m = m_domain.elements.size();
  const std::size_t counted = static_cast<std::size_t>(m_world.counted_elements(m_domain.number_of_elements()));
  m_domain.measures.resize(m);
  m_domain.rest_inverses.resize(m);
  double total = 0;
  bool is_flat = false;
  for(std::size_t e = 0; e < m && !is_flat; ++e) {
    const auto& v = m_domain.elements[e];
    is_flat =
      !internal::planar_rest_shape(points.col(v[0]), points.col(v[1]), points.col(v[2]), m_domain.rest_inverses[e], m_domain.measures[e]);
    total += e < counted && !is_flat ? m_domain.measures[e] : 0;
  }
  if(m_world.any(is_flat)) {
    message = "zero area, or none within double precision, has a face";
    return Status::degenerate_rest_element;
  }
  m_domain.rest_points.swap(points);
  m_domain.scale = extent;
  scale(m_world.sum(total));
  return Status::success;
}

// Scales the disk to area 1.
CGAL_FLIP_FREE_MAPS_INLINE void Distributed_disk::scale(double total)
{
  const double length = std::sqrt(total);
  for(std::size_t e = 0; e < m_domain.elements.size(); ++e) {
    m_domain.measures[e] /= total;
    m_domain.rest_inverses[e] *= length;
  }
  m_domain.rest_points /= length;
  m_domain.scale *= length;
  const std::size_t b = m_domain.border.size();
  for(std::size_t i = 0; i < b; ++i)
    m_domain.border_lengths.push_back(
      (m_domain.rest_points.col(m_domain.border[(i + 1) % b]) - m_domain.rest_points.col(m_domain.border[i])).norm());
}

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_disk::forget_border()
{
  m_domain.border.clear();
  m_domain.border_lengths.clear();
  // Vertices of elements are first.
  std::int32_t n = 0;
  for(const auto& triangle : m_domain.elements)
    for(std::int32_t v : triangle)
      n = (std::max)(n, v + 1);
  m_domain.number_of_vertices = n;
  m_domain.rest_points.conservativeResize(3, n);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_IMPL_H
