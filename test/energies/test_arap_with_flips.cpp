// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Energies without a barrier may be minimised from starts with flips; those with one never are.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Arap.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_arap_with_flips)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// One instantiation serves both kinds of energies.
typedef FFM::Flip_free_map_traits<CGAL::Default, FFM::Any_energy> Traits;

struct Fixture
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(10, 8));
  FFM::Positions<2> start = tutte_start(domain);
  FFM::Positions<2> flipped = start;
  FFM::Positions<2> x;
  std::vector<FFM::Iteration_report> reports;

  // Some inner vertices far from their places.
  Fixture()
  {
    for(const int v : {37, 52, 60})
      flipped.col(v) += Eigen::Vector2d(0.4, -0.3);
  }

  FFM::Summary run(const FFM::Any_energy& energy, const FFM::Positions<2>& from, bool allow_flips)
  {
    Traits traits;
    traits.energy = energy;
    traits.options.allow_flips = allow_flips;
    traits.options.characteristic_gradient_tolerance = 1e-8;
    reports.clear();
    traits.options.observer = [this](const FFM::Iteration_report& report) {
      reports.push_back(report);
      return true;
    };
    x = from;
    const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
    BOOST_TEST_MESSAGE(summary);
    return summary;
  }

  void check_refused(const FFM::Summary& summary, const FFM::Positions<2>& from)
  {
    BOOST_TEST(FFM::status_name(summary.status) == "start_not_flip_free");
    BOOST_TEST(reports.empty());
    BOOST_TEST((x.array() == from.array() || (x.array().isNaN() && from.array().isNaN())).all());
  }

  // Mean of (s_1 - 1)^2 + (s_2 - 1)^2 with signed singular values: the squared distance of J from the rotations.
  double arap(const FFM::Positions<2>& y) const
  {
    double energy = 0;
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
      const Eigen::Matrix2d J = domain.jacobian(e, y);
      const double closest = std::hypot(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1));
      energy += domain.measures[e] * (J.squaredNorm() + 2 - 2 * closest);
    }
    return energy;
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(flips_are_accepted_and_counted, Fixture)
{
  const std::int64_t flips = number_of_flips(domain, flipped);
  BOOST_TEST_REQUIRE(flips >= 5);
  const FFM::Any_energy energy{FFM::Arap()};
  const double unit = energy.value<2>(Eigen::Vector2d(2, 1)); // the package's scale of the energy
  const FFM::Summary summary = run(energy, flipped, true);
  BOOST_TEST(FFM::status_name(summary.status) == "success");
  BOOST_TEST(summary.flips == number_of_flips(domain, x));
  BOOST_TEST_REQUIRE(!reports.empty());
  BOOST_TEST(reports.front().flips == flips);
  BOOST_TEST(reports.back().flips == summary.flips);
  BOOST_TEST(std::abs(summary.energy_initial - unit * arap(flipped)) <= 1e-11 * summary.energy_initial);
  BOOST_TEST(std::abs(summary.energy - unit * arap(x)) <= 1e-11 * summary.energy);
  for(std::size_t k = 0; k + 1 < reports.size(); ++k)
    BOOST_TEST(reports[k + 1].energy <= reports[k].energy);

  // A patch like this one has a minimum without flips, to which good starts lead with and without the option.
  const FFM::Summary free = run(energy, start, false);
  BOOST_TEST(free.converged());
  BOOST_TEST(free.flips == 0);
  BOOST_TEST(number_of_flips(domain, x) == 0);
  const FFM::Summary other = run(energy, start, true);
  BOOST_TEST(other.converged());
  BOOST_TEST(other.flips == number_of_flips(domain, x));
  BOOST_TEST(std::abs(other.energy - free.energy) <= 1e-9);
  BOOST_TEST(summary.energy >= free.energy - 1e-9);
}

// Flips that are still there at the end are counted, and the map is valid all the same.
BOOST_FIXTURE_TEST_CASE(flips_remain_in_valid_maps, Fixture)
{
  FFM::Positions<2> mirrored = start;
  mirrored.row(0) *= -1;
  const std::int64_t all = domain.number_of_elements();
  Traits traits;
  traits.energy = FFM::Any_energy{FFM::Arap()};
  traits.options.allow_flips = true;
  traits.options.max_iterations = 0;
  x = mirrored;
  const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
  BOOST_TEST(FFM::status_name(summary.status) == "iteration_limit");
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(summary.flips == all);
  BOOST_TEST(summary.max_singular_value > 0);
  BOOST_TEST(summary.min_singular_value < 0);
  BOOST_TEST((x.array() == mirrored.array()).all());
}

BOOST_FIXTURE_TEST_CASE(flips_are_refused, Fixture)
{
  check_refused(run(FFM::Any_energy{FFM::Arap()}, flipped, false), flipped);
  check_refused(run(FFM::Any_energy{FFM::Symmetric_dirichlet()}, flipped, true), flipped);
  check_refused(run(FFM::Any_energy{FFM::Symmetric_dirichlet()}, flipped, false), flipped);
  FFM::Positions<2> bad = start;
  bad(1, 5) = std::numeric_limits<double>::quiet_NaN();
  check_refused(run(FFM::Any_energy{FFM::Arap()}, bad, true), bad);
}

// Surfaces whose maps of least energy have flips: without them elements end close to their collapse, but not so close that the map
// does not bear being scaled.
BOOST_FIXTURE_TEST_CASE(elements_about_to_collapse, Fixture)
{
  for(const Surface& surface : {closed_tube(8, 6), closed_tube(12, 10), bumpy_patch(16, 12, 1.5)}) {
    domain = make_domain(surface);
    start = tutte_start(domain);
    const FFM::Summary summary = run(FFM::Any_energy{FFM::Arap()}, start, false);
    BOOST_TEST(summary.is_valid(), FFM::status_name(summary.status));
    BOOST_TEST(summary.energy < 0.9 * summary.energy_initial);
    for(const double scale : {1., 0.1, 1 / 3., 12.34})
      BOOST_TEST(number_of_flips(domain, (scale * x).eval()) == 0);
  }
}

BOOST_FIXTURE_TEST_CASE(barriers_ignore_the_option, Fixture)
{
  const FFM::Summary without = run(FFM::Any_energy{FFM::Symmetric_dirichlet()}, start, false);
  const FFM::Positions<2> expected = x;
  const FFM::Summary with = run(FFM::Any_energy{FFM::Symmetric_dirichlet()}, start, true);
  BOOST_TEST(with.converged());
  BOOST_TEST(with.iterations == without.iterations);
  BOOST_TEST(with.energy == without.energy);
  BOOST_TEST(with.flips == 0);
  BOOST_TEST((x.array() == expected.array()).all());
}

BOOST_AUTO_TEST_SUITE_END() // test_arap_with_flips
