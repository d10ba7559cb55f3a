// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A triangle mesh as flat arrays. Halfedge 3 f + k goes from corner k of face f to the next one, so it names the corner, too.
// Lengths are in units of the bounding box, whose longest side is 1.
struct Cut_surface
{
  std::vector<std::array<std::int32_t, 3>> faces;
  std::vector<std::int32_t> opposite;      // by halfedge, -1 on the border
  std::vector<std::int32_t> edge_of;       // by halfedge
  std::vector<std::int32_t> edge_halfedge; // by edge, one of its halfedges
  std::vector<double> lengths;             // by edge
  std::vector<double> areas;               // by face
  std::vector<char> is_seam, is_feature;   // by edge
  std::vector<char> is_rigid;              // by edge, what must not be cut: a diagonal of a polygon; a path of other edges leads around
  Positions<3> points;
  double scale = 1; // of the user's units

  static std::int32_t next(std::int32_t h) { return next_in_triangle(h); }
  static std::int32_t prev(std::int32_t h) { return prev_in_triangle(h); }
  std::int32_t source(std::int32_t h) const { return faces[h / 3][h % 3]; }
  std::int32_t target(std::int32_t h) const { return source(next(h)); }
  std::int32_t number_of_faces() const { return static_cast<std::int32_t>(faces.size()); }
  std::int32_t number_of_edges() const { return static_cast<std::int32_t>(edge_halfedge.size()); }
  std::int32_t number_of_vertices() const { return static_cast<std::int32_t>(points.cols()); }
  bool is_border(std::int32_t edge) const { return opposite[edge_halfedge[edge]] < 0; }
};

// Brings the points into units of the bounding box, and fills in areas and lengths.
Status measure_cut_surface(Cut_surface& surface, std::string& message);

// Takes linked triangles. `is_seam` and `is_feature` tell about halfedges, the same on both sides of an edge.
Status load_cut_surface(const Linked_triangles& triangles, const std::vector<char>& is_seam, const std::vector<char>& is_feature,
                        Cut_surface& surface, std::string& message);

// Reads a mesh; `edges` are its edges by their numbers in the arrays. `is_seam` and `is_feature` tell about edges of the mesh.
template <typename TriangleMesh, typename VertexPointMap, typename IsSeam, typename IsFeature>
Status load_cut_surface(const TriangleMesh& mesh, const VertexPointMap& vertex_points, IsSeam&& is_seam, IsFeature&& is_feature,
                        Cut_surface& surface, std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor>& edges,
                        std::string& message)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  std::vector<typename Graph_traits::face_descriptor> mesh_faces;
  std::unordered_map<typename Graph_traits::vertex_descriptor, std::int32_t> vertex_numbers;
  std::unordered_map<typename Graph_traits::face_descriptor, std::int32_t> face_numbers;
  const std::size_t most = static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)() / 4);
  for(const auto f : faces(mesh)) {
    const auto number = std::to_string(mesh_faces.size());
    const auto h = halfedge(f, mesh);
    if(next(next(next(h, mesh), mesh), mesh) != h || next(next(h, mesh), mesh) == h) {
      message = "the mesh must consist of triangles; not so face number " + number;
      return Status::not_triangular;
    }
    std::array<std::int32_t, 3> face;
    auto g = h;
    for(std::int32_t& v : face) {
      const auto entry = vertex_numbers.emplace(source(g, mesh), static_cast<std::int32_t>(vertices.size()));
      if(entry.second)
        vertices.push_back(source(g, mesh));
      v = entry.first->second;
      g = next(g, mesh);
    }
    if(face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
      message = "a vertex occurs twice in face number " + number;
      return Status::non_manifold;
    }
    face_numbers.emplace(f, static_cast<std::int32_t>(mesh_faces.size()));
    mesh_faces.push_back(f);
    surface.faces.push_back(face);
    if(mesh_faces.size() > most) {
      message = "the mesh has more faces than 32-bit numbers can count";
      return Status::out_of_memory;
    }
  }
  if(mesh_faces.empty()) {
    message = "the mesh has no faces";
    return Status::empty_mesh;
  }

  surface.opposite.assign(3 * mesh_faces.size(), -1);
  surface.edge_of.assign(3 * mesh_faces.size(), -1);
  for(std::size_t i = 0; i < mesh_faces.size(); ++i) {
    auto h = halfedge(mesh_faces[i], mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const std::size_t here = 3 * i + k;
      const auto neighbor = face(opposite(h, mesh), mesh);
      if(neighbor != Graph_traits::null_face()) {
        const std::int32_t j = face_numbers.at(neighbor);
        auto g = halfedge(neighbor, mesh);
        int m = 0;
        while(m < 2 && g != opposite(h, mesh)) {
          g = next(g, mesh);
          ++m;
        }
        surface.opposite[here] = 3 * j + m;
        if(surface.edge_of[3 * j + m] >= 0) {
          surface.edge_of[here] = surface.edge_of[3 * j + m];
          continue;
        }
      }
      surface.edge_of[here] = surface.number_of_edges();
      surface.edge_halfedge.push_back(static_cast<std::int32_t>(here));
      edges.push_back(edge(h, mesh));
      surface.is_seam.push_back(neighbor != Graph_traits::null_face() && is_seam(edges.back()));
      surface.is_feature.push_back(is_feature(edges.back()));
    }
  }

  surface.points.resize(3, vertices.size());
  for(std::size_t v = 0; v < vertices.size(); ++v) {
    const auto p = get(vertex_points, vertices[v]);
    surface.points.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
  }
  surface.is_rigid.assign(surface.edge_halfedge.size(), 0);
  return measure_cut_surface(surface, message);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_SURFACE_H
