// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A user's own mesh class.

#include "support/unit_test.h"

#include "support/Own_mesh.h"
#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/io.h>

#include <array>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_own_mesh)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

using Point = std::array<double, 2>;

struct UV
{
  using key_type = own::Vertex;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::read_write_property_map_tag;
  std::vector<Point>* points;

  friend const Point& get(const UV& map, own::Vertex v) { return (*map.points)[v.i]; }
  friend void put(const UV& map, own::Vertex v, const Point& p) { (*map.points)[v.i] = p; }
};

} // namespace

BOOST_AUTO_TEST_CASE(own_arrays)
{
  const Soup soup = bumpy_soup();
  const Plain_result plain = plain_result(soup);
  const own::Mesh mesh(soup.points, soup.triangles);
  std::vector<Point> points(soup.points.size());
  const UV uv{&points};
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  check_map(mesh, uv, summary, plain.summary.energy);

  const FFM::Textured_mesh textured = FFM::textured_mesh(mesh, uv);
  BOOST_TEST(textured.triangles.size() == soup.triangles.size());
  BOOST_TEST(std::abs(FFM::measure_distortion(textured).energy - plain.summary.energy) <= 1e-9);
}

BOOST_AUTO_TEST_CASE(same_walk_same_bits)
{
  // Numbers of vertices do not matter, only the order in which faces name their corners.
  const Soup soup = bumpy_soup();
  const own::Mesh mesh(soup.points, soup.triangles);
  std::vector<Point> points(soup.points.size()), again(soup.points.size());
  FFM::parameterize(mesh, corner_halfedge(mesh), UV{&points}, tight_traits());
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), UV{&again}, tight_traits());
  BOOST_TEST(summary.converged());
  BOOST_TEST((points == again));

  const int n = static_cast<int>(soup.points.size());
  Soup mirrored = soup;
  for(int v = 0; v < n; ++v)
    mirrored.points[n - 1 - v] = soup.points[v];
  for(auto& t : mirrored.triangles)
    for(int& v : t)
      v = n - 1 - v;
  const own::Mesh other(mirrored.points, mirrored.triangles);
  std::vector<Point> other_points(n);
  BOOST_TEST(FFM::parameterize(other, corner_halfedge(other), UV{&other_points}, tight_traits()).converged());
  for(int v = 0; v < n; ++v)
    BOOST_TEST((other_points[n - 1 - v] == points[v]));
}

BOOST_AUTO_TEST_CASE(failures_leave_the_map_untouched)
{
  Soup soup = bumpy_soup(4, 4);
  soup.points[7][1] = std::numeric_limits<double>::infinity();
  const own::Mesh mesh(soup.points, soup.triangles);
  const std::vector<Point> before(soup.points.size(), Point{7, -7});
  std::vector<Point> points = before;
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), UV{&points});
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::non_finite_input));
  BOOST_TEST((points == before));
}

BOOST_AUTO_TEST_SUITE_END() // test_own_mesh
