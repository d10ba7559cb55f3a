// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The splitting against the Newton minimizer in space, from a start with flips, with fixed vertices.

#include "support/unit_test.h"

#include "support/splitting_checks.h"

#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>

#include <cstdint>

BOOST_AUTO_TEST_SUITE(test_splitting_in_space)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Energy>
using Traits = FFM::Flip_free_map_traits<CGAL::Default, Energy>;

} // namespace

BOOST_AUTO_TEST_CASE(same_energy_in_space)
{
  // Without constraints the optimum in space is the rest shape; the boundary is held in a distorted one.
  const Distorted_example<3> example(4, 3, 3);
  const FFM::Positions<3> flipped = shaken<3>(example.x, 0.3, 3);
  BOOST_TEST_REQUIRE(negative_elements(example.domain, flipped) > 10);
  FFM::Position_constraints<3> constraints;
  for(std::int32_t v = 0; v < example.domain.number_of_vertices; v += 4)
    constraints.fixed_vertices.push_back(v);
  FFM::Positions<3> start = flipped;
  for(std::int32_t v : constraints.fixed_vertices)
    start.col(v) = example.x.col(v);

  FFM::Positions<3> expected = example.x;
  const Traits<FFM::Symmetric_gradient> traits;
  const FFM::Summary newton =
    FFM::Map_minimizer<3, Traits<FFM::Symmetric_gradient>>(example.domain, traits, constraints).minimize(expected);
  BOOST_TEST_REQUIRE(newton.converged());
  FFM::Positions<3> x = start;
  const FFM::Summary splitting =
    FFM::Splitting_minimizer<3, Traits<FFM::Symmetric_gradient>>(example.domain, traits, constraints).minimize(x);
  BOOST_TEST(splitting.converged());
  BOOST_TEST(negative_elements(example.domain, x) == 0);
  BOOST_TEST(splitting.energy == newton.energy, boost::test_tools::tolerance(1e-4));
  for(std::int32_t v : constraints.fixed_vertices)
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
}

BOOST_AUTO_TEST_SUITE_END() // test_splitting_in_space
