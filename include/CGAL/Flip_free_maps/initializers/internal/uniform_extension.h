// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

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
  std::vector<std::int32_t> row(domain.number_of_vertices, 0);
  for(std::int32_t v : fixed_vertices)
    row[v] = -1;
  std::int32_t rows = 0;
  for(std::int32_t& r : row)
    if(r == 0)
      r = rows++;
  if(rows == 0)
    return true;

  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(domain.elements.size() * (D * (D + 1) / 2));
  for(const auto& element : domain.elements)
    for(int i = 0; i <= D; ++i)
      for(int j = 0; j < i; ++j)
        edges.push_back({(std::min)(element[i], element[j]), (std::max)(element[i], element[j])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  std::vector<std::array<std::int32_t, 2>> stencils;
  stencils.reserve(edges.size());
  for(const auto& edge : edges)
    stencils.push_back({row[edge[0]], row[edge[1]]});
  Block_sparse_matrix matrix;
  matrix.build_pattern(rows, 1, stencils);
  Eigen::Matrix<double, Eigen::Dynamic, D> right = Eigen::Matrix<double, Eigen::Dynamic, D>::Zero(rows, D);
  for(const auto& edge : edges) {
    for(int i = 0; i < 2; ++i) {
      const std::int32_t r = row[edge[i]];
      if(r < 0)
        continue;
      matrix.diagonal(r) += 1;
      if(row[edge[1 - i]] < 0)
        right.row(r) += x.col(edge[1 - i]).transpose();
    }
    const std::int32_t r = row[edge[0]], c = row[edge[1]];
    if(r >= 0 && c >= 0)
      matrix.add_block(r, c, matrix.slot(r, c), Eigen::Matrix<double, 1, 1>(-1));
  }
  if(!solver.analyze_pattern(matrix) || !solver.factorize(matrix))
    return false;
  for(int c = 0; c < D; ++c) {
    Eigen::VectorXd left;
    if(!solver.solve(right.col(c), left))
      return false;
    for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
      if(row[v] >= 0)
        x(c, v) = left[row[v]];
  }
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_UNIFORM_EXTENSION_H
