// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// How a run ends: every stopping rule, bad options, bad starts, and what the caller's positions hold afterwards.

#include "support/unit_test.h"

#include "support/minimizer_fixture.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_minimizer_ends)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

BOOST_FIXTURE_TEST_CASE(every_rule_has_a_message_of_its_own, Fixture)
{
  std::set<std::string> messages;
  FFM::Map_options options;

  FFM::Summary summary = run(options);
  check_valid(summary, FFM::Status::success);
  BOOST_TEST(summary.characteristic_gradient_norm <= options.characteristic_gradient_tolerance);
  messages.insert(summary.message);

  options = no_rules();
  options.gradient_tolerance = 1e-3;
  summary = run(options);
  check_valid(summary, FFM::Status::success);
  BOOST_TEST(summary.gradient_norm <= 1e-3);
  messages.insert(summary.message);

  options = no_rules();
  options.relative_energy_tolerance = 1e-4;
  summary = run(options);
  check_valid(summary, FFM::Status::success);
  messages.insert(summary.message);

  options = no_rules();
  options.target_energy = 0.5 * (summary.energy_initial + summary.energy);
  summary = run(options);
  check_valid(summary, FFM::Status::success);
  BOOST_TEST(summary.energy <= options.target_energy);
  messages.insert(summary.message);

  // At the minimum, but for rounding, nothing else ends this one.
  {
    Fixture at_rest;
    Random random(41);
    const Surface flat =
      grid(8, 7, [&](double u, double v) { return Eigen::Vector3d(u + random(-0.04, 0.04), v + random(-0.04, 0.04), 0); });
    at_rest.domain = make_domain(flat);
    at_rest.start = positions_of<2>(flat, at_rest.domain.scale);
    summary = at_rest.run(no_rules());
    at_rest.check_valid(summary, FFM::Status::success);
    BOOST_TEST(std::abs(summary.energy - 1) <= 1e-14);
    messages.insert(summary.message);
  }

  options = no_rules();
  options.max_iterations = 3;
  summary = run(options);
  check_valid(summary, FFM::Status::iteration_limit);
  BOOST_TEST(summary.iterations == 3);
  BOOST_TEST(summary.energy < summary.energy_initial);
  messages.insert(summary.message);

  options.max_iterations = 0;
  summary = run(options);
  check_valid(summary, FFM::Status::iteration_limit);
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST(summary.energy == summary.energy_initial);
  BOOST_TEST((x == start));

  options = no_rules();
  options.max_seconds = 0;
  summary = run(options);
  check_valid(summary, FFM::Status::time_limit);
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST((x == start));
  messages.insert(summary.message);

  options = no_rules();
  options.observer = [](const FFM::Iteration_report& report) { return report.iteration < 2; };
  summary = run(options);
  check_valid(summary, FFM::Status::stopped_by_observer);
  BOOST_TEST(summary.iterations == 2);
  messages.insert(summary.message);

  BOOST_TEST(messages.size() == 8u);
}

// With a factorization in each iteration, one that would gain less than the tolerance is foreseen and saved. The rule speaks of the
// next step: all further ones together give a small multiple of it, also where first steps are long, which may decrease the energy by
// little far from the optimum.
BOOST_FIXTURE_TEST_CASE(no_factorization_only_confirms_convergence, Fixture)
{
  using Traits = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, CGAL::Default,
                                           FFM::No_acceleration, FFM::Every_iteration>;
  FFM::Map_options options = no_rules();
  options.max_iterations = 500;
  const double optimum = run<Traits>(options).energy;
  int number_foreseen = 0;
  for(const bool begins_with_largest : {false, true})
    for(double tolerance = 1e-2; tolerance > 1e-10; tolerance /= 3) {
      options = no_rules();
      options.begin_with_largest_step = begins_with_largest;
      options.relative_energy_tolerance = tolerance;
      const FFM::Summary summary = run<Traits>(options);
      check_valid(summary, FFM::Status::success);
      BOOST_TEST(summary.energy - optimum <= 10 * tolerance * optimum);
      if(summary.message.find("predicted") == std::string::npos)
        continue;
      ++number_foreseen;
      options.relative_energy_tolerance = 0;
      options.max_iterations = summary.iterations + 1;
      const FFM::Summary further = run<Traits>(options);
      BOOST_TEST(further.factorizations > summary.factorizations);
      BOOST_TEST(summary.energy - further.energy <= 10 * tolerance * optimum);
    }
  BOOST_TEST(number_foreseen > 0);
}

// The plain rule of the energy looks at the last step only.
BOOST_FIXTURE_TEST_CASE(plain_rule_of_the_energy, Fixture)
{
  for(const double tolerance : {1e-1, 1e-3, 1e-6}) {
    FFM::Map_options options = no_rules();
    options.careful_stagnation = false;
    options.relative_energy_tolerance = tolerance;
    std::vector<double> energies;
    options.observer = [&](const FFM::Iteration_report& report) {
      energies.push_back(report.energy);
      return true;
    };
    const FFM::Summary summary = run(options);
    check_valid(summary, FFM::Status::success);
    BOOST_TEST_REQUIRE(energies.size() >= 2u);
    for(std::size_t i = 1; i < energies.size(); ++i)
      BOOST_TEST(((energies[i - 1] - energies[i]) / energies[i] <= tolerance) == (i + 1 == energies.size()));
  }
}

BOOST_FIXTURE_TEST_CASE(the_observer_may_stop_at_once, Fixture)
{
  FFM::Map_options options;
  int calls = 0;
  options.observer = [&](const FFM::Iteration_report& report) {
    ++calls;
    BOOST_TEST(report.iteration == 0);
    BOOST_TEST(report.flips == 0);
    BOOST_TEST(std::abs(report.energy - symmetric_dirichlet<2>(domain, start)) <= 1e-11 * report.energy);
    return false;
  };
  const FFM::Summary summary = run(options);
  check_valid(summary, FFM::Status::stopped_by_observer);
  BOOST_TEST(calls == 1);
  BOOST_TEST((x == start));
}

BOOST_FIXTURE_TEST_CASE(exceptions_of_the_observer_pass_through, Fixture)
{
  FFM::Map_options options;
  options.observer = [](const FFM::Iteration_report& report) -> bool {
    if(report.iteration == 2)
      throw std::runtime_error("enough");
    return true;
  };
  BOOST_CHECK_THROW(run(options), std::runtime_error);
  BOOST_TEST((x == start));
}

BOOST_FIXTURE_TEST_CASE(invalid_options, Fixture)
{
  typedef FFM::Map_options Options;
  const std::vector<std::function<void(Options&)>> faults{[](Options& o) { o.characteristic_gradient_tolerance = -1; },
                                                          [](Options& o) { o.characteristic_gradient_tolerance = not_a_number; },
                                                          [](Options& o) { o.characteristic_gradient_tolerance = infinity; },
                                                          [](Options& o) { o.gradient_tolerance = -1; },
                                                          [](Options& o) { o.gradient_tolerance = not_a_number; },
                                                          [](Options& o) { o.relative_energy_tolerance = -1; },
                                                          [](Options& o) { o.relative_energy_tolerance = not_a_number; },
                                                          [](Options& o) { o.stagnation_iterations = 0; },
                                                          [](Options& o) { o.target_energy = not_a_number; },
                                                          [](Options& o) { o.max_iterations = -1; },
                                                          [](Options& o) { o.max_seconds = -1; },
                                                          [](Options& o) { o.max_seconds = not_a_number; },
                                                          [](Options& o) { o.step_fraction = 0; },
                                                          [](Options& o) { o.step_fraction = 1; },
                                                          [](Options& o) { o.step_fraction = not_a_number; },
                                                          [](Options& o) { o.armijo = 0; },
                                                          [](Options& o) { o.armijo = 0.5; },
                                                          [](Options& o) { o.armijo = not_a_number; },
                                                          [](Options& o) { o.max_line_search_steps = 0; }};
  const std::vector<std::string> fields{"tolerance",   "stagnation_iterations", "target_energy", "max_iterations",
                                        "max_seconds", "step_fraction",         "armijo",        "max_line_search_steps"};
  for(const auto& fault : faults) {
    Options options;
    fault(options);
    const FFM::Summary summary = run(options);
    check_failed(summary, FFM::Status::invalid_option);
    bool names_field = false;
    for(const std::string& field : fields)
      names_field = names_field || summary.message.find(field) != std::string::npos;
    BOOST_TEST(names_field, summary.message);
    BOOST_TEST(!options.is_valid());
  }
}

BOOST_FIXTURE_TEST_CASE(bad_starts, Fixture)
{
  const FFM::Positions<2> good = start;
  for(double bad : {not_a_number, infinity, -infinity}) {
    start = good;
    start(1, 20) = bad;
    check_failed(run(), FFM::Status::start_not_flip_free);
  }
  start = good;
  start.row(0) *= -1;
  const FFM::Summary mirrored = run();
  check_failed(mirrored, FFM::Status::start_not_flip_free);
  BOOST_TEST(mirrored.flips == domain.number_of_elements());
  // One vertex on the other side of an edge.
  start = good;
  start.col(30) = good.col(0) * 2;
  const FFM::Summary flipped = run();
  check_failed(flipped, FFM::Status::start_not_flip_free);
  BOOST_TEST(flipped.flips == number_of_flips(domain, start));
  // Collapsed to a line, to a point.
  start = good;
  start.row(0).setZero();
  check_failed(run(), FFM::Status::start_not_flip_free);
  start.setZero();
  check_failed(run(), FFM::Status::start_not_flip_free);
}

// A strip of a material that hardly changes its area, bent: shear is a hundredth as stiff as that, and what is left to be done when
// the run ends is shear.
BOOST_AUTO_TEST_CASE(stiff_materials_find_their_shape)
{
  const Surface strip = grid(24, 6, [](double u, double v) { return Eigen::Vector3d(4 * u, v, 0); });
  const FFM::Simplicial_domain<2> domain = make_domain(strip);
  const FFM::Positions<2> rest = positions_of<2>(strip, domain.scale);
  FFM::Position_constraints<2> ends;
  FFM::Positions<2> target = rest;
  const Eigen::Rotation2Dd turn(1.2);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const Eigen::Vector3d& p = strip.points[v];
    if(p[0] == 0 || p[0] == 4)
      ends.fixed_vertices.push_back(v);
    if(p[0] == 4)
      target.col(v) = (Eigen::Vector2d(1.2, 1) + turn * Eigen::Vector2d(p[0] - 2, p[1])) / domain.scale;
  }
  const auto bent = [&](double tolerance) {
    FFM::Any_map_traits traits;
    traits.energy = FFM::Any_energy(FFM::Neo_hookean::of_material(1, 0.495, 2));
    if(tolerance > 0)
      traits.options.characteristic_gradient_tolerance = tolerance;
    FFM::Positions<2> x = rest;
    const FFM::Summary summary = FFM::Map_minimizer<2, FFM::Any_map_traits>(domain, traits, ends).move_fixed_vertices(x, target);
    BOOST_TEST(FFM::status_name(summary.status) == "success");
    return summary.energy;
  };
  const double optimum = bent(1e-11);
  BOOST_TEST(bent(0) <= optimum * (1 + 1e-7));
}

BOOST_FIXTURE_TEST_CASE(extreme_but_valid_starts, Fixture)
{
  const FFM::Summary expected = run();
  const FFM::Positions<2> good = start;
  for(double scale : {1e-3, 1e3}) {
    start = scale * good;
    const FFM::Summary summary = run();
    check_valid(summary, FFM::Status::success);
    BOOST_TEST(std::abs(summary.energy - expected.energy) <= 1e-6);
  }
  // Sheared to needles.
  start = good;
  start.row(0) += 300 * good.row(1);
  const FFM::Summary sheared = run();
  check_valid(sheared, FFM::Status::success);
  BOOST_TEST(sheared.energy < 0.01 * sheared.energy_initial);
}

BOOST_AUTO_TEST_SUITE_END() // test_minimizer_ends
