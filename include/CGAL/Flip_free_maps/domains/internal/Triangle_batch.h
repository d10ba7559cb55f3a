// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_BATCH_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_BATCH_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Numbers of several elements, computed at once: as many as the processor has in one register, for which the code is compiled.
constexpr int NUMBER_OF_LANES = EIGEN_MAX_ALIGN_BYTES >= 64 ? 8 : EIGEN_MAX_ALIGN_BYTES >= 32 ? 4 : 2;
using Lanes = Eigen::Array<double, NUMBER_OF_LANES, 1>;

// Whether an energy computes several elements at once. A class that inherits from such an energy, and may have another value(),
// does not. Without a barrier the smaller singular value may vanish, which the formulas below do not bear.
template <typename Energy, typename = void>
struct Has_lanes : std::false_type
{};

template <typename Energy>
struct Has_lanes<Energy, std::void_t<typename Energy::Vectorized_energy>>
  : std::bool_constant<std::is_same<typename Energy::Vectorized_energy, Energy>::value && Energy::has_barrier>
{};

// Consecutive triangles of a planar domain, one in each lane: their Jacobians J = A R, where A holds the edges of the image and R
// is the inverse of those of the rest shape. With alpha = (J_00 + J_11, J_10 - J_01) and beta = (J_00 - J_11, J_10 + J_01), J is
// half the sum of a similarity by alpha and a reflected one by beta; so are its derivatives, and no singular vectors are needed.
class Triangle_batch
{
public:
  template <typename Reference>
  Triangle_batch(const Simplicial_domain<2>& domain, const Reference& reference, std::int64_t first, const Positions<2>& x)
  {
    for(int l = 0; l < NUMBER_OF_LANES; ++l) {
      const Matrix<2> edges = domain.image_edges(first + l, x);
      const Matrix<2>& rest_inverse = reference.rest_inverse(domain, first + l);
      for(int i = 0; i < 4; ++i) {
        m_edges[i][l] = edges.data()[i];
        m_rest[i][l] = rest_inverse.data()[i];
      }
      m_weight[l] = reference.weight(domain, first + l);
    }
    const Lanes a = m_edges[0] * m_rest[0] + m_edges[2] * m_rest[1], b = m_edges[0] * m_rest[2] + m_edges[2] * m_rest[3];
    const Lanes c = m_edges[1] * m_rest[0] + m_edges[3] * m_rest[1], d = m_edges[1] * m_rest[2] + m_edges[3] * m_rest[3];
    m_alpha = {a + d, c - b};
    m_beta = {a - d, c + b};
    m_alpha_norm = (m_alpha[0].square() + m_alpha[1].square()).sqrt();
    m_beta_norm = (m_beta[0].square() + m_beta[1].square()).sqrt();
    m_s[0] = 0.5 * (m_alpha_norm + m_beta_norm);
    // The difference of the norms would cancel for thin triangles.
    m_s[1] = (a * d - b * c) / m_s[0];
  }

  // The sum of the weighted energies; +infinity when an element is not positive.
  template <typename Energy>
  double energy(const Energy& energy) const
  {
    if(!(m_s[1] > 0).all())
      return std::numeric_limits<double>::infinity();
    return (m_weight * energy.template values<2, Lanes>(m_s)).sum();
  }

  // Calls f(l, forces) for each lane: column k is the gradient of the weighted energy in vertex k+1.
  template <typename Energy, typename F>
  void for_each_gradient(const Energy& energy, F&& f) const
  {
    std::array<Lanes, 2> gradient;
    energy.template gradients<2, Lanes>(m_s, gradient);
    // Factors of alpha and beta in the derivative of the energy in J. Where beta vanishes,
    // so does the difference of the derivatives.
    const Lanes p = 0.5 * m_weight * (gradient[0] + gradient[1]) / m_alpha_norm;
    const Lanes q = 0.5 * m_weight * (gradient[0] - gradient[1]) / m_beta_norm.max((std::numeric_limits<double>::min)());
    const Lanes a = p * m_alpha[0] + q * m_beta[0], b = q * m_beta[1] - p * m_alpha[1];
    const Lanes c = p * m_alpha[1] + q * m_beta[1], d = p * m_alpha[0] - q * m_beta[0];
    const std::array<Lanes, 4> forces{a * m_rest[0] + b * m_rest[2], c * m_rest[0] + d * m_rest[2], a * m_rest[1] + b * m_rest[3],
                                      c * m_rest[1] + d * m_rest[3]};
    for(int l = 0; l < NUMBER_OF_LANES; ++l) {
      Matrix<2> lane;
      lane << forces[0][l], forces[2][l], forces[1][l], forces[3][l];
      f(l, lane);
    }
  }

private:
  std::array<Lanes, 4> m_edges, m_rest; // entries of 2 x 2 matrices, column by column
  Lanes m_weight;
  std::array<Lanes, 2> m_alpha, m_beta;
  Lanes m_alpha_norm, m_beta_norm;
  std::array<Lanes, 2> m_s; // singular values
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TRIANGLE_BATCH_H
