// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_IMPL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_potential.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cut_potential::Cut_potential(const Cut_surface& surface) : m_surface(surface)
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

CGAL_FLIP_FREE_MAPS_INLINE bool Cut_potential::find_summed_curvature(const std::vector<double>& times)
{
  const std::vector<char> is_fixed(times.size(), 0);
  std::vector<double> masses(times.size());
  for(std::size_t v = 0; v < times.size(); ++v)
    masses[v] = m_areas[v] / times[v];
  if(!solve(is_fixed, masses, 4 * CGAL_PI * m_curvatures))
    return false;
  return solve(is_fixed, masses, Eigen::Map<const Eigen::VectorXd>(masses.data(), masses.size()).cwiseProduct(m_values));
}

CGAL_FLIP_FREE_MAPS_INLINE double Cut_potential::cone_excess(std::int32_t v) const
{
  const double angle = 2 * CGAL_PI - m_curvatures[v];
  return angle > 0 ? 3 * m_areas[v] * (0.5 * (2 * CGAL_PI / angle + angle / (2 * CGAL_PI)) - 1) : 0;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cut_potential::solve(const std::vector<char>& is_fixed, const std::vector<double>& masses,
                                                     const Eigen::VectorXd& right)
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
  ask_deadline();
  return m_is_analyzed && m_solver.factorize(m_matrix) && m_solver.solve(fixed_right, m_values) && m_values.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_potential::other_end(std::int32_t e, std::int32_t v) const
{
  const std::int32_t h = m_surface.edge_halfedge[e];
  return m_surface.source(h) == v ? m_surface.target(h) : m_surface.source(h);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_POTENTIAL_IMPL_H
