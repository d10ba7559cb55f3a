// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_RENEWED_FACTORIZATION_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_RENEWED_FACTORIZATION_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A factorization of an earlier map's matrix M, renewed where the map has changed since. Near an optimum the parts of a few
// elements in a thousand change, those of thin elements, and make all others wait: a step is right everywhere but there. Let S be
// the unknowns of the elements that changed, A the matrix with their parts renewed, and N the other unknowns. S is eliminated
// exactly, and for N the Schur complement of A is taken to be that of M:
//   y_N = (M^-1 r)_N with r_S = 0, r_N = b_N - A_NS A_SS^-1 b_S, and y_S = A_SS^-1 (b_S - A_SN y_N),
// which is symmetric and positive definite, and costs one solve with M and a factorization of the small matrix A_SS.
template <int D>
class Renewed_factorization
{
public:
  // No element is renewed.
  void clear()
  {
    m_elements.clear();
    m_vertices.clear();
  }

  // Renews the elements that were deformed most between the map that was factorized, `old`, and `x`; none if the small matrix has
  // no factorization.
  template <typename Objective, typename Reference>
  void renew(const Objective& objective, const Reference& reference, const Positions<D>& old, const Positions<D>& x)
  {
    std::vector<std::int64_t> elements =
      objective.most_deformed_elements(old, x, DEFORMATION, std::int64_t(LARGEST_PART * objective.number_of_unknowns()));
    std::vector<std::int64_t> missing;
    std::set_difference(elements.begin(), elements.end(), m_elements.begin(), m_elements.end(), std::back_inserter(missing));
    if(missing.size() > FEW * elements.size()) {
      m_elements.swap(elements);
      if(!build(objective)) {
        clear();
        return;
      }
    }
    if(m_elements.empty())
      return;
    m_matrix = m_old_matrix;
    for(std::int64_t e : m_elements) {
      const auto change = objective.change_of_element(reference, old, x, e);
      const auto vertices = objective.unknowns_of_element(e);
      for(int a = 0; a <= D; ++a)
        for(int b = a; b <= D; ++b)
          if(vertices[a] >= 0 && vertices[b] >= 0) {
            const std::int32_t i = m_places[vertices[a]], j = m_places[vertices[b]];
            m_matrix.add_block(i, j, m_matrix.slot(i, j), change[a][b]);
          }
    }
    if(!m_solver.factorize(m_matrix))
      clear();
  }

  // Solves for one right-hand side; `solve(b, y)` does so with the factorization of M.
  template <typename Solve>
  bool solve(const Eigen::VectorXd& b, Solve&& solve, Eigen::VectorXd& y)
  {
    if(m_vertices.empty())
      return solve(b, y);
    gather(b, m_right_hand_side);
    if(!m_solver.solve(m_right_hand_side, m_part))
      return false;
    Eigen::VectorXd r = b;
    for(const std::int32_t v : m_vertices)
      r.template segment<D>(D * std::int64_t(v)).setZero();
    for(const Coupling& c : m_couplings)
      r.template segment<D>(D * std::int64_t(c.vertex)) -= c.block.transpose() * m_part.template segment<D>(D * std::int64_t(c.place));
    if(!solve(r, y))
      return false;
    for(const Coupling& c : m_couplings)
      m_right_hand_side.template segment<D>(D * std::int64_t(c.place)) -= c.block * y.template segment<D>(D * std::int64_t(c.vertex));
    if(!m_solver.solve(m_right_hand_side, m_part))
      return false;
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      y.template segment<D>(D * std::int64_t(m_vertices[i])) = m_part.template segment<D>(D * i);
    return true;
  }

private:
  // The block of the matrix in the rows of a renewed vertex and the columns of one that is not.
  struct Coupling
  {
    std::int32_t place;
    std::int32_t vertex;
    Matrix<D> block;
  };

  // Takes the blocks of the renewed elements' vertices out of the matrix.
  template <typename Objective>
  bool build(const Objective& objective)
  {
    const Block_sparse_matrix& matrix = objective.matrix();
    m_places.assign(matrix.number_of_vertices(), -1);
    m_vertices.clear();
    for(std::int64_t e : m_elements)
      for(std::int32_t v : objective.unknowns_of_element(e))
        if(v >= 0 && m_places[v] < 0) {
          m_places[v] = static_cast<std::int32_t>(m_vertices.size());
          m_vertices.push_back(v);
        }
    std::vector<std::array<std::int32_t, 2>> pairs;
    std::vector<Matrix<D>> blocks;
    m_couplings.clear();
    for_each_block(matrix, [&](std::int32_t v, std::int32_t w, std::int32_t slot) {
      const std::int32_t i = m_places[v], j = m_places[w];
      Matrix<D> block;
      matrix.get_block(v, w, slot, block);
      if(i >= 0 && j >= 0) {
        pairs.push_back({i, j});
        blocks.push_back(block);
      } else if(i >= 0) {
        m_couplings.push_back({i, w, block});
      } else {
        m_couplings.push_back({j, v, block.transpose()});
      }
    });
    m_old_matrix.build_pattern(static_cast<std::int32_t>(m_vertices.size()), D, pairs);
    for(std::size_t p = 0; p < pairs.size(); ++p)
      m_old_matrix.add_block(pairs[p][0], pairs[p][1], m_old_matrix.slot(pairs[p][0], pairs[p][1]), blocks[p]);
    return m_solver.analyze_pattern(m_old_matrix);
  }

  // Calls f(v, w, slot) for the stored blocks of which one vertex at least is renewed.
  template <typename F>
  void for_each_block(const Block_sparse_matrix& matrix, F&& f) const
  {
    const std::vector<Block_sparse_matrix::Index>& begin = matrix.block_column_starts();
    const std::vector<std::int32_t>& rows = matrix.block_row_indices();
    for(std::size_t v = 0; v < m_places.size(); ++v)
      for(Block_sparse_matrix::Index k = begin[v]; k < begin[v + 1]; ++k)
        if(m_places[v] >= 0 || m_places[rows[k]] >= 0)
          f(static_cast<std::int32_t>(v), rows[k], static_cast<std::int32_t>(k - begin[v]));
  }

  void gather(const Eigen::VectorXd& b, Eigen::VectorXd& part) const
  {
    part.resize(D * m_vertices.size());
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      part.template segment<D>(D * i) = b.template segment<D>(D * std::int64_t(m_vertices[i]));
  }

  // Deformation from which on an element is renewed: stiffnesses are powers of the singular values,
  // and have changed by half then.
  static constexpr double DEFORMATION = 0.15;
  // Most elements renewed, relative to the number of unknown vertices; more are not worth their factorization.
  static constexpr double LARGEST_PART = 0.02;

  // Part of the most deformed elements that may be left out, as long as they are few, rather than to choose anew.
  static constexpr double FEW = 0.1;

  std::vector<std::int64_t> m_elements; // the renewed ones, ascending
  std::vector<std::int32_t> m_vertices; // theirs, as numbers of unknowns
  std::vector<std::int32_t> m_places;   // of each unknown vertex among them, or -1
  std::vector<Coupling> m_couplings;
  Block_sparse_matrix m_old_matrix; // M_SS
  Block_sparse_matrix m_matrix;     // A_SS
  Eigen_simplicial_solver m_solver;
  Eigen::VectorXd m_right_hand_side, m_part;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_RENEWED_FACTORIZATION_H
