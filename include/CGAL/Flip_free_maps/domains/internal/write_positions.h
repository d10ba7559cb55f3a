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

// Writes a planar map to the caller's property map if it is still free of flips after conversion to the map's number type; says
// so in the summary otherwise and leaves the caller's map as it is. Flips that the summary counts already do no harm.
template <typename Kernel, typename VertexDescriptor, typename VertexUVMap>
void write_positions(const Simplicial_domain<2>& domain, const std::vector<VertexDescriptor>& vertices, const Positions<2>& x,
                     VertexUVMap& uv_map, Summary& summary)
{
  using Point = typename boost::property_traits<VertexUVMap>::value_type;
  std::vector<Point> points;
  points.reserve(vertices.size());
  Positions<2> converted(2, x.cols());
  for(std::size_t v = 0; v < vertices.size(); ++v) {
    points.push_back(make_point_2<Point>(x(0, v), x(1, v)));
    converted.col(v) << CGAL::to_double(points[v][0]), CGAL::to_double(points[v][1]);
  }
  Element_coloring schedule;
  schedule.build(domain.elements, domain.number_of_vertices);
  const bool allows_flips = summary.flips > 0;
  summary.flips =
    converted.allFinite() ? count_flips<Kernel, CGAL::Sequential_tag>(domain, schedule, converted) : domain.number_of_elements();
  if(summary.flips != 0 && !allows_flips) {
    summary.status = Status::result_not_representable;
    summary.message = "elements flip when the map is converted to the number type of the result";
    return;
  }
  for(std::size_t v = 0; v < vertices.size(); ++v)
    put(uv_map, vertices[v], points[v]);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_WRITE_POSITIONS_H
