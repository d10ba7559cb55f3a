// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/unfold_developable.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void unfold_developable(const Simplicial_domain<2>& domain, Positions<2>& x)
{
  using Complex = std::complex<double>;
  using Directed_edge = std::tuple<std::int32_t, std::int32_t, std::int64_t>; // from, to, element
  std::vector<Directed_edge> edges;
  edges.reserve(3 * domain.elements.size());
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    for(int k = 0; k < 3; ++k)
      edges.emplace_back(domain.elements[e][k], domain.elements[e][(k + 1) % 3], e);
  std::sort(edges.begin(), edges.end());

  const auto rest = [&domain](std::int64_t e) {
    const Matrix<2> m = domain.rest_inverses[e].inverse();
    return std::array<Complex, 3>{Complex(0, 0), Complex(m(0, 0), m(1, 0)), Complex(m(0, 1), m(1, 1))};
  };
  x.setZero(2, domain.number_of_vertices);
  std::vector<bool> is_laid(domain.elements.size(), false), is_placed(domain.number_of_vertices, false);
  std::vector<std::int64_t> queue;
  queue.reserve(domain.elements.size());
  const auto place = [&](std::int32_t v, const Complex& z) {
    if(!is_placed[v])
      x.col(v) << z.real(), z.imag();
    is_placed[v] = true;
  };
  const auto lay = [&](std::int64_t e) {
    is_laid[e] = true;
    queue.push_back(e);
  };

  const std::int64_t first = std::max_element(domain.measures.begin(), domain.measures.end()) - domain.measures.begin();
  const std::array<Complex, 3> shape = rest(first);
  for(int k = 0; k < 3; ++k)
    place(domain.elements[first][k], shape[k]);
  lay(first);
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = domain.elements[queue[i]][k], w = domain.elements[queue[i]][(k + 1) % 3];
      const auto twin = std::lower_bound(edges.begin(), edges.end(), Directed_edge(w, v, 0));
      if(twin == edges.end() || std::get<0>(*twin) != w || std::get<1>(*twin) != v || is_laid[std::get<2>(*twin)])
        continue;
      const std::int64_t e = std::get<2>(*twin);
      const int j = static_cast<int>(std::find(domain.elements[e].begin(), domain.elements[e].end(), w) - domain.elements[e].begin());
      const std::array<Complex, 3> q = rest(e);
      const Complex from(x(0, w), x(1, w)), to(x(0, v), x(1, v));
      const Complex& a = q[j];
      const Complex& b = q[(j + 1) % 3];
      const Complex turn = (to - from) * std::conj(b - a);
      const double length = std::abs(turn);
      if(length > 0)
        place(domain.elements[e][(j + 2) % 3], 0.5 * (from + to) + turn / length * (q[(j + 2) % 3] - 0.5 * (a + b)));
      lay(e);
    }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNFOLD_DEVELOPABLE_IMPL_H
