// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces that can be flattened without distortion: how they are told from others, and what the default method makes of them.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/energies/Conformal.h>
#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_developable)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::internal::total_curvature;
using Traits = FFM::Flip_free_map_traits<>;

namespace {

// A ribbon of nearly three turns around its axis, at a growing distance from it.
Surface spiral_ribbon(int columns, int rows)
{
  return grid(columns, rows, [](double u, double v) {
    const double angle = 5.7 * pi * u, radius = 0.5 + 0.12 * angle;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.8 * v);
  });
}

// Inscribed to the unit sphere around its pole, as far as an angle of latitude: `rings` circles of `around` vertices.
Surface spherical_cap(double angle, int rings, int around)
{
  Surface surface;
  surface.points.push_back({0, 0, 1});
  for(int r = 1; r <= rings; ++r)
    for(int i = 0; i < around; ++i) {
      const double latitude = angle * r / rings, longitude = 2 * pi * (i + 0.5 * (r % 2)) / around;
      surface.points.push_back({std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude)});
    }
  for(int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    surface.triangles.push_back({0, 1 + i, 1 + next});
    for(int r = 0; r + 1 < rings; ++r) {
      const int a = 1 + around * r + i, b = 1 + around * r + next, c = a + around, d = b + around;
      // Every other circle is turned by half a step.
      if(r % 2 == 0) {
        surface.triangles.push_back({a, d, b});
        surface.triangles.push_back({a, c, d});
      } else {
        surface.triangles.push_back({a, c, b});
        surface.triangles.push_back({b, c, d});
      }
    }
  }
  return surface;
}

double cap_curvature(double angle) { return 2 * pi * (1 - std::cos(angle)); }

struct Flat
{
  FFM::Summary summary;
  double largest_error = 0; // of the length of an edge, relative
};

Flat flattened(const Surface& surface, const Traits& traits = Traits())
{
  Soup soup;
  for(const auto& p : surface.points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& t : surface.triangles)
    soup.triangles.push_back({t[0], t[1], t[2]});
  Plain_mesh mesh;
  add_soup(soup, mesh);
  auto uv = mesh.add_property_map<Plain_mesh::Vertex_index, Plain_point_2>("v:uv").first;
  Flat flat;
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h)) {
      flat.summary = FFM::parameterize(mesh, h, uv, traits);
      break;
    }
  BOOST_TEST_MESSAGE(flat.summary);
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  for(const auto e : mesh.edges()) {
    const auto v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    const double rest = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
    const double image = std::sqrt(CGAL::squared_distance(uv[v], uv[w]));
    flat.largest_error = (std::max)(flat.largest_error, std::abs(image / rest - 1));
  }
  return flat;
}

bool adapts(const Surface& surface)
{
  Traits traits;
  FFM::internal::adapt_to_developable(make_domain(surface), traits);
  return traits.preconditioner.uses_killing;
}

const std::vector<std::pair<std::string, Surface>>& developable_surfaces()
{
  static const std::vector<std::pair<std::string, Surface>> all{{"cylinder", cylinder_patch(40, 12)},
                                                                {"cone", cone_patch(36, 14)},
                                                                {"bent sheet", bent_sheet(30, 17)},
                                                                {"spiral ribbon", spiral_ribbon(150, 6)}};
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(developable_surfaces_have_no_curvature)
{
  for(const auto& surface : developable_surfaces())
    BOOST_TEST_CONTEXT(surface.first)
    {
      BOOST_TEST(total_curvature(make_domain(surface.second)) <= 1e-10);
      BOOST_TEST(adapts(surface.second));
    }
}

// An inner vertex stands for the sphere as far as half a ring away from it, so the last half ring is missing.
BOOST_AUTO_TEST_CASE(curvature_of_a_spherical_cap)
{
  for(double angle : {0.4, 1., 2.5})
    BOOST_TEST_CONTEXT("angle " << angle)
    {
      double previous = 0;
      for(int rings : {10, 20, 40}) {
        const double curvature = total_curvature(make_domain(spherical_cap(angle, rings, 3 * rings)));
        BOOST_TEST(curvature < cap_curvature(angle));
        BOOST_TEST(curvature > cap_curvature(angle - angle / rings));
        const double error = std::abs(curvature - cap_curvature(angle - 0.5 * angle / rings));
        BOOST_TEST(error <= 2. / (rings * rings) * cap_curvature(angle));
        if(previous > 0)
          BOOST_TEST(error <= 0.3 * previous);
        previous = error;
      }
    }
}

// Negative curvature does not cancel positive one, and neither does it count with its sign.
BOOST_AUTO_TEST_CASE(curvature_of_a_saddle)
{
  const int size = 40, samples = 400;
  const double a = 0.7;
  const double curvature = total_curvature(make_domain(grid(size, size, [a](double u, double v) {
    return Eigen::Vector3d(u - 0.5, v - 0.5, a * ((u - 0.5) * (u - 0.5) - (v - 0.5) * (v - 0.5)));
  })));
  // The integral of |K| over the square less half a cell at the border.
  const double extent = 1 - 1. / size;
  double integral = 0;
  for(int i = 0; i < samples; ++i)
    for(int j = 0; j < samples; ++j) {
      const double x = extent * ((i + 0.5) / samples - 0.5), y = extent * ((j + 0.5) / samples - 0.5);
      integral += 4 * a * a * std::pow(1 + 4 * a * a * (x * x + y * y), -1.5) * extent * extent / (samples * samples);
    }
  BOOST_TEST(curvature == integral, boost::test_tools::tolerance(2e-4));
}

BOOST_AUTO_TEST_CASE(default_method_is_adapted_to_developable_surfaces_only)
{
  BOOST_TEST(adapts(spherical_cap(15 * pi / 180, 12, 36)));
  BOOST_TEST(!adapts(spherical_cap(20 * pi / 180, 12, 36)));
  BOOST_TEST(!adapts(bumpy_patch(20, 15)));

  BOOST_TEST(FFM::internal::favours_isometries(FFM::Symmetric_dirichlet()));
  BOOST_TEST(!FFM::internal::favours_isometries(FFM::Conformal()));
  BOOST_TEST(FFM::internal::Is_adaptive<Traits>::value);
  BOOST_TEST((!FFM::internal::Is_adaptive<FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Slim>>::value));
}

// Without the isometry to begin with the Killing operator finds it.
BOOST_AUTO_TEST_CASE(developable_surfaces_from_coarse_to_fine)
{
  for(const auto& surface : developable_surfaces())
    BOOST_TEST_CONTEXT(surface.first)
    {
      const FFM::Simplicial_domain<2> domain = make_domain(surface.second);
      Traits traits;
      FFM::internal::adapt_to_developable(domain, traits);
      traits.start.unfold = false;
      FFM::Positions<2> x;
      std::string name, message;
      BOOST_TEST_REQUIRE((FFM::internal::make_start(domain, traits, x, name, message) == FFM::Status::success));
      BOOST_TEST(name.find("multilevel") != std::string::npos);
      const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
      BOOST_TEST(FFM::status_name(summary.status) == "success");
      BOOST_TEST(summary.iterations <= 6);
      BOOST_TEST(summary.factorizations == summary.iterations);
      BOOST_TEST(std::abs(summary.energy - 1) <= 1e-8);
    }
}

// The triangles around the pole of a cap close but for its curvature.
BOOST_AUTO_TEST_CASE(unfolding_stands_in_for_a_start_only_where_nothing_flips)
{
  for(double angle : {0.2, 0.9, 2.5}) {
    const FFM::Simplicial_domain<2> domain = make_domain(spherical_cap(angle, 12, 36));
    FFM::Positions<2> x;
    FFM::internal::unfold_developable(domain, x);
    const bool usable = FFM::internal::is_unfolded<FFM::Flip_free_map_traits<>>(domain, x);
    Traits traits;
    traits.start.unfold = true;
    std::string name, message;
    BOOST_TEST_REQUIRE((FFM::internal::make_start(domain, traits, x, name, message) == FFM::Status::success));
    BOOST_TEST((name == "unfolded") == usable);
    BOOST_TEST(usable == (angle < 0.5));
    for(const auto& element : domain.elements)
      BOOST_TEST(FFM::internal::is_positively_oriented<Traits::Kernel>(element, x));
  }
}

BOOST_AUTO_TEST_CASE(developable_surfaces_are_unrolled_at_once)
{
  for(const auto& surface : developable_surfaces())
    BOOST_TEST_CONTEXT(surface.first)
    {
      const Traits traits;
      const Flat flat = flattened(surface.second, traits);
      BOOST_TEST(FFM::status_name(flat.summary.status) == "success");
      BOOST_TEST(flat.summary.iterations == 0);
      // Nothing is analysed for a start that is the solution.
      BOOST_TEST(flat.summary.factorizations == 0);
      BOOST_TEST(flat.summary.seconds.analyze == 0);
      BOOST_TEST(flat.summary.linear_solves == 0);
      BOOST_TEST(std::abs(flat.summary.energy - 1) <= 1e-12);
      BOOST_TEST(flat.largest_error <= 1e-9);
      BOOST_TEST(flat.summary.start == "unfolded");
      BOOST_TEST(!traits.preconditioner.uses_killing);
    }
}

BOOST_AUTO_TEST_SUITE_END() // test_developable
