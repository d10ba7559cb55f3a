// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ANGLE_SUMS_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ANGLE_SUMS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// For each vertex the sum of the rest angles of the triangles there.
inline std::vector<double> angle_sums(const Simplicial_domain<2>& domain)
{
  std::vector<double> sums(domain.number_of_vertices, 0);
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Matrix<2> edges = domain.rest_inverses[e].inverse();
    const Vector<2> p[3] = {Vector<2>::Zero(), edges.col(0), edges.col(1)};
    for(int k = 0; k < 3; ++k) {
      const Vector<2> a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      sums[domain.elements[e][k]] += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    }
  }
  return sums;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ANGLE_SUMS_H
