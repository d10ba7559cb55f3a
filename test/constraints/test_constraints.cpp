// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Fixed vertices, soft positions and terms of users in the plane: what they leave alone, and the optima they lead to.

#include "support/unit_test.h"

#include "support/constraint_checks.h"

#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>

#include <cmath>
#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(test_constraints)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

bool is_convex(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  const std::size_t b = domain.border.size();
  bool convex = true;
  for(std::size_t i = 0; i < b; ++i) {
    const Eigen::Vector2d p = x.col(domain.border[i]), q = x.col(domain.border[(i + 1) % b]), r = x.col(domain.border[(i + 2) % b]);
    convex = convex && (q - p).x() * (r - q).y() - (q - p).y() * (r - q).x() > 0;
  }
  return convex;
}

// A spring that does not say which vertices it couples.
template <int D>
struct Unannounced_spring : Spring<D>
{
  using Spring<D>::Spring;

  std::vector<std::vector<std::int32_t>> stencils() const override { return {}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(optima) { check_all_optima<2>(); }

BOOST_AUTO_TEST_CASE(fixed_borders)
{
  const auto domain = make_domain(bumpy_patch(9, 8));
  Constraints<2> constraints;
  constraints.fixed_vertices = domain.border;
  const FFM::Positions<2> circle = tutte_start(domain);
  BOOST_TEST(is_convex(domain, circle));
  check_optimum<2>(domain, constraints, circle);

  FFM::Positions<2> waves = positions_of<2>(bumpy_patch(9, 8), domain.scale);
  for(Eigen::Index v = 0; v < waves.cols(); ++v)
    waves(1, v) += 0.15 * std::sin(7 * waves(0, v));
  BOOST_TEST(!is_convex(domain, waves));
  BOOST_TEST_REQUIRE(number_of_flips(domain, waves) == 0);
  check_optimum<2>(domain, constraints, waves);
}

// Inner forces neither push nor turn the map as a whole, so the soft positions balance.
BOOST_AUTO_TEST_CASE(soft_positions_balance)
{
  const Distorted_example<2> example;
  const std::int32_t n = example.domain.number_of_vertices;
  Constraints<2> constraints;
  constraints.soft_positions = {{0, Eigen::Vector2d(-1, 0.3), 0.3}, {n - 1, Eigen::Vector2d(2, 1), 2}, {4, Eigen::Vector2d(0, 0), 1}};
  FFM::Positions<2> x = example.x;
  BOOST_TEST_REQUIRE(minimized<2>(example.domain, constraints, x).converged());
  Eigen::Vector2d force(0, 0);
  double torque = 0, size = 0;
  for(const auto& soft : constraints.soft_positions) {
    const Eigen::Vector2d p = x.col(soft.vertex), f = 2 * soft.weight * (soft.target - p);
    force += f;
    torque += p.x() * f.y() - p.y() * f.x();
    size += f.norm();
  }
  BOOST_TEST(size > 0.1);
  BOOST_TEST(force.norm() <= 1e-8 * size);
  BOOST_TEST(std::abs(torque) <= 1e-8 * size);
}

BOOST_AUTO_TEST_CASE(residual_decreases_like_one_over_the_weight)
{
  const Distorted_example<2> example;
  const std::int32_t n = example.domain.number_of_vertices;
  double last = 0;
  for(const double weight : {1e2, 1e3, 1e4, 1e5}) {
    Constraints<2> constraints;
    constraints.soft_positions = {{0, Eigen::Vector2d(-0.9, -0.5), weight}, {n - 1, Eigen::Vector2d(0.9, 0.8), weight}};
    FFM::Positions<2> x = example.x;
    BOOST_TEST(minimized<2>(example.domain, constraints, x).converged());
    const double residual = FFM::Soft_positions<2>(constraints.soft_positions).residual(x);
    BOOST_TEST(residual > 0);
    if(last > 0)
      BOOST_TEST(std::abs(residual / last - 0.1) <= 0.01);
    last = residual;
  }
}

BOOST_AUTO_TEST_CASE(invalid_constraints)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  check_message<2>({{-1}, {}}, "fixed vertex has the number -1");
  check_message<2>({{0, 1000}, {}}, "fixed vertex has the number 1000");
  check_message<2>({{}, {{1000, Eigen::Vector2d(0, 0), 1}}}, "vertex number 1000");
  check_message<2>({{}, {{3, Eigen::Vector2d(0, nan), 1}}}, "number 0, of vertex number 3, is not finite");
  for(const double weight : {-1e-9, nan, infinity})
    check_message<2>({{}, {{3, Eigen::Vector2d(0, 0), weight}}}, "weight");
  check_message<2>({{}, {}, {FFM::Sliding_vertex<2>::along(1000, Eigen::Vector2d(1, 0))}}, "sliding vertex has the number 1000");
  check_message<2>({{}, {}, {FFM::Sliding_vertex<2>::along(3, Eigen::Vector2d(0, 0))}}, "no orthogonal projection");
  check_message<2>({{}, {}, {{3, 2 * Eigen::Matrix2d::Identity()}}}, "no orthogonal projection");
}

// A block that no stencil announces has no place in the matrix: that is an error, not another block.
BOOST_AUTO_TEST_CASE(blocks_outside_the_stencils)
{
  const Distorted_example<2> example;
  const std::int32_t n = example.domain.number_of_vertices;
  for(bool moves : {false, true}) {
    Constraints<2> constraints;
    constraints.fixed_vertices = {2};
    Constrained_traits traits;
    FFM::Map_minimizer<2, Constrained_traits> minimizer(example.domain, traits, constraints);
    minimizer.add_term(std::make_shared<Unannounced_spring<2>>(0, n - 1, 0.4));
    FFM::Positions<2> x = example.x, targets = example.x;
    targets.col(2) *= 1.01;
    const FFM::Summary summary = moves ? minimizer.move_fixed_vertices(x, targets) : minimizer.minimize(x);
    BOOST_TEST(FFM::status_name(summary.status) == "invalid_option");
    BOOST_TEST(summary.message.find("stencil") != std::string::npos, summary.message);
    BOOST_TEST((x.array() == example.x.array()).all());
  }
}

// A term that comes after a run counts from then on, as if it had been there from the beginning.
BOOST_AUTO_TEST_CASE(terms_after_a_run)
{
  const Distorted_example<2> example;
  const std::int32_t n = example.domain.number_of_vertices;
  const Term<2> spring = std::make_shared<Spring<2>>(0, n - 1, 0.4);
  FFM::Positions<2> expected = example.x, x = example.x;
  BOOST_TEST_REQUIRE(minimized<2>(example.domain, {}, expected, spring).converged());

  Constrained_traits traits;
  traits.options = tight_options();
  FFM::Map_minimizer<2, Constrained_traits> minimizer(example.domain, traits);
  BOOST_TEST(minimizer.minimize(x).converged());
  x = example.x;
  minimizer.add_term(spring);
  BOOST_TEST(minimizer.minimize(x).converged());
  BOOST_TEST((x.array() == expected.array()).all());
}

BOOST_AUTO_TEST_SUITE_END() // test_constraints
