// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Minima that are known, and what factorizations cost.

#include "support/unit_test.h"

#include "support/minimizer_checks.h"

#include <CGAL/Flip_free_maps/accelerations/Lbfgs.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <cmath>
#include <tuple>

BOOST_AUTO_TEST_SUITE(test_minimizer)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef std::tuple<Method_traits<FFM::Projected_newton>, FFM::Flip_free_map_traits<>> Methods;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(developable_surfaces_become_isometric, Method, Methods) { check_developable_surfaces<Method>(); }

BOOST_AUTO_TEST_CASE_TEMPLATE(all_methods_end_at_the_same_energy, Method, Methods) { check_bumpy_patch<Method>(); }

BOOST_AUTO_TEST_CASE(constant_laplacian_is_factorized_once)
{
  const auto domain = make_domain(bumpy_patch(12, 10));
  Method_traits<FFM::Laplacian> traits;
  traits.options = tight_options();
  traits.options.characteristic_gradient_tolerance = 1e-5;
  const Outcome outcome = minimized(domain, tutte_start(domain), traits);
  BOOST_TEST(outcome.summary.converged());
  BOOST_TEST(outcome.summary.factorizations == 1);
  BOOST_TEST(std::abs(outcome.summary.energy - bumpy_minimum()) <= 1e-4);
  check_summary(domain, outcome);
}

BOOST_AUTO_TEST_CASE(analysis_ahead_of_the_run)
{
  using Traits = FFM::Flip_free_map_traits<>;
  const auto domain = make_domain(bumpy_patch(12, 10));
  FFM::Positions<2> expected = tutte_start(domain), x = expected;
  const FFM::Summary at_once = FFM::Map_minimizer<2, Traits>(domain).minimize(expected);

  FFM::Map_minimizer<2, Traits> minimizer(domain);
  FFM::Summary analysis;
  BOOST_TEST_REQUIRE(minimizer.analyze(analysis));
  BOOST_TEST(analysis.factor_entries == at_once.factor_entries);
  BOOST_TEST(analysis.seconds.analyze > 0);
  const FFM::Summary later = minimizer.minimize(x);
  BOOST_TEST(later.seconds.analyze == 0);
  BOOST_TEST(later.factor_entries == at_once.factor_entries);
  BOOST_TEST(later.iterations == at_once.iterations);
  BOOST_TEST((x == expected));
}

BOOST_AUTO_TEST_CASE(lbfgs_saves_factorizations)
{
  const auto domain = make_domain(bumpy_patch(12, 10));
  const FFM::Positions<2> start = tutte_start(domain);
  Method_traits<FFM::Projected_newton> newton;
  newton.options = tight_options();
  const Outcome expected = minimized(domain, start, newton);

  Method_traits<FFM::Projected_newton, FFM::Lbfgs, FFM::On_demand> lbfgs;
  lbfgs.options = tight_options();
  const Outcome outcome = minimized(domain, start, lbfgs);
  BOOST_TEST(outcome.summary.converged());
  BOOST_TEST(std::abs(outcome.summary.energy - expected.summary.energy) <= 1e-8);
  BOOST_TEST(outcome.summary.factorizations < expected.summary.factorizations);
  BOOST_TEST(outcome.summary.factorizations < outcome.summary.iterations);
  check_summary(domain, outcome);
}

BOOST_AUTO_TEST_CASE(scale_of_the_input_does_not_matter)
{
  const auto reference = make_domain(bumpy_patch(8, 7));
  Method_traits<FFM::Projected_newton> traits;
  const Outcome expected = minimized(reference, tutte_start(reference), traits);
  for(double scale : {1e-60, 1e-5, 1e5, 1e60}) {
    Surface surface = bumpy_patch(8, 7);
    for(auto& p : surface.points)
      p *= scale;
    const auto domain = make_domain(surface);
    const Outcome outcome = minimized(domain, tutte_start(domain), traits);
    BOOST_TEST(outcome.summary.converged());
    BOOST_TEST(std::abs(outcome.summary.energy - expected.summary.energy) <= 1e-9);
    // Powers of ten are rounded.
    BOOST_TEST(std::abs(outcome.summary.iterations - expected.summary.iterations) <= 1);
  }
}

BOOST_AUTO_TEST_CASE(repeated_and_continued)
{
  const auto domain = make_domain(bumpy_patch(8, 7));
  Method_traits<FFM::Projected_newton> traits;
  FFM::Map_minimizer<2, Method_traits<FFM::Projected_newton>> minimizer(domain, traits);
  const FFM::Positions<2> start = tutte_start(domain);
  FFM::Positions<2> first = start, second = start;
  const FFM::Summary summary = minimizer.minimize(first);
  BOOST_TEST(minimizer.minimize(second).iterations == summary.iterations);
  BOOST_TEST((first == second));
  // From the result there is nothing left to do.
  const FFM::Summary again = minimizer.minimize(second);
  BOOST_TEST(again.converged());
  BOOST_TEST(again.iterations == 0);
  BOOST_TEST((first == second));
}

BOOST_AUTO_TEST_SUITE_END() // test_minimizer
