// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Joined_polygons.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status normalize_extent(Positions<3>& points, Eigen::Vector3d& low, double& extent, std::string& message)
{
  if(!points.allFinite()) {
    message = "a coordinate of the mesh is NaN or infinite";
    return Status::non_finite_input;
  }
  // Halves, since the extent may overflow.
  low = points.rowwise().minCoeff() / 2;
  const Eigen::Vector3d high = points.rowwise().maxCoeff() / 2;
  extent = 2 * (high - low).maxCoeff();
  if(!(extent > 0) || !std::isfinite(extent)) {
    message = extent > 0 ? "the extent of the mesh exceeds the range of double precision" : "all vertices of the mesh coincide";
    return extent > 0 ? Status::non_finite_input : Status::degenerate_rest_element;
  }
  points = ((points / 2).colwise() - low) / (extent / 2);
  return Status::success;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Triangle_surface::load(Polygon_soup soup, bool is_strict, std::string& message)
{
  Joined_polygons joined(soup);
  if(!is_strict)
    joined.join();
  m_left_out = joined.without_area();
  number_faces(joined);
  const Status status = check_faces(soup, is_strict, message);
  if(status != Status::success)
    return status;
  if(!take(soup, message))
    return Status::non_finite_input;
  bool is_linked = link(message);
  if(!is_linked && !is_strict) {
    soup.vertices.swap(m_sources);
    soup.first_corners.swap(m_first_halfedges);
    soup.points.swap(m_points);
    const bool is_any = joined.remove_repeated();
    number_faces(joined);
    is_linked = is_any && take(soup, message) && link(message);
  }
  if(!is_linked)
    return Status::non_manifold;
  m_first.clear();
  for(Index v = 0; v < static_cast<Index>(number_of_vertices()); ++v)
    m_first.push_back(joined.first(v));
  if(!is_pinched())
    return Status::success;
  message = "several sheets of the surface meet at a vertex";
  return Status::non_manifold;
}

CGAL_FLIP_FREE_MAPS_INLINE Status Triangle_surface::check_faces(const Polygon_soup& soup, bool is_strict, std::string& message) const
{
  std::vector<Index> corners;
  for(Index f = 0; f < soup.number_of_polygons(); ++f) {
    if(is_strict && soup.size(f) != 3) {
      message = "the mesh must consist of triangles; not so face number " + std::to_string(f);
      return Status::not_triangular;
    }
    corners.assign(soup.vertices.begin() + soup.first_corners[f], soup.vertices.begin() + soup.first_corners[f + 1]);
    std::sort(corners.begin(), corners.end());
    if(std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      message = "a vertex occurs twice in face number " + std::to_string(m_numbers[f]);
      return Status::non_manifold;
    }
  }
  if(soup.number_of_polygons() > 0)
    return Status::success;
  message = m_left_out.empty() ? "the mesh has no faces" : "no face has corners at three different places";
  return Status::empty_mesh;
}

CGAL_FLIP_FREE_MAPS_INLINE void Triangle_surface::number_faces(const Joined_polygons& joined)
{
  m_numbers.clear();
  for(Index f = 0; f < joined.number_of_polygons(); ++f)
    m_numbers.push_back(joined.number(f));
}

// False if a coordinate of a used point is not finite.
CGAL_FLIP_FREE_MAPS_INLINE bool Triangle_surface::take(Polygon_soup& soup, std::string& message)
{
  m_sources.swap(soup.vertices);
  m_first_halfedges.swap(soup.first_corners);
  m_points.swap(soup.points);
  m_faces.resize(m_sources.size());
  for(std::size_t f = 0; f < number_of_faces(); ++f)
    std::fill(m_faces.begin() + m_first_halfedges[f], m_faces.begin() + m_first_halfedges[f + 1], static_cast<Index>(f));
  m_incoming.assign(m_points.cols(), NONE);
  for(std::size_t h = 0; h < m_sources.size(); ++h)
    m_incoming[target(static_cast<Index>(h))] = static_cast<Index>(h);
  for(std::size_t v = 0; v < m_incoming.size(); ++v)
    if(m_incoming[v] == NONE)
      m_points.col(v).setZero();
  message = "a coordinate of the mesh is NaN or infinite";
  return m_points.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Triangle_surface::is_pinched() const
{
  std::vector<Index> degrees(m_incoming.size(), 0);
  for(const Index v : m_sources)
    ++degrees[v];
  return has_pinched_vertex(degrees, [this](Index v) {
    Index number = 0, h = m_incoming[v];
    do {
      number += h >= 0 ? 1 : 0;
      h = opposite(next(h));
    } while(h != m_incoming[v]);
    return number;
  });
}

CGAL_FLIP_FREE_MAPS_INLINE Triangle_surface::Index Triangle_surface::longest_border() const
{
  std::vector<char> seen(m_opposite.size(), 0);
  Index longest = NONE;
  double most = -1;
  for(std::size_t i = 0; i < m_opposite.size(); ++i) {
    if(m_opposite[i] >= 0 || seen[i])
      continue;
    double length = 0;
    Index h = m_opposite[i];
    do {
      seen[-1 - h] = 1;
      // Squares of tiny lengths vanish.
      const Vector<3> side = m_points.col(target(h)) - m_points.col(source(h));
      length += std::hypot(side[0], side[1], side[2]);
      h = next(h);
    } while(h != m_opposite[i]);
    if(length > most) {
      most = length;
      longest = m_opposite[i];
    }
  }
  return longest;
}

CGAL_FLIP_FREE_MAPS_INLINE Triangle_surface::Index Triangle_surface::next(Index h) const
{
  if(h >= 0)
    return next_in_face(h);
  // Around the target to the other end of its fan.
  Index g = -1 - h;
  while(g >= 0)
    g = opposite(prev_in_face(g));
  return g;
}

CGAL_FLIP_FREE_MAPS_INLINE Triangle_surface::Index Triangle_surface::prev(Index h) const
{
  if(h >= 0)
    return prev_in_face(h);
  Index g = -1 - h;
  while(g >= 0)
    g = opposite(next(g));
  return g;
}

CGAL_FLIP_FREE_MAPS_INLINE Triangle_surface::Index Triangle_surface::halfedge_between(Index from, Index to) const
{
  if(from < 0 || to < 0 || !is_used(from) || !is_used(to))
    return NONE;
  Index h = m_incoming[to];
  do {
    if(source(h) == from)
      return h;
    h = opposite(next(h));
  } while(h != m_incoming[to]);
  return NONE;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Triangle_surface::link(std::string& message)
{
  m_opposite.assign(m_sources.size(), NONE);
  std::unordered_map<std::uint64_t, Index> halfedges;
  const auto key = [](Index a, Index b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b); };
  for(std::size_t i = 0; i < m_opposite.size(); ++i) {
    const Index h = static_cast<Index>(i);
    if(!halfedges.emplace(key(source(h), target(h)), h).second) {
      message = "two faces have an edge in the same direction, one of them face number " + std::to_string(m_numbers[m_faces[i]]);
      return false;
    }
  }
  for(std::size_t i = 0; i < m_opposite.size(); ++i) {
    const Index h = static_cast<Index>(i);
    const auto found = halfedges.find(key(target(h), source(h)));
    m_opposite[i] = found == halfedges.end() ? -1 - h : found->second;
  }
  for(std::size_t i = 0; i < m_opposite.size(); ++i)
    if(m_opposite[i] < 0)
      m_incoming[target(m_opposite[i])] = m_opposite[i];
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_IMPL_H
