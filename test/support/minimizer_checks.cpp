// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include <boost/test/unit_test.hpp>

#include "support/minimizer_checks.h"

#include "support/dense_algebra.h"

#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace test_support {

FFM::Map_options tight_options()
{
  FFM::Map_options options;
  options.characteristic_gradient_tolerance = 1e-9;
  options.max_iterations = 3000;
  return options;
}

double bumpy_minimum()
{
  const auto domain = make_domain(bumpy_patch(12, 10));
  Method_traits<FFM::Projected_newton> traits;
  traits.options.characteristic_gradient_tolerance = 1e-12;
  FFM::Positions<2> x = tutte_start(domain);
  return FFM::Map_minimizer<2, Method_traits<FFM::Projected_newton>>(domain, traits).minimize(x).energy;
}

void check_summary(const FFM::Simplicial_domain<2>& domain, const Outcome& outcome)
{
  const FFM::Summary& summary = outcome.summary;
  BOOST_TEST(number_of_flips(domain, outcome.x) == 0);
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(summary.vertices == domain.number_of_vertices);
  BOOST_TEST(summary.elements == domain.number_of_elements());
  BOOST_TEST(std::abs(summary.energy - symmetric_dirichlet<2>(domain, outcome.x)) <= 1e-11 * summary.energy);
  BOOST_TEST(std::abs(summary.energy_initial - symmetric_dirichlet<2>(domain, outcome.start)) <= 1e-11 * summary.energy_initial);
  BOOST_TEST(summary.energy < summary.energy_initial);
  double smallest = summary.max_singular_value, largest = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Vector2d s = singular_values(domain.jacobian(e, outcome.x));
    smallest = (std::min)(smallest, s[1]);
    largest = (std::max)(largest, s[0]);
  }
  BOOST_TEST(std::abs(summary.min_singular_value - smallest) <= 1e-12 * largest);
  BOOST_TEST(std::abs(summary.max_singular_value - largest) <= 1e-12 * largest);
  BOOST_TEST(summary.factorizations >= 1);
}

} // namespace test_support
