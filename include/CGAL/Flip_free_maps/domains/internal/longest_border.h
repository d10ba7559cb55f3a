// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LONGEST_BORDER_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LONGEST_BORDER_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <optional>
#include <unordered_set>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A halfedge of the longest border, the first one of several; none on a closed surface. Lengths may be of any magnitude: squares of
// tiny ones vanish.
template <typename FaceGraph, typename VertexPointMap>
std::optional<typename boost::graph_traits<FaceGraph>::halfedge_descriptor> longest_border(const FaceGraph& mesh,
                                                                                           const VertexPointMap& vertex_points)
{
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  std::optional<Halfedge> longest;
  double greatest = -1;
  std::unordered_set<Halfedge> is_seen;
  for(const Halfedge first : halfedges(mesh)) {
    if(!CGAL::is_border(first, mesh) || is_seen.count(first) != 0)
      continue;
    double length = 0;
    Halfedge h = first;
    do {
      is_seen.insert(h);
      const auto p = get(vertex_points, source(h, mesh));
      const auto q = get(vertex_points, target(h, mesh));
      length += std::hypot(CGAL::to_double(q[0]) - CGAL::to_double(p[0]), CGAL::to_double(q[1]) - CGAL::to_double(p[1]),
                           CGAL::to_double(q[2]) - CGAL::to_double(p[2]));
      h = next(h, mesh);
    } while(h != first);
    if(length > greatest) {
      longest = first;
      greatest = length;
    }
  }
  return longest;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_LONGEST_BORDER_H
