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
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
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

  explicit Cut_potential(const Cut_surface& surface) : m_surface(surface)
  {
    const std::int32_t n = surface.number_of_vertices();
    m_curvatures.setConstant(n, 2 * CGAL_PI);
    m_areas.assign(n, 0.);
    m_weights.assign(surface.number_of_edges(), 0.);
    for(std::int32_t h = 0; h < static_cast<std::int32_t>(surface.opposite.size()); ++h) {
      const std::int32_t v = surface.source(h), w = surface.target(h), x = surface.source(Cut_surface::prev(h));
      const Vector<3> a = surface.points.col(w) - surface.points.col(v), b = surface.points.col(x) - surface.points.col(v);
      const double doubled = a.cross(b).norm(), dot = a.dot(b);
      m_curvatures[v] -= std::atan2(doubled, dot);
      m_areas[v] += surface.areas[h / 3] / 3;
      m_weights[surface.edge_of[Cut_surface::next(h)]] += 0.5 * dot / doubled;
    }
    // The angles at the border are not those of a full turn.
    for(std::int32_t e = 0; e < surface.number_of_edges(); ++e)
      if(surface.is_border(e))
        m_curvatures[surface.source(surface.edge_halfedge[e])] = m_curvatures[surface.target(surface.edge_halfedge[e])] = 0;
    // Edges that are not Delaunay may have negative weights, with which the potential could oscillate.
    for(double& weight : m_weights)
      weight = (std::max)(weight, SMALLEST_WEIGHT);
    m_first_edges.assign(n + 1, 0);
    for(std::int32_t h : surface.edge_halfedge) {
      ++m_first_edges[surface.source(h) + 1];
      ++m_first_edges[surface.target(h) + 1];
    }
    std::partial_sum(m_first_edges.begin(), m_first_edges.end(), m_first_edges.begin());
    m_edges.resize(m_first_edges.back());
    std::vector<std::int32_t> place(m_first_edges.begin(), m_first_edges.end() - 1);
    for(std::int32_t e = 0; e < surface.number_of_edges(); ++e) {
      const std::int32_t h = surface.edge_halfedge[e];
      m_edges[place[surface.source(h)]++] = e;
      m_edges[place[surface.target(h)]++] = e;
    }
    std::vector<std::array<std::int32_t, 2>> pairs;
    for(std::int32_t h : surface.edge_halfedge)
      pairs.push_back({surface.source(h), surface.target(h)});
    m_matrix.build_pattern(n, 1, pairs);
  }

  // Makes u the values: 0 at some vertices, of which each component must have one. `false` if the factorization fails.
  bool find_potential(const std::vector<char>& is_fixed) { return solve(is_fixed, std::vector<double>(), m_curvatures); }

  // Makes the curvature that is summed over discs the values: K is spread by two steps of heat diffusion of given lengths, by
  // vertex, and multiplied such that curvature in one point is its own sum.
  bool find_summed_curvature(const std::vector<double>& times)
  {
    const std::vector<char> is_fixed(times.size(), 0);
    std::vector<double> masses(times.size());
    for(std::size_t v = 0; v < times.size(); ++v)
      masses[v] = m_areas[v] / times[v];
    if(!solve(is_fixed, masses, 4 * CGAL_PI * m_curvatures))
      return false;
    return solve(is_fixed, masses, Eigen::Map<const Eigen::VectorXd>(masses.data(), masses.size()).cwiseProduct(m_values));
  }

  double value(std::int32_t v) const { return m_values[v]; }

  // The expected energy above 1 at a vertex, times its area. Beyond some distortion it does not count more:
  // long tubes would hide everything else.
  double excess(std::int32_t v) const { return m_areas[v] * (std::cosh(2 * (std::min)(std::abs(m_values[v]), LARGEST_POTENTIAL)) - 1); }

  // The energy above 1, times the area, of the triangles around a vertex that is flattened without a cut to it: their angles are
  // widened or narrowed to a full turn, which the potential does not see on coarse meshes.
  double cone_excess(std::int32_t v) const
  {
    const double angle = 2 * CGAL_PI - m_curvatures[v];
    return angle > 0 ? 3 * m_areas[v] * (0.5 * (2 * CGAL_PI / angle + angle / (2 * CGAL_PI)) - 1) : 0;
  }

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
  bool solve(const std::vector<char>& is_fixed, const std::vector<double>& masses, const Eigen::VectorXd& right)
  {
    const std::int32_t n = m_surface.number_of_vertices();
    m_matrix.set_zero();
    Eigen::VectorXd fixed_right = right;
    for(std::int32_t v = 0; v < n; ++v) {
      m_matrix.diagonal(v) = is_fixed[v] ? 1. : masses.empty() ? 0. : masses[v];
      if(is_fixed[v])
        fixed_right[v] = 0;
    }
    Eigen::Matrix<double, 1, 1> entry;
    for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e) {
      const std::int32_t h = m_surface.edge_halfedge[e], v = m_surface.source(h), w = m_surface.target(h);
      for(std::int32_t end : {v, w})
        if(!is_fixed[end])
          m_matrix.diagonal(end) += m_weights[e];
      if(is_fixed[v] || is_fixed[w])
        continue;
      entry << -m_weights[e];
      m_matrix.add_block(v, w, m_matrix.slot(v, w), entry);
    }
    if(!m_is_analyzed)
      m_is_analyzed = m_solver.analyze_pattern(m_matrix);
    return m_is_analyzed && m_solver.factorize(m_matrix) && m_solver.solve(fixed_right, m_values) && m_values.allFinite();
  }

  std::int32_t other_end(std::int32_t e, std::int32_t v) const
  {
    const std::int32_t h = m_surface.edge_halfedge[e];
    return m_surface.source(h) == v ? m_surface.target(h) : m_surface.source(h);
  }

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

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_H
