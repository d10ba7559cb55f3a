// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// L-BFGS against the dense formula, the secant equation, and what holds on quadratic functions.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/accelerations/Lbfgs.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_lbfgs)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

constexpr int N = 5;
using Pair = std::pair<Eigen::VectorXd, Eigen::VectorXd>; // step and change of the gradient

Eigen::MatrixXd random_positive_matrix(Random& random)
{
  const Eigen::MatrixXd root = random.matrix<N>();
  return root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(N, N);
}

// Nocedal and Wright (6.17), for some pairs in their order.
Eigen::MatrixXd inverse_hessian(Eigen::MatrixXd H, const std::vector<Pair>& pairs)
{
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(N, N);
  for(const auto& [s, y] : pairs) {
    const double rho = 1 / y.dot(s);
    H = (identity - rho * s * y.transpose()) * H * (identity - rho * y * s.transpose()) + rho * s * s.transpose();
  }
  return H;
}

struct Fixture
{
  Random random{91};
  Eigen::MatrixXd preconditioner = random_positive_matrix(random), hessian = random_positive_matrix(random);

  Eigen::VectorXd direction(FFM::Lbfgs& lbfgs, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient) const
  {
    Eigen::VectorXd result;
    const auto solve = [this](const Eigen::VectorXd& b, Eigen::VectorXd& y) {
      y = preconditioner.ldlt().solve(b);
      return true;
    };
    BOOST_TEST_REQUIRE(lbfgs.direction(x, gradient, solve, result));
    return result;
  }

  void check(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) const
  {
    BOOST_TEST((found - expected).norm() <= 1e-10 * expected.norm());
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(directions_are_those_of_the_dense_formula, Fixture)
{
  for(const int memory : {1, 3, 8}) {
    FFM::Lbfgs lbfgs(memory);
    std::vector<Pair> pairs;
    Eigen::VectorXd last_x, last_gradient;
    for(int k = 0; k < 7; ++k) {
      const Eigen::VectorXd x = random.vector(N), gradient = hessian * x + 0.05 * x.array().cube().matrix();
      if(k > 0) {
        pairs.emplace_back(x - last_x, gradient - last_gradient);
        if(static_cast<int>(pairs.size()) > memory)
          pairs.erase(pairs.begin());
      }
      check(direction(lbfgs, x, gradient), -inverse_hessian(preconditioner.inverse(), pairs) * gradient);
      last_x = x;
      last_gradient = gradient;
    }
  }
}

// H y = s: where the last gradient was 0, the direction leads back along the last step.
BOOST_FIXTURE_TEST_CASE(the_secant_equation_holds, Fixture)
{
  FFM::Lbfgs lbfgs;
  for(int k = 0; k < 4; ++k) {
    const Eigen::VectorXd x = random.vector(N);
    direction(lbfgs, x, hessian * x);
  }
  const Eigen::VectorXd x = random.vector(N), step = random.vector(N);
  direction(lbfgs, x, Eigen::VectorXd::Zero(N));
  check(direction(lbfgs, x + step, hessian * step), -step);
}

BOOST_FIXTURE_TEST_CASE(exact_steps_end_at_the_minimum_of_a_quadratic, Fixture)
{
  FFM::Lbfgs lbfgs;
  Eigen::VectorXd x = random.vector(N);
  for(int k = 0; k < N; ++k) {
    BOOST_TEST(x.norm() > 1e-6);
    const Eigen::VectorXd gradient = hessian * x, d = direction(lbfgs, x, gradient);
    x -= gradient.dot(d) / d.dot(hessian * d) * d;
  }
  BOOST_TEST(x.norm() <= 1e-8);
}

BOOST_FIXTURE_TEST_CASE(pairs_of_negative_curvature_are_left_out, Fixture)
{
  FFM::Lbfgs lbfgs;
  const Eigen::VectorXd x = random.vector(N), step = random.vector(N), gradient = hessian * x;
  direction(lbfgs, x, gradient);
  const Eigen::VectorXd next = gradient - hessian * step;
  check(direction(lbfgs, x + step, next), -preconditioner.ldlt().solve(next));
}

BOOST_FIXTURE_TEST_CASE(resets_and_failures, Fixture)
{
  FFM::Lbfgs lbfgs;
  for(int k = 0; k < 3; ++k) {
    const Eigen::VectorXd x = random.vector(N);
    direction(lbfgs, x, hessian * x);
  }
  const Eigen::VectorXd x = random.vector(N), gradient = hessian * x, plain = -preconditioner.ldlt().solve(gradient);
  FFM::Lbfgs copy = lbfgs;
  BOOST_TEST((direction(copy, x, gradient) - plain).norm() > 1e-3);
  lbfgs.reset();
  check(direction(lbfgs, x, gradient), plain);
  Eigen::VectorXd result;
  BOOST_TEST(!lbfgs.direction(
    x, gradient, [](const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }, result));
}

BOOST_AUTO_TEST_SUITE_END() // test_lbfgs
