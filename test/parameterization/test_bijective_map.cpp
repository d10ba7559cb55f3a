// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps that must not overlap themselves: a surface whose free map does, judged by all pairs of triangles; surfaces whose free map
// does not; starts and statuses.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Scaffold.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bijective_map)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

namespace {

// A flat ring of `turns` turns, whose ends lie above each other.
Soup ramp(int around, int across, double turns)
{
  Soup soup;
  for(int i = 0; i <= around; ++i)
    for(int j = 0; j <= across; ++j) {
      const double angle = 2 * CGAL_PI * turns * i / around, r = 1 + 0.6 * j / across;
      soup.points.push_back({r * std::cos(angle), r * std::sin(angle), 0.05 * angle});
    }
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j) {
      const int a = i * (across + 1) + j, b = a + 1, c = a + across + 1, d = c + 1;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

struct Example
{
  explicit Example(const Soup& soup)
  {
    add_soup(soup, mesh);
    uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv", Plain_point_2(77, 77)).first;
    for(const Halfedge h : mesh.halfedges())
      if(mesh.is_border(h))
        border = h;
  }

  FFM::Summary map(bool bijective) { return map(bijective, FFM::Flip_free_map_traits<>()); }

  FFM::Summary map(bool bijective, const FFM::Flip_free_map_traits<>& traits)
  {
    return FFM::parameterize(mesh, border, uv, traits, FFM::parameters::bijective(bijective));
  }

  // Whether the images of any two triangles share what the triangles do not: all pairs, in exact arithmetic.
  bool overlaps() const
  {
    std::vector<std::array<Vertex, 3>> triangles;
    for(const auto f : mesh.faces()) {
      std::array<Vertex, 3> t;
      std::copy_n(CGAL::vertices_around_face(mesh.halfedge(f), mesh).begin(), 3, t.begin());
      triangles.push_back(t);
    }
    const auto point = [this](Vertex v) { return Exact::Point_2(uv[v].x(), uv[v].y()); };
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(std::size_t j = i + 1; j < triangles.size(); ++j) {
        const auto &s = triangles[i], &t = triangles[j];
        int shared = 0;
        for(Vertex v : s)
          shared += static_cast<int>(std::count(t.begin(), t.end(), v));
        if(shared == 0) {
          if(CGAL::do_intersect(Exact::Triangle_2(point(s[0]), point(s[1]), point(s[2])),
                                Exact::Triangle_2(point(t[0]), point(t[1]), point(t[2]))))
            return true;
          continue;
        }
        // Positive triangles with a common edge lie on either side of it. With a common vertex only, an edge of one must not
        // leave that vertex into the other.
        if(shared == 1 && (enters(s, t) || enters(t, s)))
          return true;
      }
    return false;
  }

  // Whether an edge of s from the common vertex runs within the angle of t there, or the opposite edge crosses t.
  bool enters(const std::array<Vertex, 3>& s, const std::array<Vertex, 3>& t) const
  {
    const auto point = [this](Vertex v) { return Exact::Point_2(uv[v].x(), uv[v].y()); };
    const auto k = std::find_first_of(t.begin(), t.end(), s.begin(), s.end()) - t.begin();
    const Exact::Point_2 o = point(t[k]), a = point(t[(k + 1) % 3]), b = point(t[(k + 2) % 3]);
    for(Vertex v : s)
      if(v != t[k] && CGAL::orientation(o, a, point(v)) != CGAL::RIGHT_TURN && CGAL::orientation(o, b, point(v)) != CGAL::LEFT_TURN &&
         CGAL::angle(a, o, point(v)) != CGAL::OBTUSE)
        return true;
    return false;
  }

  Mesh mesh;
  Mesh::Property_map<Vertex, Plain_point_2> uv;
  Halfedge border;
};

} // namespace

BOOST_AUTO_TEST_CASE(more_than_one_turn)
{
  Example example(ramp(48, 3, 1.15));
  const FFM::Summary free = example.map(false);
  BOOST_TEST_REQUIRE(free.converged());
  BOOST_TEST(!free.is_bijective.has_value());
  BOOST_TEST(example.overlaps());
  BOOST_TEST(!FFM::is_bijective(example.mesh, example.uv));

  const FFM::Summary summary = example.map(true);
  BOOST_TEST_CONTEXT(summary)
  {
    BOOST_TEST(FFM::status_name(summary.status) == std::string("success"));
    BOOST_TEST(summary.is_bijective.value());
    BOOST_TEST(!example.overlaps());
    BOOST_TEST(FFM::is_bijective(example.mesh, example.uv));
    BOOST_TEST(FFM::number_of_flipped_elements(example.mesh, example.uv) == 0);
    // Constraints cost, but the strip needs to bend by a seventh of a turn only.
    BOOST_TEST(summary.energy > free.energy);
    BOOST_TEST(summary.energy < 1.1);
    // The summary is about the surface, not about what was added around it.
    const FFM::Distortion_report report = FFM::measure_distortion(example.mesh, example.uv);
    BOOST_TEST(std::abs(report.energy - summary.energy) <= 1e-9);
    BOOST_TEST(report.elements == summary.elements);
    BOOST_TEST(std::abs(report.max_singular_value - summary.max_singular_value) <= 1e-9);
    BOOST_TEST(summary.vertices == static_cast<std::int64_t>(example.mesh.number_of_vertices()));
  }
}

BOOST_AUTO_TEST_CASE(free_maps_that_do_not_overlap_are_taken)
{
  Example example(bumpy_soup());
  const FFM::Summary free = example.map(false), summary = example.map(true);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.is_bijective.value());
  BOOST_TEST(summary.energy == free.energy);
  BOOST_TEST(summary.iterations == free.iterations);
  BOOST_TEST(!example.overlaps());
}

BOOST_AUTO_TEST_CASE(ramp_with_holes)
{
  Soup soup = ramp(50, 5, 1.1);
  for(const int cell : {5 * 30 + 2, 5 * 10 + 2})
    soup.triangles.erase(soup.triangles.begin() + 2 * cell, soup.triangles.begin() + 2 * cell + 2);
  Example example(soup);
  for(const Halfedge h : example.mesh.halfedges())
    if(example.mesh.is_border(h) && CGAL::halfedges_around_face(h, example.mesh).size() > 4)
      example.border = h;
  const FFM::Summary summary = example.map(true);
  BOOST_TEST(FFM::status_name(summary.status) == std::string("success"));
  BOOST_TEST(summary.is_bijective.value());
  BOOST_TEST(!example.overlaps());
  BOOST_TEST(summary.energy < 1.1);
}

BOOST_AUTO_TEST_CASE(limits_and_observers)
{
  Example example(ramp(48, 3, 1.15));
  const auto check = [&](const char* status, auto&& change) {
    FFM::Flip_free_map_traits<> traits;
    change(traits.options);
    const FFM::Summary summary = example.map(true, traits);
    BOOST_TEST(FFM::status_name(summary.status) == std::string(status));
    BOOST_TEST(summary.is_bijective.value());
    BOOST_TEST(!example.overlaps());
  };
  check("time_limit", [](auto& options) { options.max_seconds = 0; });
  check("iteration_limit", [](auto& options) { options.max_iterations = 7; });
  // After the free run, which calls the observer once more than it has iterations.
  int calls = example.map(false).iterations + 5;
  check("stopped_by_observer", [&calls](auto& options) {
    options.observer = [&calls](const FFM::Iteration_report& report) {
      BOOST_TEST(report.energy > 0.99);
      return --calls > 0;
    };
  });
}

BOOST_AUTO_TEST_CASE(start_that_overlaps)
{
  // The free map, given as the start, leaves no injective map to begin with.
  Example example(ramp(48, 3, 1.15));
  BOOST_TEST_REQUIRE(example.map(false).converged());
  std::map<Vertex, Plain_point_2> start;
  for(const Vertex v : example.mesh.vertices()) {
    start[v] = example.uv[v];
    example.uv[v] = Plain_point_2(77, 77);
  }
  const boost::associative_property_map<std::map<Vertex, Plain_point_2>> start_map(start);
  const FFM::Summary summary =
    FFM::parameterize(example.mesh, example.border, example.uv, FFM::parameters::bijective(true, FFM::parameters::start_map(start_map)));
  BOOST_TEST(FFM::status_name(summary.status) == std::string("not_bijective"));
  BOOST_TEST(summary.message.size() > 20u);
  BOOST_TEST(!summary.is_valid());
  for(const Vertex v : example.mesh.vertices())
    BOOST_TEST((example.uv[v] == Plain_point_2(77, 77)));
}

BOOST_AUTO_TEST_CASE(scaffold_tiles_a_box)
{
  // A flat sheet with a hole, as its own image.
  Soup soup = bumpy_soup(9, 8);
  for(auto& p : soup.points)
    p[2] = 0;
  soup.triangles.erase(soup.triangles.begin() + 2 * (9 * 3 + 4), soup.triangles.begin() + 2 * (9 * 3 + 6));
  Example example(soup);
  FFM::Face_graph_domain<Mesh> graph;
  std::string message;
  graph.load(example.mesh, corner_halfedge(example.mesh), get(CGAL::vertex_point, example.mesh), message);
  const FFM::Simplicial_domain<2>& domain = graph.domain();
  FFM::Positions<2> x = domain.rest_points.topRows(2);
  FFM::internal::Scaffold scaffold;
  BOOST_TEST_REQUIRE(scaffold.build(domain, x));
  const FFM::Simplicial_domain<2> extended = scaffold.extend(domain, 0.25);
  const FFM::Positions<2>& y = scaffold.positions();
  BOOST_TEST((y.leftCols(x.cols()) == x));
  BOOST_TEST(FFM::internal::is_bijective(extended, y, &message));
  double area = 0, weight = 0;
  for(std::int64_t e = 0; e < extended.number_of_elements(); ++e) {
    area += 0.5 * extended.image_edges(e, y).determinant();
    weight += extended.measures[e];
    if(e >= domain.number_of_elements())
      BOOST_TEST((extended.jacobian(e, y) - Eigen::Matrix2d::Identity()).norm() <= 1e-9);
  }
  const Eigen::Vector2d extent = y.rowwise().maxCoeff() - y.rowwise().minCoeff();
  BOOST_TEST(std::abs(area - extent[0] * extent[1]) <= 1e-9);
  BOOST_TEST(std::abs(weight - 1.25) <= 1e-9);
  BOOST_TEST(scaffold.fixed_vertices().size() == 4u);
  // Borders that cross each other have no outside.
  x.row(0) = x.row(0).cwiseAbs2().eval() - x.row(0);
  std::swap(x(0, domain.border[0]), x(0, domain.border[domain.border.size() / 2]));
  std::swap(x(1, domain.border[0]), x(1, domain.border[domain.border.size() / 2]));
  BOOST_TEST(!scaffold.build(domain, x));
}

BOOST_AUTO_TEST_SUITE_END() // test_bijective_map
