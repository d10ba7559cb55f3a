// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_BOUNDARY_TRIANGLES_OF_SOLID_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_BOUNDARY_TRIANGLES_OF_SOLID_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The facets that belong to one tetrahedron only, counterclockwise seen from outside.
inline std::vector<std::array<std::int32_t, 3>> boundary_triangles_of_solid(const std::vector<std::array<std::int32_t, 4>>& elements)
{
  using Triangle = std::array<std::int32_t, 3>;
  constexpr int FACETS[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::vector<std::pair<Triangle, Triangle>> facets; // sorted, and as they turn
  facets.reserve(4 * elements.size());
  for(const auto& element : elements)
    for(const auto& facet : FACETS) {
      const Triangle triangle = {{element[facet[0]], element[facet[1]], element[facet[2]]}};
      Triangle key = triangle;
      std::sort(key.begin(), key.end());
      facets.emplace_back(key, triangle);
    }
  std::sort(facets.begin(), facets.end());
  std::vector<Triangle> result;
  for(std::size_t i = 0; i < facets.size(); ++i)
    if((i == 0 || facets[i - 1].first != facets[i].first) && (i + 1 == facets.size() || facets[i + 1].first != facets[i].first))
      result.push_back(facets[i].second);
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_BOUNDARY_TRIANGLES_OF_SOLID_H
