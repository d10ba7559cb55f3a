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
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Chart_surface::Chart_surface(const Linked_triangles& surface, double begin, Unwrap_summary& summary)
  : m_summary(summary),
    m_begin(begin),
    m_surface(surface),
    m_is_cut(surface.opposite.size(), 0),
    m_is_feature(surface.opposite.size(), 0),
    m_place(surface.triangles.size(), -1),
    m_is_unassigned(surface.triangles.size(), 0)
{}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::fail(Status status, const std::string& message)
{
  m_summary.status = status;
  m_summary.message = message;
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_surface::mark(std::vector<char>& marks, std::int32_t h)
{
  if(m_surface.opposite[h] >= 0)
    marks[h] = marks[m_surface.opposite[h]] = 1;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t Chart_surface::number_of_polygons(const std::vector<std::int32_t>& faces) const
{
  return std::count_if(faces.begin(), faces.end(), [this](std::int32_t f) { return m_surface.is_first(f); });
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
        const std::int32_t other = neighbor(3 * piece.faces[q] + (k + 2) % 3);
        if(other >= 0 && m_is_unassigned[other]) {
          m_is_unassigned[other] = 0;
          piece.faces.push_back(other);
        }
      }
    m_queue.push_back(std::move(piece));
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_surface::close_slits(Linked_triangles& open)
{
  std::vector<std::array<std::int32_t, 3>> sides; // smaller vertex, larger vertex, halfedge
  for(std::size_t h = 0; h < open.opposite.size(); ++h)
    if(open.opposite[h] < 0) {
      const std::int32_t v = open.triangles[h / 3][h % 3], w = open.triangles[h / 3][(h + 1) % 3];
      sides.push_back({{(std::min)(v, w), (std::max)(v, w), static_cast<std::int32_t>(h)}});
    }
  std::sort(sides.begin(), sides.end());
  const auto source = [&open](std::int32_t h) { return open.triangles[h / 3][h % 3]; };
  for(std::size_t i = 0, j; i < sides.size(); i = j) {
    for(j = i + 1; j < sides.size() && sides[j][0] == sides[i][0] && sides[j][1] == sides[i][1];)
      ++j;
    const std::int32_t g = sides[i][2], h = sides[j - 1][2];
    if(j - i == 2 && source(g) != source(h)) {
      open.opposite[g] = h;
      open.opposite[h] = g;
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Linked_triangles Chart_surface::open_surface(const std::vector<std::int32_t>& faces)
{
  Linked_triangles open;
  const std::size_t m = faces.size();
  for(std::size_t e = 0; e < m; ++e)
    m_place[faces[e]] = static_cast<std::int32_t>(e);
  open.opposite.resize(3 * m);
  for(std::size_t e = 0; e < m; ++e) {
    open.polygons.push_back(m_surface.polygons[faces[e]]);
    for(int k = 0; k < 3; ++k) {
      const std::int32_t h = 3 * faces[e] + k, g = m_surface.opposite[h];
      open.opposite[3 * e + k] = is_seam(h) ? -1 : 3 * m_place[g / 3] + g % 3;
    }
  }
  std::vector<std::int32_t> vertices, first_corners;
  number_fans(
    open.opposite, [&open](std::int32_t h) { return open.opposite[h] < 0; }, vertices, first_corners);
  open.triangles.resize(m);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    open.triangles[i / 3][i % 3] = vertices[i];
  close_slits(open);
  open.points.resize(3, first_corners.size());
  for(std::size_t v = 0; v < first_corners.size(); ++v) {
    const std::int32_t c = first_corners[v];
    open.points.col(v) = m_surface.points.col(m_surface.triangles[faces[c / 3]][c % 3]);
  }
  return open;
}

CGAL_FLIP_FREE_MAPS_INLINE Chart_surface::Open_piece Chart_surface::open(const std::vector<std::int32_t>& faces)
{
  Open_piece piece;
  piece.surface = open_surface(faces);
  const Linked_triangles& open = piece.surface;
  std::vector<Vertex> mesh_vertices;
  for(Eigen::Index v = 0; v < open.points.cols(); ++v)
    mesh_vertices.push_back(piece.mesh.add_vertex({open.points(0, v), open.points(1, v), open.points(2, v)}));
  for(const auto& t : open.triangles)
    piece.is_mesh = piece.is_mesh && piece.mesh.add_face(mesh_vertices[t[0]], mesh_vertices[t[1]], mesh_vertices[t[2]]).is_valid();
  piece.border.load(open.triangles, open.opposite, static_cast<std::int32_t>(open.points.cols()));
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
      length += (open.surface.points.col(open.mesh.target(h)) - open.surface.points.col(open.mesh.source(h))).norm();
    }
    if(length > longest.first)
      longest = {length, first};
  }
  return longest.second;
}

CGAL_FLIP_FREE_MAPS_INLINE double Chart_surface::missing_angles(const Open_piece& open)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Border_curves& border = open.border;
  if(border.curves().size() < 2)
    return infinity;
  const std::int64_t faces = static_cast<std::int64_t>(open.surface.triangles.size());
  const std::int64_t edges = (3 * faces + static_cast<std::int64_t>(border.edges().size())) / 2;
  if(open.surface.points.cols() - edges + faces + static_cast<std::int64_t>(border.curves().size()) != 2)
    return infinity;
  std::vector<double> angles(open.surface.points.cols(), 0);
  for(const auto& v : open.surface.triangles)
    for(int k = 0; k < 3; ++k) {
      const Vector<3> a = open.surface.points.col(v[(k + 1) % 3]) - open.surface.points.col(v[k]);
      const Vector<3> b = open.surface.points.col(v[(k + 2) % 3]) - open.surface.points.col(v[k]);
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

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> Chart_surface::with_moved_border(const Open_piece& open, const Positions<2>& x, double distance)
{
  Positions<2> normals = Positions<2>::Zero(2, x.cols());
  for(const Border_edge& edge : open.border.edges()) {
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

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_surface::Crossing> Chart_surface::crossings(const Open_piece& open, const Positions<2>& x)
{
  const std::size_t most = 100000;
  const Border_curves& border = open.border;
  std::vector<std::int32_t> rank(border.edges().size(), 0);
  for(const auto& curve : border.curves())
    for(std::size_t i = 0; i < curve.size(); ++i)
      rank[curve[i]] = static_cast<std::int32_t>(i);
  std::vector<Crossing> result;
  border.for_each_crossing(x, [&](std::int32_t i, std::int32_t j) {
    const Border_edge& a = border.edges()[i];
    const Border_edge& b = border.edges()[j];
    const std::int32_t length = static_cast<std::int32_t>(border.curves()[a.curve].size());
    std::int32_t way = std::abs(rank[i] - rank[j]);
    way = a.curve == b.curve ? (std::min)(way, length - way) : static_cast<std::int32_t>(border.edges().size());
    result.push_back({{(std::min)(i, j), (std::max)(i, j)}, way});
    return result.size() < most;
  });
  std::sort(result.begin(), result.end(), [](const Crossing& a, const Crossing& b) {
    return std::make_tuple(-a.way, a.edges[0], a.edges[1]) < std::make_tuple(-b.way, b.edges[0], b.edges[1]);
  });
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_surface::has_overlap(const Open_piece& open, const Positions<2>& x)
{
  bool is_crossing = false;
  open.border.for_each_crossing(x, [&](std::int32_t, std::int32_t) {
    is_crossing = true;
    return false;
  });
  return is_crossing || !open.border.are_nested(x);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_IMPL_H
