// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The framework of Boost.Test, compiled once for all tests: in each of them it would take longer than most.

#define BOOST_TEST_MODULE Flip_free_maps
#define BOOST_TEST_NO_MAIN
#include <boost/test/included/unit_test.hpp>

#include <iostream>
#include <string>

namespace {

bool has_skipped = false;

} // namespace

namespace test_support {

void skip_case(const std::string& why)
{
  std::cout << "Skipped: " << why << std::endl;
  has_skipped = true;
}

} // namespace test_support

int main(int argc, char* argv[])
{
  const int code = boost::unit_test::unit_test_main(&init_unit_test_suite, argc, argv);
  return code == 0 && has_skipped ? 77 : code;
}
