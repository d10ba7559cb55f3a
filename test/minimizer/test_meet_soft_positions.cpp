// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Weights are raised until soft positions are met: the result is the map with the same vertices fixed there.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/minimizer/meet_soft_positions.h>

#include <cmath>

BOOST_AUTO_TEST_SUITE(test_meet_soft_positions)

using namespace test_support;

namespace {

struct Pulled
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  FFM::Positions<2> start = tutte_start(domain);
  FFM::Position_constraints<2> constraints;

  Pulled()
  {
    const std::int32_t a = domain.border[0], b = domain.border[domain.border.size() / 2];
    constraints.soft_positions = {{a, start.col(a) * 1.2, 1}, {b, start.col(b) * 1.2, 1}};
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(soft_positions_are_met)
{
  Pulled pulled;
  FFM::Positions<2> x = pulled.start;
  double residual = -1;
  FFM::Weight_schedule schedule;
  schedule.tolerance = 1e-5;
  const FFM::Summary summary = FFM::meet_soft_positions<2>(pulled.domain, x, pulled.constraints, residual, {}, schedule);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::success));
  double largest = 0;
  for(const auto& soft : pulled.constraints.soft_positions)
    largest = (std::max)(largest, (x.col(soft.vertex) - soft.target).norm());
  BOOST_TEST(residual == largest);
  BOOST_TEST(residual <= schedule.tolerance);

  FFM::Positions<2> fixed = pulled.start, targets = fixed;
  FFM::Position_constraints<2> hard;
  for(const auto& soft : pulled.constraints.soft_positions) {
    hard.fixed_vertices.push_back(soft.vertex);
    targets.col(soft.vertex) = soft.target;
  }
  FFM::Map_minimizer<2> minimizer(pulled.domain, {}, hard);
  const FFM::Summary expected = minimizer.move_fixed_vertices(fixed, targets);
  BOOST_TEST(expected.is_valid());
  // The distances that remain change the energy to first order.
  BOOST_TEST(std::abs(summary.energy - summary.energy_of_terms - expected.energy) <= 1e-3 * expected.energy);
}

BOOST_AUTO_TEST_CASE(unreachable_tolerance_is_reported)
{
  Pulled pulled;
  FFM::Positions<2> x = pulled.start;
  double residual = -1;
  FFM::Weight_schedule schedule;
  schedule.tolerance = 1e-12;
  schedule.largest_factor = 100;
  const FFM::Summary summary = FFM::meet_soft_positions<2>(pulled.domain, x, pulled.constraints, residual, {}, schedule);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::unreachable_constraints));
  BOOST_TEST(residual > schedule.tolerance);
  BOOST_TEST((x.array() == pulled.start.array()).all());
}

BOOST_AUTO_TEST_CASE(bad_schedule_and_constraints_are_refused)
{
  Pulled pulled;
  FFM::Positions<2> x = pulled.start;
  double residual = -1;
  FFM::Weight_schedule schedule;
  schedule.factor = 1;
  BOOST_TEST(
    (FFM::meet_soft_positions<2>(pulled.domain, x, pulled.constraints, residual, {}, schedule).status == FFM::Status::invalid_option));
  pulled.constraints.soft_positions[0].weight = -1;
  BOOST_TEST((FFM::meet_soft_positions<2>(pulled.domain, x, pulled.constraints, residual).status == FFM::Status::invalid_option));
}

BOOST_AUTO_TEST_SUITE_END() // test_meet_soft_positions
