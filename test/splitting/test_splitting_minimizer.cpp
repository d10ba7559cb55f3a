// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The splitting against the Newton minimizer on the same problem, starts with flips, fixed vertices, and how runs end.

#define BOOST_TEST_MODULE splitting_minimizer
#include <boost/test/included/unit_test.hpp>

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/Map_minimizer.h>
#include <CGAL/Flip_free_maps/Splitting_minimizer.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>

#include <limits>

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Energy>
using Traits = FFM::Flip_free_map_traits<CGAL::Default, Energy>;

template <int D>
std::int64_t negative_elements(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x)
{
  std::int64_t flips = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    flips += !(domain.image_edges(e, x).determinant() > 0);
  return flips;
}

// Some vertices jump far enough to flip the elements around them.
template <int D>
FFM::Positions<D> shaken(const FFM::Positions<D>& x, double length, int every)
{
  Random random(11);
  FFM::Positions<D> result = x;
  for(Eigen::Index v = 0; v < x.cols(); v += every)
    for(int c = 0; c < D; ++c)
      result(c, v) += random(-length, length);
  return result;
}

// Newton's method, converged far beyond the splitting's tolerances.
template <int D, typename Energy>
double minimum_near(const FFM::Simplicial_domain<D>& domain, FFM::Positions<D> x)
{
  Traits<Energy> traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  const FFM::Summary summary = FFM::Map_minimizer<D, Traits<Energy>>(domain, traits).minimize(x);
  BOOST_TEST(summary.converged());
  return summary.energy;
}

template <int D, typename Energy>
FFM::Summary check_splitting(const FFM::Simplicial_domain<D>& domain, FFM::Positions<D>& x)
{
  const FFM::Summary summary = FFM::Splitting_minimizer<D, Traits<Energy>>(domain).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(negative_elements(domain, x) == 0);
  BOOST_TEST(summary.factorizations < summary.iterations);
  BOOST_TEST(summary.min_singular_value > 0);
  return summary;
}

} // namespace

BOOST_AUTO_TEST_CASE(same_energy_in_the_plane)
{
  typedef FFM::Symmetric_dirichlet Energy;
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(12, 9));
  const FFM::Positions<2> start = tutte_start(domain), flipped = shaken<2>(start, 0.2, 5), wild = shaken<2>(start, 0.5, 5);
  BOOST_TEST_REQUIRE(negative_elements(domain, flipped) > 10);
  BOOST_TEST_REQUIRE(negative_elements(domain, wild) > 10);
  const double minimum = minimum_near<2, Energy>(domain, start);
  for(const FFM::Positions<2>& from : {start, flipped}) {
    FFM::Positions<2> x = from;
    const FFM::Summary splitting = check_splitting<2, Energy>(domain, x);
    BOOST_TEST(splitting.energy == minimum, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(splitting.energy >= minimum - 1e-9);
  }

  // From a start that is far off, the map may turn twice around a vertex. It is a local minimum all the same.
  FFM::Positions<2> x = wild;
  const FFM::Summary splitting = check_splitting<2, Energy>(domain, x);
  const double nearby = minimum_near<2, Energy>(domain, x);
  BOOST_TEST(splitting.energy == nearby, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(splitting.energy >= nearby - 1e-9);
  BOOST_TEST(nearby >= minimum - 1e-9);
}

BOOST_AUTO_TEST_CASE(handles_that_jump_from_a_model)
{
  const Surface flat = grid(12, 6, [](double u, double v) { return Eigen::Vector3d(2 * u, v, 0); });
  const FFM::Simplicial_domain<2> domain = make_domain(flat);
  const FFM::Positions<2> rest = positions_of<2>(flat, domain.scale);
  FFM::Positions<2> start = rest;
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices = {0, 12, 45};
  start.col(45) += Eigen::Vector2d(0.35, 0.4);
  BOOST_TEST_REQUIRE(negative_elements(domain, start) > 0);
  FFM::Splitting_options options;
  options.polish = true;
  FFM::Positions<2> x = start;
  FFM::Summary summary;
  FFM::Splitting_minimizer<2, Traits<FFM::Symmetric_dirichlet>>(domain, {}, constraints, options).minimize(x, rest, summary);
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(summary.start.find("splitting") != std::string::npos);
  for(std::int32_t v : constraints.fixed_vertices)
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
}

BOOST_AUTO_TEST_CASE(ends_of_runs)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  const FFM::Positions<2> start = tutte_start(domain), flipped = shaken<2>(start, 0.5, 4);
  const auto run = [&](const FFM::Splitting_options& options, FFM::Positions<2>& x) {
    return FFM::Splitting_minimizer<2, Traits<FFM::Symmetric_dirichlet>>(domain, {}, {}, options).minimize(x);
  };
  FFM::Splitting_options options;
  options.max_iterations = 0;
  FFM::Positions<2> x = flipped;
  FFM::Summary summary = run(options, x);
  BOOST_TEST(FFM::status_name(summary.status) == "flips_remain");
  BOOST_TEST(summary.flips == number_of_flips(domain, flipped));
  BOOST_TEST(summary.message.find(std::to_string(summary.flips)) != std::string::npos);
  BOOST_TEST((x.array() == flipped.array()).all());
  x = start;
  BOOST_TEST((run(options, x).status == FFM::Status::iteration_limit));

  // The first iterate without flips is the one that the observer is shown.
  options = FFM::Splitting_options();
  options.stop_when_flip_free = true;
  int seen = -1, calls = 0;
  options.observer = [&](const FFM::Splitting_report& report) {
    BOOST_TEST(report.iteration == calls++);
    if(report.flips == 0 && seen < 0)
      seen = report.iteration;
    return true;
  };
  x = flipped;
  summary = run(options, x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.iterations == seen);
  BOOST_TEST(number_of_flips(domain, x) == 0);

  options = FFM::Splitting_options();
  options.observer = [](const FFM::Splitting_report& report) { return report.iteration < 3; };
  x = start;
  summary = run(options, x);
  BOOST_TEST((summary.status == FFM::Status::stopped_by_observer));
  BOOST_TEST(summary.iterations == 3);

  x(0, 3) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((run({}, x).status == FFM::Status::non_finite_input));
  x.resize(2, 5);
  BOOST_TEST((run({}, x).status == FFM::Status::invalid_option));
  options.penalty_factor = 1;
  x = start;
  BOOST_TEST((run(options, x).status == FFM::Status::invalid_option));

  // The target energy is met by the map itself.
  options = FFM::Splitting_options();
  options.target_energy = 1.05;
  x = start;
  summary = run(options, x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.energy <= 1.05);
}
