// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_CHECKS_H

// What every method must achieve. To be included after Boost.Test; one file per few methods keeps compile times short.

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

// A method of the papers: one factorization for each step.
template <typename Preconditioner, typename Acceleration = FFM::No_acceleration, typename Rule = FFM::Every_iteration>
using Method_traits =
  FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Preconditioner, CGAL::Default, CGAL::Default, Acceleration, Rule>;

struct Outcome
{
  FFM::Summary summary;
  FFM::Positions<2> start, x;
};

template <typename Traits>
Outcome minimized(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& start, Traits traits)
{
  Outcome outcome;
  outcome.start = outcome.x = start;
  FFM::Map_minimizer<2, Traits> minimizer(domain, traits);
  outcome.summary = minimizer.minimize(outcome.x);
  BOOST_TEST_MESSAGE(outcome.summary);
  return outcome;
}

FFM::Map_options tight_options();

// Of the patch that `check_bumpy_patch()` flattens, by the projected Newton method.
double bumpy_minimum();

void check_summary(const FFM::Simplicial_domain<2>& domain, const Outcome& outcome);

// Developable surfaces have isometric maps.
template <typename Method>
void check_developable_surfaces()
{
  for(const Surface& surface : {cylinder_patch(14, 8), cone_patch(14, 8), bent_sheet(16, 8)}) {
    const auto domain = make_domain(surface);
    const FFM::Positions<2> start = tutte_start(domain);
    BOOST_TEST_REQUIRE(start.cols() == domain.number_of_vertices);
    Method traits;
    traits.options = tight_options();
    const Outcome outcome = minimized(domain, start, traits);
    BOOST_TEST((outcome.summary.status == FFM::Status::success));
    BOOST_TEST(outcome.summary.energy_initial > 1.01);
    BOOST_TEST(std::abs(outcome.summary.energy - 1) <= 1e-8);
    BOOST_TEST(std::abs(outcome.summary.min_singular_value - 1) <= 1e-3);
    BOOST_TEST(std::abs(outcome.summary.max_singular_value - 1) <= 1e-3);
    BOOST_TEST(outcome.summary.preconditioner == Method::Preconditioner::name());
    check_summary(domain, outcome);
  }
}

// Surfaces with hills have not, but all methods must agree.
template <typename Method>
void check_bumpy_patch()
{
  const auto domain = make_domain(bumpy_patch(12, 10));
  const double minimum = bumpy_minimum();
  Method traits;
  traits.options = tight_options();
  double last = 1e300;
  bool is_monotone = true;
  int reports = 0;
  traits.options.observer = [&](const FFM::Iteration_report& report) {
    is_monotone = is_monotone && report.energy <= last && report.iteration == reports;
    last = report.energy;
    ++reports;
    return true;
  };
  const Outcome outcome = minimized(domain, tutte_start(domain), traits);
  BOOST_TEST(outcome.summary.converged());
  BOOST_TEST(minimum > 1.001);
  BOOST_TEST(std::abs(outcome.summary.energy - minimum) <= 1e-6);
  BOOST_TEST(is_monotone);
  BOOST_TEST(reports == outcome.summary.iterations + 1);
  BOOST_TEST(last == outcome.summary.energy);
  check_summary(domain, outcome);

  // The gradient at the result, by differences of the energy.
  Eigen::VectorXd gradient(outcome.x.size());
  for(Eigen::Index i = 0; i < gradient.size(); ++i) {
    FFM::Positions<2> low = outcome.x, high = outcome.x;
    low.data()[i] -= 1e-5;
    high.data()[i] += 1e-5;
    gradient[i] = (symmetric_dirichlet<2>(domain, high) - symmetric_dirichlet<2>(domain, low)) / 2e-5;
  }
  BOOST_TEST(gradient.norm() <= 1e-7);
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_CHECKS_H
