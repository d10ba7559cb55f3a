// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_OWN_MESH_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_OWN_MESH_H

#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

// A triangle mesh as a program without CGAL may have one: halfedges in arrays, points that are three numbers. Nothing in it is
// CGAL's; what CGAL wants to know stands below the class.
namespace own {

// A number that knows what it numbers.
template <int Kind>
struct Handle
{
  int i = -1;
  bool operator==(Handle other) const { return i == other.i; }
  bool operator!=(Handle other) const { return i != other.i; }
  bool operator<(Handle other) const { return i < other.i; }
};

using Vertex = Handle<0>;
using Halfedge = Handle<1>;
using Face = Handle<2>;
using Edge = Handle<3>;

// Halfedges 2e and 2e + 1 are opposite.
struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<Halfedge> of_vertex; // ends in it; on the border if the vertex is
  std::vector<Halfedge> of_face;
  std::vector<Vertex> target;
  std::vector<Halfedge> next, prev;
  std::vector<Face> face;

  Mesh(const std::vector<std::array<double, 3>>& corners, const std::vector<std::array<int, 3>>& triangles)
    : points(corners), of_vertex(corners.size())
  {
    std::map<std::pair<int, int>, Halfedge> halfedge;
    const auto find = [&](int v, int w) {
      if(halfedge.count({v, w}) == 0)
        for(const auto& ends : {std::make_pair(v, w), std::make_pair(w, v)}) {
          halfedge[ends] = {static_cast<int>(target.size())};
          target.push_back({ends.second});
          next.emplace_back();
          prev.emplace_back();
          face.emplace_back();
        }
      return halfedge[{v, w}];
    };
    const auto link = [&](Halfedge h, Halfedge g) {
      next[h.i] = g;
      prev[g.i] = h;
    };
    for(const auto& t : triangles) {
      const Halfedge h[3] = {find(t[0], t[1]), find(t[1], t[2]), find(t[2], t[0])};
      for(int k = 0; k < 3; ++k) {
        link(h[k], h[(k + 1) % 3]);
        face[h[k].i] = {static_cast<int>(of_face.size())};
        of_vertex[target[h[k].i].i] = h[k];
      }
      of_face.push_back(h[0]);
    }
    std::map<int, Halfedge> border_from;
    for(int h = 0; h < static_cast<int>(target.size()); ++h)
      if(face[h].i < 0)
        border_from[target[h ^ 1].i] = {h};
    for(const auto& entry : border_from) {
      link(entry.second, border_from.at(target[entry.second.i].i));
      of_vertex[target[entry.second.i].i] = entry.second;
    }
  }
};

} // namespace own

template <int Kind>
struct std::hash<own::Handle<Kind>>
{
  std::size_t operator()(own::Handle<Kind> handle) const { return std::hash<int>()(handle.i); }
};

// Types of the graph, in the words of the concepts FaceListGraph and HalfedgeListGraph.
template <>
struct boost::graph_traits<own::Mesh>
{
  template <typename Descriptor>
  struct Iterator
    : boost::iterator_adaptor<Iterator<Descriptor>, boost::counting_iterator<int>, Descriptor, boost::random_access_traversal_tag,
                              Descriptor>
  {
    Iterator() = default;
    explicit Iterator(int i) : Iterator::iterator_adaptor_(boost::counting_iterator<int>(i)) {}
    Descriptor dereference() const { return {*this->base()}; }
  };

  using vertex_descriptor = own::Vertex;
  using halfedge_descriptor = own::Halfedge;
  using face_descriptor = own::Face;
  using edge_descriptor = own::Edge;
  using vertex_iterator = Iterator<own::Vertex>;
  using halfedge_iterator = Iterator<own::Halfedge>;
  using face_iterator = Iterator<own::Face>;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = boost::vertex_list_graph_tag;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static own::Vertex null_vertex() { return {}; }
  static own::Halfedge null_halfedge() { return {}; }
  static own::Face null_face() { return {}; }
};

// Functions of the graph, found by their arguments.
namespace own {

using Graph_traits = boost::graph_traits<Mesh>;

inline Vertex target(Halfedge h, const Mesh& mesh) { return mesh.target[h.i]; }
inline Vertex source(Halfedge h, const Mesh& mesh) { return mesh.target[h.i ^ 1]; }
inline Halfedge opposite(Halfedge h, const Mesh&) { return {h.i ^ 1}; }
inline Halfedge next(Halfedge h, const Mesh& mesh) { return mesh.next[h.i]; }
inline Halfedge prev(Halfedge h, const Mesh& mesh) { return mesh.prev[h.i]; }
inline Face face(Halfedge h, const Mesh& mesh) { return mesh.face[h.i]; }
inline Halfedge halfedge(Vertex v, const Mesh& mesh) { return mesh.of_vertex[v.i]; }
inline Halfedge halfedge(Face f, const Mesh& mesh) { return mesh.of_face[f.i]; }
inline Halfedge halfedge(Edge e, const Mesh&) { return {2 * e.i}; }
inline Edge edge(Halfedge h, const Mesh&) { return {h.i / 2}; }
inline std::size_t num_vertices(const Mesh& mesh) { return mesh.points.size(); }
inline std::size_t num_halfedges(const Mesh& mesh) { return mesh.target.size(); }
inline std::size_t num_faces(const Mesh& mesh) { return mesh.of_face.size(); }

template <typename Iterator>
boost::iterator_range<Iterator> first_numbers(std::size_t n)
{
  return {Iterator(0), Iterator(static_cast<int>(n))};
}

inline auto vertices(const Mesh& mesh) { return first_numbers<Graph_traits::vertex_iterator>(num_vertices(mesh)); }
inline auto halfedges(const Mesh& mesh) { return first_numbers<Graph_traits::halfedge_iterator>(num_halfedges(mesh)); }
inline auto faces(const Mesh& mesh) { return first_numbers<Graph_traits::face_iterator>(num_faces(mesh)); }

struct Point_map
{
  using key_type = Vertex;
  using value_type = std::array<double, 3>;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;
  const Mesh* mesh;
};

inline const std::array<double, 3>& get(const Point_map& map, Vertex v) { return map.mesh->points[v.i]; }
inline Point_map get(CGAL::vertex_point_t, const Mesh& mesh) { return {&mesh}; }

} // namespace own

template <>
struct CGAL::graph_has_property<own::Mesh, CGAL::vertex_point_t> : CGAL::Tag_true
{};

template <>
struct boost::property_map<own::Mesh, CGAL::vertex_point_t>
{
  using type = own::Point_map;
  using const_type = own::Point_map;
};

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_OWN_MESH_H
