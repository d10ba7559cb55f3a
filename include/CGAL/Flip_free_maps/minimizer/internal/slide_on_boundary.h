// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_SLIDE_ON_BOUNDARY_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_SLIDE_ON_BOUNDARY_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/boundary_triangles_of_solid.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Lets the vertices on the boundary of a solid at rest slide on it: those around which it is flat in its plane, those on a straight
// crease, or a cylinder, along that. Where the boundary bends in both directions there is no way to go, and vertices are fixed.
inline void slide_on_boundary(const Simplicial_domain<3>& domain, Position_constraints<3>& constraints)
{
  // The square of the angle, in radians, by which normals of one plane differ: coordinates are rounded.
  const double tolerance = 1e-6;
  const Positions<3>& p = domain.rest_points;
  std::vector<Matrix<3>> normals(domain.number_of_vertices, Matrix<3>::Zero()); // sums of their products with themselves
  for(const auto& t : boundary_triangles_of_solid(domain.elements)) {
    const Vector<3> normal = Vector<3>(p.col(t[1]) - p.col(t[0])).cross(Vector<3>(p.col(t[2]) - p.col(t[0]))).normalized();
    for(const std::int32_t v : t)
      normals[v] += normal * normal.transpose();
  }
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const double number = normals[v].trace();
    if(number == 0)
      continue;
    Signed_svd<3> svd;
    signed_svd(normals[v], svd);
    if(svd.s[1] <= tolerance * number)
      constraints.sliding_vertices.push_back(Sliding_vertex<3>::normal_to(v, svd.V.col(0)));
    else if(std::abs(svd.s[2]) <= tolerance * number)
      constraints.sliding_vertices.push_back(Sliding_vertex<3>::along(v, svd.V.col(2)));
    else
      constraints.fixed_vertices.push_back(v);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_SLIDE_ON_BOUNDARY_H
