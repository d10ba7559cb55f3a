// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What unwrap() does about charts that overlap themselves: surfaces whose maps are known do so in known places.

#include "support/unit_test.h"

#include "atlas/atlas_checks.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_unwrap_overlaps)

using namespace test_support;
using FFM::Status;

// No splits but those of overlaps.
static FFM::Unwrap_options plain_options()
{
  FFM::Unwrap_options options;
  options.max_length = std::numeric_limits<double>::infinity();
  options.min_occupancy = 0;
  return options;
}

// A flat band along a curve with loops, each of which crosses itself once. Its map is an isometry, whatever is done.
static Soup looping_band_soup(int loops)
{
  Soup soup;
  const int steps = 60 * loops, across = 2;
  const double width = 0.4;
  for(int i = 0; i <= steps; ++i) {
    // A prolate cycloid; loops are where it runs back.
    const double t = CGAL_PI + 2 * CGAL_PI * i / 60;
    const Mesh::Point p(t - 4 * std::sin(t), -4 * std::cos(t), 0);
    CGAL::Simple_cartesian<double>::Vector_3 along(1 - 4 * std::cos(t), 4 * std::sin(t), 0);
    along = along / std::sqrt(along.squared_length());
    for(int k = 0; k <= across; ++k) {
      const double s = width * (1. * k / across - 0.5);
      soup.points.emplace_back(p.x() - s * along.y(), p.y() + s * along.x(), 0);
    }
  }
  for(int i = 0; i < steps; ++i)
    for(int k = 0; k < across; ++k) {
      const int a = (across + 1) * i + k, b = a + across + 1;
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  return soup;
}

BOOST_AUTO_TEST_CASE(all_crossings_are_parted_in_one_round)
{
  for(const int loops : {1, 3, 8}) {
    Atlas_surface band(looping_band_soup(loops));
    const FFM::Unwrap_summary summary = band.unwrap(plain_options());
    BOOST_TEST_CONTEXT(loops << " loops")
    {
      check_atlas(band, summary);
      BOOST_TEST(std::abs(summary.energy - 1) <= 1e-6);
      BOOST_TEST(summary.splits_of_overlaps == 1);
      BOOST_TEST(summary.charts.size() >= 2u);
      BOOST_TEST(static_cast<int>(summary.charts.size()) <= loops + 1);
    }
  }
}

// A saddle, cut by the user from its border to its centre: its sides come to lie over each other.
static void cut_saddle(int n, Atlas_surface& saddle)
{
  const int row = n + 1;
  const std::vector<Mesh::Vertex_index> vertices(saddle.mesh.vertices().begin(), saddle.mesh.vertices().end());
  for(int i = 0; i < n / 2; ++i) {
    const auto h = saddle.mesh.halfedge(vertices[row * (n / 2) + i], vertices[row * (n / 2) + i + 1]);
    saddle.user[saddle.mesh.edge(h)] = true;
  }
}

static Soup saddle_soup(int n, double height)
{
  Soup soup;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i) {
      const double x = 2. * i / n - 1, y = 2. * j / n - 1;
      soup.points.emplace_back(x, y, height * (x * x - y * y));
    }
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

BOOST_AUTO_TEST_CASE(sides_of_a_seam_are_led_apart)
{
  for(const double height : {0.1, 0.2, 0.25}) {
    Atlas_surface saddle(saddle_soup(20, height));
    cut_saddle(20, saddle);
    const FFM::Unwrap_summary summary = saddle.unwrap(plain_options());
    BOOST_TEST_CONTEXT("height " << height)
    {
      check_atlas(saddle, summary);
      BOOST_TEST(summary.seam_edges == 10);
      BOOST_TEST(summary.charts.size() == 1u);
      BOOST_TEST(summary.splits_of_overlaps == 0);
      BOOST_TEST(summary.energy <= 1.025);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_limit_for_each_chart_does_not_end_late_ones)
{
  Atlas_surface late(together(plate_soup(5), ball_soup()));
  FFM::Unwrap_options options;
  options.max_seconds = 0;
  FFM::Flip_free_map_traits<> traits;
  traits.options.max_seconds = 0;
  const FFM::Unwrap_summary summary = late.unwrap(options, traits);
  check_atlas(late, summary);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::time_limit));
  BOOST_TEST(summary.energy < 2);
}

// A seam of one edge whose ends are inside has the same vertices on both sides.
BOOST_AUTO_TEST_CASE(seams_of_one_edge)
{
  for(const bool is_closed : {false, true}) {
    Soup soup = is_closed ? ball_soup() : saddle_soup(8, 0);
    Atlas_surface surface(soup);
    const std::vector<Mesh::Edge_index> edges(surface.mesh.edges().begin(), surface.mesh.edges().end());
    for(std::size_t i = 0; i < edges.size(); i += edges.size() / 3) {
      const auto h = surface.mesh.halfedge(edges[i]);
      surface.user[edges[i]] = !surface.mesh.is_border(surface.mesh.source(h)) && !surface.mesh.is_border(surface.mesh.target(h));
    }
    for(const double bound : {1.025, std::numeric_limits<double>::infinity()}) {
      FFM::Unwrap_options options = plain_options();
      options.max_distortion = bound;
      const FFM::Unwrap_summary summary = surface.unwrap(options);
      BOOST_TEST_CONTEXT((is_closed ? "closed" : "open") << ", bound " << bound)
      {
        check_atlas(surface, summary);
        if(!is_closed) {
          BOOST_TEST(std::abs(summary.energy - 1) <= 1e-6);
          BOOST_TEST(summary.charts.size() == 1u);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_unwrap_overlaps
