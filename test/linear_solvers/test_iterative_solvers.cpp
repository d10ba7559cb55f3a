// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Conjugate gradients against a dense factorization, their inexact solves, and the choice between them and a direct solver.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/initializers/internal/make_start.h>
#include <CGAL/Flip_free_maps/linear_solvers/Automatic_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <Eigen/Cholesky>

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_iterative_solvers)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// Stiffness and a little mass, of blocks that couple the coordinates.
template <int D>
void fill(FFM::Block_sparse_matrix& matrix, const FFM::Simplicial_domain<2>& domain)
{
  Random random(71);
  matrix.set_zero();
  for(const auto& t : domain.elements)
    for(int k = 0; k < 3; ++k)
      for(int l = k + 1; l < 3; ++l) {
        Eigen::Matrix<double, D, D> block;
        for(Eigen::Index i = 0; i < block.size(); ++i)
          block.data()[i] = random(-1, 1);
        block = (block * block.transpose()).eval();
        matrix.add_block(t[k], t[k], 0, block);
        matrix.add_block(t[l], t[l], 0, block);
        matrix.add_block(t[k], t[l], matrix.slot(t[k], t[l]), Eigen::Matrix<double, D, D>(-block));
      }
  for(FFM::Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
    matrix.diagonal(i) += 1e-3;
}

Eigen::VectorXd product(const FFM::Block_sparse_matrix& matrix, const Eigen::VectorXd& x)
{
  return matrix.lower().selfadjointView<Eigen::Lower>() * x;
}

template <int D>
struct System
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(14, 9));
  FFM::Block_sparse_matrix matrix;
  Eigen::VectorXd right, expected;

  System()
  {
    matrix.build_pattern(domain.number_of_vertices, D, domain.elements);
    fill<D>(matrix, domain);
    right = Random(72).vector(static_cast<int>(matrix.rows()));
    const Eigen::MatrixXd lower(matrix.lower());
    Eigen::MatrixXd full = lower + lower.transpose();
    full.diagonal() = lower.diagonal();
    expected = full.ldlt().solve(right);
  }
};

template <typename Solver, int D>
void check(const System<D>& system)
{
  Eigen::VectorXd x;
  Solver exact(1e-13);
  BOOST_TEST(!exact.solve(system.right, x));
  BOOST_TEST_REQUIRE(exact.analyze_pattern(system.matrix));
  BOOST_TEST_REQUIRE(exact.factorize(system.matrix));
  BOOST_TEST_REQUIRE(exact.solve(system.right, x));
  BOOST_TEST((x - system.expected).norm() <= 1e-8 * system.expected.norm());

  Solver inexact;
  BOOST_TEST_REQUIRE(inexact.analyze_pattern(system.matrix));
  BOOST_TEST_REQUIRE(inexact.factorize(system.matrix));
  BOOST_TEST_REQUIRE(inexact.solve(system.right, x));
  const double first = (product(system.matrix, x) - system.right).norm() / system.right.norm();
  BOOST_TEST(first <= 0.01);
  BOOST_TEST(first > 1e-9);
  BOOST_TEST(inexact.iterations() > 0);
  BOOST_TEST(inexact.iterations() < exact.iterations());
  BOOST_TEST(x.dot(system.right) > 0);
  // A right-hand side 10^-8 times as long is solved 10^4 times as exactly.
  const Eigen::VectorXd small = 1e-8 * system.right;
  BOOST_TEST_REQUIRE(inexact.solve(small, x));
  BOOST_TEST((product(system.matrix, x) - small).norm() <= 1e-6 * small.norm());
}

// Remembers what it is told.
class Listening_preconditioner : public FFM::Incomplete_cholesky
{
public:
  static constexpr bool takes_positions = true;

  void set_positions(const Eigen::VectorXd& positions) { told().push_back(positions); }

  bool factorize(const FFM::Block_sparse_matrix& matrix)
  {
    ++factorizations();
    BOOST_TEST_REQUIRE(told().size() == factorizations());
    BOOST_TEST(told().back().size() == matrix.rows());
    return FFM::Incomplete_cholesky::factorize(matrix);
  }

  static std::vector<Eigen::VectorXd>& told()
  {
    static std::vector<Eigen::VectorXd> all;
    return all;
  }

  static std::size_t& factorizations()
  {
    static std::size_t number = 0;
    return number;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(conjugate_gradients)
{
  check<FFM::Conjugate_gradient_solver<>>(System<2>());
  check<FFM::Conjugate_gradient_solver<FFM::Block_jacobi<2>>>(System<2>());
  check<FFM::Conjugate_gradient_solver<>>(System<3>());
  check<FFM::Conjugate_gradient_solver<FFM::Block_jacobi<3>>>(System<3>());
}

BOOST_AUTO_TEST_CASE(blocks_that_are_not_positive_definite_are_refused)
{
  System<2> system;
  system.matrix.diagonal(5) = -1;
  FFM::Conjugate_gradient_solver<FFM::Block_jacobi<2>> solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(system.matrix));
  BOOST_TEST(!solver.factorize(system.matrix));
  Eigen::VectorXd x;
  BOOST_TEST(!solver.solve(system.right, x));
  BOOST_TEST(!FFM::Block_jacobi<3>().analyze_pattern(system.matrix));
}

// A direction of descent all the same.
BOOST_AUTO_TEST_CASE(matrices_that_are_not_positive_end_the_iteration)
{
  System<2> system;
  for(double value : {-1., -1e3}) {
    system.matrix.diagonal(5) = value;
    FFM::Conjugate_gradient_solver<> solver(1e-13);
    BOOST_TEST_REQUIRE(solver.analyze_pattern(system.matrix));
    BOOST_TEST_REQUIRE(solver.factorize(system.matrix));
    Eigen::VectorXd x;
    BOOST_TEST_REQUIRE(solver.solve(system.right, x));
    BOOST_TEST(!solver.converged());
    BOOST_TEST(x.dot(system.right) > 0);
    // Where the curvature is negative at once, too.
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(system.matrix.rows(), 5);
    BOOST_TEST_REQUIRE(solver.solve(unit, x));
    BOOST_TEST(x[5] > 0);
  }
}

BOOST_AUTO_TEST_CASE(nothing_to_solve_for)
{
  const System<3> system;
  FFM::Conjugate_gradient_solver<> solver;
  BOOST_TEST_REQUIRE((solver.analyze_pattern(system.matrix) && solver.factorize(system.matrix)));
  Eigen::VectorXd x;
  BOOST_TEST(solver.solve(Eigen::VectorXd::Zero(system.matrix.rows()), x));
  BOOST_TEST(solver.converged());
  BOOST_TEST(x.isZero(0));
  BOOST_TEST(x.size() == system.matrix.rows());
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
BOOST_AUTO_TEST_CASE(the_budget_decides, *boost::unit_test::label("needs_cholmod"))
{
  const System<2> system;
  FFM::Cholmod_solver direct;
  BOOST_TEST_REQUIRE(direct.analyze_pattern(system.matrix));
  const double bytes = 8. * static_cast<double>(direct.factor_entries());
  for(double budget : {0., 0.5 * bytes, 2 * bytes}) {
    FFM::Automatic_solver<FFM::Cholmod_solver> solver(budget);
    BOOST_TEST_REQUIRE(solver.analyze_pattern(system.matrix));
    BOOST_TEST_REQUIRE(solver.factorize(system.matrix));
    Eigen::VectorXd x;
    BOOST_TEST_REQUIRE(solver.solve(system.right, x));
    const double residual = (product(system.matrix, x) - system.right).norm() / system.right.norm();
    if(budget == 0.5 * bytes) {
      BOOST_TEST(solver.name().find("conjugate gradients") == 0u);
      BOOST_TEST(solver.iterations() > 0);
      BOOST_TEST(residual <= 0.01);
    } else {
      BOOST_TEST(solver.name().find("cholmod") == 0u);
      BOOST_TEST(solver.iterations() == 0);
      BOOST_TEST(residual <= 1e-12);
    }
  }
}

// Directions that are one percent off lead to the same minimum.
BOOST_AUTO_TEST_CASE(maps_without_memory_for_a_factor, *boost::unit_test::label("needs_cholmod"))
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(24, 18));
  FFM::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-7;
  FFM::Positions<2> start;
  std::string name, message;
  BOOST_TEST_REQUIRE((FFM::internal::make_start(domain, traits, start, name, message) == FFM::Status::success));
  FFM::Positions<2> x = start;
  const FFM::Summary direct = FFM::Map_minimizer<2>(domain, traits).minimize(x);
  traits.options.memory_budget = 1;
  x = start;
  const FFM::Summary iterative = FFM::Map_minimizer<2>(domain, traits).minimize(x);
  BOOST_TEST(direct.converged());
  BOOST_TEST(iterative.converged());
  BOOST_TEST(direct.inner_iterations == 0);
  BOOST_TEST(iterative.inner_iterations > iterative.iterations);
  BOOST_TEST(iterative.linear_solver.find("conjugate gradients") == 0u);
  BOOST_TEST(iterative.flips == 0);
  BOOST_TEST(iterative.energy == direct.energy, boost::test_tools::tolerance(1e-9));

  traits.options.memory_budget = -1;
  BOOST_TEST(FFM::status_name(FFM::Map_minimizer<2>(domain, traits).minimize(x).status) == FFM::status_name(FFM::Status::invalid_option));
}
// Through all layers, before each factorization.
BOOST_AUTO_TEST_CASE(preconditioners_are_told_the_map, *boost::unit_test::label("needs_cholmod"))
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(12, 9));
  FFM::Any_map_traits traits;
  traits.use_method("projected-newton+");
  traits.options.memory_budget = 1;
  FFM::Positions<2> start;
  std::string name, message;
  BOOST_TEST_REQUIRE((FFM::internal::make_start(domain, traits, start, name, message) == FFM::Status::success));
  traits.use_linear_solver<FFM::Automatic_solver<FFM::Cholmod_solver, FFM::Conjugate_gradient_solver<Listening_preconditioner>>>();
  Listening_preconditioner::told().clear();
  Listening_preconditioner::factorizations() = 0;
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices = {0};
  FFM::Positions<2> x = start;
  const FFM::Summary summary = FFM::Map_minimizer<2, FFM::Any_map_traits>(domain, traits, constraints).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST_REQUIRE(Listening_preconditioner::told().size() >= 2u);
  const Eigen::VectorXd begin = Eigen::Map<const Eigen::VectorXd>(start.data() + 2, start.size() - 2);
  BOOST_TEST((Listening_preconditioner::told().front() - begin).norm() == 0);
  BOOST_TEST((Listening_preconditioner::told().back() - begin).norm() > 1e-3);
}
#else
BOOST_AUTO_TEST_CASE(budgets, *boost::unit_test::label("needs_cholmod")) { skip_case("built without CHOLMOD"); }
#endif

BOOST_AUTO_TEST_SUITE_END() // test_iterative_solvers
