// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_FIXTURE_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_FIXTURE_H

// A start, and what must hold of it after a run that ended well or badly. To be included after Boost.Test.

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <limits>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

template <typename Energy = CGAL::Default, typename Preconditioner = CGAL::Default, typename Solver = CGAL::Default>
using Varied_traits = FFM::Flip_free_map_traits<CGAL::Default, Energy, Preconditioner, CGAL::Default, Solver>;

struct Fixture
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  FFM::Positions<2> start = tutte_start(domain);
  FFM::Positions<2> x = start;

  template <typename T = Varied_traits<>>
  FFM::Summary run(const FFM::Map_options& options = FFM::Map_options())
  {
    T traits;
    traits.options = options;
    x = start;
    return FFM::Map_minimizer<2, T>(domain, traits).minimize(x);
  }

  static FFM::Map_options no_rules()
  {
    FFM::Map_options options;
    options.characteristic_gradient_tolerance = 0;
    return options;
  }

  void check_valid(const FFM::Summary& summary, FFM::Status status)
  {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(number_of_flips(domain, x) == 0);
    BOOST_TEST(std::abs(summary.energy - symmetric_dirichlet<2>(domain, x)) <= 1e-11 * summary.energy);
  }

  void check_failed(const FFM::Summary& summary, FFM::Status status)
  {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST(!summary.is_valid());
    BOOST_TEST(!summary.message.empty());
    BOOST_TEST((x.array() == start.array() || (x.array().isNaN() && start.array().isNaN())).all());
  }
};

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MINIMIZER_FIXTURE_H
