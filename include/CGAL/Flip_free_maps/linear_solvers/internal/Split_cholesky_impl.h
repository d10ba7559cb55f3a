// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Split_cholesky.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::analyze(const Block_sparse_matrix& matrix, const Elimination_split& split)
{
  m_block_size = matrix.block_size();
  m_number_of_separator_rows = m_block_size * static_cast<Index>(split.separator().size());
  std::array<bool, 2> analyzed;
  with_both([&] { analyzed[0] = m_halves[0].analyze(matrix, split.part(0), split.separator()); },
            [&] { analyzed[1] = m_halves[1].analyze(matrix, split.part(1), split.separator()); });
  m_separator.clear();
  return analyzed[0] && analyzed[1];
}

CGAL_FLIP_FREE_MAPS_INLINE double Split_cholesky::entries() const
{
  const double m = static_cast<double>(m_number_of_separator_rows);
  return m_halves[0].factor.entries() + m_halves[1].factor.entries() + m * (m + 1) / 2;
}

CGAL_FLIP_FREE_MAPS_INLINE double Split_cholesky::operations() const
{
  const double m = static_cast<double>(m_number_of_separator_rows);
  return m_halves[0].factor.operations() + m_halves[1].factor.operations() + m * m * m / 3;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::factorize(const Block_sparse_matrix& matrix)
{
  std::array<bool, 2> factorized;
  with_both([&] { factorized[0] = m_halves[0].factorize(matrix); }, [&] { factorized[1] = m_halves[1].factorize(matrix); });
  if(!factorized[0] || !factorized[1])
    return false;
  if(m_number_of_separator_rows == 0)
    return true;
  Eigen::MatrixXd& sum = m_halves[0].schur_complement;
  sum += m_halves[1].schur_complement;
  m_halves[0].subtract_separator(sum);
  m_separator_values.clear();
  for(Index j = 0; j < sum.cols(); ++j)
    m_separator_values.insert(m_separator_values.end(), sum.data() + j * sum.rows() + j, sum.data() + (j + 1) * sum.rows());
  return (m_separator.is_analyzed() || analyze_separator()) && m_separator.factorize(separator_view());
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  std::array<bool, 2> solved;
  with_both([&] { solved[0] = m_halves[0].eliminate(b); }, [&] { solved[1] = m_halves[1].eliminate(b); });
  if(!solved[0] || !solved[1])
    return false;
  x.resize(b.size());
  if(m_number_of_separator_rows > 0) {
    m_separator_right = m_halves[0].separator_part(b) + m_halves[0].correction + m_halves[1].correction;
    if(!m_separator.solve(m_separator_right, m_separator_solution))
      return false;
    m_halves[0].enter_separator_part(m_separator_solution, x);
  }
  with_both([&] { solved[0] = m_halves[0].substitute(m_separator_solution, x); },
            [&] { solved[1] = m_halves[1].substitute(m_separator_solution, x); });
  return solved[0] && solved[1];
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::Half::analyze(const Block_sparse_matrix& whole, const std::vector<std::int32_t>& part,
                                                              const std::vector<std::int32_t>& separator)
{
  block_size = whole.block_size();
  vertices = part;
  vertices.insert(vertices.end(), separator.begin(), separator.end());
  number_of_inner_rows = block_size * static_cast<Index>(part.size());
  std::vector<std::int32_t> numbers(whole.number_of_vertices(), -1);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    numbers[vertices[i]] = static_cast<std::int32_t>(i);
  std::vector<std::array<std::int32_t, 2>> edges;
  const auto for_each_edge = [&](auto&& f) {
    const auto& columns = whole.block_column_starts();
    const auto& rows = whole.block_row_indices();
    for(std::int32_t v : vertices)
      for(Index i = columns[v] + 1; i < columns[v + 1]; ++i)
        if(numbers[rows[i]] >= 0)
          f(v, rows[i], static_cast<std::int32_t>(i - columns[v]));
  };
  for_each_edge([&](std::int32_t v, std::int32_t w, std::int32_t) { edges.push_back({{numbers[v], numbers[w]}}); });
  matrix.build_pattern(static_cast<std::int32_t>(vertices.size()), block_size, edges);
  sources.clear();
  sources.reserve(edges.size());
  for_each_edge([&](std::int32_t v, std::int32_t w, std::int32_t slot) {
    sources.push_back({numbers[v], numbers[w], matrix.slot(numbers[v], numbers[w]), slot});
  });
  return factor.analyze_in_order(cholmod_view(matrix), nullptr);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::Half::factorize(const Block_sparse_matrix& whole)
{
  matrix.set_zero();
  Block block(block_size, block_size);
  for(std::size_t v = 0; v < vertices.size(); ++v) {
    whole.get_block(vertices[v], vertices[v], 0, block);
    matrix.add_block(static_cast<std::int32_t>(v), static_cast<std::int32_t>(v), 0, block);
  }
  for(const Source& source : sources) {
    whole.get_block(vertices[source.v], vertices[source.w], source.whole_slot, block);
    matrix.add_block(source.v, source.w, source.slot, block);
  }
  if(!factor.factorize(cholmod_view(matrix)))
    return false;
  factor.last_block(number_of_inner_rows, last_block);
  schur_complement.setZero(last_block.rows(), last_block.cols());
  add_square(last_block, schur_complement);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Split_cholesky::Half::subtract_separator(Eigen::MatrixXd& sum) const
{
  const auto& columns = matrix.column_starts();
  const auto& rows = matrix.row_indices();
  for(Index j = number_of_inner_rows; j < matrix.rows(); ++j)
    for(Index i = columns[j]; i < columns[j + 1]; ++i)
      sum(rows[i] - number_of_inner_rows, j - number_of_inner_rows) -= matrix.values()[i];
}

CGAL_FLIP_FREE_MAPS_INLINE Eigen::VectorXd Split_cholesky::Half::separator_part(const Eigen::VectorXd& b) const
{
  Eigen::VectorXd result(matrix.rows() - number_of_inner_rows);
  for(Index i = number_of_inner_rows; i < matrix.rows(); ++i)
    result[i - number_of_inner_rows] = b[whole_row(i)];
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void Split_cholesky::Half::enter_separator_part(const Eigen::VectorXd& part, Eigen::VectorXd& x) const
{
  for(Index i = number_of_inner_rows; i < matrix.rows(); ++i)
    x[whole_row(i)] = part[i - number_of_inner_rows];
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::Half::eliminate(const Eigen::VectorXd& b)
{
  eliminated.setZero(matrix.rows());
  for(Index i = 0; i < number_of_inner_rows; ++i)
    eliminated[i] = b[whole_row(i)];
  if(!factor.solve_lower(eliminated))
    return false;
  const Index m = matrix.rows() - number_of_inner_rows;
  correction = last_block.triangularView<Eigen::Lower>() * eliminated.tail(m);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::Half::substitute(const Eigen::VectorXd& separator_solution, Eigen::VectorXd& x)
{
  const Index m = matrix.rows() - number_of_inner_rows;
  if(m > 0)
    eliminated.tail(m) = last_block.triangularView<Eigen::Lower>().transpose() * separator_solution;
  if(!factor.solve_upper(eliminated))
    return false;
  for(Index i = 0; i < number_of_inner_rows; ++i)
    x[whole_row(i)] = eliminated[i];
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Split_cholesky::add_square(const Eigen::MatrixXd& L, Eigen::MatrixXd& sum)
{
  using Dsyrk =
    void(const char*, const char*, const int*, const int*, const double*, const double*, const int*, const double*, double*, const int*);
  static Dsyrk* const dsyrk = blas_function<Dsyrk>("dsyrk_");
  constexpr Index PANEL = 192;
  const double one = 1;
  for(Index j = 0; j < L.cols(); j += PANEL) {
    const Index rows = L.rows() - j, columns = (std::min)(PANEL, L.cols() - j);
    if(dsyrk != nullptr) {
      const int n = static_cast<int>(rows), k = static_cast<int>(columns), lda = static_cast<int>(L.rows());
      dsyrk("L", "N", &n, &k, &one, L.data() + j * L.rows() + j, &lda, &one, sum.data() + j * L.rows() + j, &lda);
    } else {
      sum.bottomRightCorner(rows, rows).selfadjointView<Eigen::Lower>().rankUpdate(L.block(j, j, rows, columns));
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Split_cholesky::analyze_separator()
{
  const Index m = m_number_of_separator_rows;
  m_separator_columns.resize(m + 1);
  m_separator_rows.clear();
  m_separator_rows.reserve(m * (m + 1) / 2);
  for(Index j = 0; j <= m; ++j) {
    m_separator_columns[j] = static_cast<Index>(m_separator_rows.size());
    for(Index i = j; i < m; ++i)
      m_separator_rows.push_back(i);
  }
  return m_separator.analyze_in_order(separator_view(), nullptr);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_IMPL_H
