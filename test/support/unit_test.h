// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_UNIT_TEST_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_UNIT_TEST_H

// Boost.Test for the file of a test, whose cases are a suite with the name of the file: files share a program where they are compiled
// together.

#include <boost/test/unit_test.hpp>

#include <string>

namespace test_support {

// Says why a case cannot do here what it is for. Unless something fails, the program then ends with the code that ctest counts as
// skipped. Such cases have a label `needs_...`: those of one label are a test of their own.
void skip_case(const std::string& why);

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_UNIT_TEST_H
