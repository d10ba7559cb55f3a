// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_SURFACE_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
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
      length += (m_points.col(target(h)) - m_points.col(source(h))).norm();
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
    return h % 3 == 2 ? h - 2 : h + 1;
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
  m_opposite.assign(3 * m_triangles.size(), NONE);
  std::unordered_map<std::uint64_t, Index> halfedges;
  const auto key = [](Index a, Index b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b); };
  for(std::size_t i = 0; i < m_opposite.size(); ++i) {
    const Index h = static_cast<Index>(i);
    if(!halfedges.emplace(key(source(h), target(h)), h).second) {
      message = "two faces have an edge in the same direction, one of them face number " + std::to_string(i / 3);
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
