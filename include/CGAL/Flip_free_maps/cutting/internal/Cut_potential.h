// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#else
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#endif

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// How much a surface would be scaled by the conformal map that flattens it and keeps the lengths of its borders and seams:
// exp(u), where the Laplacian of u is the Gaussian curvature and u = 0 on borders and seams. The mean of cosh(2 u) is the mean
// symmetric Dirichlet energy of that map, so maxima of |u| are the places that seams should reach.
class Cut_potential
{
public:
  // A place that would be distorted, and its part of the energy above 1, times the area.
  struct Peak
  {
    std::int32_t vertex;
    double excess;
  };

  explicit Cut_potential(const Cut_surface& surface);

  // Makes u the values: 0 at some vertices, of which each component must have one. `false` if the factorization fails.
  bool find_potential(const std::vector<char>& is_fixed) { return solve(is_fixed, std::vector<double>(), m_curvatures); }

  // Makes the curvature that is summed over discs the values: K is spread by two steps of heat diffusion of given lengths, by
  // vertex, and multiplied such that curvature in one point is its own sum.
  bool find_summed_curvature(const std::vector<double>& times);

  double value(std::int32_t v) const { return m_values[v]; }

  // The expected energy above 1 at a vertex, times its area. Beyond some distortion it does not count more:
  // long tubes would hide everything else.
  double excess(std::int32_t v) const { return m_areas[v] * (std::cosh(2 * (std::min)(std::abs(m_values[v]), LARGEST_POTENTIAL)) - 1); }

  // The energy above 1, times the area, of the triangles around a vertex that is flattened without a cut to it: their angles are
  // widened or narrowed to a full turn, which the potential does not see on coarse meshes.
  double cone_excess(std::int32_t v) const;

  // Maxima of the values' magnitudes that are higher by `prominence` than the passes to higher maxima, each with the excess of
  // its surroundings down to the passes; those with the largest excess come first.
  // Vertices where `is_wanted` does not hold are left out.
  template <typename IsWanted>
  std::vector<Peak> peaks(double prominence, IsWanted&& is_wanted) const
  {
    const std::int32_t n = m_surface.number_of_vertices();
    std::vector<std::int32_t> order;
    for(std::int32_t v = 0; v < n; ++v)
      if(m_values[v] != 0 && is_wanted(v))
        order.push_back(v);
    const auto height = [this](std::int32_t v) { return std::abs(m_values[v]); };
    std::sort(order.begin(), order.end(),
              [&](std::int32_t v, std::int32_t w) { return height(v) != height(w) ? height(v) > height(w) : v < w; });
    // Regions grow downhill from the maxima, each known by its highest vertex. A region ends where it meets a higher one.
    std::vector<std::int32_t> top(n, -1);
    std::vector<std::int32_t> merged(n, -1); // by maximum, the higher one that it was merged into
    const auto root = [&](std::int32_t v) {
      std::int32_t t = top[v];
      while(merged[t] >= 0)
        t = merged[t];
      top[v] = top[v] == v ? v : t;
      return t;
    };
    std::vector<double> excesses(n, 0.);
    for(std::int32_t v : order) {
      std::int32_t own = -1;
      for(std::int32_t i = m_first_edges[v]; i < m_first_edges[v + 1]; ++i) {
        const std::int32_t w = other_end(m_edges[i], v);
        if(top[w] < 0)
          continue;
        std::int32_t other = root(w);
        if(own < 0 || other == own) {
          own = other;
          continue;
        }
        if(height(other) > height(own) || (height(other) == height(own) && other < own))
          std::swap(own, other);
        if(height(other) - height(v) < prominence) {
          merged[other] = own;
          excesses[own] += excesses[other];
          excesses[other] = 0;
        }
      }
      top[v] = own >= 0 ? own : v;
      excesses[top[v]] += excess(v);
    }
    std::vector<Peak> result;
    for(std::int32_t v : order)
      if(top[v] == v && merged[v] < 0)
        result.push_back({v, excesses[v]});
    std::sort(result.begin(), result.end(),
              [](const Peak& a, const Peak& b) { return a.excess != b.excess ? a.excess > b.excess : a.vertex < b.vertex; });
    return result;
  }

private:
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  using Solver = Cholmod_solver;
#else
  using Solver = Eigen_simplicial_solver;
#endif

  static constexpr double SMALLEST_WEIGHT = 1e-3;
  static constexpr double LARGEST_POTENTIAL = 1.5;

  // Solves with the Laplacian, to whose diagonal masses are added if there are any, and the values 0 at fixed vertices. All
  // vertices are in the matrix, so that its pattern is analysed only once.
  bool solve(const std::vector<char>& is_fixed, const std::vector<double>& masses, const Eigen::VectorXd& right);

  std::int32_t other_end(std::int32_t e, std::int32_t v) const;

  const Cut_surface& m_surface;
  Eigen::VectorXd m_curvatures;  // by vertex
  std::vector<double> m_areas;   // by vertex
  std::vector<double> m_weights; // by edge
  std::vector<std::int32_t> m_first_edges, m_edges;
  Eigen::VectorXd m_values; // by vertex
  Block_sparse_matrix m_matrix;
  Solver m_solver;
  bool m_is_analyzed = false;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/cutting/internal/Cut_potential_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_H
