// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Point, typename = void>
struct Has_y : std::false_type
{};

template <typename Point>
struct Has_y<Point, std::void_t<decltype(std::declval<const Point&>().y())>> : std::true_type
{};

template <typename Point, typename = void>
struct Has_z : std::false_type
{};

template <typename Point>
struct Has_z<Point, std::void_t<decltype(std::declval<const Point&>().z())>> : std::true_type
{};

// Whether a point, of CGAL or a user's own, has two coordinates only.
template <typename Point>
struct Is_planar_point : std::bool_constant<Has_y<Point>::value && !Has_z<Point>::value>
{};

template <typename T, std::size_t N>
struct Is_planar_point<std::array<T, N>> : std::bool_constant<N == 2>
{};

// Whether a type is an array of points or simplices: a random access container whose elements have `[0]`. Meshes are not.
template <typename Range, typename = void>
struct Is_array : std::false_type
{};

template <typename Range>
struct Is_array<Range,
                std::void_t<decltype(std::declval<const Range&>().size()), decltype(*std::declval<const Range&>().begin()),
                            decltype(std::declval<const Range&>()[std::size_t(0)]), decltype((*std::declval<const Range&>().begin())[0])>>
  : std::true_type
{};

// The halfedges of a mesh. Domains and arrays have none, so that the functions for meshes are out of the question for them.
template <typename TriangleMesh, bool IsArray = Is_array<TriangleMesh>::value>
struct Halfedge_of
{
  using type = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
};

template <typename Array>
struct Halfedge_of<Array, true>
{};

template <int D>
struct Halfedge_of<Simplicial_domain<D>, false>
{};

// Brings coordinates of any magnitude into the unit cube, before areas are formed. `low` is half of the lower corner, in the given
// units, and `extent` the factor back.
Status normalize_extent(Positions<3>& points, Eigen::Vector3d& low, double& extent, std::string& message);

// Whether the triangles around some vertex form more than one fan: they have more corners there than a walk around the vertex
// passes. `passed(v)` tells how many that are.
template <typename Passed>
bool has_pinched_vertex(const std::vector<std::array<std::int32_t, 3>>& triangles, std::size_t number_of_vertices, Passed&& passed)
{
  std::vector<std::int32_t> degree(number_of_vertices, 0);
  for(const auto& triangle : triangles)
    for(const std::int32_t v : triangle)
      ++degree[v];
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(degree[v] > 0 && passed(static_cast<std::int32_t>(v)) != degree[v])
      return true;
  return false;
}

// The vertices, halfedges, edges and faces of `Triangle_surface` are numbers of different types.
template <int Kind>
struct Surface_index
{
  std::int32_t number = (std::numeric_limits<std::int32_t>::min)();

  operator std::int32_t() const { return number; }

  Surface_index& operator++()
  {
    ++number;
    return *this;
  }
};

// A triangle mesh as flat arrays, and a model of `FaceListGraph` on them, so that what takes meshes takes arrays, too. Halfedge
// 3 f + k goes from corner k of face f to the next corner; -1 - h is the border halfedge on the other side of h.
class Triangle_surface
{
public:
  using Index = std::int32_t;

  // Reads points, whose third coordinate may be missing, and triangles. Points that no triangle uses may have any value.
  template <typename PointRange, typename TriangleRange>
  Status load(const PointRange& points, const TriangleRange& triangles, std::string& message)
  {
    const std::size_t size = points.size();
    constexpr std::size_t MOST = static_cast<std::size_t>((std::numeric_limits<Index>::max)() / 4);
    m_triangles.clear();
    for(const auto& triangle : triangles) {
      Triangle t;
      for(int k = 0; k < 3; ++k) {
        // A negative number becomes a very large one.
        const std::size_t v = static_cast<std::size_t>(triangle[k]);
        if(v >= size) {
          message = "triangle number " + std::to_string(m_triangles.size()) + " has the vertex " + std::to_string(triangle[k]) +
                    ", but there are " + std::to_string(size) + " points";
          return Status::invalid_option;
        }
        t[k] = static_cast<Index>(v);
      }
      if(t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        message = "a vertex occurs twice in face number " + std::to_string(m_triangles.size());
        return Status::non_manifold;
      }
      m_triangles.push_back(t);
      if(size > MOST || m_triangles.size() > MOST) {
        message = "the mesh has more vertices or faces than 32-bit numbers can count";
        return Status::out_of_memory;
      }
    }
    if(m_triangles.empty()) {
      message = "the mesh has no faces";
      return Status::empty_mesh;
    }
    if(!read_points(points)) {
      message = "a coordinate of the mesh is NaN or infinite";
      return Status::non_finite_input;
    }
    if(!link(message))
      return Status::non_manifold;
    const auto passed = [this](Index v) {
      Index number = 0, h = m_incoming[v];
      do {
        number += h >= 0 ? 1 : 0;
        h = opposite(next(h));
      } while(h != m_incoming[v]);
      return number;
    };
    if(has_pinched_vertex(m_triangles, size, passed)) {
      message = "several sheets of the surface meet at a vertex";
      return Status::non_manifold;
    }
    return Status::success;
  }

  using Triangle = std::array<Index, 3>;

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  std::size_t number_of_vertices() const { return m_incoming.size(); }
  // The points as they were given; unused ones are 0.
  const Positions<3>& points() const { return m_points; }
  bool is_used(Index v) const { return m_incoming[v] != NONE; }

  // The longest border: a halfedge on it, or `NONE` if there is no border.
  Index longest_border() const;

  static constexpr Index NONE = (std::numeric_limits<Index>::min)();

  Index source(Index h) const { return h >= 0 ? m_triangles[h / 3][h % 3] : target(-1 - h); }
  Index target(Index h) const { return h >= 0 ? m_triangles[h / 3][(h + 1) % 3 == 0 ? 0 : h % 3 + 1] : source(-1 - h); }
  Index opposite(Index h) const { return h >= 0 ? m_opposite[h] : -1 - h; }
  Index face(Index h) const { return h >= 0 ? h / 3 : NONE; }

  Index next(Index h) const;

  Index prev(Index h) const;

  // The halfedge from one vertex to another, on the border or not; `NONE` if there is no such edge.
  Index halfedge_between(Index from, Index to) const;

  // A halfedge to the vertex, on the border if there is one.
  Index incoming(Index v) const { return m_incoming[v]; }

private:
  static Index prev_in_face(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  template <typename PointRange>
  bool read_points(const PointRange& points)
  {
    m_incoming.assign(points.size(), NONE);
    for(std::size_t h = 0; h < 3 * m_triangles.size(); ++h)
      m_incoming[target(static_cast<Index>(h))] = static_cast<Index>(h);
    m_points.setZero(3, points.size());
    for(std::size_t v = 0; v < points.size(); ++v)
      if(m_incoming[v] != NONE) {
        m_points.col(v) << CGAL::to_double(points[v][0]), CGAL::to_double(points[v][1]), 0;
        if constexpr(!Is_planar_point<std::decay_t<decltype(points[v])>>::value)
          m_points(2, v) = CGAL::to_double(points[v][2]);
      }
    return m_points.allFinite();
  }

  bool link(std::string& message);

  std::vector<Triangle> m_triangles;
  Positions<3> m_points;
  std::vector<Index> m_opposite; // by halfedge
  std::vector<Index> m_incoming; // by vertex, a halfedge to it; `NONE` where no face has it
};

using Surface_vertex = Surface_index<0>;
using Surface_halfedge = Surface_index<1>;
using Surface_face = Surface_index<2>;
using Surface_edge = Surface_index<3>; // has the number of the greater of its halfedges

// The vertex with the given index, the null vertex if the index is out of range.
template <typename Integer>
Surface_vertex vertex_of_index(Integer index, std::size_t size)
{
  return static_cast<std::size_t>(index) < size ? Surface_vertex{static_cast<std::int32_t>(index)} : Surface_vertex();
}

template <typename Index>
using Surface_iterator = boost::counting_iterator<Index, boost::forward_traversal_tag, std::ptrdiff_t>;

template <typename Index>
boost::iterator_range<Surface_iterator<Index>> surface_range(std::size_t size)
{
  return {Surface_iterator<Index>(Index{0}), Surface_iterator<Index>(Index{static_cast<std::int32_t>(size)})};
}

// The functions of the graph.
inline auto faces(const Triangle_surface& s) { return surface_range<Surface_face>(s.triangles().size()); }
inline auto vertices(const Triangle_surface& s) { return surface_range<Surface_vertex>(s.number_of_vertices()); }
// The one to corner 0, as in `CGAL::Surface_mesh`.
inline Surface_halfedge halfedge(Surface_face f, const Triangle_surface&) { return {3 * f.number + 2}; }
inline Surface_halfedge halfedge(Surface_vertex v, const Triangle_surface& s) { return {s.incoming(v)}; }
inline Surface_halfedge halfedge(Surface_edge e, const Triangle_surface&) { return {e.number}; }
inline Surface_edge edge(Surface_halfedge h, const Triangle_surface& s) { return {(std::max)(h.number, s.opposite(h))}; }
inline Surface_face face(Surface_halfedge h, const Triangle_surface& s) { return {s.face(h)}; }
inline Surface_halfedge opposite(Surface_halfedge h, const Triangle_surface& s) { return {s.opposite(h)}; }
inline Surface_halfedge next(Surface_halfedge h, const Triangle_surface& s) { return {s.next(h)}; }
inline Surface_halfedge prev(Surface_halfedge h, const Triangle_surface& s) { return {s.prev(h)}; }
inline Surface_vertex source(Surface_halfedge h, const Triangle_surface& s) { return {s.source(h)}; }
inline Surface_vertex target(Surface_halfedge h, const Triangle_surface& s) { return {s.target(h)}; }

// The points of a surface as a property map.
struct Surface_points
{
  using key_type = Surface_vertex;
  using value_type = std::array<double, 3>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Triangle_surface* surface;

  friend value_type get(const Surface_points& map, Surface_vertex v)
  {
    const auto p = map.surface->points().col(v);
    return {p[0], p[1], p[2]};
  }
};

inline Surface_points get(CGAL::vertex_point_t, const Triangle_surface& s) { return {&s}; }

// An array as a property map.
template <typename Value>
struct Array_map
{
  using key_type = std::size_t;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  std::vector<Value>* values;

  friend Value get(const Array_map& map, std::size_t i) { return (*map.values)[i]; }
  friend void put(const Array_map& map, std::size_t i, const Value& value) { (*map.values)[i] = value; }
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

namespace boost {

template <>
struct graph_traits<CGAL::Flip_free_maps::internal::Triangle_surface>
{
  using vertex_descriptor = CGAL::Flip_free_maps::internal::Surface_vertex;
  using halfedge_descriptor = CGAL::Flip_free_maps::internal::Surface_halfedge;
  using face_descriptor = CGAL::Flip_free_maps::internal::Surface_face;
  using edge_descriptor = CGAL::Flip_free_maps::internal::Surface_edge;
  using face_iterator = CGAL::Flip_free_maps::internal::Surface_iterator<face_descriptor>;
  using vertex_iterator = CGAL::Flip_free_maps::internal::Surface_iterator<vertex_descriptor>;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct property_map<CGAL::Flip_free_maps::internal::Triangle_surface, CGAL::vertex_point_t>
{
  using type = CGAL::Flip_free_maps::internal::Surface_points;
  using const_type = type;
};

} // namespace boost

namespace CGAL {

template <>
struct graph_has_property<Flip_free_maps::internal::Triangle_surface, CGAL::vertex_point_t> : Tag_true
{};

} // namespace CGAL

namespace std {

template <int Kind>
struct hash<CGAL::Flip_free_maps::internal::Surface_index<Kind>>
{
  size_t operator()(CGAL::Flip_free_maps::internal::Surface_index<Kind> i) const { return hash<int32_t>()(i.number); }
};

} // namespace std

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_H
