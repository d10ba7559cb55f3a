// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_IMPL_H

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::array<int, 3>> boundary_triangles(const Tetrahedral_mesh& mesh,
                                                                              std::vector<std::size_t>* owners)
{
  struct Facet
  {
    std::array<int, 3> sorted;
    std::size_t number;

    bool operator<(const Facet& other) const { return sorted < other.sorted; }
  };
  const int corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

  std::vector<Facet> facets;
  facets.reserve(4 * mesh.tetrahedra.size());
  for(const std::array<int, 4>& tetrahedron : mesh.tetrahedra) {
    for(const auto& corner : corners) {
      std::array<int, 3> sorted = {{tetrahedron[corner[0]], tetrahedron[corner[1]], tetrahedron[corner[2]]}};
      std::sort(sorted.begin(), sorted.end());
      facets.push_back({sorted, facets.size()});
    }
  }
  std::sort(facets.begin(), facets.end());
  std::vector<std::size_t> numbers;
  for(std::size_t i = 0, j; i < facets.size(); i = j) {
    for(j = i + 1; j < facets.size() && facets[j].sorted == facets[i].sorted;)
      ++j;
    if(j == i + 1)
      numbers.push_back(facets[i].number);
  }
  std::sort(numbers.begin(), numbers.end());

  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(numbers.size());
  if(owners != nullptr)
    owners->clear();
  for(const std::size_t number : numbers) {
    const std::array<int, 4>& tetrahedron = mesh.tetrahedra[number / 4];
    const auto& corner = corners[number % 4];
    triangles.push_back({{tetrahedron[corner[0]], tetrahedron[corner[1]], tetrahedron[corner[2]]}});
    if(owners != nullptr)
      owners->push_back(number / 4);
  }
  return triangles;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_IMPL_H
