// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_MAP_OBJECTIVE_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_MAP_OBJECTIVE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/Element_schedule.h>
#include <CGAL/Flip_free_maps/internal/Signed_svd.h>
#include <CGAL/Flip_free_maps/internal/Vertex_relaxation.h>
#include <CGAL/Flip_free_maps/line_search/largest_flip_free_step.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/preconditioners/Increment_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The mean energy of a map, with its gradient and the preconditioner's matrix: the one place where elements are visited.
template <int D, typename Traits>
class Map_objective
{
  using Energy = typename Traits::Energy;
  using Reference = typename Traits::Reference;
  using Preconditioner = typename Traits::Preconditioner;
  using Tag = typename Traits::Concurrency_tag;
  using Element = typename Simplicial_domain<D>::Element;

  static constexpr int PAIRS = D * (D + 1) / 2; // of distinct vertices of an element

public:
  Map_objective(const Simplicial_domain<D>& domain, const Energy& energy, const Preconditioner& preconditioner)
    : m_domain(domain), m_energy(energy), m_preconditioner(preconditioner)
  {
    m_schedule.build(domain.elements, domain.number_of_vertices);
  }

  const Element_schedule& schedule() const { return m_schedule; }

  // Builds the pattern of the matrix and every element's places in it.
  void build_pattern()
  {
    m_matrix.build_pattern(m_domain.number_of_vertices, D, m_domain.elements);
    m_slots.resize(m_domain.elements.size());
    m_schedule.template scatter<Tag>([this](std::int64_t e) {
      const Element& v = m_domain.elements[e];
      int p = 0;
      for(int a = 0; a <= D; ++a)
        for(int b = a + 1; b <= D; ++b)
          m_slots[e][p++] = m_matrix.slot(v[a], v[b]);
    });
  }

  Block_sparse_matrix& matrix() { return m_matrix; }

  // Mean energy; +infinity when an element of a barrier energy is not positive.
  double energy(const Reference& reference, const Positions<D>& x) const
  {
    return m_schedule.template sum<Tag>([&](std::int64_t e) {
      const Vector<D> s = signed_singular_values(Matrix<D>(m_domain.image_edges(e, x) * reference.rest_inverse(m_domain, e)));
      if(Energy::has_barrier && !(s[D - 1] > 0))
        return std::numeric_limits<double>::infinity();
      return reference.weight(m_domain, e) * m_energy.template value<D>(s);
    });
  }

  // Gradient, laid out like the positions, and, when asked, the matrix.
  void derivatives(const Reference& reference, const Positions<D>& x, bool with_matrix, Eigen::VectorXd& gradient)
  {
    gradient.setZero(x.size());
    if(with_matrix)
      m_matrix.set_zero();
    m_schedule.template scatter<Tag>([&](std::int64_t e) {
      const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
      const double weight = reference.weight(m_domain, e);
      Signed_svd<D> svd;
      signed_svd(Matrix<D>(m_domain.image_edges(e, x) * rest_inverse), svd);
      Element_state<D> state;
      state.s = svd.s;
      m_energy.template derivatives<D>(state.s, state.gradient, state.hessian);

      // Column k: the gradient of vertex k+1's hat function, turned into the frame of V.
      const Matrix<D> hats = svd.V.transpose() * rest_inverse.transpose();
      const Matrix<D> forces = svd.U * (weight * (state.gradient.asDiagonal() * hats));
      const Element& v = m_domain.elements[e];
      for(int k = 0; k < D; ++k) {
        gradient.template segment<D>(D * std::int64_t(v[k + 1])) += forces.col(k);
        gradient.template segment<D>(D * std::int64_t(v[0])) -= forces.col(k);
      }
      if(with_matrix) {
        Increment_form<D> form;
        m_preconditioner.form(state, m_energy, form);
        scatter_form(e, weight, svd.U, hats, form);
      }
    });
  }

  // The step at which the first element collapses.
  double largest_step(const Positions<D>& x, const Positions<D>& direction) const
  {
    return m_schedule.template minimum<Tag>([&](std::int64_t e) {
      return largest_flip_free_step(m_domain.image_edges(e, x), m_domain.image_edges(e, direction));
    });
  }

  // Moves the vertices of the elements that would collapse within `bound` along the direction, each to the optimum of the elements around
  // it: such elements hold up the whole map, and need a place of their own first. `is_positive(e, x)` has the last word on each move.
  template <typename IsPositive>
  void free_blocked_vertices(const Reference& reference, const Positions<D>& direction, double bound, IsPositive&& is_positive,
                             Positions<D>& x)
  {
    if(m_star_begin.empty())
      build_stars();
    std::vector<std::int32_t> blocked;
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      if(largest_flip_free_step(m_domain.image_edges(e, x), m_domain.image_edges(e, direction)) <= bound)
        blocked.insert(blocked.end(), m_domain.elements[e].begin(), m_domain.elements[e].end());
    std::sort(blocked.begin(), blocked.end());
    blocked.erase(std::unique(blocked.begin(), blocked.end()), blocked.end());

    Vertex_relaxation<D, Energy> relaxation(m_energy);
    for(std::int32_t v : blocked) {
      relaxation.clear();
      for(std::int64_t i = m_star_begin[v]; i < m_star_begin[v + 1]; ++i) {
        const std::int64_t e = m_stars[i];
        const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
        int k = 0;
        while(m_domain.elements[e][k] != v)
          ++k;
        const Vector<D> hat = k == 0 ? Vector<D>(-rest_inverse.colwise().sum().transpose()) : Vector<D>(rest_inverse.row(k - 1).transpose());
        relaxation.add(m_domain.image_edges(e, x) * rest_inverse, hat, reference.weight(m_domain, e));
      }
      const Vector<D> origin = x.col(v);
      Vector<D> u = Vector<D>::Zero();
      relaxation.relax(u, 2, [&](const Vector<D>& displacement) {
        x.col(v) = origin + displacement;
        for(std::int64_t i = m_star_begin[v]; i < m_star_begin[v + 1]; ++i)
          if(!is_positive(m_stars[i], x))
            return false;
        return true;
      });
      x.col(v) = origin + u;
    }
  }

  // Smallest and largest signed singular value over all elements.
  std::pair<double, double> singular_value_range(const Positions<D>& x) const
  {
    const double low = m_schedule.template minimum<Tag>(
      [&](std::int64_t e) { return signed_singular_values(m_domain.jacobian(e, x))[D - 1]; });
    const double high = -m_schedule.template minimum<Tag>(
      [&](std::int64_t e) { return -signed_singular_values(m_domain.jacobian(e, x))[0]; });
    return {low, high};
  }

private:
  // The elements around each vertex.
  void build_stars()
  {
    m_star_begin.assign(m_domain.number_of_vertices + 1, 0);
    for(const Element& element : m_domain.elements)
      for(std::int32_t v : element)
        ++m_star_begin[v + 1];
    for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v)
      m_star_begin[v + 1] += m_star_begin[v];
    m_stars.resize(m_star_begin.back());
    std::vector<std::int64_t> next(m_star_begin.begin(), m_star_begin.end() - 1);
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      for(std::int32_t v : m_domain.elements[e])
        m_stars[next[v]++] = static_cast<std::int32_t>(e);
  }

  // Adds weight * (B^T H B) of one element, with B the map from its vertices' displacements to dJ. Rows sum to zero, so the blocks of
  // vertex 0 follow from the others.
  void scatter_form(std::int64_t e, double weight, const Matrix<D>& U, const Matrix<D>& hats, const Increment_form<D>& form)
  {
    std::array<std::array<Matrix<D>, D + 1>, D + 1> blocks;
    blocks[0][0].setZero();
    for(int k = 1; k <= D; ++k)
      blocks[0][k].setZero();
    for(int k = 0; k < D; ++k)
      for(int l = k; l < D; ++l) {
        Matrix<D>& block = blocks[k + 1][l + 1];
        block = weight * (U * form.block(hats.col(k), hats.col(l)) * U.transpose());
        blocks[0][l + 1] -= block;
        if(l != k)
          blocks[0][k + 1] -= block.transpose();
      }
    for(int k = 1; k <= D; ++k)
      blocks[0][0] -= blocks[0][k];

    const Element& v = m_domain.elements[e];
    int p = 0;
    for(int a = 0; a <= D; ++a) {
      m_matrix.add_block(v[a], v[a], 0, blocks[a][a]);
      for(int b = a + 1; b <= D; ++b)
        m_matrix.add_block(v[a], v[b], m_slots[e][p++], blocks[a][b]);
    }
  }

  const Simplicial_domain<D>& m_domain;
  const Energy& m_energy;
  const Preconditioner& m_preconditioner;
  Element_schedule m_schedule;
  Block_sparse_matrix m_matrix;
  std::vector<std::array<std::int32_t, PAIRS>> m_slots;
  std::vector<std::int64_t> m_star_begin; // among m_stars, for each vertex
  std::vector<std::int32_t> m_stars;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_MAP_OBJECTIVE_H
