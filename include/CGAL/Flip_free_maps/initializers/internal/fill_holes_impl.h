// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/fill_holes.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::vector<double> perimeters_of_holes(const Simplicial_domain<2>& domain)
{
  std::vector<std::int32_t> next(domain.number_of_vertices, -1), hole(domain.number_of_vertices, -1);
  for(std::size_t h = 0; h < domain.holes.size(); ++h)
    for(std::size_t i = 0; i < domain.holes[h].size(); ++i) {
      next[domain.holes[h][i]] = domain.holes[h][(i + 1) % domain.holes[h].size()];
      hole[domain.holes[h][i]] = static_cast<std::int32_t>(h);
    }
  std::vector<double> perimeters(domain.holes.size(), 0);
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = domain.elements[e][k];
      if(next[v] < 0 || next[v] != domain.elements[e][(k + 1) % 3])
        continue;
      const Matrix<2> edges = domain.rest_inverses[e].inverse();
      perimeters[hole[v]] += k == 0 ? edges.col(0).norm() : k == 1 ? (edges.col(1) - edges.col(0)).norm() : edges.col(1).norm();
    }
  return perimeters;
}

CGAL_FLIP_FREE_MAPS_INLINE Simplicial_domain<2> fill_holes(const Simplicial_domain<2>& domain)
{
  Simplicial_domain<2> disk;
  disk.elements = domain.elements;
  disk.rest_inverses = domain.rest_inverses;
  disk.number_of_vertices = domain.number_of_vertices;
  disk.border = domain.border;
  disk.border_lengths = domain.border_lengths;

  struct Corner
  {
    std::int32_t number;
    Vector<2> place;
  };
  const auto corner = [](std::int32_t number, double radius, double angle) {
    return Corner{number, Vector<2>(radius * std::cos(angle), radius * std::sin(angle))};
  };
  const auto add = [&disk](const Corner& a, const Corner& b, const Corner& c) {
    Matrix<2> edges;
    edges << b.place - a.place, c.place - a.place;
    disk.elements.push_back({a.number, b.number, c.number});
    disk.rest_inverses.push_back(edges.inverse());
  };
  constexpr std::size_t LARGEST_FAN = 8;
  constexpr double LAYER = 1.5; // thickness of a ring over the length of its outer edges

  const std::vector<double> perimeters = perimeters_of_holes(domain);
  std::vector<Corner> outer, inner;
  for(std::size_t h = 0; h < domain.holes.size(); ++h) {
    std::size_t n = domain.holes[h].size();
    if(n < 3)
      continue;
    double radius = perimeters[h] / (2 * CGAL_PI);
    outer.clear();
    // Backwards: counterclockwise as seen from the new triangles.
    for(std::size_t i = 0; i < n; ++i)
      outer.push_back(corner(domain.holes[h][n - 1 - i], radius, 2 * CGAL_PI * i / n));
    while(n > LARGEST_FAN) {
      const std::size_t m = (n + 1) / 2;
      radius *= std::exp(-2 * CGAL_PI * LAYER / n);
      inner.clear();
      for(std::size_t j = 0; j < m; ++j)
        inner.push_back(corner(disk.number_of_vertices++, radius, CGAL_PI * (2. * j + (std::min)(2 * j + 2, n)) / n));
      for(std::size_t j = 0; j < m; ++j) {
        for(std::size_t i = 2 * j; i < (std::min)(2 * j + 2, n); ++i)
          add(outer[i], outer[(i + 1) % n], inner[j]);
        add(inner[j], outer[(std::min)(2 * j + 2, n) % n], inner[(j + 1) % m]);
      }
      outer.swap(inner);
      n = m;
    }
    if(n == 3) {
      add(outer[0], outer[1], outer[2]);
      continue;
    }
    const Corner centre{disk.number_of_vertices++, Vector<2>::Zero()};
    for(std::size_t i = 0; i < n; ++i)
      add(outer[i], outer[(i + 1) % n], centre);
  }
  return disk;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_FILL_HOLES_IMPL_H
