// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Newton's method: quadratic convergence, and what becomes of indefinite Hessians.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_newton_method)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef FFM::Any_map_traits Traits;

FFM::Summary minimized(const char* method, const FFM::Simplicial_domain<2>& domain, FFM::Positions<2>& x, const FFM::Map_options& options,
                       bool with_eigen = true)
{
  Traits traits;
  BOOST_TEST_REQUIRE(traits.use_method(method));
  if(with_eigen)
    traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
  traits.options = options;
  const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
  BOOST_TEST_MESSAGE(summary);
  return summary;
}

} // namespace

BOOST_AUTO_TEST_CASE(newton_converges_quadratically)
{
  const auto domain = make_domain(bumpy_patch(8, 7));
  FFM::Map_options options;
  options.characteristic_gradient_tolerance = 1e-3;
  FFM::Positions<2> x = tutte_start(domain);
  BOOST_TEST_REQUIRE(minimized("newton", domain, x, options).converged());

  const FFM::Positions<2> start = x;
  options.characteristic_gradient_tolerance = 1e-13;
  double energy = 0;
  for(const bool with_eigen : {true, false}) {
    std::vector<double> norms;
    options.observer = [&](const FFM::Iteration_report& report) {
      norms.push_back(report.gradient_norm);
      return true;
    };
    x = start;
    const FFM::Summary summary = minimized("newton", domain, x, options, with_eigen);
    energy = summary.energy;
    BOOST_TEST_CONTEXT(summary.linear_solver)
    {
      BOOST_TEST(summary.converged());
      // Along rotations the curvature is that of the gradient, and may be negative until the end:
      // Cholesky factorizations refuse that.
      if(!with_eigen)
        continue;
      BOOST_TEST(summary.fallbacks == 0);
      BOOST_TEST(norms.size() <= 6u);
      for(std::size_t k = 0; k + 1 < norms.size(); ++k)
        BOOST_TEST(norms[k + 1] <= 20 * norms[k] * norms[k] + 1e-14);
    }
  }

  // It is the minimum.
  FFM::Positions<2> y = tutte_start(domain);
  options.observer = nullptr;
  const FFM::Summary projected = minimized("projected-newton", domain, y, options);
  BOOST_TEST(projected.converged());
  BOOST_TEST(std::abs(projected.energy - energy) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(newton_falls_back_from_indefinite_matrices)
{
  const auto domain = make_domain(bumpy_patch(8, 7));
  FFM::Map_options options;
  options.characteristic_gradient_tolerance = 1e-9;
  FFM::Positions<2> optimum = tutte_start(domain);
  const FFM::Summary expected = minimized("projected-newton", domain, optimum, options);
  BOOST_TEST_REQUIRE(expected.converged());
  BOOST_TEST(expected.fallbacks == 0);

  // A shrunken map gains most by growing: the Hessian is negative along rotations, which let the map grow.
  FFM::Positions<2> x = 0.3 * optimum;
  // The LDLT of Eigen factorizes indefinite matrices, and may find a direction of descent; Cholesky factorizations refuse them.
  const FFM::Positions<2> start = x;
  for(const bool with_eigen : {true, false}) {
    x = start;
    const FFM::Summary summary = minimized("newton", domain, x, options, with_eigen);
    BOOST_TEST_CONTEXT(summary.linear_solver)
    {
      BOOST_TEST(summary.converged());
      if(summary.linear_solver.find("cholmod") != std::string::npos)
        BOOST_TEST(summary.fallbacks >= 1);
      BOOST_TEST(summary.fallbacks <= summary.iterations);
      BOOST_TEST(std::abs(summary.energy - expected.energy) <= 1e-9);
      BOOST_TEST(number_of_flips(domain, x) == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_newton_method
