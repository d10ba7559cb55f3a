// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_FACE_GRAPH_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_FACE_GRAPH_DOMAIN_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/give_area.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsDomains
/// The connected component of a mesh that a border halfedge belongs to, as flat arrays, with the way back to the mesh'
/// vertices. Vertices are numbered in the order in which a walk over the faces meets them, so neither gaps in the mesh' indices
/// nor other components matter. Triangles are laid isometrically in the plane.
///
/// Unless it is to be strict, polygons are cut into triangles by diagonals that suit their shapes, and triangles without area, which
/// have no rest shape, get thin ones: their vertices are moved a little, here only, as `unwrap()` does.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose vertex and face descriptors are `Hashable`
template <typename TriangleMesh>
class Face_graph_domain
{
public:
  /// \name Types
  /// @{

  /// Vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// Face of the mesh.
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// @}

  /// Reads the component of `border_halfedge`, which must be a topological disk, or a disk with holes.
  /// The halfedge is on the outer border.
  ///
  /// \tparam VertexPointMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and points in space as
  ///   values
  /// \param mesh the mesh
  /// \param border_halfedge a halfedge on its outer border
  /// \param vertex_points its points
  /// \param message what is wrong
  /// \param strict whether polygons that are no triangles, and faces without area, are refused
  /// \returns `Status::success`, or one of `empty_mesh`, `not_triangular`, `no_border`, `not_a_disk`, `non_manifold`,
  ///   `degenerate_rest_element` and `non_finite_input` with a sentence in `message`
  ///
  /// Complexity: linear in the size of the component, on average.
  template <typename VertexPointMap>
  Status load(const TriangleMesh& mesh, halfedge_descriptor border_halfedge, const VertexPointMap& vertex_points, std::string& message,
              bool strict = true)
  {
    clear(strict);
    const auto null = boost::graph_traits<TriangleMesh>::null_halfedge();
    const auto null_face = boost::graph_traits<TriangleMesh>::null_face();
    if(border_halfedge == null || face(border_halfedge, mesh) != null_face) {
      message = "the given halfedge is not on the border: the surface is closed, or another halfedge is meant";
      return Status::no_border;
    }
    const face_descriptor first = face(opposite(border_halfedge, mesh), mesh);
    if(first == null_face) {
      message = "the given border halfedge has no face on either side";
      return Status::empty_mesh;
    }

    Status status = walk(mesh, first, message);
    if(status == Status::success)
      status = check_topology(mesh, border_halfedge, message);
    if(status == Status::success)
      status = measure(mesh, vertex_points, message);
    return status;
  }

  /// Reads a planar mesh, all of it, which must be connected, and may have any number of borders.
  ///
  /// \tparam VertexPointMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and points in the plane, or
  ///   points in space with the same third coordinate, as values
  /// \param mesh a triangle mesh, counterclockwise in the plane
  /// \param vertex_points its points
  /// \param x receives the positions of the vertices, in the domain's units
  /// \param message what is wrong
  /// \param strict as above. Otherwise faces without area need not be counterclockwise, which cannot be said of them
  /// \returns as `load()`, or `several_components` or `not_planar`; a mesh with clockwise triangles gives `start_not_flip_free`
  template <typename VertexPointMap>
  Status load_planar(const TriangleMesh& mesh, const VertexPointMap& vertex_points, Positions<2>& x, std::string& message,
                     bool strict = true)
  {
    clear(strict);
    if(faces(mesh).begin() == faces(mesh).end()) {
      message = "the mesh has no faces";
      return Status::empty_mesh;
    }
    Status status = walk(mesh, *faces(mesh).begin(), message);
    if(status != Status::success)
      return status;
    std::size_t number_of_faces = 0;
    for(const face_descriptor f : faces(mesh)) {
      static_cast<void>(f);
      ++number_of_faces;
    }
    if(number_of_faces != m_number_of_faces) {
      message = "the mesh has several components";
      return Status::several_components;
    }
    if(has_pinched_vertex(mesh)) {
      message = "several sheets of the surface meet at a vertex";
      return Status::non_manifold;
    }
    status = measure(mesh, vertex_points, message);
    if(status != Status::success)
      return status;
    Positions<3> points = m_domain.rest_points;
    for(const auto& [v, point] : m_moved)
      points.col(v) = point;
    if((points.row(2).array() != points(2, 0)).any()) {
      message = "the mesh does not lie in a plane z = const";
      return Status::not_planar;
    }
    x = points.topRows(2);
    for(std::size_t e = 0; e < m_faces.size(); ++e)
      if(!(m_domain.image_edges(e, x).determinant() > 0) && !is_flat(e)) {
        message = numbered("the planar mesh must be counterclockwise; not so face number ", mesh, m_faces[e]);
        return Status::start_not_flip_free;
      }
    return Status::success;
  }

  /// Multiplies the measures of the elements by weights and scales them to sum 1 again. `false`, and nothing changes, unless all
  /// weights are positive and finite.
  template <typename FaceWeightMap>
  bool weigh(const FaceWeightMap& weights)
  {
    std::vector<double> weighted(m_domain.measures.size());
    double total = 0;
    for(std::size_t e = 0; e < weighted.size(); ++e) {
      weighted[e] = m_domain.measures[e] * CGAL::to_double(get(weights, m_faces[e]));
      if(!(weighted[e] > 0) || !std::isfinite(weighted[e]))
        return false;
      total += weighted[e];
    }
    for(double& w : weighted)
      w /= total;
    m_domain.measures.swap(weighted);
    return true;
  }

  /// The number of a mesh' vertex in the flat arrays, -1 if it has none.
  std::int32_t number_of(vertex_descriptor v) const
  {
    const auto found = m_numbers.find(v);
    return found == m_numbers.end() ? -1 : found->second;
  }

  /// The elements without area, in ascending order.
  const std::vector<std::int64_t>& elements_without_area() const { return m_flat; }

  /// The numbers of the faces all of whose elements have no area, which are their places among all faces, in ascending order.
  std::vector<std::int64_t> faces_without_area(const TriangleMesh& mesh) const
  {
    const std::vector<std::int32_t> left_out = internal::left_out_faces(mesh);
    std::vector<std::int64_t> result(left_out.begin(), left_out.end());
    if(m_flat.empty() && m_digons.empty())
      return result;
    std::unordered_map<face_descriptor, std::int64_t> with_area; // elements
    for(std::size_t e = 0; e < m_faces.size(); ++e)
      with_area[m_faces[e]] += is_flat(e) ? 0 : 1;
    std::int64_t place = 0;
    for(const face_descriptor f : faces(mesh)) {
      const auto found = with_area.find(f);
      if(found == with_area.end() ? m_digons.count(f) > 0 : found->second == 0)
        result.push_back(internal::number_of_face(mesh, f, place));
      ++place;
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// The mesh' faces by the numbers of the elements.
  const std::vector<face_descriptor>& faces_of_elements() const { return m_faces; }

  /// The flat arrays.
  const Simplicial_domain<2>& domain() const { return m_domain; }

  /// The mesh' vertices by their numbers in the flat arrays.
  const std::vector<vertex_descriptor>& vertices() const { return m_vertices; }

private:
  // The text and the number that the mesh itself gives to the face: its place among all faces.
  static std::string numbered(const char* text, const TriangleMesh& mesh, face_descriptor named)
  {
    std::int64_t place = 0;
    for(const face_descriptor f : faces(mesh)) {
      if(f == named)
        break;
      ++place;
    }
    return text + std::to_string(internal::number_of_face(mesh, named, place));
  }

  std::int32_t number(vertex_descriptor v)
  {
    const auto entry = m_numbers.emplace(v, static_cast<std::int32_t>(m_vertices.size()));
    if(entry.second)
      m_vertices.push_back(v);
    return entry.first->second;
  }

  void clear(bool strict)
  {
    m_is_strict = strict;
    m_domain = Simplicial_domain<2>();
    m_vertices.clear();
    m_numbers.clear();
    m_faces.clear();
    m_degrees.clear();
    m_polygons.clear();
    m_digons.clear();
    m_flat.clear();
    m_moved.clear();
    m_inner_halfedges = 0;
    m_border_halfedges.clear();
  }

  bool is_flat(std::int64_t element) const { return std::binary_search(m_flat.begin(), m_flat.end(), element); }

  // Breadth first, so that neighbours are near each other in memory.
  Status walk(const TriangleMesh& mesh, face_descriptor first, std::string& message)
  {
    const auto null_face = boost::graph_traits<TriangleMesh>::null_face();
    std::unordered_set<face_descriptor> seen{first};
    std::vector<face_descriptor> queue{first};
    std::vector<std::int32_t> corners;
    for(std::size_t q = 0; q < queue.size(); ++q) {
      const halfedge_descriptor h = halfedge(queue[q], mesh);
      corners.clear();
      halfedge_descriptor g = h;
      do {
        corners.push_back(number(source(g, mesh)));
        const face_descriptor neighbor = face(opposite(g, mesh), mesh);
        if(neighbor == null_face) {
          m_border_halfedges.push_back(opposite(g, mesh));
        } else {
          ++m_inner_halfedges;
          if(seen.insert(neighbor).second)
            queue.push_back(neighbor);
        }
        g = next(g, mesh);
      } while(g != h);
      const Status status = add_face(mesh, queue[q], corners, message);
      if(status != Status::success)
        return status;
    }
    m_number_of_faces = queue.size();
    m_domain.number_of_vertices = static_cast<std::int32_t>(m_vertices.size());
    if(!m_faces.empty())
      return Status::success;
    message = "no face has corners at three different vertices";
    return Status::empty_mesh;
  }

  // Polygons have their elements before it is known which ones these are.
  Status add_face(const TriangleMesh& mesh, face_descriptor f, const std::vector<std::int32_t>& corners, std::string& message)
  {
    if(corners.size() != 3 && (m_is_strict || corners.size() < 2)) {
      message = numbered("the mesh must consist of triangles; not so face number ", mesh, f);
      return Status::not_triangular;
    }
    m_sorted = corners;
    std::sort(m_sorted.begin(), m_sorted.end());
    if(std::adjacent_find(m_sorted.begin(), m_sorted.end()) != m_sorted.end()) {
      message = numbered("a vertex occurs twice in face number ", mesh, f);
      return Status::non_manifold;
    }
    if(m_vertices.size() > static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)() / 4)) {
      message = "the mesh has more vertices than 32-bit numbers can count";
      return Status::out_of_memory;
    }
    m_degrees.resize(m_vertices.size(), 0);
    for(const std::int32_t v : corners)
      ++m_degrees[v];
    if(corners.size() == 2)
      m_digons.insert(f);
    if(corners.size() > 3)
      m_polygons.emplace_back(m_domain.elements.size(), corners);
    for(std::size_t k = 2; k < corners.size(); ++k) {
      m_domain.elements.push_back({corners[0], corners[k - 1], corners[k]});
      m_faces.push_back(f);
    }
    return Status::success;
  }

  Status check_topology(const TriangleMesh& mesh, halfedge_descriptor border_halfedge, std::string& message)
  {
    std::vector<char> on_border(m_vertices.size(), 0);
    if(!walk_border(mesh, border_halfedge, on_border, m_domain.border)) {
      message = "the border passes through a vertex twice";
      return Status::non_manifold;
    }
    std::size_t passed = m_domain.border.size();
    bool touches = false;
    for(const halfedge_descriptor h : m_border_halfedges)
      if(!on_border[m_numbers.at(target(h, mesh))]) {
        m_domain.holes.emplace_back();
        touches = !walk_border(mesh, h, on_border, m_domain.holes.back()) || touches;
        passed += m_domain.holes.back().size();
      }
    if(touches || passed != m_border_halfedges.size()) {
      message = "borders meet at a vertex";
      return Status::non_manifold;
    }

    const std::int64_t euler = static_cast<std::int64_t>(m_vertices.size() + m_number_of_faces) -
                               static_cast<std::int64_t>(m_border_halfedges.size() + m_inner_halfedges / 2);
    const std::int64_t borders = 1 + static_cast<std::int64_t>(m_domain.holes.size());
    if(euler == 2 - borders)
      return Status::success;
    if(has_pinched_vertex(mesh)) {
      message = "several sheets of the surface meet at a vertex";
      return Status::non_manifold;
    }
    message = "the component has genus " + std::to_string((2 - borders - euler) / 2) + ": its Euler characteristic is " +
              std::to_string(euler) + ", and with " + std::to_string(borders) + (borders == 1 ? " border" : " borders") + " it should be " +
              std::to_string(2 - borders) + "; cut_to_disk() opens its handles";
    return Status::not_a_disk;
  }

  // The vertices of the border that a halfedge is on, in the order of the faces' edges there: backwards along the border
  // halfedges. `false` if one of them was met before, on this border or another.
  bool walk_border(const TriangleMesh& mesh, halfedge_descriptor border_halfedge, std::vector<char>& on_border,
                   std::vector<std::int32_t>& border) const
  {
    bool is_simple = true;
    halfedge_descriptor h = border_halfedge;
    do {
      const std::int32_t v = m_numbers.at(target(h, mesh));
      is_simple = is_simple && !on_border[v];
      on_border[v] = 1;
      border.push_back(v);
      h = prev(h, mesh);
    } while(h != border_halfedge && border.size() <= m_border_halfedges.size());
    return is_simple;
  }

  // Whether the faces around some vertex form more than one fan: the walk around the vertex then misses some of them.
  bool has_pinched_vertex(const TriangleMesh& mesh) const
  {
    const auto null_face = boost::graph_traits<TriangleMesh>::null_face();
    return internal::has_pinched_vertex(m_degrees, [&](std::int32_t v) {
      std::int32_t passed = 0;
      for(halfedge_descriptor h : CGAL::halfedges_around_target(halfedge(m_vertices[v], mesh), mesh))
        passed += face(h, mesh) != null_face ? 1 : 0;
      return passed;
    });
  }

  template <typename Point>
  static double third_coordinate(const Point& p)
  {
    if constexpr(internal::Is_planar_point<Point>::value)
      return 0;
    else
      return CGAL::to_double(p[2]);
  }

  template <typename VertexPointMap>
  Status measure(const TriangleMesh& mesh, const VertexPointMap& vertex_points, std::string& message)
  {
    const std::size_t n = m_vertices.size();
    Positions<3> points(3, n);
    for(std::size_t v = 0; v < n; ++v) {
      const auto p = get(vertex_points, m_vertices[v]);
      points.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), third_coordinate(p);
    }
    if(!m_is_strict && !make_fit(points)) {
      message = internal::NO_PLACES_FOR_AREA;
      return Status::degenerate_rest_element;
    }
    Eigen::Vector3d low;
    double extent;
    const Status status = internal::normalize_extent(points, low, extent, message);
    if(status != Status::success)
      return status;

    const std::size_t m = m_domain.elements.size();
    m_domain.measures.resize(m);
    m_domain.rest_inverses.resize(m);
    double total = 0;
    for(std::size_t e = 0; e < m; ++e) {
      const auto& v = m_domain.elements[e];
      if(!internal::planar_rest_shape(points.col(v[0]), points.col(v[1]), points.col(v[2]), m_domain.rest_inverses[e],
                                      m_domain.measures[e])) {
        message = numbered("zero area, or none within double precision, has face number ", mesh, m_faces[e]);
        return Status::degenerate_rest_element;
      }
      total += m_domain.measures[e];
    }
    const double length = std::sqrt(total);
    for(std::size_t e = 0; e < m; ++e) {
      m_domain.measures[e] /= total;
      m_domain.rest_inverses[e] *= length;
    }
    points /= length;
    m_domain.scale = extent * length;
    m_domain.origin = 2 * low.head<2>();
    for(auto& moved : m_moved)
      moved.second = (moved.second / 2 - low) / (extent / 2) / length;

    const std::size_t b = m_domain.border.size();
    m_domain.border_lengths.resize(b);
    for(std::size_t i = 0; i < b; ++i)
      m_domain.border_lengths[i] = (points.col(m_domain.border[(i + 1) % b]) - points.col(m_domain.border[i])).norm();
    m_domain.rest_points.swap(points);
    return Status::success;
  }

  // Cuts polygons into triangles, and gives an area to those that have none. False if that is impossible; what makes a mesh
  // unfit as a whole is found later.
  bool make_fit(Positions<3>& points)
  {
    if(!points.allFinite())
      return true;
    const double extent = (points.rowwise().maxCoeff() / 2 - points.rowwise().minCoeff() / 2).maxCoeff();
    if(!(extent > 0) || !std::isfinite(extent))
      return true;
    // A power of two as the unit of length rounds nothing, and keeps areas within the range of double precision.
    const int exponent = std::ilogb(extent);
    Positions<3> scaled = points.unaryExpr([exponent](double c) { return std::ldexp(c, -exponent); });
    cut_polygons(scaled);
    for(std::size_t e = 0; e < m_domain.elements.size(); ++e)
      if(!internal::has_area(scaled, m_domain.elements[e], internal::LEAST_HEIGHT_IN_PATCH))
        m_flat.push_back(static_cast<std::int64_t>(e));
    if(m_flat.empty())
      return true;
    const Positions<3> before = scaled;
    if(!internal::give_area(m_domain.elements, scaled, internal::LEAST_HEIGHT_IN_PATCH))
      return false;
    for(Eigen::Index v = 0; v < points.cols(); ++v)
      if(scaled.col(v) != before.col(v)) {
        m_moved.emplace_back(static_cast<std::int32_t>(v), points.col(v));
        points.col(v) = scaled.col(v).unaryExpr([exponent](double c) { return std::ldexp(c, exponent); });
      }
    return true;
  }

  // An edge between the ends of another one makes a surface that cannot be flattened.
  void cut_polygons(const Positions<3>& points)
  {
    if(m_polygons.empty())
      return;
    const auto key = [](std::int32_t v, std::int32_t w) {
      return static_cast<std::uint64_t>((std::min)(v, w)) << 32 | static_cast<std::uint64_t>((std::max)(v, w));
    };
    std::unordered_set<std::uint64_t> edges;
    for(std::size_t e = 0, p = 0; e < m_domain.elements.size();) {
      const bool is_polygon = p < m_polygons.size() && m_polygons[p].first == e;
      const std::vector<std::int32_t> corners =
        is_polygon ? m_polygons[p++].second : std::vector<std::int32_t>(m_domain.elements[e].begin(), m_domain.elements[e].end());
      for(std::size_t k = 0; k < corners.size(); ++k)
        edges.insert(key(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]));
      e += corners.size() - 2;
    }
    internal::Polygon_triangulator triangulator;
    for(const auto& [first, corners] : m_polygons) {
      const std::vector<std::int32_t>& v = corners;
      Positions<3> places(3, v.size());
      for(std::size_t k = 0; k < v.size(); ++k)
        places.col(k) = points.col(v[k]);
      const auto& triangles = triangulator.triangulate(places, [&](int i, int j) { return edges.count(key(v[i], v[j])) > 0; });
      for(std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& t = triangles[i];
        m_domain.elements[first + i] = {v[t[0]], v[t[1]], v[t[2]]};
        for(int k = 0; k < 3; ++k)
          edges.insert(key(v[t[k]], v[t[(k + 1) % 3]]));
      }
    }
  }

  bool m_is_strict = true;
  Simplicial_domain<2> m_domain;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<face_descriptor> m_faces; // by element
  std::size_t m_number_of_faces = 0;
  std::vector<std::int32_t> m_degrees; // by vertex: how many faces have it
  std::vector<std::int32_t> m_sorted;  // of a face
  // Polygons of more than three corners: their first elements, and corners. Those of two have none.
  std::vector<std::pair<std::size_t, std::vector<std::int32_t>>> m_polygons;
  std::unordered_set<face_descriptor> m_digons;
  std::vector<std::int64_t> m_flat; // elements without area
  std::vector<std::pair<std::int32_t, Eigen::Vector3d>>
    m_moved; // the vertices that are not at rest where the mesh has them, and where that is
  std::unordered_map<vertex_descriptor, std::int32_t> m_numbers;
  std::size_t m_inner_halfedges = 0;
  std::vector<halfedge_descriptor> m_border_halfedges;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_FACE_GRAPH_DOMAIN_H
