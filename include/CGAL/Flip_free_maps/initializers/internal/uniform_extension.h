// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Laplacian_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Moves every vertex that is not fixed to the mean of its neighbours (Tutte 1963): the start of a map whose boundary is given. In
// space elements may flip. Returns `false` when the linear solver fails, as where a part of the mesh has no fixed vertex.
template <int D, typename LinearSolver>
bool uniform_extension(const Simplicial_domain<D>& domain, const std::vector<std::int32_t>& fixed_vertices, LinearSolver&& solver,
                       Positions<D>& x)
{
  const Unknowns row(domain.number_of_vertices, fixed_vertices);
  if(row.size() == 0)
    return true;

  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(domain.elements.size() * (D * (D + 1) / 2));
  for(const auto& element : domain.elements)
    for(int i = 0; i <= D; ++i)
      for(int j = 0; j < i; ++j)
        edges.push_back({(std::min)(element[i], element[j]), (std::max)(element[i], element[j])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  Laplacian_matrix matrix(row, edges);
  Eigen::Matrix<double, Eigen::Dynamic, D> right = Eigen::Matrix<double, Eigen::Dynamic, D>::Zero(row.size(), D);
  for(const auto& edge : edges) {
    matrix.add_edge(edge[0], edge[1], 1);
    for(int i = 0; i < 2; ++i)
      if(!row.is_fixed(edge[i]) && row.is_fixed(edge[1 - i]))
        right.row(row[edge[i]]) += x.col(edge[1 - i]).transpose();
  }
  if(!matrix.factorize(solver))
    return false;
  for(int c = 0; c < D; ++c) {
    Eigen::VectorXd left;
    if(!solver.solve(right.col(c), left))
      return false;
    row.for_each([&](std::int32_t v, std::int32_t r) { x(c, v) = left[r]; });
  }
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H
