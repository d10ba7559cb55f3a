// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_H

#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A copy of the user's mesh of one type, so that mesh generators are instantiated once, checked to bound a volume.
class Closed_surface
{
public:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

  template <typename FaceGraph, typename VertexPointMap>
  Status load(const FaceGraph& surface, const VertexPointMap& vertex_points, std::string& message)
  {
    Status status = copy(surface, vertex_points, message);
    if(status == Status::success)
      status = check(message);
    return status;
  }

  const Mesh& mesh() const { return m_mesh; }
  const std::vector<std::array<std::int32_t, 3>>& triangles() const { return m_triangles; }
  std::int32_t number_of_components() const
  {
    return count_components(m_triangles, static_cast<std::int32_t>(m_mesh.number_of_vertices()));
  }
  double diagonal() const { return std::sqrt(CGAL::squared_distance(m_low, m_high)); }

private:
  template <typename FaceGraph, typename VertexPointMap>
  Status copy(const FaceGraph& surface, const VertexPointMap& vertex_points, std::string& message)
  {
    const auto null_face = boost::graph_traits<FaceGraph>::null_face();
    std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::int32_t> numbers;
    m_mesh.clear();
    m_triangles.clear();
    std::size_t i = 0;
    for(const auto f : faces(surface)) {
      auto h = halfedge(f, surface);
      if(next(next(next(h, surface), surface), surface) != h || next(next(h, surface), surface) == h) {
        message = numbered(i) + " is no triangle";
        return Status::not_triangular;
      }
      for(int k = 0; k < 3; ++k, h = next(h, surface)) {
        if(face(opposite(h, surface), surface) == null_face) {
          message = "the surface is not closed: " + numbered(i) + " has a border edge";
          return Status::non_manifold;
        }
        numbers.emplace(target(h, surface), -1);
      }
      ++i;
    }
    if(i == 0) {
      message = "the surface has no face";
      return Status::empty_mesh;
    }

    // In the order of the user's mesh, less the vertices without faces.
    for(const auto v : vertices(surface)) {
      const auto entry = numbers.find(v);
      if(entry == numbers.end())
        continue;
      const auto p = get(vertex_points, v);
      const Kernel::Point_3 point(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
      if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
        message = "a coordinate of the surface is NaN or infinite";
        return Status::non_finite_input;
      }
      entry->second = static_cast<std::int32_t>(m_mesh.number_of_vertices());
      m_mesh.add_vertex(point);
    }
    for(const auto f : faces(surface)) {
      auto h = halfedge(f, surface);
      std::array<std::int32_t, 3> triangle;
      for(int k = 0; k < 3; ++k, h = next(h, surface))
        triangle[k] = numbers.at(target(h, surface));
      using Vertex_index = Mesh::Vertex_index;
      if(m_mesh.add_face(Vertex_index(triangle[0]), Vertex_index(triangle[1]), Vertex_index(triangle[2])) == Mesh::null_face()) {
        message = "several sheets of the surface meet at " + numbered(m_triangles.size());
        return Status::non_manifold;
      }
      m_triangles.push_back(triangle);
    }
    return Status::success;
  }

  static std::string numbered(std::size_t face) { return "face number " + std::to_string(face); }

  Status check(std::string& message);

  Mesh m_mesh;
  std::vector<std::array<std::int32_t, 3>> m_triangles;
  Kernel::Point_3 m_low{0, 0, 0};
  Kernel::Point_3 m_high{0, 0, 0};
};

// Checks the options of a mesh generator and loads the surface that it is to fill, with the named parameters of its function.
template <typename Options, typename FaceGraph, typename NamedParameters>
Status load_closed_surface(const FaceGraph& surface, const Options& options, const NamedParameters& np, Closed_surface& closed,
                           std::string& message)
{
  if(!options.is_valid(&message))
    return Status::invalid_option;
  const auto vertex_points = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                                get_const_property_map(CGAL::vertex_point, surface));
  return closed.load(surface, vertex_points, message);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/tetrahedralization/internal/Closed_surface_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_H
