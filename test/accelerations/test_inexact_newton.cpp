// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Conjugate gradients on the current matrix with an old factorization: against the matrix itself, and whole runs against those
// that factorize in each iteration.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/accelerations/Inexact_newton.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <Eigen/Cholesky>

#include <algorithm>

BOOST_AUTO_TEST_SUITE(test_inexact_newton)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// A matrix, and the factorization of another.
struct Dense
{
  Eigen::MatrixXd matrix;
  Eigen::LLT<Eigen::MatrixXd> factorization;

  bool operator()(const Eigen::VectorXd& b, Eigen::VectorXd& y) const
  {
    y = factorization.solve(b);
    return true;
  }
  void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& product) const { product = matrix * p; }
};

Dense make_dense(int n, int changed)
{
  Random random(3);
  Eigen::MatrixXd root(n, n);
  for(Eigen::Index i = 0; i < root.size(); ++i)
    root.data()[i] = random(-1, 1);
  Dense dense;
  dense.matrix = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
  dense.factorization.compute(dense.matrix);
  for(int k = 0; k < changed; ++k)
    dense.matrix(k, k) += 50;
  return dense;
}

template <typename Acceleration, typename Rule>
using Traits =
  FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, CGAL::Default, Acceleration, Rule>;

template <typename Acceleration, typename Rule>
FFM::Summary minimized(const FFM::Simplicial_domain<2>& domain, double tolerance, int iterations, FFM::Positions<2>& x,
                       const Acceleration& acceleration = Acceleration())
{
  Traits<Acceleration, Rule> traits;
  traits.acceleration = acceleration;
  traits.options.characteristic_gradient_tolerance = tolerance;
  traits.options.max_iterations = iterations;
  x = tutte_start(domain);
  return FFM::Map_minimizer<2, Traits<Acceleration, Rule>>(domain, traits).minimize(x);
}

} // namespace

// The matrices differ in `changed` directions, so as many steps and one more are enough.
BOOST_AUTO_TEST_CASE(direction_of_the_current_matrix)
{
  const int n = 40;
  for(int changed : {0, 1, 4}) {
    const Dense dense = make_dense(n, changed);
    const Eigen::VectorXd gradient = Eigen::VectorXd::LinSpaced(n, -1, 2);
    FFM::Inexact_newton acceleration;
    acceleration.largest_residual = acceleration.smallest_residual = 1e-10;
    acceleration.max_steps = changed + 1;
    Eigen::VectorXd direction;
    BOOST_TEST_REQUIRE(acceleration.direction(gradient, gradient, dense, direction));
    const Eigen::VectorXd exact = -dense.matrix.llt().solve(gradient);
    BOOST_TEST((direction - exact).norm() <= 1e-9 * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(residuals_are_within_their_bound)
{
  const Dense dense = make_dense(60, 30);
  const Eigen::VectorXd gradient = Eigen::VectorXd::LinSpaced(60, -1, 2);
  FFM::Inexact_newton acceleration;
  acceleration.largest_residual = 0.05;
  Eigen::VectorXd direction;
  // The second gradient is a thousandth of the first, and so is its bound.
  for(double factor : {1., 1e-3}) {
    BOOST_TEST_REQUIRE(acceleration.direction(gradient, factor * gradient, dense, direction));
    const double residual = (dense.matrix * direction + factor * gradient).norm();
    BOOST_TEST(residual <= (std::min)(0.05, factor) * factor * gradient.norm());
  }
}

// Where the matrix is not positive along the first search direction, that is the preconditioned gradient, the latter is taken.
BOOST_AUTO_TEST_CASE(negative_curvature)
{
  Dense dense = make_dense(10, 0);
  dense.matrix = -dense.matrix;
  const Eigen::VectorXd gradient = Eigen::VectorXd::Ones(10);
  Eigen::VectorXd direction, expected;
  BOOST_TEST_REQUIRE(FFM::Inexact_newton().direction(gradient, gradient, dense, direction));
  dense(gradient, expected);
  BOOST_TEST((direction + expected).norm() <= 1e-12 * expected.norm());
}

// Solved to the end, the directions are those of a factorization in each iteration.
BOOST_AUTO_TEST_CASE(exact_directions_give_the_same_iterates)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(12, 10, 0.5));
  FFM::Inexact_newton exact;
  exact.largest_residual = exact.smallest_residual = 1e-13;
  exact.max_steps = 400;
  for(int iterations : {2, 5}) {
    FFM::Positions<2> a, b;
    const FFM::Summary newton = minimized<FFM::No_acceleration, FFM::Every_iteration>(domain, 0, iterations, a);
    const FFM::Summary inexact = minimized<FFM::Inexact_newton, FFM::On_demand>(domain, 0, iterations, b, exact);
    BOOST_TEST(newton.iterations == iterations);
    BOOST_TEST(inexact.energy == newton.energy, boost::test_tools::tolerance(1e-8));
    BOOST_TEST((a - b).norm() <= 1e-5 * a.norm());
  }
}

BOOST_AUTO_TEST_CASE(high_accuracy_with_few_factorizations)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(30, 25, 0.4));
  FFM::Positions<2> a, b;
  const FFM::Summary newton = minimized<FFM::No_acceleration, FFM::Every_iteration>(domain, 1e-8, 1000, a);
  const FFM::Summary inexact = minimized<FFM::Inexact_newton, FFM::On_demand>(domain, 1e-8, 1000, b);
  BOOST_TEST_MESSAGE(newton);
  BOOST_TEST_MESSAGE(inexact);
  BOOST_CHECK(inexact.status == FFM::Status::success && newton.status == FFM::Status::success);
  BOOST_TEST(inexact.energy == newton.energy, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(inexact.characteristic_gradient_norm <= 1e-8);
  BOOST_TEST(inexact.factorizations < newton.factorizations);
}

BOOST_AUTO_TEST_SUITE_END() // test_inexact_newton
