// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Factorization in two parts: the split of the elimination tree against its definition, solutions against the matrix, threads.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Cholmod_factor.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Elimination_split.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Split_cholesky.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#endif

BOOST_AUTO_TEST_SUITE(test_split_cholesky)

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

using Edges = std::vector<std::array<std::int32_t, 2>>;

// A grid of quadrangles, its vertices numbered from `first` on.
void add_grid(int columns, int rows, std::int32_t first, Edges& edges)
{
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j) {
      const std::int32_t v = first + i * rows + j;
      if(i + 1 < columns)
        edges.push_back({{v, v + rows}});
      if(j + 1 < rows)
        edges.push_back({{v, v + 1}});
    }
}

// Positive definite: a random semidefinite matrix for each edge, and a small multiple of the identity.
FFM::Block_sparse_matrix make_matrix(std::int32_t n, int b, const Edges& edges, std::uint64_t seed)
{
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(n, b, edges);
  Random random(seed);
  for(const auto& edge : edges) {
    Eigen::MatrixXd root(b, 2 * b);
    for(Eigen::Index i = 0; i < root.size(); ++i)
      root.data()[i] = random(-1, 1);
    const Eigen::MatrixXd element = root.transpose() * root;
    for(int k = 0; k < 2; ++k)
      for(int l = k; l < 2; ++l)
        matrix.add_block(edge[k], edge[l], matrix.slot(edge[k], edge[l]), element.block(k * b, l * b, b, b));
  }
  for(FFM::Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
    matrix.diagonal(i) += 0.1;
  return matrix;
}

double residual(const FFM::Block_sparse_matrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& x)
{
  return (matrix.lower().selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
}

FFM::internal::Elimination_split split_of(const FFM::Block_sparse_matrix& matrix, std::vector<std::int64_t>* order = nullptr,
                                          std::vector<double>* counts = nullptr)
{
  const std::vector<FFM::Block_sparse_matrix::Index> rows(matrix.block_row_indices().begin(), matrix.block_row_indices().end());
  FFM::internal::Cholmod_factor factor;
  BOOST_TEST_REQUIRE(
    factor.order(FFM::internal::cholmod_view(matrix.number_of_vertices(), matrix.block_column_starts(), rows, nullptr), CHOLMOD_METIS));
  if(order != nullptr)
    order->assign(factor.order(), factor.order() + matrix.number_of_vertices());
  if(counts != nullptr)
    counts->assign(factor.column_counts(), factor.column_counts() + matrix.number_of_vertices());
  return FFM::internal::Elimination_split(matrix, factor.order(), factor.column_counts());
}

} // namespace

BOOST_AUTO_TEST_CASE(parts_are_not_adjacent_and_keep_the_order)
{
  Edges edges;
  add_grid(50, 40, 0, edges);
  const FFM::Block_sparse_matrix matrix = make_matrix(2000, 1, edges, 71);
  std::vector<std::int64_t> order;
  std::vector<double> counts;
  const FFM::internal::Elimination_split split = split_of(matrix, &order, &counts);
  BOOST_TEST_REQUIRE(split.is_worthwhile());

  std::vector<int> place(2000), part(2000, -1);
  for(int k = 0; k < 2000; ++k)
    place[order[k]] = k;
  const std::array<const std::vector<std::int32_t>*, 3> sets = {{&split.part(0), &split.part(1), &split.separator()}};
  for(int i = 0; i < 3; ++i) {
    for(std::int32_t v : *sets[i]) {
      BOOST_TEST_REQUIRE(part[v] == -1);
      part[v] = i;
    }
    BOOST_TEST(std::is_sorted(sets[i]->begin(), sets[i]->end(), [&](int v, int w) { return place[v] < place[w]; }));
  }
  BOOST_TEST(std::count(part.begin(), part.end(), -1) == 0);
  for(const auto& edge : edges)
    BOOST_TEST(part[edge[0]] + part[edge[1]] != 1);
  // In the time of two threads, in units of the entries of columns squared, the split must gain what makes it worthwhile.
  std::array<double, 2> load = {{0, 0}};
  double total = 0;
  for(int k = 0; k < 2000; ++k) {
    const double work = counts[k] * counts[k];
    total += work;
    if(part[order[k]] < 2)
      load[part[order[k]]] += work;
  }
  BOOST_TEST(1.3 * ((std::max)(load[0], load[1]) + std::pow(split.separator().size(), 3)) <= total);

  // The same again, from an ordering of its own.
  const FFM::internal::Elimination_split again = split_of(matrix);
  for(int i = 0; i < 2; ++i)
    BOOST_TEST((again.part(i) == split.part(i)));
  BOOST_TEST((again.separator() == split.separator()));
}

BOOST_AUTO_TEST_CASE(a_chain_is_not_split)
{
  // In its natural order the tree of a path is a path.
  Edges edges;
  for(int v = 0; v < 99; ++v)
    edges.push_back({{v, v + 1}});
  const FFM::Block_sparse_matrix matrix = make_matrix(100, 1, edges, 72);
  std::vector<std::int64_t> order(100), counts(100, 2);
  std::iota(order.begin(), order.end(), 0);
  BOOST_TEST(!FFM::internal::Elimination_split(matrix, order.data(), counts.data()).is_worthwhile());
}

BOOST_AUTO_TEST_CASE(solutions_and_threads, *boost::unit_test::label("needs_tbb"))
{
  struct Example
  {
    int columns, rows, block_size;
    bool is_supernodal;
  };
  for(const Example& example : {Example{50, 40, 2, true}, Example{40, 30, 3, true}, Example{700, 2, 1, false}}) {
    Edges edges;
    add_grid(example.columns, example.rows, 0, edges);
    const FFM::Block_sparse_matrix matrix = make_matrix(example.columns * example.rows, example.block_size, edges, 73);
    const FFM::internal::Elimination_split split = split_of(matrix);
    BOOST_TEST_REQUIRE(split.is_worthwhile());
    const Eigen::VectorXd right = Random(74).vector(matrix.rows());
    FFM::Cholmod_solver whole;
    Eigen::VectorXd expected;
    BOOST_TEST_REQUIRE((whole.analyze_pattern(matrix) && whole.factorize(matrix) && whole.solve(right, expected)));
    BOOST_TEST(residual(matrix, right, expected) <= 1e-12);

    std::vector<Eigen::VectorXd> solutions;
    for(int threads : {1, 2, 2}) {
#ifdef CGAL_LINKED_WITH_TBB
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#else
      static_cast<void>(threads);
#endif
      FFM::internal::Split_cholesky solver;
      BOOST_TEST_REQUIRE(solver.analyze(matrix, split));
      BOOST_TEST(solver.is_supernodal() == example.is_supernodal);
      solutions.emplace_back();
      // The second factorization uses the storage of the first.
      for(int i = 0; i < 2; ++i)
        BOOST_TEST_REQUIRE((solver.factorize(matrix) && solver.solve(right, solutions.back())));
      BOOST_TEST(residual(matrix, right, solutions.back()) <= 1e-12);
      BOOST_TEST((solutions.back() - expected).norm() <= 1e-11 * expected.norm());
      BOOST_TEST((solutions.back() == solutions.front()));
    }
  }
#ifndef CGAL_LINKED_WITH_TBB
  skip_case("built without oneTBB: there is one thread only");
#endif
}

BOOST_AUTO_TEST_CASE(parts_without_a_separator)
{
  Edges edges;
  add_grid(30, 30, 0, edges);
  add_grid(30, 30, 900, edges);
  const FFM::Block_sparse_matrix matrix = make_matrix(1800, 2, edges, 75);
  const FFM::internal::Elimination_split split = split_of(matrix);
  BOOST_TEST_REQUIRE(split.is_worthwhile());
  BOOST_TEST(split.separator().empty());
  FFM::internal::Split_cholesky solver;
  const Eigen::VectorXd right = Random(76).vector(matrix.rows());
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE((solver.analyze(matrix, split) && solver.factorize(matrix) && solver.solve(right, x)));
  BOOST_TEST(residual(matrix, right, x) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(indefinite_matrices_are_rejected)
{
  Edges edges;
  add_grid(40, 40, 0, edges);
  FFM::Block_sparse_matrix matrix = make_matrix(1600, 2, edges, 77);
  const FFM::internal::Elimination_split split = split_of(matrix);
  BOOST_TEST_REQUIRE(split.is_worthwhile());
  FFM::internal::Split_cholesky solver;
  BOOST_TEST_REQUIRE(solver.analyze(matrix, split));
  for(const std::vector<std::int32_t>* set : {&split.part(0), &split.part(1), &split.separator()}) {
    const std::size_t row = 2 * set->back();
    const double good = matrix.diagonal(row);
    matrix.diagonal(row) = -1;
    BOOST_TEST(!solver.factorize(matrix));
    matrix.diagonal(row) = good;
    BOOST_TEST(solver.factorize(matrix));
  }
}

// Large enough for the solver to consider two parts.
BOOST_AUTO_TEST_CASE(large_matrices)
{
  Edges edges;
  add_grid(150, 150, 0, edges);
  const FFM::Block_sparse_matrix matrix = make_matrix(22500, 3, edges, 78);
  FFM::Cholmod_solver solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
  BOOST_TEST(solver.factor_operations() >= FFM::Cholmod_solver::SPLIT_THRESHOLD);
  BOOST_TEST(solver.factor_entries() > matrix.number_of_entries());
  BOOST_TEST(solver.name() == "cholmod_supernodal");
  const Eigen::VectorXd right = Random(79).vector(matrix.rows());
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE((solver.factorize(matrix) && solver.solve(right, x)));
  BOOST_TEST(residual(matrix, right, x) <= 1e-12);
}
#else
BOOST_AUTO_TEST_CASE(needs_cholmod) { test_support::skip_case("built without CHOLMOD"); }

BOOST_AUTO_TEST_CASE(solutions_and_threads, *boost::unit_test::label("needs_tbb")) { test_support::skip_case("built without CHOLMOD"); }
#endif

BOOST_AUTO_TEST_SUITE_END() // test_split_cholesky
