// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_surface.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::load(const Positions<3>& points, const std::vector<std::array<std::int32_t, 3>>& triangles)
{
  m_summary.faces = static_cast<std::int64_t>(triangles.size());
  if(triangles.empty())
    return fail(Status::empty_mesh, "the mesh has no faces");
  if(!points.allFinite())
    return fail(Status::non_finite_input, "a coordinate of the mesh is NaN or infinite");
  // A power of two as the unit of length rounds nothing, and keeps areas within the range of double precision.
  const double extent = (points.rowwise().maxCoeff() / 2 - points.rowwise().minCoeff() / 2).maxCoeff();
  if(!(extent > 0) || !std::isfinite(extent))
    return fail(extent > 0 ? Status::non_finite_input : Status::degenerate_rest_element,
                extent > 0 ? "the extent of the mesh exceeds the range of double precision" : "all vertices of the mesh coincide");
  m_exponent = std::ilogb(extent);
  m_triangles = triangles;
  m_points = points.unaryExpr([this](double c) { return std::ldexp(c, -m_exponent); });
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    Matrix<2> rest_inverse;
    double area;
    if(!planar_rest_shape(m_points.col(t[0]), m_points.col(t[1]), m_points.col(t[2]), rest_inverse, area))
      return fail(Status::degenerate_rest_element, "zero area, or none within double precision, has face number " + std::to_string(f));
  }
  std::vector<Vertex> vertices;
  for(Eigen::Index v = 0; v < m_points.cols(); ++v)
    vertices.push_back(m_mesh.add_vertex({m_points(0, v), m_points(1, v), m_points(2, v)}));
  for(std::size_t f = 0; f < triangles.size(); ++f)
    if(!m_mesh.add_face(vertices[triangles[f][0]], vertices[triangles[f][1]], vertices[triangles[f][2]]).is_valid())
      return fail(Status::non_manifold,
                  "more than two faces have an edge, or several sheets a vertex, of face number " + std::to_string(f));
  m_is_cut = m_mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
  m_is_feature = m_mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  m_corners.resize(triangles.size());
  m_corner_of.assign(m_mesh.number_of_halfedges(), -1);
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    Halfedge h = m_mesh.halfedge(Face(static_cast<Mesh::size_type>(f)));
    while(m_mesh.target(h) != vertices[triangles[f][0]])
      h = m_mesh.next(h);
    for(int k = 0; k < 3; ++k, h = m_mesh.next(h)) {
      m_corners[f][k] = h;
      m_corner_of[h] = k;
    }
  }
  std::vector<std::int32_t> degrees(m_points.cols(), 0);
  for(const auto& t : triangles)
    for(const std::int32_t v : t)
      ++degrees[v];
  for(std::size_t v = 0; v < degrees.size(); ++v) {
    std::int32_t passed = 0;
    if(degrees[v] > 0)
      for(const Halfedge h : CGAL::halfedges_around_target(m_mesh.halfedge(vertices[v]), m_mesh))
        passed += m_mesh.is_border(h) ? 0 : 1;
    if(passed != degrees[v])
      return fail(Status::non_manifold, "several sheets of the surface meet at a vertex");
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::fail(Status status, const std::string& message)
{
  m_summary.status = status;
  m_summary.message = message;
  m_summary.seconds = wall_seconds() - m_begin;
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::mark(Edge_map& map, std::int32_t face, int k)
{
  const Halfedge h = m_corners[face][k];
  if(m_mesh.is_border(m_mesh.opposite(h)) || map[m_mesh.edge(h)])
    return false;
  map[m_mesh.edge(h)] = true;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Chart_surface::neighbor(std::int32_t face, int k) const
{
  const Halfedge h = m_corners[face][k];
  const Face other = m_mesh.face(m_mesh.opposite(h));
  return !other.is_valid() || m_is_cut[m_mesh.edge(h)] ? -1 : static_cast<std::int32_t>(other);
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_surface::enqueue_parts(const std::vector<std::int32_t>& faces, const Piece& origin)
{
  for(const std::int32_t f : faces)
    m_is_unassigned[f] = 1;
  for(const std::int32_t first : faces) {
    if(!m_is_unassigned[first])
      continue;
    Piece piece;
    piece.was_cut = origin.was_cut;
    piece.recuts = origin.recuts;
    piece.target = origin.target;
    piece.is_part = origin.is_part;
    piece.faces.assign(1, first);
    m_is_unassigned[first] = 0;
    for(std::size_t q = 0; q < piece.faces.size(); ++q)
      for(int k = 0; k < 3; ++k) {
        const std::int32_t other = neighbor(piece.faces[q], k);
        if(other >= 0 && m_is_unassigned[other]) {
          m_is_unassigned[other] = 0;
          piece.faces.push_back(other);
        }
      }
    m_queue.push_back(std::move(piece));
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_surface::Open_piece Chart_surface::open(const std::vector<std::int32_t>& faces)
{
  Open_piece piece;
  const std::size_t m = faces.size();
  for(std::size_t e = 0; e < m; ++e)
    m_place[faces[e]] = static_cast<std::int32_t>(e);
  piece.elements.assign(m, {{-1, -1, -1}});
  piece.neighbors.resize(m);
  std::vector<std::int32_t> originals;
  for(std::size_t e = 0; e < m; ++e)
    for(int k = 0; k < 3; ++k) {
      // The side from corner k is the edge to the next corner.
      const std::int32_t other = neighbor(faces[e], (k + 1) % 3);
      piece.neighbors[e][k] = other < 0 ? -1 : m_place[other];
      if(piece.elements[e][k] >= 0)
        continue;
      // All corners of the fan around the vertex, in one direction and then in the other.
      const std::int32_t number = static_cast<std::int32_t>(originals.size());
      originals.push_back(m_triangles[faces[e]][k]);
      const auto visit = [&](Halfedge h) {
        std::int32_t& corner = piece.elements[m_place[m_mesh.face(h)]][m_corner_of[h]];
        const bool is_new = corner < 0;
        corner = number;
        return is_new;
      };
      const auto is_end = [&](Halfedge h) { return m_mesh.is_border(m_mesh.opposite(h)) || m_is_cut[m_mesh.edge(h)]; };
      Halfedge h = m_corners[faces[e]][k];
      bool is_new = visit(h);
      while(is_new && !is_end(m_mesh.next(h))) {
        h = m_mesh.opposite(m_mesh.next(h));
        is_new = visit(h);
      }
      h = m_corners[faces[e]][k];
      while(is_new && !is_end(h)) {
        h = m_mesh.prev(m_mesh.opposite(h));
        is_new = visit(h);
      }
    }
  piece.points.resize(3, originals.size());
  std::vector<Vertex> vertices;
  for(std::size_t v = 0; v < originals.size(); ++v) {
    piece.points.col(v) = m_points.col(originals[v]);
    vertices.push_back(piece.mesh.add_vertex({piece.points(0, v), piece.points(1, v), piece.points(2, v)}));
  }
  for(const auto& t : piece.elements)
    piece.is_mesh = piece.is_mesh && piece.mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]).is_valid();
  return piece;
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_surface::Halfedge Chart_surface::longest_border(const Open_piece& open)
{
  std::vector<char> is_seen(open.mesh.number_of_halfedges(), 0);
  std::pair<double, Halfedge> longest(0, Halfedge());
  for(const Halfedge first : open.mesh.halfedges()) {
    if(is_seen[first] || !open.mesh.is_border(first))
      continue;
    double length = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(first, open.mesh)) {
      is_seen[h] = 1;
      length += (open.points.col(open.mesh.target(h)) - open.points.col(open.mesh.source(h))).norm();
    }
    if(length > longest.first)
      longest = {length, first};
  }
  return longest.second;
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_surface::missing_angles(const Open_piece& open)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Border_curves border;
  if(!border.load(open.elements, static_cast<std::int32_t>(open.points.cols())) || border.curves().size() < 2)
    return infinity;
  const std::int64_t faces = static_cast<std::int64_t>(open.elements.size());
  const std::int64_t edges = (3 * faces + static_cast<std::int64_t>(border.edges().size())) / 2;
  if(open.points.cols() - edges + faces + static_cast<std::int64_t>(border.curves().size()) != 2)
    return infinity;
  std::vector<double> angles(open.points.cols(), 0);
  for(const auto& v : open.elements)
    for(int k = 0; k < 3; ++k) {
      const Vector<3> a = open.points.col(v[(k + 1) % 3]) - open.points.col(v[k]);
      const Vector<3> b = open.points.col(v[(k + 2) % 3]) - open.points.col(v[k]);
      angles[v[k]] += std::atan2(a.cross(b).norm(), a.dot(b));
    }
  const std::int32_t outer = static_cast<std::int32_t>(open.mesh.target(longest_border(open)));
  double missing = 0;
  for(const auto& curve : border.curves()) {
    double turn = 0;
    bool is_outer = false;
    for(const std::int32_t i : curve) {
      const std::int32_t v = border.edges()[i].target;
      turn += CGAL_PI - angles[v];
      angles[v] = 2 * CGAL_PI;
      is_outer = is_outer || v == outer;
    }
    missing += is_outer ? 0 : std::abs(turn + 2 * CGAL_PI);
  }
  for(const double angle : angles)
    missing += std::abs(2 * CGAL_PI - angle);
  return missing;
}

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> Chart_surface::with_moved_border(const Open_piece& open, const Positions<2>& x,
                                                                         double distance) const
{
  Border_curves border;
  border.load(open.elements, static_cast<std::int32_t>(x.cols()));
  Positions<2> normals = Positions<2>::Zero(2, x.cols());
  for(const Border_edge& edge : border.edges()) {
    const Vector<2> side = (x.col(edge.target) - x.col(edge.source)).normalized(), normal(side[1], -side[0]);
    normals.col(edge.source) += normal;
    normals.col(edge.target) += normal;
  }
  Positions<2> moved = x;
  for(Eigen::Index v = 0; v < x.cols(); ++v) {
    const double length = normals.col(v).norm();
    if(length > 1e-6)
      moved.col(v) += distance / length * normals.col(v);
  }
  return moved;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::find_overlap(const Open_piece& open, const Positions<2>& x,
                                                            std::pair<std::int32_t, std::int32_t>& overlap) const
{
  Border_curves border;
  border.load(open.elements, static_cast<std::int32_t>(x.cols()));
  std::vector<std::int32_t> rank(border.edges().size(), 0);
  for(const auto& curve : border.curves())
    for(std::size_t i = 0; i < curve.size(); ++i)
      rank[curve[i]] = static_cast<std::int32_t>(i);
  std::int32_t best = -1;
  int number = 0;
  border.for_each_crossing(x, [&](std::int32_t i, std::int32_t j) {
    const Border_edge& a = border.edges()[i];
    const Border_edge& b = border.edges()[j];
    const std::int32_t length = static_cast<std::int32_t>(border.curves()[a.curve].size());
    std::int32_t way = std::abs(rank[i] - rank[j]);
    way = a.curve == b.curve ? (std::min)(way, length - way) : static_cast<std::int32_t>(border.edges().size());
    if(way > best) {
      best = way;
      overlap = {a.element, b.element};
    }
    return ++number < 100000;
  });
  if(best < 0 && !border.are_nested(x)) {
    overlap = {0, 0};
    return true;
  }
  return best >= 0;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_IMPL_H
