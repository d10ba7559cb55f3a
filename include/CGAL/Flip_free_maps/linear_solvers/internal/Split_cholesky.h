// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#include <CGAL/Flip_free_maps/internal/parallel_invoke.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Cholesky factorization in two parts that do not need each other, and their separator. With A = [A_1 0 B_1; 0 A_2 B_2; B_1^T
// B_2^T S] the factors of [A_i B_i; B_i^T S] end with those of the Schur complements S - B_i^T A_i^-1 B_i; these, with one S
// taken away, add up to the matrix of the separator's unknowns. All is done in the same order by one thread and by two,
// so results are the same.
class Split_cholesky
{
public:
  static constexpr int LARGEST_BLOCK = 3; // rows

private:
  using Index = Block_sparse_matrix::Index;
  using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, LARGEST_BLOCK, LARGEST_BLOCK>;

public:
  bool analyze(const Block_sparse_matrix& matrix, const Elimination_split& split);

  bool is_supernodal() const { return m_halves[0].factor.is_supernodal(); }

  // The separator's factor is dense.
  double entries() const;

  double operations() const;

  bool factorize(const Block_sparse_matrix& matrix);

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

private:
  // One part with the separator behind it.
  struct Half
  {
    // A block of the whole matrix and its place in this one.
    struct Source
    {
      std::int32_t v, w; // here
      std::int32_t slot, whole_slot;
    };

    std::vector<std::int32_t> vertices; // in the whole matrix
    Index number_of_inner_rows = 0;
    int block_size = 0;
    Block_sparse_matrix matrix;
    std::vector<Source> sources;
    Cholmod_factor factor;
    Eigen::MatrixXd schur_complement; // lower triangle
    Eigen::MatrixXd last_block;       // of the factor
    Eigen::VectorXd eliminated, correction;

    bool analyze(const Block_sparse_matrix& whole, const std::vector<std::int32_t>& part, const std::vector<std::int32_t>& separator);

    bool factorize(const Block_sparse_matrix& whole);

    // Takes the separator's own entries away from the lower triangle of a matrix.
    void subtract_separator(Eigen::MatrixXd& sum) const;

    // The row in the whole matrix of row i here.
    Index whole_row(Index i) const { return vertices[i / block_size] * Index(block_size) + i % block_size; }

    Eigen::VectorXd separator_part(const Eigen::VectorXd& b) const;

    void enter_separator_part(const Eigen::VectorXd& part, Eigen::VectorXd& x) const;

    // Eliminates the inner unknowns from the right-hand side; what that adds to the separator's is the correction.
    bool eliminate(const Eigen::VectorXd& b);

    // Enters the inner unknowns that belong to a solution on the separator into x.
    bool substitute(const Eigen::VectorXd& separator_solution, Eigen::VectorXd& x);
  };

  // Runs both functions, each without further threads; OpenMP keeps that setting for each thread.
  template <typename F, typename G>
  static void with_both(F&& f, G&& g)
  {
    const auto run_alone = [](const auto& function) {
      const Single_thread guard;
      function();
    };
    parallel_invoke<CGAL::Parallel_if_available_tag>([&] { run_alone(f); }, [&] { run_alone(g); });
  }

  // Adds L L^T to the lower triangle of a matrix, panel by panel below the diagonal of L.
  static void add_square(const Eigen::MatrixXd& L, Eigen::MatrixXd& sum);

  cholmod_sparse separator_view() const
  {
    return cholmod_view(m_number_of_separator_rows, m_separator_columns, m_separator_rows, m_separator_values.data());
  }

  // Only a factorization needs memory for a dense pattern.
  bool analyze_separator();

  int m_block_size = 0;
  Index m_number_of_separator_rows = 0;
  std::array<Half, 2> m_halves;
  std::vector<Index> m_separator_columns, m_separator_rows;
  std::vector<double> m_separator_values;
  Cholmod_factor m_separator;
  Eigen::VectorXd m_separator_right, m_separator_solution;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Split_cholesky_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_SPLIT_CHOLESKY_H
