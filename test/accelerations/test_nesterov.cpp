// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Nesterov's acceleration: the steps it asks for, and AQP against the Sobolev gradient.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/accelerations/Nesterov.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_nesterov)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

struct Outcome
{
  FFM::Summary summary;
  FFM::Positions<2> x;
  std::vector<double> energies;
};

Outcome minimized(const FFM::Simplicial_domain<2>& domain, const FFM::Any_map_traits& method)
{
  Outcome outcome;
  FFM::Any_map_traits traits = method;
  traits.options.characteristic_gradient_tolerance = 1e-6;
  traits.options.observer = [&](const FFM::Iteration_report& report) {
    outcome.energies.push_back(report.energy);
    return true;
  };
  outcome.x = tutte_start(domain);
  outcome.summary = FFM::Map_minimizer<2, FFM::Any_map_traits>(domain, traits).minimize(outcome.x);
  BOOST_TEST_MESSAGE(outcome.summary);
  return outcome;
}

Outcome minimized(const FFM::Simplicial_domain<2>& domain, const std::string& name)
{
  FFM::Any_map_traits traits;
  BOOST_TEST_REQUIRE(traits.use_method(name));
  return minimized(domain, traits);
}

} // namespace

BOOST_AUTO_TEST_CASE(displacements)
{
  const Eigen::Vector3d x_0(1, 2, 3), x_1(2, 4, -5), x_2(2.5, 4, -6);
  const auto check = [&](FFM::Nesterov& nesterov, double theta) {
    Eigen::VectorXd displacement;
    BOOST_TEST(!nesterov.extrapolate(x_0, displacement));
    BOOST_TEST(nesterov.extrapolate(x_1, displacement));
    BOOST_TEST((displacement - theta * (x_1 - x_0)).norm() <= 1e-14);
    BOOST_TEST(nesterov.extrapolate(x_2, displacement));
    BOOST_TEST((displacement - theta * (x_2 - x_1)).norm() <= 1e-14);
  };
  FFM::Nesterov nesterov, other(25), none(1);
  check(nesterov, (1 - std::sqrt(0.01)) / (1 + std::sqrt(0.01)));
  nesterov.reset();
  check(nesterov, 9. / 11);
  check(other, 2. / 3);
  check(none, 0);

  // The direction itself is that of the preconditioner.
  Eigen::VectorXd direction;
  const auto half = [](const Eigen::VectorXd& b, Eigen::VectorXd& y) {
    y = 0.5 * b;
    return true;
  };
  BOOST_TEST(nesterov.direction(x_0, x_1, half, direction));
  BOOST_TEST((direction + 0.5 * x_1).norm() == 0);
  BOOST_TEST(!nesterov.direction(
    x_0, x_1, [](const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }, direction));
}

BOOST_AUTO_TEST_CASE(aqp_is_faster_than_the_sobolev_gradient)
{
  const auto domain = make_domain(bumpy_patch(12, 10, 0.4));
  const Outcome newton = minimized(domain, "projected-newton"), sobolev = minimized(domain, "sobolev"), aqp = minimized(domain, "aqp");
  BOOST_TEST_REQUIRE(newton.summary.converged());
  for(const Outcome& outcome : {sobolev, aqp}) {
    BOOST_TEST(outcome.summary.converged());
    BOOST_TEST(std::abs(outcome.summary.energy - newton.summary.energy) <= 1e-8);
    BOOST_TEST(std::abs(outcome.summary.energy - symmetric_dirichlet<2>(domain, outcome.x)) <= 1e-11 * outcome.summary.energy);
    BOOST_TEST(number_of_flips(domain, outcome.x) == 0);
    BOOST_TEST(outcome.summary.factorizations == 1);
    BOOST_TEST(outcome.summary.linear_solves == outcome.summary.iterations);
  }
  BOOST_TEST(aqp.summary.iterations < sobolev.summary.iterations);
  BOOST_TEST(aqp.summary.energy_evaluations >= 2 * aqp.summary.iterations - 2);

  // Extrapolation may give back a part of the last decrease, but no more.
  BOOST_TEST_REQUIRE(aqp.energies.size() >= 3u);
  bool is_bounded = true;
  for(std::size_t k = 0; k + 1 < aqp.energies.size(); ++k)
    is_bounded = is_bounded && aqp.energies[k + 1] <= aqp.energies[k] * (1 + 1e-14);
  BOOST_TEST(is_bounded);
}

// With eta = 1 nothing is extrapolated.
BOOST_AUTO_TEST_CASE(eta_of_one_is_no_acceleration)
{
  const auto domain = make_domain(bumpy_patch(6, 5));
  FFM::Any_map_traits traits;
  traits.use_method("aqp");
  traits.acceleration = FFM::Any_acceleration(FFM::Nesterov(1));
  const Outcome plain = minimized(domain, "sobolev"), none = minimized(domain, traits);
  BOOST_TEST(none.summary.converged());
  BOOST_TEST(std::abs(none.summary.iterations - plain.summary.iterations) <= 1);
  BOOST_TEST((none.x - plain.x).norm() <= 1e-10);
}

BOOST_AUTO_TEST_SUITE_END() // test_nesterov
