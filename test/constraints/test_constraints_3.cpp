// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Fixed vertices, soft positions and terms of users in space.

#include "support/unit_test.h"

#include "support/constraint_checks.h"

#include <limits>

BOOST_AUTO_TEST_SUITE(test_constraints_3)

using namespace test_support;

BOOST_AUTO_TEST_CASE(optima) { check_all_optima<3>(); }

BOOST_AUTO_TEST_CASE(invalid_constraints)
{
  check_message<3>({{0, 1000}, {}}, "fixed vertex has the number 1000");
  check_message<3>({{}, {{3, Eigen::Vector3d(0, 0, std::numeric_limits<double>::infinity()), 1}}},
                   "number 0, of vertex number 3, is not finite");
}

BOOST_AUTO_TEST_SUITE_END() // test_constraints_3
