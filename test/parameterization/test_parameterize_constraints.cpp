// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Named parameters of parameterizations: starts, fixed vertices and borders, weights of faces, soft positions.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_parameterize_constraints)

namespace FFM = CGAL::Flip_free_maps;
namespace FFP = CGAL::Flip_free_maps::parameters;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Point_2 = Plain_point_2;
using Soft = std::vector<std::tuple<Vertex, Point_2, double>>;

namespace {

struct Fixture
{
  Mesh mesh;
  std::vector<Vertex> vertices = add_soup(bumpy_soup(), mesh);
  Mesh::Halfedge_index border = corner_halfedge(mesh);
  Mesh::Property_map<Vertex, Point_2> uv = mesh.add_property_map<Vertex, Point_2>("v:uv", Point_2(77, 77)).first;
  Mesh::Property_map<Vertex, Point_2> start = mesh.add_property_map<Vertex, Point_2>("v:start").first;
  Mesh::Property_map<Vertex, bool> is_fixed = mesh.add_property_map<Vertex, bool>("v:fixed", false).first;
  Mesh::Property_map<Face, double> weight = mesh.add_property_map<Face, double>("f:weight", 1.).first;

  // The sheet seen from above, sheared: without flips, with a border that is not convex, in the units of the surface.
  Fixture()
  {
    for(const Vertex v : vertices) {
      const auto p = mesh.point(v);
      start[v] = Point_2(1.1 * p.x() + 0.3 * p.y() + 0.7, p.y() + 0.05 * std::sin(9 * p.x()) - 0.1);
    }
  }

  template <typename NamedParameters>
  FFM::Summary run(const NamedParameters& np)
  {
    const FFM::Summary summary = FFM::parameterize(mesh, border, uv, tight_traits(), np);
    BOOST_TEST_MESSAGE(summary);
    return summary;
  }

  template <typename NamedParameters>
  void check_refused(const NamedParameters& np, FFM::Status status, const std::string& part)
  {
    for(const Vertex v : vertices)
      uv[v] = Point_2(77, 77);
    const FFM::Summary summary = run(np);
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST_CONTEXT(summary.message)
    BOOST_TEST(summary.message.find(part) != std::string::npos);
    for(const Vertex v : vertices)
      BOOST_TEST_REQUIRE((uv[v] == Point_2(77, 77)));
  }

  void check_valid(const FFM::Summary& summary)
  {
    BOOST_TEST(FFM::status_name(summary.status) == "success");
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  }

  // What the minimizer makes of the same start, with measures multiplied by hand.
  FFM::Summary minimized(FFM::Face_graph_domain<Mesh>& graph, FFM::Positions<2>& x, const FFM::Position_constraints<2>& constraints,
                         bool is_weighted)
  {
    std::string message;
    BOOST_TEST_REQUIRE((graph.load(mesh, border, mesh.points(), message) == FFM::Status::success));
    FFM::Simplicial_domain<2> domain = graph.domain();
    if(is_weighted) {
      double total = 0;
      for(std::size_t e = 0; e < domain.measures.size(); ++e)
        total += domain.measures[e] *= weight[graph.faces_of_elements()[e]];
      for(double& measure : domain.measures)
        measure /= total;
    }
    x.resize(2, domain.number_of_vertices);
    for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
      x.col(v) << start[graph.vertices()[v]].x() / domain.scale, start[graph.vertices()[v]].y() / domain.scale;
    FFM::Map_minimizer<2> minimizer(domain, tight_traits(), constraints);
    const FFM::Summary summary = minimizer.minimize(x);
    x *= domain.scale;
    return summary;
  }

  double difference(const FFM::Face_graph_domain<Mesh>& graph, const FFM::Positions<2>& x) const
  {
    double largest = 0;
    for(std::size_t v = 0; v < graph.vertices().size(); ++v)
      largest = std::max(largest, std::hypot(uv[graph.vertices()[v]].x() - x(0, v), uv[graph.vertices()[v]].y() - x(1, v)));
    return largest;
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(given_start, Fixture)
{
  const FFM::Summary summary = run(FFP::start_map(start));
  check_valid(summary);
  BOOST_TEST(summary.start == "given");
  FFM::Face_graph_domain<Mesh> graph;
  FFM::Positions<2> x;
  const FFM::Summary expected = minimized(graph, x, {}, false);
  BOOST_TEST(std::abs(summary.energy_initial - expected.energy_initial) <= 1e-12);
  BOOST_TEST(summary.iterations == expected.iterations);
  BOOST_TEST(difference(graph, x) <= 1e-9);

  // The optimum is that of any other start, and a run of no steps changes nothing.
  BOOST_TEST(std::abs(summary.energy - plain_result(bumpy_soup()).summary.energy) <= 1e-9);
  BOOST_TEST(FFM::status_name(run(FFP::start_map(start, CGAL::parameters::number_of_iterations(0))).status) == "iteration_limit");
  for(const Vertex v : vertices)
    BOOST_TEST_REQUIRE(std::hypot(uv[v].x() - start[v].x(), uv[v].y() - start[v].y()) <= 1e-14);
}

BOOST_FIXTURE_TEST_CASE(fixed_vertices, Fixture)
{
  for(const int v : {0, 5, 60, 61, 90})
    is_fixed[vertices[v]] = true;
  const FFM::Summary summary = run(FFP::start_map(start, CGAL::parameters::vertex_is_constrained_map(is_fixed)));
  check_valid(summary);
  BOOST_TEST(summary.iterations > 0);
  int moved = 0;
  for(const Vertex v : vertices) {
    if(is_fixed[v])
      BOOST_TEST((uv[v] == start[v]));
    else
      moved += std::hypot(uv[v].x() - start[v].x(), uv[v].y() - start[v].y()) > 1e-6;
  }
  BOOST_TEST(moved == int(vertices.size()) - 5);

  // They keep the places of a computed start as well: at the optimum of the others, relative to each other.
  for(const Vertex v : vertices)
    is_fixed[v] = true;
  const FFM::Summary nothing = run(CGAL::parameters::vertex_is_constrained_map(is_fixed));
  check_valid(nothing);
  BOOST_TEST(nothing.iterations == 0);
  BOOST_TEST(std::abs(nothing.energy - nothing.energy_initial) <= 1e-14 * nothing.energy);
}

BOOST_FIXTURE_TEST_CASE(fixed_border, Fixture)
{
  const FFM::Summary summary = run(FFP::start_map(start, FFP::border_is_fixed(true)));
  check_valid(summary);
  double inner = 0;
  for(const Vertex v : vertices) {
    if(mesh.is_border(v))
      BOOST_TEST((uv[v] == start[v]));
    else
      inner = std::max(inner, std::hypot(uv[v].x() - start[v].x(), uv[v].y() - start[v].y()));
  }
  BOOST_TEST(inner > 1e-3);
  const FFM::Summary free = run(FFP::start_map(start, FFP::border_is_fixed(false)));
  check_valid(free);
  BOOST_TEST(free.energy < summary.energy - 1e-3);
  // With the border of the optimum nothing is lost.
  for(const Vertex v : vertices)
    start[v] = uv[v];
  const FFM::Summary again = run(FFP::border_is_fixed(true, FFP::start_map(start)));
  check_valid(again);
  BOOST_TEST(std::abs(again.energy - free.energy) <= 1e-9);
}

BOOST_FIXTURE_TEST_CASE(weights_of_faces, Fixture)
{
  double area = 0, weighted = 0;
  for(const Face f : faces(mesh)) {
    weight[f] = f % 3 == 0 ? 2. : 1.;
    const double a = CGAL::Polygon_mesh_processing::face_area(f, mesh);
    area += a;
    weighted += a * weight[f];
  }
  BOOST_TEST(weighted > 1.1 * area);
  const FFM::Summary summary = run(FFP::start_map(start, FFP::face_weight_map(weight)));
  check_valid(summary);
  FFM::Face_graph_domain<Mesh> graph;
  FFM::Positions<2> x, unweighted;
  const FFM::Summary expected = minimized(graph, x, {}, true);
  BOOST_TEST(std::abs(summary.energy - expected.energy) <= 1e-11);
  BOOST_TEST(std::abs(summary.energy_initial - expected.energy_initial) <= 1e-11);
  BOOST_TEST(difference(graph, x) <= 1e-8);
  const FFM::Summary plain = minimized(graph, unweighted, {}, false);
  BOOST_TEST(difference(graph, unweighted) > 1e-5);

  // Weights are relative.
  for(const Face f : faces(mesh))
    weight[f] = 1e-3;
  BOOST_TEST(std::abs(run(FFP::face_weight_map(weight, FFP::start_map(start))).energy - plain.energy) <= 1e-11);
}

BOOST_FIXTURE_TEST_CASE(soft_positions, Fixture)
{
  const Soft soft{{vertices[0], Point_2(-0.3, 0.2), 2.}, {vertices[115], Point_2(1.4, 1.1), 2.}, {vertices[50], Point_2(0.5, 0.5), 0.3}};
  const FFM::Summary summary = run(FFP::start_map(start, FFP::soft_positions(soft)));
  check_valid(summary);
  FFM::Face_graph_domain<Mesh> graph;
  std::string message;
  BOOST_TEST_REQUIRE((graph.load(mesh, border, mesh.points(), message) == FFM::Status::success));
  FFM::Position_constraints<2> constraints;
  double terms = 0;
  for(const auto& s : soft) {
    const Point_2 p = std::get<1>(s);
    constraints.soft_positions.push_back(
      {graph.number_of(std::get<0>(s)), Eigen::Vector2d(p.x(), p.y()) / graph.domain().scale, std::get<2>(s)});
    // Lengths in units of the square root of the area.
    const Point_2 q = uv[std::get<0>(s)];
    terms += std::get<2>(s) * (std::pow(p.x() - q.x(), 2) + std::pow(p.y() - q.y(), 2)) / CGAL::Polygon_mesh_processing::area(mesh);
  }
  BOOST_TEST(terms > 1e-3);
  BOOST_TEST(std::abs(summary.energy_of_terms - terms) <= 1e-11);
  FFM::Positions<2> x;
  const FFM::Summary expected = minimized(graph, x, constraints, false);
  BOOST_TEST(std::abs(summary.energy - expected.energy) <= 1e-11);
  BOOST_TEST(difference(graph, x) <= 1e-8);
}

BOOST_FIXTURE_TEST_CASE(errors, Fixture)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for(const double bad : {0., -1., nan, infinity}) {
    weight[Face(7)] = bad;
    check_refused(FFP::face_weight_map(weight), FFM::Status::invalid_option, "weight");
  }
  check_refused(FFP::soft_positions(Soft{{vertices[3], Point_2(nan, 0), 1.}}), FFM::Status::invalid_option, "not finite");
  check_refused(FFP::soft_positions(Soft{{vertices[3], Point_2(0, 0), -1.}}), FFM::Status::invalid_option, "weight");
  const Vertex lonely = mesh.add_vertex(mesh.point(vertices[0]));
  check_refused(FFP::soft_positions(Soft{{lonely, Point_2(0, 0), 1.}}), FFM::Status::invalid_option, "number 0 is not of a vertex");

  const Point_2 kept = start[vertices[60]];
  for(const Point_2& bad : {Point_2(10, 10), Point_2(nan, 0), Point_2(infinity, 0)}) {
    start[vertices[60]] = bad;
    check_refused(FFP::start_map(start), FFM::Status::start_not_flip_free, "flipped");
  }
  start[vertices[60]] = kept;
  for(const Vertex v : vertices)
    start[v] = Point_2(-start[v].x(), start[v].y());
  check_refused(FFP::start_map(start), FFM::Status::start_not_flip_free, "flipped");
}

BOOST_AUTO_TEST_SUITE_END() // test_parameterize_constraints
