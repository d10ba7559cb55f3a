// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE double total_curvature(const Simplicial_domain<2>& domain)
{
  std::vector<double> defects = angle_sums(domain);
  for(double& defect : defects)
    defect = 2 * CGAL_PI - defect;
  for(std::int32_t v : domain.border)
    defects[v] = 0;
  double sum = 0;
  for(const auto& hole : domain.holes) {
    // The angles of the filling are what is left of 2 pi at each vertex; they turn its border by pi minus that.
    double curvature = 2 * CGAL_PI;
    for(std::int32_t v : hole) {
      curvature -= CGAL_PI - defects[v];
      defects[v] = 0;
    }
    sum += std::abs(curvature);
  }
  for(double defect : defects)
    sum += std::abs(defect);
  return sum;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_IMPL_H
