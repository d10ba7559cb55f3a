// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Methods with progressive references end where projected Newton ends,
// and the hybrid preconditioner changes over by its two rules.

#include "support/unit_test.h"

#include "support/full_matrix.h"
#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_progressive_methods)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// A wavy strip, whose ends a Tutte map on a circle squeezes.
FFM::Simplicial_domain<2> strip_domain()
{
  return make_domain(grid(
    80, 4, [](double u, double v) { return Eigen::Vector3d(40 * u, 2 * v, 0.2 * std::sin(60 * u) * std::cos(3 * v)); }, true));
}

double distorted_fraction(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x, double bound)
{
  double number = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Matrix2d J = domain.jacobian(e, x);
    number += (J.squaredNorm() + J.inverse().squaredNorm()) / 4 > bound;
  }
  return number / double(domain.number_of_elements());
}

struct Outcome
{
  FFM::Summary summary;
  FFM::Positions<2> x;
};

Outcome minimized(const FFM::Simplicial_domain<2>& domain, FFM::Any_map_traits traits)
{
  Outcome outcome;
  outcome.x = tutte_start(domain);
  FFM::Map_minimizer<2, FFM::Any_map_traits> minimizer(domain, traits);
  outcome.summary = minimizer.minimize(outcome.x);
  BOOST_TEST_MESSAGE(outcome.summary);
  return outcome;
}

FFM::Any_map_traits method(const std::string& name)
{
  FFM::Any_map_traits traits;
  BOOST_TEST_REQUIRE(traits.use_method(name));
  traits.options.characteristic_gradient_tolerance = 1e-8;
  return traits;
}

} // namespace

BOOST_AUTO_TEST_CASE(progressive_methods_reach_the_optimum)
{
  const auto domain = strip_domain();
  BOOST_TEST(distorted_fraction(domain, tutte_start(domain), FFM::Progressive_reference().bound) > 0.02);
  const Outcome expected = minimized(domain, method("projected-newton"));
  BOOST_TEST_REQUIRE(expected.summary.converged());
  // Not an isometry, by much more than energies are compared to.
  BOOST_TEST(expected.summary.energy > 1 + 5e-5);
  for(const char* name : {"pp", "p-cm", "p-slim", "p-akvf"}) {
    BOOST_TEST_CONTEXT(name)
    {
      const Outcome outcome = minimized(domain, method(name));
      BOOST_TEST(outcome.summary.converged());
      BOOST_TEST(std::abs(outcome.summary.energy - expected.summary.energy) <= 1e-6);
      BOOST_TEST(std::abs(outcome.summary.energy - symmetric_dirichlet<2>(domain, outcome.x)) <= 1e-11 * outcome.summary.energy);
      BOOST_TEST(number_of_flips(domain, outcome.x) == 0);
      BOOST_TEST(outcome.summary.flips == 0);
    }
  }
}

// A target that every map meets ends a run as soon as the rest shape is the reference, and not before.
BOOST_AUTO_TEST_CASE(runs_end_on_the_rest_shape)
{
  const auto domain = strip_domain();
  FFM::Any_map_traits traits = method("projected-newton");
  traits.options.target_energy = 1e300;
  traits.options.characteristic_gradient_tolerance = 1e300;
  BOOST_TEST(minimized(domain, traits).summary.iterations == 0);

  for(const char* name : {"pp", "p-slim"}) {
    traits.use_method(name);
    std::vector<double> energies;
    traits.options.observer = [&](const FFM::Iteration_report& report) {
      energies.push_back(report.energy);
      return true;
    };
    const Outcome outcome = minimized(domain, traits);
    BOOST_TEST(outcome.summary.converged());
    BOOST_TEST(outcome.summary.iterations >= 1);
    BOOST_TEST(energies.size() == std::size_t(outcome.summary.iterations) + 1);
    // What is reported is measured on the rest shape throughout.
    BOOST_TEST(std::abs(energies.front() - symmetric_dirichlet<2>(domain, tutte_start(domain))) <= 1e-11 * energies.front());
    BOOST_TEST(std::abs(energies.back() - symmetric_dirichlet<2>(domain, outcome.x)) <= 1e-11 * energies.back());
    BOOST_TEST(distorted_fraction(domain, outcome.x, 60) <= 0.01);
  }
  traits.options.observer = nullptr;
  for(const char* name : {"pp+", "p-slim+"}) {
    traits.use_method(name);
    BOOST_TEST(distorted_fraction(domain, minimized(domain, traits).x, 60) == 0);
  }
}

// An infinite bound leaves no element to be distorted too much; all is as on the rest shape.
BOOST_AUTO_TEST_CASE(infinite_bound_is_the_rest_shape)
{
  const auto domain = strip_domain();
  FFM::Any_map_traits traits = method("slim");
  BOOST_TEST(!traits.has_progressive_reference());
  const Outcome fixed = minimized(domain, traits);
  traits.use_progressive_reference(1e200);
  BOOST_TEST(traits.has_progressive_reference());
  const Outcome progressive = minimized(domain, traits);
  BOOST_TEST(fixed.summary.iterations == progressive.summary.iterations);
  BOOST_TEST((fixed.x.array() == progressive.x.array()).all());
}

BOOST_AUTO_TEST_CASE(hybrid_changes_over)
{
  const FFM::Symmetric_dirichlet energy;
  const Eigen::Vector2d s(3, 0.2);
  const Full_matrix<2> first = frame_matrix<2>(FFM::Slim(), energy, s), second = frame_matrix<2>(FFM::Projected_newton(), energy, s);
  BOOST_TEST((first - second).norm() > 0.1);
  FFM::Hybrid<> hybrid;
  double asked = 0, fraction = 0.5;
  FFM::Iteration_state state;
  state.distorted_fraction = [&](double bound) {
    asked = bound;
    return fraction;
  };
  const auto uses_second = [&](int iteration, double relative_decrease, double distorted) {
    state.iteration = iteration;
    state.relative_decrease = relative_decrease;
    fraction = distorted;
    hybrid.begin_iteration(state);
    const Full_matrix<2> form = frame_matrix<2>(hybrid, energy, s);
    BOOST_TEST((form == first || form == second));
    return form == second;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(!uses_second(0, infinity, 0.5));
  BOOST_TEST(asked == 60);
  BOOST_TEST(!uses_second(1, 0.101, 0.0101));
  BOOST_TEST(uses_second(2, 0.099, 0.5)); // a small decrease
  BOOST_TEST(uses_second(3, 10., 0.5));   // for the rest of the run
  BOOST_TEST(!uses_second(0, infinity, 0.5));
  BOOST_TEST(!uses_second(1, -0.101, 0.5)); // an increase is a change as well
  BOOST_TEST(uses_second(2, -0.099, 0.5));
  BOOST_TEST(!uses_second(0, infinity, 0.5)); // a new run
  BOOST_TEST(uses_second(1, 10., 0.01));      // few distorted elements
  BOOST_TEST(uses_second(2, 10., 0.5));
  BOOST_TEST(uses_second(0, infinity, 0.)); // none from the beginning
  hybrid.bound = 10;
  uses_second(0, infinity, 0.5);
  BOOST_TEST(asked == 10);
}

BOOST_AUTO_TEST_SUITE_END() // test_progressive_methods
