// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The compiled library: the same bits as the headers alone give, for meshes and for arrays.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_map_traits.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_core)

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#error "This test is about the compiled library."
#endif

namespace FFM = CGAL::Flip_free_maps;

namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<int, 3>>;
using Uv = std::vector<std::array<double, 2>>;
using Corners = std::vector<std::array<std::array<double, 2>, 3>>;

// The default method under another name: the library does not know it, so it is compiled here.
struct Own_traits : FFM::Flip_free_map_traits<>
{};

// A bumpy sheet of n x n squares.
void make_sheet(int n, Points& points, Triangles& triangles)
{
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      points.push_back({double(i), double(j), 1.5 * std::sin(0.7 * i) * std::cos(0.5 * j)});
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      triangles.push_back({v, v + 1, v + n + 2});
      triangles.push_back({v, v + n + 2, v + n + 1});
    }
}

struct Sheet
{
  Points points;
  Triangles triangles;
  Uv uv;

  Sheet() { make_sheet(20, points, triangles); }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(default_method_has_the_bits_of_the_headers, Sheet)
{
  const FFM::Summary compiled = FFM::parameterize(points, triangles, uv);
  Uv own;
  const FFM::Summary headers = FFM::parameterize(points, triangles, own, FFM::parameters::map_traits(Own_traits()));
  BOOST_TEST(compiled.is_valid());
  BOOST_TEST(compiled.flips == 0);
  BOOST_TEST(compiled.iterations == headers.iterations);
  BOOST_TEST(compiled.iterations > 0);
  BOOST_TEST(compiled.energy == headers.energy);
  BOOST_TEST((uv == own));
  // Nothing is isometric here, so the energy is above its minimum.
  BOOST_TEST(compiled.energy > 1);
}

BOOST_FIXTURE_TEST_CASE(default_traits_are_the_default_method, Sheet)
{
  Uv with_traits;
  BOOST_TEST(FFM::parameterize(points, triangles, uv).is_valid());
  BOOST_TEST(FFM::parameterize(points, triangles, with_traits, FFM::parameters::map_traits(FFM::Flip_free_map_traits<>())).is_valid());
  BOOST_TEST((uv == with_traits));
}

// Traits that derive from those of the library are not taken for them, which would be another method.
BOOST_FIXTURE_TEST_CASE(derived_traits_keep_their_method, Sheet)
{
  const FFM::Splitting_map_traits<> splitting;
  const FFM::Summary summary = FFM::parameterize(points, triangles, uv, FFM::parameters::map_traits(splitting));
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(summary.preconditioner == "admm_splitting");
}

BOOST_FIXTURE_TEST_CASE(methods_chosen_at_run_time, Sheet)
{
  FFM::Any_map_traits traits;
  BOOST_TEST(traits.use_method("cm"));
  Uv bijective;
  const FFM::Summary summary = FFM::parameterize(points, triangles, uv, FFM::parameters::map_traits(traits));
  BOOST_TEST(summary.is_valid());
  const FFM::Summary whole =
    FFM::parameterize(points, triangles, bijective, FFM::parameters::map_traits(traits, FFM::parameters::bijective(true)));
  BOOST_TEST(whole.is_valid());
  BOOST_TEST(whole.is_bijective.value_or(false));
  // A sheet that is nearly flat does not overlap itself, and then both are the same map.
  BOOST_TEST((uv == bijective));
}

BOOST_FIXTURE_TEST_CASE(options_as_named_parameters, Sheet)
{
  FFM::Map_options options;
  options.max_iterations = 1;
  const FFM::Summary summary = FFM::parameterize(points, triangles, uv, FFM::parameters::map_options(options));
  BOOST_TEST(summary.iterations == 1);
  BOOST_TEST((summary.status == FFM::Status::iteration_limit));
}

BOOST_AUTO_TEST_CASE(atlas_of_arrays)
{
  // A tetrahedron: without distortion its faces lie in the plane with edges of one length.
  const Points points{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const Triangles triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  Corners corners;
  const FFM::Unwrap_summary summary = FFM::unwrap(points, triangles, corners);
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(corners.size() == triangles.size());
  for(const auto& c : corners) {
    const auto length = [&](int i, int j) { return std::hypot(c[i][0] - c[j][0], c[i][1] - c[j][1]); };
    BOOST_TEST(length(0, 1) == length(1, 2), boost::test_tools::tolerance(1e-6));
    BOOST_TEST(length(0, 1) == length(2, 0), boost::test_tools::tolerance(1e-6));
    const double doubled_area = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    BOOST_TEST(doubled_area > 0);
  }
}

BOOST_FIXTURE_TEST_CASE(bad_arrays_are_refused, Sheet)
{
  const Uv before{{1., 2.}};
  uv = before;
  Corners corners;
  Triangles bad = triangles;
  bad[5][1] = static_cast<int>(points.size());
  BOOST_TEST((FFM::parameterize(points, bad, uv).status == FFM::Status::invalid_option));
  BOOST_TEST((FFM::unwrap(points, bad, corners).status == FFM::Status::invalid_option));
  bad[5][1] = -1;
  BOOST_TEST((FFM::parameterize(points, bad, uv).status == FFM::Status::invalid_option));
  BOOST_TEST((FFM::parameterize(points, Triangles(), uv).status == FFM::Status::empty_mesh));
  points[7][2] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((FFM::parameterize(points, triangles, uv).status == FFM::Status::non_finite_input));
  BOOST_TEST((FFM::unwrap(points, triangles, corners).status == FFM::Status::non_finite_input));
  BOOST_TEST((uv == before));
  BOOST_TEST(corners.empty());
}

BOOST_AUTO_TEST_SUITE_END() // test_core
