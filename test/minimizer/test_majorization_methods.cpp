// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Minima that are known, reached with composite majorization.

#include "support/unit_test.h"

#include "support/minimizer_checks.h"

#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>

#include <tuple>

BOOST_AUTO_TEST_SUITE(test_majorization_methods)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef std::tuple<Method_traits<FFM::Composite_majorization<true>>, Method_traits<FFM::Composite_majorization<false>>> Methods;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(developable_surfaces_become_isometric, Method, Methods) { check_developable_surfaces<Method>(); }

BOOST_AUTO_TEST_CASE_TEMPLATE(all_methods_end_at_the_same_energy, Method, Methods) { check_bumpy_patch<Method>(); }

BOOST_AUTO_TEST_SUITE_END() // test_majorization_methods
