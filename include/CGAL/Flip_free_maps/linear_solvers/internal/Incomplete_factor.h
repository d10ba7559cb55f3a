// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Incomplete_factor_base.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/cuthill_mckee_order.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The factors L D L^T of a matrix that is scaled to ones on the diagonal, with b x b blocks, ones on the diagonal of L, and no block
// where the matrix has none: on its pattern the product equals the matrix. L is stored by rows. Single precision suffices for it and
// halves what a solve has to read; since the pivots D are made for the rounded L, the product stays symmetric and positive
// definite to the last bit.
template <int b>
class Incomplete_factor : public Incomplete_factor_base
{
public:
  using Index = Block_sparse_matrix::Index;

  explicit Incomplete_factor(const Block_graph& graph);

  bool factorize(const Block_sparse_matrix& matrix) override;

  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& x) override;

  std::int64_t entries() const override
  {
    return static_cast<std::int64_t>(m_blocks.size()) * b * b + static_cast<std::int64_t>(m_pivots.size()) * b * (b + 1) / 2;
  }

private:
  using Block = Eigen::Matrix<double, b, b>;
  using Stored_block = Eigen::Matrix<float, b, b>;
  using Vector = Eigen::Matrix<double, b, 1>;

  // A pivot below is lost in the rounding of L.
  static constexpr double LEAST_PIVOT = 1e-7;
  static constexpr double FIRST_SHIFT = 1e-3;
  static constexpr double LARGEST_SHIFT = 1e6;

  // Enters the scaled matrix.
  void load(const Block_sparse_matrix& matrix);

  // Factorizes what was loaded with `shift` added to the diagonal. `false` at the first pivot that is not positive.
  bool eliminate(double shift);

  // Replaces a pivot by its inverse.
  static bool invert(Block& pivot, double least);

  Block_graph m_graph;                  // of the matrix
  std::vector<std::int32_t> m_order;    // the vertex of each row of blocks
  std::vector<std::int32_t> m_places;   // the inverse
  std::vector<Index> m_begin;           // rows of L
  std::vector<std::int32_t> m_columns;  // ascending in each row
  std::vector<std::uint32_t> m_targets; // of the matrix' blocks, in its order
  std::vector<Stored_block> m_blocks;
  std::vector<Block> m_pivots; // inverted
  Eigen::VectorXd m_scales;    // in the order of the rows of L
  Eigen::VectorXd m_reduced, m_solution;
  std::vector<std::int32_t> m_marks; // -1 between rows
  std::vector<Block> m_row;
};

template <int b>
Incomplete_factor<b>::Incomplete_factor(const Block_graph& graph) : m_graph(graph), m_order(cuthill_mckee_order(graph))
{
  const std::int32_t n = graph.number_of_vertices();
  m_places.resize(n);
  for(std::int32_t i = 0; i < n; ++i)
    m_places[m_order[i]] = i;

  // A counting sort of the blocks by their columns, and a stable one by their rows.
  struct Entry
  {
    std::int32_t row, column;
    std::uint32_t source;
  };
  std::vector<Entry> entries;
  entries.reserve(graph.rows.size() - n);
  for(std::int32_t v = 0; v < n; ++v)
    for(Index k = graph.columns[v] + 1; k < graph.columns[v + 1]; ++k) {
      const std::int32_t p = m_places[v], q = m_places[graph.rows[k]];
      entries.push_back({(std::max)(p, q), (std::min)(p, q), static_cast<std::uint32_t>(entries.size())});
    }
  std::vector<Entry> sorted(entries.size());
  const auto sort_by = [n](const std::vector<Entry>& from, std::int32_t Entry::*key, std::vector<Entry>& to) {
    std::vector<Index> begin(std::size_t(n) + 1, 0);
    for(const Entry& entry : from)
      ++begin[entry.*key + 1];
    for(std::int32_t i = 0; i < n; ++i)
      begin[i + 1] += begin[i];
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for(const Entry& entry : from)
      to[next[entry.*key]++] = entry;
    return begin;
  };
  sort_by(entries, &Entry::column, sorted);
  m_begin = sort_by(sorted, &Entry::row, entries);
  m_columns.resize(entries.size());
  m_targets.resize(entries.size());
  for(std::size_t k = 0; k < entries.size(); ++k) {
    m_columns[k] = entries[k].column;
    m_targets[entries[k].source] = static_cast<std::uint32_t>(k);
  }

  Index widest = 0;
  for(std::int32_t i = 0; i < n; ++i)
    widest = (std::max)(widest, m_begin[i + 1] - m_begin[i]);
  m_row.resize(widest);
  m_marks.assign(n, -1);
  m_blocks.resize(entries.size());
  m_pivots.resize(n);
  m_scales.resize(Eigen::Index(n) * b);
}

template <int b>
bool Incomplete_factor<b>::factorize(const Block_sparse_matrix& matrix)
{
  for(m_shift = 0; m_shift <= LARGEST_SHIFT; m_shift = (std::max)(FIRST_SHIFT, 2 * m_shift)) {
    load(matrix);
    if(eliminate(m_shift))
      return true;
  }
  return false;
}

template <int b>
void Incomplete_factor<b>::load(const Block_sparse_matrix& matrix)
{
  for(std::int32_t v = 0; v < m_graph.number_of_vertices(); ++v)
    for(int i = 0; i < b; ++i) {
      const double diagonal = std::abs(matrix.diagonal(std::size_t(v) * b + i));
      m_scales[Eigen::Index(m_places[v]) * b + i] = diagonal > 0 ? 1 / std::sqrt(diagonal) : 1;
    }
  std::size_t source = 0;
  m_graph.template for_each_block<b>(matrix.values(), [&](std::int32_t v, std::int32_t w, const double* const* block) {
    const std::int32_t p = m_places[v], q = m_places[w];
    const double* s = m_scales.data() + Eigen::Index(p) * b;
    const double* t = m_scales.data() + Eigen::Index(q) * b;
    if(v == w) {
      for(int j = 0; j < b; ++j)
        for(int i = j; i < b; ++i)
          m_pivots[p](i, j) = m_pivots[p](j, i) = t[i] * block[j][i] * s[j];
      return;
    }
    Stored_block& target = m_blocks[m_targets[source++]];
    for(int j = 0; j < b; ++j)
      for(int i = 0; i < b; ++i)
        (p < q ? target(i, j) : target(j, i)) = static_cast<float>(t[i] * block[j][i] * s[j]);
  });
}

template <int b>
bool Incomplete_factor<b>::eliminate(double shift)
{
  for(std::size_t i = 0; i < m_pivots.size(); ++i) {
    const Index first = m_begin[i], last = m_begin[i + 1];
    for(Index k = first; k < last; ++k)
      m_marks[m_columns[k]] = static_cast<std::int32_t>(k - first);
    Block& pivot = m_pivots[i];
    pivot.diagonal().array() += shift;
    // Row i of L D, of which that of L follows.
    for(Index k = first; k < last; ++k) {
      const std::int32_t column = m_columns[k];
      Block product = m_blocks[k].template cast<double>();
      for(Index l = m_begin[column]; l < m_begin[column + 1]; ++l) {
        const std::int32_t place = m_marks[m_columns[l]];
        if(place >= 0)
          product.noalias() -= m_row[place] * m_blocks[l].template cast<double>().transpose();
      }
      m_row[k - first] = product;
      m_blocks[k] = (product * m_pivots[column]).template cast<float>();
      pivot.noalias() -= product * m_blocks[k].template cast<double>().transpose();
    }
    for(Index k = first; k < last; ++k)
      m_marks[m_columns[k]] = -1;
    if(!invert(pivot, LEAST_PIVOT))
      return false;
  }
  return true;
}

template <int b>
bool Incomplete_factor<b>::invert(Block& pivot, double least)
{
  // The inverse of a Cholesky factor; written out, since the decompositions of the library take longer to compile than all else here.
  Block root = Block::Zero(), inverse = Block::Zero();
  for(int j = 0; j < b; ++j) {
    for(int i = j; i < b; ++i) {
      root(i, j) = pivot(i, j);
      for(int k = 0; k < j; ++k)
        root(i, j) -= root(i, k) * root(j, k);
      if(i == j && !(root(j, j) > least && std::isfinite(root(j, j))))
        return false;
      root(i, j) = i == j ? std::sqrt(root(j, j)) : root(i, j) / root(j, j);
    }
    inverse(j, j) = 1 / root(j, j);
    for(int i = 0; i < j; ++i) {
      for(int k = i; k < j; ++k)
        inverse(j, i) -= root(j, k) * inverse(k, i);
      inverse(j, i) *= inverse(j, j);
    }
  }
  for(int j = 0; j < b; ++j)
    for(int i = j; i < b; ++i) {
      double product = 0;
      for(int k = i; k < b; ++k)
        product += inverse(k, i) * inverse(k, j);
      // Symmetric to the last bit.
      pivot(i, j) = pivot(j, i) = product;
    }
  return true;
}

template <int b>
void Incomplete_factor<b>::solve(const Eigen::VectorXd& right, Eigen::VectorXd& x)
{
  const std::int32_t n = static_cast<std::int32_t>(m_pivots.size());
  x.resize(right.size());
  m_reduced.resize(right.size());
  m_solution.resize(right.size());
  for(std::int32_t i = 0; i < n; ++i) {
    const Eigen::Index row = Eigen::Index(i) * b;
    Vector sum = m_scales.segment<b>(row).cwiseProduct(right.segment<b>(Eigen::Index(m_order[i]) * b));
    for(Index k = m_begin[i]; k < m_begin[i + 1]; ++k)
      sum.noalias() -= m_blocks[k].template cast<double>() * m_reduced.segment<b>(Eigen::Index(m_columns[k]) * b);
    m_reduced.segment<b>(row) = sum;
    m_solution.segment<b>(row).noalias() = m_pivots[i] * sum;
  }
  for(std::int32_t i = n; i-- > 0;) {
    const Eigen::Index row = Eigen::Index(i) * b;
    const Vector value = m_solution.segment<b>(row);
    for(Index k = m_begin[i + 1]; k-- > m_begin[i];)
      m_solution.segment<b>(Eigen::Index(m_columns[k]) * b).noalias() -= m_blocks[k].template cast<double>().transpose() * value;
    x.segment<b>(Eigen::Index(m_order[i]) * b) = m_scales.segment<b>(row).cwiseProduct(value);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_INCOMPLETE_FACTOR_H
