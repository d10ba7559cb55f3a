// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Cells of CGAL's triangulations give the same domain as the arrays that they were made from.

#include "support/unit_test.h"

#include "support/volume_checks.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/domains/Triangulation_3_domain.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_triangulation_3_domain)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;

// Points without symmetries, so that no cell of their Delaunay triangulation is a sliver.
std::vector<Point> cloud()
{
  Random random(3);
  std::vector<Point> points;
  for(int i = 0; i < 60; ++i)
    points.emplace_back(random(10, 14), random(-5, -2), random(0, 3));
  return points;
}

// The cells of a triangulation as arrays, numbered independently of the class that is tested.
template <typename Triangulation, typename Predicate, typename PointOf>
Fingerprint expected(const Triangulation& triangulation, const Predicate& is_selected, const PointOf& point_of)
{
  std::map<typename Triangulation::Vertex_handle, int> numbers;
  FFM::Tetrahedral_mesh mesh;
  for(auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    numbers[v] = static_cast<int>(mesh.points.size());
    const Point p = point_of(v);
    mesh.points.push_back({{p.x(), p.y(), p.z()}});
  }
  for(auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
    if(is_selected(c))
      mesh.tetrahedra.push_back({{numbers[c->vertex(0)], numbers[c->vertex(1)], numbers[c->vertex(2)], numbers[c->vertex(3)]}});
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  return Fingerprint::of(domain);
}

} // namespace

BOOST_AUTO_TEST_CASE(delaunay_triangulation)
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
  const std::vector<Point> points = cloud();
  const Triangulation triangulation(points.begin(), points.end());
  FFM::Triangulation_3_domain<Triangulation> domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(triangulation, message) == Status::success), message);
  BOOST_TEST(domain.domain().number_of_elements() == triangulation.number_of_finite_cells());
  const auto point_of = [](Triangulation::Vertex_handle v) { return v->point(); };
  const Fingerprint all = expected(
    triangulation, [](Triangulation::Cell_handle) { return true; }, point_of);
  BOOST_TEST(Fingerprint::of(domain).distance(all) < 1e-11);

  // Only cells of one half.
  const auto is_selected = [](Triangulation::Cell_handle c) { return c->vertex(0)->point().x() + c->vertex(1)->point().x() < 25; };
  BOOST_TEST_REQUIRE((domain.load(triangulation, is_selected, message) == Status::success), message);
  BOOST_TEST(domain.domain().number_of_elements() < triangulation.number_of_finite_cells());
  BOOST_TEST(Fingerprint::of(domain).distance(expected(triangulation, is_selected, point_of)) < 1e-11);
  BOOST_TEST((domain.load(
                triangulation, [](Triangulation::Cell_handle) { return false; }, message) == Status::empty_mesh));
}

BOOST_AUTO_TEST_CASE(results_are_keyed_by_handles_and_leave_the_triangulation_alone)
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
  const std::vector<Point> points = cloud();
  const Triangulation triangulation(points.begin(), points.end());
  FFM::Triangulation_3_domain<Triangulation> domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(triangulation, message) == Status::success), message);
  FFM::Positions<3> x = 2 * domain.domain().rest_points;

  std::unordered_map<Triangulation::Vertex_handle, Point> result;
  BOOST_TEST((domain.write_back(x, boost::make_assoc_property_map(result), message) == Status::success));
  BOOST_TEST(result.size() == triangulation.number_of_vertices());
  const Eigen::Vector3d origin = domain.from_domain(Eigen::Vector3d::Zero());
  for(const auto& entry : result) {
    const Point p = entry.first->point();
    const Eigen::Vector3d before(p.x(), p.y(), p.z()), after(entry.second.x(), entry.second.y(), entry.second.z());
    BOOST_TEST((after - (2 * before - origin)).norm() < 1e-12);
    BOOST_TEST(domain.number(entry.first) >= 0);
  }
  BOOST_TEST(domain.number(triangulation.infinite_vertex()) == -1);
  BOOST_TEST(triangulation.is_valid());
}

BOOST_AUTO_TEST_CASE(regular_triangulation_of_weighted_points)
{
  typedef CGAL::Regular_triangulation_3<Kernel> Triangulation;
  std::vector<Triangulation::Weighted_point> points;
  Random random(4);
  for(const Point& p : cloud())
    points.emplace_back(p, random(0, 0.05));
  const Triangulation triangulation(points.begin(), points.end());
  FFM::Triangulation_3_domain<Triangulation> domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(triangulation, message) == Status::success), message);
  const Fingerprint all = expected(
    triangulation, [](Triangulation::Cell_handle) { return true; }, [](Triangulation::Vertex_handle v) { return v->point().point(); });
  BOOST_TEST(Fingerprint::of(domain).distance(all) < 1e-11);
}

BOOST_AUTO_TEST_CASE(triangulation_without_the_delaunay_property)
{
  typedef CGAL::Triangulation_3<Kernel> Triangulation;
  const std::array<Point, 5> corners = {{Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0), Point(0, 0, 2), Point(0.4, 0.5, 0.6)}};
  const Triangulation triangulation(corners.begin(), corners.end());
  FFM::Triangulation_3_domain<Triangulation> domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(triangulation, message) == Status::success), message);
  BOOST_TEST(domain.domain().number_of_elements() == 4);
  BOOST_TEST(std::abs(domain.domain().scale - std::cbrt(8. / 6)) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END() // test_triangulation_3_domain
