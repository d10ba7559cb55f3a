// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The block matrix against a dense one, and every linear solver against Eigen's dense LDL^T.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#endif
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Sparse_linear_algebra_solver.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseLU>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_linear_solvers)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef std::vector<std::array<std::int32_t, 3>> Triangles;

typedef FFM::Sparse_linear_algebra_solver<CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>>
  Lu_traits_solver;
typedef FFM::Sparse_linear_algebra_solver<
  CGAL::Eigen_solver_traits<Eigen::BiCGSTAB<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::IncompleteLUT<double>>>>
  Default_traits_solver;

typedef std::tuple<
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  FFM::Cholmod_solver,
#endif
  FFM::Eigen_simplicial_solver, Lu_traits_solver, Default_traits_solver>
  Solvers;

// Those that factorize by the symmetric structure and can tell a failure.
typedef std::tuple<
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  FFM::Cholmod_solver,
#endif
  FFM::Eigen_simplicial_solver>
  Direct_solvers;

Triangles grid_triangles(int columns, int rows)
{
  return grid(columns, rows, [](double u, double v) { return Eigen::Vector3d(u, v, 0); }).triangles;
}

Eigen::MatrixXd dense(const FFM::Block_sparse_matrix& matrix)
{
  const Eigen::MatrixXd lower(matrix.lower());
  Eigen::MatrixXd full = lower + lower.transpose();
  full.diagonal() = lower.diagonal();
  return full;
}

// For each triangle a positive semidefinite matrix on its vertices' coordinates, plus a small multiple of the identity.
void fill(FFM::Block_sparse_matrix& matrix, const Triangles& triangles, std::uint64_t seed)
{
  Random random(seed);
  const int b = matrix.block_size();
  matrix.set_zero();
  for(const auto& t : triangles) {
    Eigen::MatrixXd root(2 * b, 3 * b);
    for(Eigen::Index i = 0; i < root.size(); ++i)
      root.data()[i] = random(-1, 1);
    const Eigen::MatrixXd element = root.transpose() * root;
    for(int k = 0; k < 3; ++k)
      for(int l = k; l < 3; ++l)
        matrix.add_block(t[k], t[l], matrix.slot(t[k], t[l]), element.block(k * b, l * b, b, b));
  }
  for(FFM::Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
    matrix.diagonal(i) += 0.1;
}

double residual(const FFM::Block_sparse_matrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& x)
{
  return (matrix.lower().selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
}

// Fails always, wherever it is asked to.
struct Failing_solver
{
  bool fails_in_analysis = false;

  std::string name() const { return "failing"; }
  std::string ordering() const { return "none"; }
  bool analyze_pattern(const FFM::Block_sparse_matrix&) { return !fails_in_analysis; }
  bool factorize(const FFM::Block_sparse_matrix&) { return false; }
  bool solve(const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }
  std::int64_t factor_entries() const { return -1; }
};

} // namespace

BOOST_AUTO_TEST_CASE(pattern_of_the_block_matrix)
{
  // Vertex 5 is in no stencil; stencils overlap.
  const Triangles triangles{{3, 0, 2}, {0, 2, 1}, {4, 3, 2}};
  const std::set<std::pair<int, int>> pairs{{0, 2}, {0, 3}, {2, 3}, {0, 1}, {1, 2}, {3, 4}, {2, 4}};
  for(int b : {1, 2, 3}) {
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(6, b, triangles);
    BOOST_TEST(matrix.block_size() == b);
    BOOST_TEST(matrix.number_of_vertices() == 6);
    BOOST_TEST(matrix.rows() == 6 * b);
    BOOST_TEST(matrix.number_of_entries() == 6 * b * (b + 1) / 2 + static_cast<int>(pairs.size()) * b * b);
    std::set<std::pair<int, int>> expected, found;
    for(int v = 0; v < 6; ++v)
      for(int w = v; w < 6; ++w)
        if(v == w || pairs.count({v, w}) != 0)
          for(int i = 0; i < b; ++i)
            for(int j = 0; j < b; ++j)
              if(b * w + i >= b * v + j)
                expected.insert({b * v + j, b * w + i});
    const auto& columns = matrix.column_starts();
    for(int column = 0; column < 6 * b; ++column) {
      BOOST_TEST(matrix.row_indices()[columns[column]] == column);
      for(auto k = columns[column]; k < columns[column + 1]; ++k) {
        found.insert({column, static_cast<int>(matrix.row_indices()[k])});
        if(k > columns[column]) {
          BOOST_TEST(matrix.row_indices()[k] > matrix.row_indices()[k - 1]);
        }
      }
    }
    BOOST_TEST((found == expected));
    for(const auto& pair : pairs) {
      const auto slot = matrix.slot(pair.first, pair.second);
      BOOST_TEST(slot == matrix.slot(pair.second, pair.first));
      BOOST_TEST(matrix.block_row_indices()[matrix.block_column_starts()[pair.first] + slot] == pair.second);
    }
  }
}

BOOST_AUTO_TEST_CASE(blocks_in_both_orders)
{
  const Triangles triangles = grid_triangles(4, 3);
  Random random(51);
  for(int b : {1, 2, 3}) {
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(20, b, triangles);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(20 * b, 20 * b);
    for(int repetition = 0; repetition < 2; ++repetition)
      for(const auto& t : triangles)
        for(int k = 0; k < 3; ++k)
          for(int l = 0; l < 3; ++l) {
            Eigen::MatrixXd block(b, b);
            for(Eigen::Index i = 0; i < block.size(); ++i)
              block.data()[i] = random(-1, 1);
            if(k == l)
              block = (block + block.transpose()).eval();
            matrix.add_block(t[k], t[l], matrix.slot(t[k], t[l]), block);
            expected.block(b * t[k], b * t[l], b, b) += block;
            if(k != l)
              expected.block(b * t[l], b * t[k], b, b) += block.transpose();
          }
    BOOST_TEST((dense(matrix) - expected).norm() <= 1e-14 * expected.norm());
    for(int i = 0; i < 20 * b; ++i)
      BOOST_TEST(std::as_const(matrix).diagonal(i) == matrix.lower().coeff(i, i));
    matrix.set_zero();
    BOOST_TEST(dense(matrix).norm() == 0);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(agrees_with_dense, Solver, Solvers)
{
  const Triangles triangles = grid_triangles(9, 7);
  Random random(52);
  for(int b : {1, 2, 3}) {
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(80, b, triangles);
    Solver solver;
    BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
    // New values with the old analysis, then again for a second right-hand side.
    for(std::uint64_t seed : {53, 54, 55}) {
      fill(matrix, triangles, seed);
      BOOST_TEST_REQUIRE(solver.factorize(matrix));
      const Eigen::LDLT<Eigen::MatrixXd> reference(dense(matrix));
      for(int k = 0; k < 2; ++k) {
        const Eigen::VectorXd right = random.vector(80 * b);
        Eigen::VectorXd x;
        BOOST_TEST_REQUIRE(solver.solve(right, x));
        const Eigen::VectorXd expected = reference.solve(right);
        BOOST_TEST((x - expected).norm() <= 1e-9 * expected.norm());
        BOOST_TEST(residual(matrix, right, x) <= 1e-11);
      }
    }
    BOOST_TEST(!solver.name().empty());
    BOOST_TEST(!solver.ordering().empty());
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(another_pattern_in_the_same_solver, Solver, Solvers)
{
  Random random(56);
  Solver solver;
  for(int columns : {5, 3, 8}) {
    const Triangles triangles = grid_triangles(columns, 4);
    const int n = 5 * (columns + 1);
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(n, 2, triangles);
    BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
    fill(matrix, triangles, 57);
    BOOST_TEST_REQUIRE(solver.factorize(matrix));
    const Eigen::VectorXd right = random.vector(2 * n);
    Eigen::VectorXd x;
    BOOST_TEST_REQUIRE(solver.solve(right, x));
    BOOST_TEST(residual(matrix, right, x) <= 1e-11);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(solve_needs_a_factorization, Solver, Solvers)
{
  const Triangles triangles = grid_triangles(3, 3);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(16, 2, triangles);
  fill(matrix, triangles, 58);
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(32);
  Eigen::VectorXd x;
  Solver solver;
  BOOST_TEST(!solver.solve(right, x));
  BOOST_TEST(solver.analyze_pattern(matrix));
  BOOST_TEST(!solver.solve(right, x));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(factorize_needs_an_analysis, Solver, Direct_solvers)
{
  const Triangles triangles = grid_triangles(3, 3);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(16, 2, triangles);
  fill(matrix, triangles, 58);
  Solver solver;
  BOOST_TEST(!solver.factorize(matrix));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_values, Solver, Direct_solvers)
{
  const Triangles triangles = grid_triangles(6, 6);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(49, 2, triangles);
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(98);
  Eigen::VectorXd x;
  Solver solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
  // All zero.
  BOOST_TEST(!solver.factorize(matrix));
  BOOST_TEST(!solver.solve(right, x));
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for(int row : {0, 40, 97}) {
      fill(matrix, triangles, 59);
      matrix.diagonal(row) = bad;
      // NaN must be noticed in one of the two calls at the latest.
      BOOST_TEST(!(solver.factorize(matrix) && solver.solve(right, x)));
    }
  // The object is as good as new afterwards.
  fill(matrix, triangles, 60);
  BOOST_TEST_REQUIRE(solver.factorize(matrix));
  BOOST_TEST_REQUIRE(solver.solve(right, x));
  BOOST_TEST(residual(matrix, right, x) <= 1e-11);
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
BOOST_AUTO_TEST_CASE(cholmod_rejects_indefinite_matrices, *boost::unit_test::label("needs_cholmod"))
{
  // Small ones are factorized by the simplicial kernel, large ones with dense rows by the supernodal one.
  std::set<std::string> names;
  for(int size : {5, 60}) {
    const Triangles triangles = grid_triangles(size, size);
    FFM::Block_sparse_matrix matrix;
    const int n = (size + 1) * (size + 1);
    matrix.build_pattern(n, 3, triangles);
    fill(matrix, triangles, 61);
    FFM::Cholmod_solver solver;
    BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
    names.insert(solver.name());
    BOOST_TEST(solver.factor_entries() > 0);
    const double good = matrix.diagonal(n);
    matrix.diagonal(n) = -1;
    Eigen::VectorXd x;
    BOOST_TEST(!solver.factorize(matrix));
    BOOST_TEST(!solver.solve(Eigen::VectorXd::Ones(3 * n), x));
    matrix.diagonal(n) = good;
    BOOST_TEST(solver.factorize(matrix));
    BOOST_TEST(solver.solve(Eigen::VectorXd::Ones(3 * n), x));
    BOOST_TEST(residual(matrix, Eigen::VectorXd::Ones(3 * n), x) <= 1e-11);
  }
  BOOST_TEST(names.size() == 2u);
}
#endif

BOOST_AUTO_TEST_CASE_TEMPLATE(large_matrix, Solver, Direct_solvers)
{
  const Triangles triangles = grid_triangles(159, 159);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(160 * 160, 2, triangles);
  fill(matrix, triangles, 62);
  Solver solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
  BOOST_TEST_REQUIRE(solver.factorize(matrix));
  BOOST_TEST((solver.ordering() == "metis" || solver.ordering() == "amd"));
  BOOST_TEST(solver.factor_entries() > matrix.number_of_entries());
  const Eigen::VectorXd right = Random(63).vector(matrix.rows());
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE(solver.solve(right, x));
  BOOST_TEST(residual(matrix, right, x) <= 1e-11);
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
// Minimum degree suffices for a strip; a cube has separators that nested dissection finds.
BOOST_AUTO_TEST_CASE(cholmod_ordering, *boost::unit_test::label("needs_cholmod"))
{
  const auto ordering_of = [](int n_x, int n_y, int n_z) {
    std::vector<std::array<std::int32_t, 2>> edges;
    for(int x = 0; x < n_x; ++x)
      for(int y = 0; y < n_y; ++y)
        for(int z = 0; z < n_z; ++z) {
          const std::int32_t v = (x * n_y + y) * n_z + z;
          if(x + 1 < n_x)
            edges.push_back({{v, v + n_y * n_z}});
          if(y + 1 < n_y)
            edges.push_back({{v, v + n_z}});
          if(z + 1 < n_z)
            edges.push_back({{v, v + 1}});
        }
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(n_x * n_y * n_z, 3, edges);
    FFM::Cholmod_solver solver;
    BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
    return solver.ordering();
  };
  BOOST_TEST(ordering_of(4000, 2, 1) == "amd");
  BOOST_TEST(ordering_of(16, 16, 16) == "metis");
}
#else
BOOST_AUTO_TEST_CASE(cholmod, *boost::unit_test::label("needs_cholmod")) { skip_case("built without CHOLMOD"); }
#endif

BOOST_AUTO_TEST_CASE(robust_solver_falls_back)
{
  const Triangles triangles = grid_triangles(6, 5);
  for(bool fails_in_analysis : {false, true}) {
    FFM::Block_sparse_matrix matrix;
    matrix.build_pattern(42, 2, triangles);
    fill(matrix, triangles, 64);
    Failing_solver failing;
    failing.fails_in_analysis = fails_in_analysis;
    FFM::Summary summary;
    FFM::internal::Robust_solver<Failing_solver> solver(failing);
    const auto reporting = solver.report_to(summary);
    BOOST_TEST(solver.analyze_pattern(matrix));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(84);
    Eigen::VectorXd x;
    BOOST_TEST_REQUIRE(solver.factorize(matrix, 0));
    BOOST_TEST_REQUIRE(solver.solve(right, x));
    BOOST_TEST(residual(matrix, right, x) <= 1e-11);
    BOOST_TEST(summary.linear_solver == "failing, then eigen_simplicial_ldlt");
    BOOST_TEST(summary.factorizations == 2);
    BOOST_TEST(summary.linear_solves == 1);
  }
}

BOOST_AUTO_TEST_CASE(robust_solver_shifts)
{
  // The row sums of a graph's Laplacian vanish: singular, until the diagonal grows.
  const Triangles triangles = grid_triangles(6, 5);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(42, 1, triangles);
  const Eigen::Matrix<double, 1, 1> one(1.), minus(-1.);
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k) {
      const int v = t[k], w = t[(k + 1) % 3];
      matrix.add_block(v, v, 0, one);
      matrix.add_block(w, w, 0, one);
      matrix.add_block(v, w, matrix.slot(v, w), minus);
    }
  const Eigen::MatrixXd before = dense(matrix);
  FFM::Eigen_simplicial_solver eigen;
  FFM::Summary summary;
  FFM::internal::Robust_solver<FFM::Eigen_simplicial_solver> solver(eigen);
  const auto reporting = solver.report_to(summary);
  BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
  BOOST_TEST_REQUIRE(solver.factorize(matrix, 1e-3));
  Eigen::MatrixXd expected = before;
  expected.diagonal() *= 1.001;
  BOOST_TEST((dense(matrix) - expected).norm() <= 1e-14 * expected.norm());
  const Eigen::VectorXd right = Random(65).vector(42);
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE(solver.solve(right, x));
  BOOST_TEST((expected * x - right).norm() <= 1e-11 * right.norm());
}

BOOST_AUTO_TEST_CASE(robust_solver_gives_up)
{
  const Triangles triangles = grid_triangles(6, 5);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(42, 2, triangles);
  fill(matrix, triangles, 66);
  matrix.diagonal(7) = std::numeric_limits<double>::quiet_NaN();
  Failing_solver failing;
  FFM::Summary summary;
  FFM::internal::Robust_solver<Failing_solver> solver(failing);
  const auto reporting = solver.report_to(summary);
  BOOST_TEST(solver.analyze_pattern(matrix));
  BOOST_TEST(!solver.factorize(matrix, 1e-9));
  // Each attempt tries both solvers; the number of shifts is bounded.
  BOOST_TEST(summary.factorizations <= 40);
}

// Work is entered into a summary only as long as the caller asks for it; the summary may be gone afterwards.
BOOST_AUTO_TEST_CASE(robust_solver_forgets_the_summary)
{
  const Triangles triangles = grid_triangles(6, 5);
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(42, 2, triangles);
  fill(matrix, triangles, 67);
  Failing_solver failing;
  FFM::internal::Robust_solver<Failing_solver> solver(failing);
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(84);
  Eigen::VectorXd x;
  FFM::Summary outer;
  {
    const auto reporting = solver.report_to(outer);
    {
      auto inner = std::make_unique<FFM::Summary>();
      const auto nested = solver.report_to(*inner);
      BOOST_TEST(solver.analyze_pattern(matrix));
      BOOST_TEST(solver.factorize(matrix, 0));
      BOOST_TEST(inner->factorizations == 2);
    }
    BOOST_TEST(outer.factorizations == 0);
    BOOST_TEST(solver.solve(right, x));
    BOOST_TEST(outer.linear_solves == 1);
  }
  BOOST_TEST(solver.solve(right, x));
  BOOST_TEST(residual(matrix, right, x) <= 1e-11);
  BOOST_TEST(outer.linear_solves == 1);

  // Another pattern: the solver that stepped in analyses it as well.
  FFM::Block_sparse_matrix other;
  const Triangles few = grid_triangles(3, 4);
  other.build_pattern(20, 2, few);
  fill(other, few, 68);
  BOOST_TEST(solver.analyze_pattern(other));
  BOOST_TEST(solver.factorize(other, 0));
  const Eigen::VectorXd short_right = Eigen::VectorXd::Ones(40);
  BOOST_TEST(solver.solve(short_right, x));
  BOOST_TEST(residual(other, short_right, x) <= 1e-11);
}

BOOST_AUTO_TEST_CASE(pairs_outside_the_pattern_have_no_slot)
{
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(5, 2, std::vector<std::array<std::int32_t, 3>>{{0, 1, 3}});
  BOOST_TEST(matrix.slot(1, 0) == 1);
  BOOST_TEST(matrix.slot(0, 3) == 2);
  for(std::int32_t v : {2, 4})
    BOOST_TEST(matrix.slot(0, v) == -1);
  BOOST_TEST(matrix.slot(4, 3) == -1);
}

BOOST_AUTO_TEST_SUITE_END() // test_linear_solvers
