// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The map does not depend on the number of threads, not by one bit.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstring>

BOOST_AUTO_TEST_SUITE(test_minimizer_threads)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Tag>
using Traits =
  FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, Tag>;

template <int D, typename Tag>
FFM::Summary minimize(const FFM::Simplicial_domain<D>& domain, FFM::Positions<D>& x, int iterations)
{
  Traits<Tag> traits;
  traits.options.max_iterations = iterations;
  return FFM::Map_minimizer<D, Traits<Tag>>(domain, traits).minimize(x);
}

template <int D>
void check(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& start, int iterations = 8)
{
  FFM::Positions<D> expected = start;
  const FFM::Summary sequential = minimize<D, CGAL::Sequential_tag>(domain, expected, iterations);
  BOOST_TEST_REQUIRE(sequential.is_valid());
  BOOST_TEST(sequential.iterations >= (std::min)(3, iterations));
#ifdef CGAL_LINKED_WITH_TBB
  for(int threads : {1, 2, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    FFM::Positions<D> x = start;
    const FFM::Summary parallel = minimize<D, CGAL::Parallel_tag>(domain, x, iterations);
    BOOST_TEST(parallel.energy == sequential.energy);
    BOOST_TEST(parallel.energy_evaluations == sequential.energy_evaluations);
    BOOST_TEST(std::memcmp(x.data(), expected.data(), x.size() * sizeof(double)) == 0);
  }
#else
  test_support::skip_case("built without oneTBB: there is one thread only");
#endif
}

} // namespace

BOOST_AUTO_TEST_CASE(plane, *boost::unit_test::label("needs_tbb"))
{
  const auto domain = make_domain(bumpy_patch(60, 50));
  check<2>(domain, tutte_start(domain));
}

BOOST_AUTO_TEST_CASE(space, *boost::unit_test::label("needs_tbb"))
{
  const Distorted_example<3> example(8, 6, 5);
  check<3>(example.domain, example.x);
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
// Large enough for a factorization in two parts.
BOOST_AUTO_TEST_CASE(factorization_in_two_parts, *boost::unit_test::label("needs_tbb"))
{
  const Distorted_example<3> example(16, 12, 12);
  FFM::Block_sparse_matrix pattern;
  pattern.build_pattern(example.domain.number_of_vertices, 3, example.domain.elements);
  FFM::Cholmod_solver solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(pattern));
  BOOST_TEST_REQUIRE(solver.is_split());
  check<3>(example.domain, example.x, 2);
}
#endif

// A distorted bar goes back to its rest shape: the only minimum in space that is known beforehand.
BOOST_AUTO_TEST_CASE(bar_returns_to_its_rest_shape)
{
  const Distorted_example<3> example(4, 2, 2);
  FFM::Positions<3> x = example.x;
  Traits<CGAL::Sequential_tag> traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  const FFM::Summary summary = FFM::Map_minimizer<3, Traits<CGAL::Sequential_tag>>(example.domain, traits).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.energy_initial > 1.05);
  BOOST_TEST(summary.energy - 1 <= 1e-10);
  BOOST_TEST(symmetric_dirichlet<3>(example.domain, x) - 1 <= 1e-10);
}

BOOST_AUTO_TEST_SUITE_END() // test_minimizer_threads
