// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps of long closed tubes in polar coordinates. On a tube of circumference c and length l, at the distance t from its tip, the
// terms of the symmetric Dirichlet energy that matter are (k^2 r^2 + 1 / r'^2) / 4, k = 2 pi / c. The first integral of Euler's
// equation is k^2 r^2 + 3 / r'^2 = k^2 r(l)^2, whence r(l)^2 = 4 sqrt(3) l / (pi k), and the mean energy is sqrt(3) l / c.
// The other terms are positive.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/initializers/Multilevel_initializer.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polar_map)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Traits = FFM::Flip_free_map_traits<>;

namespace {

std::vector<double> equal_depths(int number)
{
  std::vector<double> depths;
  for(int i = 0; i <= number; ++i)
    depths.push_back(static_cast<double>(i) / number);
  return depths;
}

// The mean energy, infinite if a triangle is flipped.
double energy_of(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  double sum = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Matrix2d J = domain.jacobian(e, x);
    sum += J.determinant() > 0 ? domain.measures[e] * 0.25 * (J.squaredNorm() + J.inverse().squaredNorm()) : INFINITY;
  }
  return sum;
}

struct Polar
{
  explicit Polar(const FFM::Simplicial_domain<2>& domain) : map(domain)
  {
    const Traits traits;
    is_built = map.build([&] { return traits.make_linear_solver(); });
    if(is_built)
      map.place(x);
  }

  FFM::internal::Polar_map map;
  bool is_built = false;
  FFM::Positions<2> x;
};

} // namespace

BOOST_AUTO_TEST_CASE(profile_of_a_flat_disk_is_an_isometry)
{
  constexpr int n = 200;
  FFM::internal::Radial_profile profile;
  profile.set_knots(equal_depths(n), n);
  for(int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n, area = 2 * t / n;
    profile.add_radial(t, area, 4);
    profile.add_tangential(t, area, 1 / (t * t) * 4);
  }
  profile.optimize();
  BOOST_TEST(profile.energy() == 1, boost::test_tools::tolerance(1e-6));
  for(double t : {0.25, 0.5, 1.})
    BOOST_TEST(profile.radius(t) == 0.5 * t, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(profile_of_a_tube_is_that_of_eulers_equation)
{
  constexpr int n = 2000;
  const double length = 100, k = 2 * pi;
  FFM::internal::Radial_profile profile;
  profile.set_knots(equal_depths(n), n);
  for(int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n;
    profile.add_radial(t, 1. / n, 1 / (length * length));
    if(i >= n / 100) // the tip is no tube
      profile.add_tangential(t, 1. / n, k * k);
  }
  profile.optimize();
  BOOST_TEST(profile.energy() == std::sqrt(3.) * length, boost::test_tools::tolerance(5e-3));
  BOOST_TEST(profile.radius(1) == std::sqrt(4 * std::sqrt(3.) * length / (pi * k)), boost::test_tools::tolerance(2e-2));
}

BOOST_AUTO_TEST_CASE(radii_grow_as_asked)
{
  constexpr int n = 100;
  FFM::internal::Radial_profile profile;
  profile.set_knots(equal_depths(n), n);
  for(int i = 0; i < n; ++i) {
    profile.add_radial((i + 0.5) / n, 1. / n, 1);
    profile.add_tangential((i + 0.5) / n, 1. / n, 4);
  }
  profile.add_growth(0.5, 0.7, 8);
  profile.optimize();
  BOOST_TEST(std::log(profile.radius(0.7) / profile.radius(0.5)) >= 0.2 * 8);
  BOOST_TEST(std::log(profile.radius(1) / profile.radius(0.8)) < 0.2 * 8);
}

BOOST_AUTO_TEST_CASE(tubes_have_the_energy_of_concentric_circles)
{
  for(int around : {12, 24}) {
    const int rings = 15 * around;
    const auto domain = make_domain(closed_tube(around, rings));
    const Polar polar(domain);
    BOOST_REQUIRE(polar.is_built);
    const double least = std::sqrt(3.) * rings / around;
    BOOST_TEST(polar.map.energy() >= least);
    BOOST_TEST(polar.map.energy() <= 1.05 * least);
    BOOST_TEST(energy_of(domain, polar.x) <= 1.4 * least);
  }
}

BOOST_AUTO_TEST_CASE(no_triangle_is_flipped_where_vertices_are_not_aligned)
{
  Random random(5);
  Surface surface = closed_tube(20, 240);
  const double radius = surface.points[0].head<2>().norm();
  for(std::size_t v = 20; v + 1 < surface.points.size(); ++v) {
    const double angle = std::atan2(surface.points[v][1], surface.points[v][0]) + 2 * pi / 20 * random(-0.2, 0.2);
    surface.points[v] << radius * std::cos(angle), radius * std::sin(angle), surface.points[v][2] + random(-0.2, 0.2);
  }
  const auto domain = make_domain(surface);
  const Polar polar(domain);
  BOOST_REQUIRE(polar.is_built);
  BOOST_TEST(polar.map.energy() <= 1.05 * std::sqrt(3.) * 12);
  BOOST_TEST(std::isfinite(energy_of(domain, polar.x)));
}

BOOST_AUTO_TEST_CASE(long_tubes_begin_as_circles_and_others_do_not)
{
  Traits traits;
  FFM::Positions<2> x;
  std::string name, message;
  const auto tube = make_domain(closed_tube(12, 360));
  BOOST_REQUIRE(FFM::Multilevel_initializer<Traits>(traits)(tube, x, name, message) == FFM::Status::success);
  BOOST_TEST(name.find("polar") == 0u);

  traits.options.relative_energy_tolerance = 1e-4;
  traits.options.max_iterations = 100;
  const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(tube, traits).minimize(x);
  BOOST_TEST((summary.status == FFM::Status::success));
  BOOST_TEST(energy_of(tube, x) <= 1.05 * std::sqrt(3.) * 30);

  BOOST_REQUIRE(FFM::Multilevel_initializer<Traits>(traits)(make_domain(bumpy_patch(40, 30)), x, name, message) == FFM::Status::success);
  BOOST_TEST(name.find("multilevel") == 0u);
}

BOOST_AUTO_TEST_SUITE_END() // test_polar_map
