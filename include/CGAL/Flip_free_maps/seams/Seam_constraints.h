// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H

#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// A seam on the flat arrays: a chain of edges of the surface that was cut open, each of which the map shows twice.
struct Seam
{
  /// The edges in their order: source and target as seen from the left of the chain, then the same two as seen from its right.
  /// The two sides share a vertex where the seam ends inside of the surface.
  std::vector<std::array<std::int32_t, 4>> edges;
  /// Their rest lengths, in the domain's units.
  std::vector<double> lengths;

  /// The sum of the lengths.
  double length() const
  {
    double sum = 0;
    for(double l : lengths)
      sum += l;
    return sum;
  }
};

/// \ingroup PkgFlipFreeMapsSeams
/// The term that asks the two sides of each seam s to be related by one linear map T = [a b; -b a], which is a similarity, up to
/// a translation (Shtengel et al. 2017, section 5.3, equation 27):
///   weight / 2 sum_k |r_k + y_k|^2 / (l_k L), r_k = (v2 - v1) - T (u2 - u1),
/// over all edges k with rest lengths l_k of sum L, with sides u and v and multipliers y_k; and, if `quarter_turn_weight` is
/// positive, to be a rotation by a multiple of 90 degrees (equation 28):
///   quarter_turn_weight / 2 sum_s (L_s / L) ((a^2 + b^2 - 1)^2 + (a b)^2).
///
/// The pairs (a, b) are unknowns, too: they are the positions of additional vertices without elements, `first_transformation`
/// plus the number of the seam, which may be fixed like others to prescribe T. The matrix is that of Gauss and Newton.
class Seam_constraints : public Objective_term<2>
{
public:
  double weight = 0.1;            ///< of the similarities, not negative
  double quarter_turn_weight = 0; ///< of the quarter turns, not negative

  /// \param seams the seams
  /// \param first_transformation the vertex of which the position is (a, b) of the first seam; those of the others follow
  Seam_constraints(std::vector<Seam> seams, std::int32_t first_transformation) : m_seams(std::move(seams)), m_first(first_transformation)
  {
    m_multipliers.resize(m_seams.size());
    for(std::size_t s = 0; s < m_seams.size(); ++s) {
      m_multipliers[s].assign(m_seams[s].edges.size(), internal::Vector<2>::Zero());
      m_length += m_seams[s].length();
    }
  }

  /// The vertex of a seam's (a, b).
  std::int32_t transformation(std::size_t s) const { return m_first + static_cast<std::int32_t>(s); }

  /// The seams.
  const std::vector<Seam>& seams() const { return m_seams; }

  /// The vertices of each edge and its seam's (a, b).
  std::vector<std::vector<std::int32_t>> stencils() const override
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

  /// Its value.
  double value(const Positions<2>& x) const override
  {
    double sum = 0;
    for(std::size_t s = 0; s < m_seams.size(); ++s) {
      for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
        sum += weight_of(s, k) * (residual_of(x, s, k) + m_multipliers[s][k]).squaredNorm();
      sum += quarter_turn_weight_of(s) * quarter_turn_residual(x.col(transformation(s))).squaredNorm();
    }
    return 0.5 * sum;
  }

  /// Its derivatives; the matrix is that of Gauss and Newton.
  void add_derivatives(const Positions<2>& x, Positions<2>& gradient, Term_matrix<2>* matrix) const override
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

  /// The greatest |r_k|, over the length of its seam.
  double residual(const Positions<2>& x) const
  {
    double largest = 0;
    for(std::size_t s = 0; s < m_seams.size(); ++s)
      for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
        largest = (std::max)(largest, residual_of(x, s, k).norm() / m_seams[s].length());
    return largest;
  }

  /// Adds the residuals to the multipliers (method of multipliers:
  /// the constraints are met in the limit with the weight as it is).
  void update_multipliers(const Positions<2>& x)
  {
    for(std::size_t s = 0; s < m_seams.size(); ++s)
      for(std::size_t k = 0; k < m_seams[s].edges.size(); ++k)
        m_multipliers[s][k] += residual_of(x, s, k);
  }

  /// Multiplies the weight of the similarities, leaving the forces that the multipliers exert as they are.
  void scale_weight(double factor)
  {
    weight *= factor;
    for(auto& of_seam : m_multipliers)
      for(auto& multiplier : of_seam)
        multiplier /= factor;
  }

  /// The (a, b) that relate the sides of a seam best.
  internal::Vector<2> best_transformation(const Positions<2>& x, std::size_t s) const
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

  /// T.
  static internal::Matrix<2> transformation_matrix(const internal::Vector<2>& p)
  {
    internal::Matrix<2> map;
    map << p[0], p[1], -p[1], p[0];
    return map;
  }

private:
  // The derivative of T d by (a, b).
  static internal::Matrix<2> by_transformation(const internal::Vector<2>& d)
  {
    internal::Matrix<2> map;
    map << d[0], d[1], d[1], -d[0];
    return map;
  }

  static internal::Vector<2> quarter_turn_residual(const internal::Vector<2>& p) { return {p.squaredNorm() - 1, p[0] * p[1]}; }

  internal::Vector<2> residual_of(const Positions<2>& x, std::size_t s, std::size_t k) const
  {
    const auto& edge = m_seams[s].edges[k];
    return x.col(edge[3]) - x.col(edge[2]) - transformation_matrix(x.col(transformation(s))) * (x.col(edge[1]) - x.col(edge[0]));
  }

  double weight_of(std::size_t s, std::size_t k) const { return weight / (m_seams[s].lengths[k] * m_length); }

  double quarter_turn_weight_of(std::size_t s) const { return quarter_turn_weight * m_seams[s].length() / m_length; }

  std::vector<Seam> m_seams;
  std::int32_t m_first;
  std::vector<std::vector<internal::Vector<2>>> m_multipliers;
  double m_length = 0;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H
