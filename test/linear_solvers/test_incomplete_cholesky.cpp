// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The factorization without fill against what defines it: exact where there is no fill, equal to the matrix on its pattern elsewhere.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Symmetric_product.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/cuthill_mckee_order.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_incomplete_cholesky)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

using Edges = std::vector<std::array<std::int32_t, 2>>;

// 0 to n - 1 in another order, for n prime to 37.
std::int32_t shuffled(std::int32_t v, std::int32_t n) { return (37 * v + 11) % n; }

Edges path(std::int32_t n)
{
  Edges edges;
  for(std::int32_t v = 0; v + 1 < n; ++v)
    edges.push_back({{shuffled(v, n), shuffled(v + 1, n)}});
  return edges;
}

Edges tree(std::int32_t n)
{
  Edges edges;
  for(std::int32_t v = 1; v < n; ++v)
    edges.push_back({{shuffled((v - 1) / 3, n), shuffled(v, n)}});
  return edges;
}

// Quadrangles with one diagonal each.
Edges grid(std::int32_t columns, std::int32_t rows)
{
  Edges edges;
  const auto number = [=](std::int32_t i, std::int32_t j) { return shuffled(i * rows + j, columns * rows); };
  for(std::int32_t i = 0; i < columns; ++i)
    for(std::int32_t j = 0; j < rows; ++j) {
      if(i + 1 < columns)
        edges.push_back({{number(i, j), number(i + 1, j)}});
      if(j + 1 < rows)
        edges.push_back({{number(i, j), number(i, j + 1)}});
      if(i + 1 < columns && j + 1 < rows)
        edges.push_back({{number(i, j), number(i + 1, j + 1)}});
    }
  return edges;
}

// Positive definite: a random semidefinite matrix for each edge, and a small multiple of the identity.
void fill(FFM::Block_sparse_matrix& matrix, const Edges& edges, std::uint64_t seed)
{
  const int b = matrix.block_size();
  Random random(seed);
  matrix.set_zero();
  for(const auto& edge : edges) {
    Eigen::MatrixXd root(2 * b, 2 * b);
    for(Eigen::Index i = 0; i < root.size(); ++i)
      root.data()[i] = random(-1, 1);
    const Eigen::MatrixXd element = root.transpose() * root;
    for(int k = 0; k < 2; ++k)
      for(int l = k; l < 2; ++l)
        matrix.add_block(edge[k], edge[l], matrix.slot(edge[k], edge[l]), element.block(k * b, l * b, b, b));
  }
  for(FFM::Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
    matrix.diagonal(i) += 0.1;
}

FFM::Block_sparse_matrix make_matrix(std::int32_t n, int b, const Edges& edges, std::uint64_t seed = 5)
{
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(n, b, edges);
  fill(matrix, edges, seed);
  return matrix;
}

Eigen::MatrixXd dense(const FFM::Block_sparse_matrix& matrix)
{
  Eigen::MatrixXd full(matrix.lower());
  full.triangularView<Eigen::StrictlyUpper>() = full.transpose();
  return full;
}

// The matrix that the factor solves with, inverted.
Eigen::MatrixXd inverse_of_factors(FFM::Incomplete_cholesky& factor, Eigen::Index n)
{
  Eigen::MatrixXd inverse(n, n);
  Eigen::VectorXd x;
  for(Eigen::Index i = 0; i < n; ++i) {
    BOOST_TEST_REQUIRE(factor.solve(Eigen::VectorXd::Unit(n, i), x));
    inverse.col(i) = x;
  }
  return inverse;
}

// The largest difference on the pattern and beside it, each entry in proportion to the diagonal ones.
std::array<double, 2> differences(const FFM::Block_sparse_matrix& matrix, const Eigen::MatrixXd& product, double shift)
{
  const Eigen::MatrixXd full = dense(matrix);
  Eigen::MatrixXd is_stored = Eigen::MatrixXd::Zero(matrix.rows(), matrix.rows());
  for(FFM::Block_sparse_matrix::Index j = 0; j < matrix.rows(); ++j)
    for(FFM::Block_sparse_matrix::Index k = matrix.column_starts()[j]; k < matrix.column_starts()[j + 1]; ++k)
      is_stored(matrix.row_indices()[k], j) = is_stored(j, matrix.row_indices()[k]) = 1;
  std::array<double, 2> result{{0, 0}};
  for(Eigen::Index j = 0; j < full.rows(); ++j)
    for(Eigen::Index i = 0; i < full.rows(); ++i) {
      const double expected = full(i, j) + (i == j ? shift * std::abs(full(i, i)) : 0);
      double& largest = result[is_stored(i, j) == 1 ? 0 : 1];
      largest = (std::max)(largest, std::abs(product(i, j) - expected) / std::sqrt(std::abs(full(i, i) * full(j, j))));
    }
  return result;
}

void check_positive_definite(const Eigen::MatrixXd& inverse)
{
  BOOST_TEST((inverse - inverse.transpose()).norm() <= 1e-13 * inverse.norm());
  const Eigen::MatrixXd symmetric = 0.5 * (inverse + inverse.transpose());
  BOOST_TEST(smallest_eigenvalue(symmetric) > 0);
}

// 0, or the least shift times a power of two.
bool is_doubled_shift(double shift) { return shift > 0 && std::abs(std::remainder(std::log2(shift / 1e-3), 1)) < 1e-9; }

} // namespace

BOOST_AUTO_TEST_CASE(exact_where_there_is_no_fill)
{
  for(int b = 1; b <= 4; ++b)
    for(const Edges& edges : {path(60), tree(60)}) {
      const FFM::Block_sparse_matrix matrix = make_matrix(60, b, edges);
      const Eigen::VectorXd right = Random(6).vector(static_cast<int>(matrix.rows()));
      FFM::Incomplete_cholesky factor;
      BOOST_TEST_REQUIRE(factor.analyze_pattern(matrix));
      BOOST_TEST_REQUIRE(factor.factorize(matrix));
      BOOST_TEST(factor.shift() == 0);
      Eigen::VectorXd x;
      BOOST_TEST_REQUIRE(factor.solve(right, x));
      BOOST_TEST((dense(matrix) * x - right).norm() <= 1e-5 * right.norm());
    }
}

BOOST_AUTO_TEST_CASE(equal_to_the_matrix_on_its_pattern)
{
  for(int b = 1; b <= 4; ++b) {
    const FFM::Block_sparse_matrix matrix = make_matrix(9 * 7, b, grid(9, 7));
    FFM::Incomplete_cholesky factor;
    BOOST_TEST(factor.factor_entries() == -1);
    BOOST_TEST_REQUIRE(factor.analyze_pattern(matrix));
    BOOST_TEST(factor.factor_entries() == matrix.number_of_entries());
    BOOST_TEST_REQUIRE(factor.factorize(matrix));
    BOOST_TEST(factor.shift() == 0);
    const Eigen::MatrixXd inverse = inverse_of_factors(factor, matrix.rows());
    check_positive_definite(inverse);
    const auto difference = differences(matrix, inverse.inverse(), 0);
    BOOST_TEST(difference[0] <= 1e-6);
    BOOST_TEST(difference[1] >= 1e-2);
  }
}

BOOST_AUTO_TEST_CASE(pivots_that_are_not_positive_get_a_shift)
{
  // The example of Kershaw 1978 is positive definite, its factorization without fill fails.
  const Edges cycle{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{0, 3}}};
  FFM::Block_sparse_matrix kershaw;
  kershaw.build_pattern(4, 1, cycle);
  for(int v = 0; v < 4; ++v) {
    kershaw.diagonal(v) = 3;
    kershaw.add_block(cycle[v][0], cycle[v][1], kershaw.slot(cycle[v][0], cycle[v][1]), Eigen::Matrix<double, 1, 1>(v < 3 ? -2 : 2));
  }
  std::vector<FFM::Block_sparse_matrix> matrices{kershaw};
  for(int b = 1; b <= 4; ++b)
    for(double factor : {-1., 0.01}) {
      matrices.push_back(make_matrix(9 * 7, b, grid(9, 7)));
      matrices.back().diagonal(17) *= factor;
    }
  for(const FFM::Block_sparse_matrix& matrix : matrices) {
    FFM::Incomplete_cholesky factor;
    BOOST_TEST_REQUIRE(factor.analyze_pattern(matrix));
    BOOST_TEST_REQUIRE(factor.factorize(matrix));
    BOOST_TEST(is_doubled_shift(factor.shift()));
    const Eigen::MatrixXd inverse = inverse_of_factors(factor, matrix.rows());
    check_positive_definite(inverse);
    BOOST_TEST(differences(matrix, inverse.inverse(), factor.shift())[0] <= 1e-5 * (1 + factor.shift()));
  }
}

BOOST_AUTO_TEST_CASE(bits_depend_on_the_matrix_alone)
{
  const Edges edges = grid(9, 7);
  FFM::Block_sparse_matrix matrix = make_matrix(9 * 7, 3, edges);
  const Eigen::VectorXd right = Random(7).vector(static_cast<int>(matrix.rows()));
  Eigen::VectorXd first, second, x;
  FFM::Incomplete_cholesky factor;
  BOOST_TEST_REQUIRE((factor.analyze_pattern(matrix) && factor.factorize(matrix) && factor.solve(right, first)));
  BOOST_TEST_REQUIRE(factor.solve(right, x));
  BOOST_TEST((x == first));
  // A matrix that needs a shift leaves no trace.
  matrix.diagonal(40) = -1;
  BOOST_TEST_REQUIRE((factor.factorize(matrix) && factor.solve(right, second)));
  BOOST_TEST(factor.shift() > 0);
  BOOST_TEST((second != first));
  fill(matrix, edges, 5);
  BOOST_TEST_REQUIRE((factor.factorize(matrix) && factor.solve(right, x)));
  BOOST_TEST((x == first));
  // What is larger than single precision holds, too: powers of two are exact.
  const double scale = std::ldexp(1, 200);
  for(int v = 0; v < 9 * 7; ++v)
    for(auto k = matrix.block_column_starts()[v]; k < matrix.block_column_starts()[v + 1]; ++k) {
      const std::int32_t w = matrix.block_row_indices()[k];
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      matrix.get_block(v, w, matrix.slot(v, w), block);
      matrix.add_block(v, w, matrix.slot(v, w), Eigen::Matrix3d((scale - 1) * block));
    }
  BOOST_TEST_REQUIRE((factor.factorize(matrix) && factor.solve(right, x)));
  BOOST_TEST((scale * x - first).norm() <= 1e-6 * first.norm());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_factorized)
{
  FFM::Block_sparse_matrix matrix = make_matrix(60, 2, path(60));
  const FFM::Block_sparse_matrix other = make_matrix(61, 2, tree(61));
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(matrix.rows());
  Eigen::VectorXd x;
  FFM::Incomplete_cholesky factor;
  BOOST_TEST(!factor.factorize(matrix));
  BOOST_TEST(!factor.solve(right, x));
  BOOST_TEST_REQUIRE(factor.analyze_pattern(matrix));
  BOOST_TEST(!factor.solve(right, x));
  BOOST_TEST(!factor.factorize(other));
  BOOST_TEST(factor.factorize(matrix));
  BOOST_TEST(factor.solve(right, x));
  for(double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    matrix.diagonal(3) = value;
    BOOST_TEST(!factor.factorize(matrix));
    BOOST_TEST(!factor.solve(right, x));
  }
}

BOOST_AUTO_TEST_CASE(order)
{
  // A grid, a path, and a vertex alone.
  Edges edges = grid(8, 8);
  for(const auto& edge : path(20))
    edges.push_back({{edge[0] + 64, edge[1] + 64}});
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(85, 2, edges);
  const std::vector<std::int32_t> order = FFM::internal::cuthill_mckee_order(FFM::internal::Block_graph(matrix));
  BOOST_TEST_REQUIRE(order.size() == 85u);
  std::vector<int> places(85, -1);
  for(int i = 0; i < 85; ++i)
    places[order[i]] = i;
  BOOST_TEST(*std::min_element(places.begin(), places.end()) == 0);
  // Each has a neighbour after it, but for the last ones of the parts; and none is far away.
  std::vector<char> has_later(85, 0);
  int bandwidth = 0;
  for(const auto& edge : edges) {
    has_later[places[edge[0]] < places[edge[1]] ? edge[0] : edge[1]] = 1;
    bandwidth = (std::max)(bandwidth, std::abs(places[edge[0]] - places[edge[1]]));
  }
  BOOST_TEST(std::count(has_later.begin(), has_later.end(), 0) == 3);
  BOOST_TEST(bandwidth <= 20);
  for(const auto& edge : edges)
    if(edge[0] >= 64)
      BOOST_TEST(std::abs(places[edge[0]] - places[edge[1]]) == 1);
}

BOOST_AUTO_TEST_CASE(products)
{
  for(int b = 1; b <= 4; ++b) {
    const FFM::Block_sparse_matrix matrix = make_matrix(9 * 7, b, grid(9, 7));
    const Eigen::VectorXd x = Random(8).vector(static_cast<int>(matrix.rows()));
    FFM::internal::Symmetric_product product;
    product.analyze_pattern(matrix);
    BOOST_TEST_REQUIRE(product.copy(matrix));
    Eigen::VectorXd y = x;
    product.multiply(x, y);
    BOOST_TEST((y - dense(matrix) * x).norm() <= 1e-14 * y.norm());
    BOOST_TEST(!product.copy(make_matrix(60, b, path(60))));
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_incomplete_cholesky
