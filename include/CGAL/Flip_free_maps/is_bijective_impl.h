// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/is_bijective.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool is_bijective(const Textured_mesh& mesh, std::string* message)
{
  internal::Corner_numbers<int> numbers;
  std::vector<std::array<std::int32_t, 3>> elements;
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array<std::int32_t, 3> element;
    for(int k = 0; k < 3; ++k) {
      const auto& p = mesh.texture[mesh.texture_triangles[i][k]];
      element[k] = numbers(mesh.triangles[i][k], p[0], p[1]);
    }
    elements.push_back(element);
  }
  return internal::is_bijective(elements, numbers.positions(), message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_IMPL_H
