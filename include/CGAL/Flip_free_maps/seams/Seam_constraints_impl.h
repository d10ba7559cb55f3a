// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/seams/Seam_constraints.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE double Seam::length() const
{
  double sum = 0;
  for(double l : lengths)
    sum += l;
  return sum;
}

CGAL_FLIP_FREE_MAPS_INLINE Seam_constraints::Seam_constraints(std::vector<Seam> seams, std::int32_t first_transformation)
  : m_seams(std::move(seams)), m_first(first_transformation)
{
  m_multipliers.resize(m_seams.size());
  for(std::size_t s = 0; s < m_seams.size(); ++s) {
    m_multipliers[s].assign(m_seams[s].edges.size(), internal::Vector<2>::Zero());
    m_length += m_seams[s].length();
  }
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::vector<std::int32_t>> Seam_constraints::stencils() const
{
  std::vector<std::vector<std::int32_t>> all;
  for(std::size_t s = 0; s < m_seams.size(); ++s)
    for(const auto& edge : m_seams[s].edges) {
      std::vector<std::int32_t> stencil(edge.begin(), edge.end());
      stencil.push_back(transformation(s));
      std::sort(stencil.begin(), stencil.end());
      stencil.erase(std::unique(stencil.begin(), stencil.end()), stencil.end());
      all.push_back(std::move(stencil));
    }
  return all;
}

CGAL_FLIP_FREE_MAPS_INLINE double Seam_constraints::value(const Positions<2>& x) const
{
  double sum = 0;
  for(std::size_t s = 0; s < m_seams.size(); ++s) {
    for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
      sum += weight_of(s, k) * (residual_of(x, s, k) + m_multipliers[s][k]).squaredNorm();
    sum += quarter_turn_weight_of(s) * quarter_turn_residual(x.col(transformation(s))).squaredNorm();
  }
  return 0.5 * sum;
}

CGAL_FLIP_FREE_MAPS_INLINE void Seam_constraints::add_derivatives(const Positions<2>& x, Positions<2>& gradient,
                                                                  Term_matrix<2>* matrix) const
{
  using internal::Matrix;
  for(std::size_t s = 0; s < m_seams.size(); ++s) {
    const std::int32_t t = transformation(s);
    const internal::Vector<2> p = x.col(t);
    for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k) {
      const auto& edge = m_seams[s].edges[k];
      const Matrix<2> map = transformation_matrix(p);
      const double w = weight_of(s, k);
      const std::array<std::int32_t, 5> vertices{edge[0], edge[1], edge[2], edge[3], t};
      const std::array<Matrix<2>, 5> jacobians{map, -map, -Matrix<2>::Identity(), Matrix<2>::Identity(),
                                               -by_transformation(x.col(edge[1]) - x.col(edge[0]))};
      const internal::Vector<2> r = residual_of(x, s, k) + m_multipliers[s][k];
      for(int i = 0; i < 5; ++i)
        gradient.col(vertices[i]) += w * jacobians[i].transpose() * r;
      if(matrix == nullptr)
        continue;
      for(int i = 0; i < 5; ++i) {
        matrix->add(vertices[i], vertices[i], w * jacobians[i].transpose() * jacobians[i]);
        for(int j = i + 1; j < 5; ++j) {
          const Matrix<2> block = w * jacobians[i].transpose() * jacobians[j];
          if(vertices[i] == vertices[j])
            matrix->add(vertices[i], vertices[i], block + block.transpose());
          else
            matrix->add(vertices[i], vertices[j], block);
        }
      }
    }
    const double w = quarter_turn_weight_of(s);
    if(w > 0) {
      Matrix<2> jacobian;
      jacobian << 2 * p[0], 2 * p[1], p[1], p[0];
      gradient.col(t) += w * jacobian.transpose() * quarter_turn_residual(p);
      if(matrix != nullptr)
        matrix->add(t, t, w * jacobian.transpose() * jacobian);
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE double Seam_constraints::residual(const Positions<2>& x) const
{
  double largest = 0;
  for(std::size_t s = 0; s < m_seams.size(); ++s)
    for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
      largest = (std::max)(largest, residual_of(x, s, k).norm() / m_seams[s].length());
  return largest;
}

CGAL_FLIP_FREE_MAPS_INLINE void Seam_constraints::update_multipliers(const Positions<2>& x)
{
  for(std::size_t s = 0; s < m_seams.size(); ++s)
    for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
      m_multipliers[s][k] += residual_of(x, s, k);
}

CGAL_FLIP_FREE_MAPS_INLINE void Seam_constraints::scale_weight(double factor)
{
  weight *= factor;
  for(auto& of_seam : m_multipliers)
    for(auto& multiplier : of_seam)
      multiplier /= factor;
}

CGAL_FLIP_FREE_MAPS_INLINE internal::Vector<2> Seam_constraints::best_transformation(const Positions<2>& x, std::size_t s) const
{
  internal::Vector<2> sum = internal::Vector<2>::Zero();
  double squares = 0;
  for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k) {
    const auto& edge = m_seams[s].edges[k];
    const internal::Vector<2> from = x.col(edge[1]) - x.col(edge[0]), to = x.col(edge[3]) - x.col(edge[2]);
    sum += by_transformation(from).transpose() * to / m_seams[s].lengths[k];
    squares += from.squaredNorm() / m_seams[s].lengths[k];
  }
  return sum / squares;
}

CGAL_FLIP_FREE_MAPS_INLINE internal::Matrix<2> Seam_constraints::transformation_matrix(const internal::Vector<2>& p)
{
  internal::Matrix<2> map;
  map << p[0], p[1], -p[1], p[0];
  return map;
}

CGAL_FLIP_FREE_MAPS_INLINE internal::Matrix<2> Seam_constraints::by_transformation(const internal::Vector<2>& d)
{
  internal::Matrix<2> map;
  map << d[0], d[1], d[1], -d[0];
  return map;
}

CGAL_FLIP_FREE_MAPS_INLINE internal::Vector<2> Seam_constraints::residual_of(const Positions<2>& x, std::size_t s, std::size_t k) const
{
  const auto& edge = m_seams[s].edges[k];
  return x.col(edge[3]) - x.col(edge[2]) - transformation_matrix(x.col(transformation(s))) * (x.col(edge[1]) - x.col(edge[0]));
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_IMPL_H
