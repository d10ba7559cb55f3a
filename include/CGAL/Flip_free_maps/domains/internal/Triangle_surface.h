// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Polygon_soup.h>
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

// Whether the faces around some vertex form more than one fan: they have more corners there, as `degrees` tell, than a walk around
// the vertex passes. `passed(v)` tells how many that are.
template <typename Passed>
bool has_pinched_vertex(const std::vector<std::int32_t>& degrees, Passed&& passed)
{
  for(std::size_t v = 0; v < degrees.size(); ++v)
    if(degrees[v] > 0 && passed(static_cast<std::int32_t>(v)) != degrees[v])
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

class Joined_polygons;

// A mesh as flat arrays, and a model of `FaceListGraph` on them, so that what takes meshes takes arrays, too. The halfedges of face
// f follow each other in the order of its corners, each going to the next corner; -1 - h is the border halfedge on the other side of h.
class Triangle_surface
{
public:
  using Index = std::int32_t;

  // Reads points, whose third coordinate may be missing, and triangles; or polygons, see `Joined_polygons`, unless it `is_strict`.
  // Points that no face uses may have any value.
  template <typename PointRange, typename PolygonRange>
  Status load(const PointRange& points, const PolygonRange& polygons, std::string& message, bool is_strict = true)
  {
    Polygon_soup soup;
    const Status status = read_polygon_soup(points, polygons, soup, message);
    return status == Status::success ? load(std::move(soup), is_strict, message) : status;
  }

  Status load(Polygon_soup soup, bool is_strict, std::string& message);

  std::size_t number_of_faces() const { return m_first_halfedges.size() - 1; }
  std::size_t number_of_halfedges() const { return m_sources.size(); } // those of faces
  std::size_t number_of_vertices() const { return m_incoming.size(); }
  // The user's number of a face, of which some may be left out; and those of the faces that are so for want of three corners.
  Index number_of_face(Index f) const { return m_numbers[f]; }
  const std::vector<Index>& left_out() const { return m_left_out; }
  // The vertex that stands for a point, often itself.
  Index vertex_of_point(Index v) const { return m_first[v]; }
  // The points as they were given; unused ones are 0.
  const Positions<3>& points() const { return m_points; }
  bool is_used(Index v) const { return m_incoming[v] != NONE; }

  // The longest border: a halfedge on it, or `NONE` if there is no border.
  Index longest_border() const;

  static constexpr Index NONE = (std::numeric_limits<Index>::min)();

  Index source(Index h) const { return h >= 0 ? m_sources[h] : target(-1 - h); }
  Index target(Index h) const { return h >= 0 ? m_sources[next_in_face(h)] : source(-1 - h); }
  Index opposite(Index h) const { return h >= 0 ? m_opposite[h] : -1 - h; }
  Index face(Index h) const { return h >= 0 ? m_faces[h] : NONE; }
  Index last_halfedge(Index f) const { return m_first_halfedges[f + 1] - 1; }

  Index next(Index h) const;

  Index prev(Index h) const;

  // The halfedge from one vertex to another, on the border or not; `NONE` if there is no such edge.
  Index halfedge_between(Index from, Index to) const;

  // A halfedge to the vertex, on the border if there is one.
  Index incoming(Index v) const { return m_incoming[v]; }

private:
  Index next_in_face(Index h) const { return h == last_halfedge(m_faces[h]) ? m_first_halfedges[m_faces[h]] : h + 1; }
  Index prev_in_face(Index h) const { return h == m_first_halfedges[m_faces[h]] ? last_halfedge(m_faces[h]) : h - 1; }

  Status check_faces(const Polygon_soup& soup, bool is_strict, std::string& message) const;
  void number_faces(const Joined_polygons& joined);
  bool take(Polygon_soup& soup, std::string& message);
  bool link(std::string& message);
  bool is_pinched() const;

  std::vector<Index> m_first_halfedges{0}; // by face
  std::vector<Index> m_sources, m_faces;   // by halfedge
  Positions<3> m_points;
  std::vector<Index> m_opposite; // by halfedge
  std::vector<Index> m_incoming; // by vertex, a halfedge to it; `NONE` where no face has it
  std::vector<Index> m_numbers, m_left_out, m_first;
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
inline auto faces(const Triangle_surface& s) { return surface_range<Surface_face>(s.number_of_faces()); }
inline auto vertices(const Triangle_surface& s) { return surface_range<Surface_vertex>(s.number_of_vertices()); }
// The one to corner 0, as in `CGAL::Surface_mesh`.
inline Surface_halfedge halfedge(Surface_face f, const Triangle_surface& s) { return {s.last_halfedge(f)}; }
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

// The user's numbers of faces: of meshes, their places among all faces.
template <typename Mesh, typename Face>
std::int64_t number_of_face(const Mesh&, Face, std::int64_t place)
{
  return place;
}

inline std::int64_t number_of_face(const Triangle_surface& s, Surface_face f, std::int64_t) { return s.number_of_face(f); }

// The numbers of faces that the user has, but the mesh has not.
template <typename Mesh>
std::vector<std::int32_t> left_out_faces(const Mesh&)
{
  return {};
}

inline const std::vector<std::int32_t>& left_out_faces(const Triangle_surface& s) { return s.left_out(); }

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

// A property map of the user's numbers of faces, for those of a surface.
template <typename Map>
struct Map_of_faces
{
  const Triangle_surface* surface;
  Map map;

  friend auto get(const Map_of_faces& faces, Surface_face f)
  {
    return get(faces.map, static_cast<std::size_t>(faces.surface->number_of_face(f)));
  }
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
