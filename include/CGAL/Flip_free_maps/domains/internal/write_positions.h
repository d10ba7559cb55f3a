// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WRITE_POSITIONS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WRITE_POSITIONS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The type of a point's coordinates.
template <typename Point>
using Coordinate = std::decay_t<decltype(std::declval<const Point&>()[0])>;

// Aggregates, such as std::array, have no constructor from coordinates.
template <typename Point>
Point make_point_2(double x, double y)
{
  using C = Coordinate<Point>;
  if constexpr(std::is_constructible_v<Point, C, C>)
    return Point(C(x), C(y));
  else
    return Point{C(x), C(y)};
}

// Converts the positions to the numbers of a property map, and writes them if `certify(written)` accepts them as they will be
// read, all of them or none.
template <typename VertexDescriptor, typename VertexUVMap, typename Certify>
void write_positions(const std::vector<VertexDescriptor>& vertices, const Positions<2>& x, VertexUVMap& uv_map, Certify&& certify)
{
  using Point = typename boost::property_traits<VertexUVMap>::value_type;
  std::vector<Point> points;
  points.reserve(vertices.size());
  Positions<2> written(2, x.cols());
  for(std::size_t v = 0; v < vertices.size(); ++v) {
    points.push_back(make_point_2<Point>(x(0, v), x(1, v)));
    written.col(v) << CGAL::to_double(points[v][0]), CGAL::to_double(points[v][1]);
  }
  if(!certify(written))
    return;
  using boost::put; // for pointers
  for(std::size_t v = 0; v < vertices.size(); ++v)
    put(uv_map, vertices[v], points[v]);
}

// The same, for a map without flips, unless it had some before.
template <typename Kernel, typename VertexDescriptor, typename VertexUVMap>
void write_positions(const Simplicial_domain<2>& domain, const std::vector<VertexDescriptor>& vertices, const Positions<2>& x,
                     VertexUVMap& uv_map, Summary& summary)
{
  write_positions(vertices, x, uv_map, [&](const Positions<2>& written) { return certify_flips<Kernel>(domain, written, summary); });
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WRITE_POSITIONS_H
