// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Planar deformations: handles arrive exactly and nothing flips, or it is said why not; and sessions of many moves.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/deform.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_deform)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Point_2 = Plain_point_2;
using Handles = std::vector<std::pair<Vertex, Point_2>>;

namespace {

const double nan_ = std::numeric_limits<double>::quiet_NaN();

// A bar of length 4 and height 1 in the plane z = 0.3, far from the origin.
Soup bar_soup(int columns = 16, int rows = 4)
{
  Soup soup;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i)
      soup.points.push_back({10 + 4. * i / columns, -5 + 1. * j / rows, 0.3});
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      if((i + j) % 2 == 0) {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      } else {
        soup.triangles.push_back({a, b, d});
        soup.triangles.push_back({b, c, d});
      }
    }
  return soup;
}

struct Fixture
{
  Mesh mesh;
  std::vector<Vertex> vertices;
  Mesh::Property_map<Vertex, Point_2> result = mesh.add_property_map<Vertex, Point_2>("v:result", Point_2(77, 77)).first;
  std::vector<Vertex> left, right;

  Fixture() { build(bar_soup()); }

  void build(const Soup& soup)
  {
    vertices = add_soup(soup, mesh);
    for(const Vertex v : vertices) {
      if(mesh.point(v).x() == 10)
        left.push_back(v);
      if(mesh.point(v).x() == 14)
        right.push_back(v);
    }
  }

  Point_2 rest(Vertex v) const { return Point_2(mesh.point(v).x(), mesh.point(v).y()); }

  // Both ends, moved by two functions.
  template <typename Left, typename Right>
  Handles ends(Left&& move_left, Right&& move_right) const
  {
    Handles handles;
    for(const Vertex v : left)
      handles.emplace_back(v, move_left(rest(v)));
    for(const Vertex v : right)
      handles.emplace_back(v, move_right(rest(v)));
    return handles;
  }

  FFM::Summary run(const Handles& handles)
  {
    const FFM::Summary summary = FFM::deform(mesh, handles, result);
    BOOST_TEST_MESSAGE(summary);
    return summary;
  }

  void check_valid(const FFM::Summary& summary, const Handles& handles)
  {
    BOOST_TEST_CONTEXT(summary.message)
    BOOST_TEST_REQUIRE(FFM::status_name(summary.status) == "success");
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, result) == 0);
    for(const auto& handle : handles)
      BOOST_TEST((result[handle.first] == handle.second));
  }

  void check_refused(const Handles& handles, FFM::Status status, const std::string& part)
  {
    const FFM::Summary summary = run(handles);
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST_CONTEXT(summary.message)
    BOOST_TEST(summary.message.find(part) != std::string::npos);
    for(const Vertex v : mesh.vertices())
      BOOST_TEST_REQUIRE((result[v] == Point_2(77, 77)));
  }
};

Point_2 stay(const Point_2& p) { return p; }

// About the middle of the bar's axis, then away.
Point_2 turned(const Point_2& p, double angle)
{
  const double x = p.x() - 12, y = p.y() + 4.5;
  return Point_2(12 + std::cos(angle) * x - std::sin(angle) * y, -4.5 + std::sin(angle) * x + std::cos(angle) * y);
}

} // namespace

BOOST_FIXTURE_TEST_CASE(handles_at_rest_leave_the_shape, Fixture)
{
  const Handles handles = ends(stay, stay);
  const FFM::Summary summary = run(handles);
  check_valid(summary, handles);
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST(std::abs(summary.energy - 1) <= 1e-12);
  for(const Vertex v : vertices)
    BOOST_TEST(std::hypot(result[v].x() - rest(v).x(), result[v].y() - rest(v).y()) <= 1e-13);
  check_valid(run(Handles()), Handles());
}

BOOST_FIXTURE_TEST_CASE(rigid_motions_are_isometries, Fixture)
{
  const std::vector<std::function<Point_2(const Point_2&)>> motions{
    [](const Point_2& p) { return Point_2(p.x() + 100, p.y() - 3); }, [](const Point_2& p) { return turned(p, 0.8); },
    [](const Point_2& p) { return turned(p, 3); }, [](const Point_2& p) { return turned(Point_2(p.x() + 5, p.y()), -1.7); }};
  for(const auto& motion : motions) {
    const Handles handles = ends(motion, motion);
    const FFM::Summary summary = run(handles);
    check_valid(summary, handles);
    BOOST_TEST(std::abs(summary.energy - 1) <= 1e-8);
    for(const Vertex v : vertices) {
      const Point_2 p = motion(rest(v));
      BOOST_TEST(std::hypot(result[v].x() - p.x(), result[v].y() - p.y()) <= 1e-3);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(bar_is_bent_by_half_a_turn, Fixture)
{
  // The right end comes to lie above the left one, upside down.
  const auto bend = [](const Point_2& p) { return Point_2(24 - p.x(), -2 - (p.y() + 5)); };
  const Handles handles = ends(stay, bend);
  const FFM::Summary summary = run(handles);
  check_valid(summary, handles);
  BOOST_TEST(summary.energy > 1.01);
  BOOST_TEST(summary.energy < 3);
  BOOST_TEST(summary.min_singular_value > 0.05);

  // Mirror images of a shape and its handles are mirror images.
  Handles mirrored;
  const auto mirror = [](const Point_2& p) { return Point_2(p.x(), -9 - p.y()); };
  for(const Vertex v : left)
    mirrored.emplace_back(v, rest(v));
  for(const Vertex v : right)
    mirrored.emplace_back(v, mirror(bend(mirror(rest(v)))));
  const FFM::Summary other = run(mirrored);
  check_valid(other, mirrored);
  BOOST_TEST(std::abs(other.energy - summary.energy) <= 1e-4 * summary.energy);
}

BOOST_FIXTURE_TEST_CASE(start_may_be_given, Fixture)
{
  auto start = mesh.add_property_map<Vertex, Point_2>("v:start").first;
  for(const Vertex v : vertices)
    start[v] = turned(rest(v), 1);
  const auto motion = [](const Point_2& p) { return turned(p, 1); };
  const Handles handles = ends(motion, motion);
  const FFM::Summary summary = FFM::deform(mesh, handles, result, FFM::Flip_free_map_traits<>(), FFM::parameters::start_map(start));
  check_valid(summary, handles);
  BOOST_TEST(summary.start == "given");
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST(std::abs(summary.energy - 1) <= 1e-12);
}

BOOST_FIXTURE_TEST_CASE(unreachable_handles, Fixture)
{
  Fixture triangle;
  triangle.mesh.clear_without_removing_property_maps();
  triangle.build({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for(const Vertex v : triangle.mesh.vertices())
    triangle.result[v] = Point_2(77, 77);
  const auto& v = triangle.vertices;
  triangle.check_refused({{v[0], Point_2(1, 1)}, {v[1], Point_2(1, 0)}, {v[2], Point_2(0, 1)}}, FFM::Status::unreachable_constraints, "");
  triangle.check_refused({{v[0], Point_2(0.5, 0.5)}, {v[1], Point_2(1, 0)}, {v[2], Point_2(0, 1)}}, FFM::Status::unreachable_constraints,
                         "");
  const Handles shift{{v[0], Point_2(5, 1)}, {v[1], Point_2(6, 1)}, {v[2], Point_2(5, 2)}};
  const FFM::Summary shifted = triangle.run(shift);
  triangle.check_valid(shifted, shift);
  BOOST_TEST(std::abs(shifted.energy - 1) <= 1e-12);

  // A face of the bar's middle all of whose corners are handles.
  const auto corners = CGAL::vertices_around_face(mesh.halfedge(Mesh::Face_index(70)), mesh);
  Handles handles;
  for(const Vertex w : corners)
    handles.emplace_back(w, rest(w));
  std::swap(handles[0].second, handles[1].second);
  check_refused(handles, FFM::Status::unreachable_constraints, "");
}

BOOST_FIXTURE_TEST_CASE(errors, Fixture)
{
  Handles handles = ends(stay, stay);
  handles[2].second = Point_2(nan_, 0);
  check_refused(handles, FFM::Status::non_finite_input, "NaN");
  handles[2].second = Point_2(0, std::numeric_limits<double>::infinity());
  check_refused(handles, FFM::Status::non_finite_input, "infinite");
  const Vertex lonely = mesh.add_vertex(mesh.point(vertices[0]));
  result[lonely] = Point_2(77, 77);
  check_refused({{lonely, Point_2(0, 0)}}, FFM::Status::invalid_option, "handle");

  // The same vertex at two places; at one place, told twice, it does no harm.
  handles = ends(stay, stay);
  handles.insert(handles.begin(), {right[1], Point_2(14.25, rest(right[1]).y())});
  check_refused(handles, FFM::Status::invalid_option, "different targets");
  handles[0] = handles.back();
  check_valid(run(handles), handles);

  Fixture other;
  other.mesh.point(other.vertices[7]) = Mesh::Point(11, -5, 0.3000001);
  other.check_refused(other.ends(stay, stay), FFM::Status::not_planar, "plane");
  Fixture clockwise;
  for(const Vertex v : clockwise.vertices)
    clockwise.mesh.point(v) = Mesh::Point(-clockwise.mesh.point(v).x(), clockwise.mesh.point(v).y(), 0);
  clockwise.check_refused(clockwise.ends(stay, stay), FFM::Status::start_not_flip_free, "counterclockwise");
  Fixture two;
  add_soup(bar_soup(2, 2), two.mesh);
  two.check_refused(two.ends(stay, stay), FFM::Status::several_components, "components");
}

// Small moves end where one large one ends, and the matrix is analysed once.
BOOST_FIXTURE_TEST_CASE(sessions, Fixture)
{
  FFM::Face_graph_domain<Mesh> graph;
  FFM::Positions<2> start;
  std::string message;
  BOOST_TEST_REQUIRE((graph.load_planar(mesh, mesh.points(), start, message) == FFM::Status::success));
  const FFM::Simplicial_domain<2>& domain = graph.domain();
  start = (domain.scale * start).colwise() + domain.origin;
  const auto bend = [](const Point_2& p, double t) { return turned(Point_2(p.x() - 0.5 * t, p.y()), 0.7 * t); };
  std::vector<std::int32_t> numbers;
  for(const Vertex v : left)
    numbers.push_back(graph.number_of(v));
  for(const Vertex v : right)
    numbers.push_back(graph.number_of(v));
  const auto targets = [&](double t) {
    FFM::Positions<2> places(2, numbers.size());
    for(std::size_t i = 0; i < numbers.size(); ++i) {
      const Vertex v = graph.vertices()[numbers[i]];
      const Point_2 p = i < left.size() ? rest(v) : bend(rest(v), t);
      places.col(i) << p.x(), p.y();
    }
    return places;
  };

  FFM::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-7;
  FFM::Deformation<2> one(domain, start, numbers, traits), many(domain, start, numbers, traits);
  BOOST_TEST((many.positions().array() == start.array()).all());
  const FFM::Summary large = one.move(targets(1));
  BOOST_TEST(large.converged());
  FFM::Summary last;
  int factorizations = 0;
  for(int k = 1; k <= 20; ++k) {
    last = many.move(targets(k / 20.));
    BOOST_TEST(last.converged());
    BOOST_TEST(last.flips == 0);
    BOOST_TEST((last.seconds.analyze > 0) == (k == 1));
    factorizations += last.factorizations;
    for(std::size_t i = 0; i < numbers.size(); ++i)
      BOOST_TEST_REQUIRE((many.positions().col(numbers[i]).array() == targets(k / 20.).col(i).array()).all());
  }
  BOOST_TEST(factorizations <= 40);
  BOOST_TEST(std::abs(last.energy - large.energy) <= 1e-6);
  BOOST_TEST((many.positions() - one.positions()).norm() <= 1e-3 * domain.scale);

  // A failed move changes nothing, and the next one succeeds.
  const FFM::Positions<2> kept = many.positions();
  FFM::Positions<2> bad = targets(1);
  bad(0, 0) = nan_;
  BOOST_TEST(FFM::status_name(many.move(bad).status) == "non_finite_input");
  BOOST_TEST(FFM::status_name(many.move(bad.leftCols(3)).status) == "invalid_option");
  BOOST_TEST((many.positions().array() == kept.array()).all());
  BOOST_TEST(many.move(targets(0.9)).converged());

  // Back to rest.
  const FFM::Summary back = many.move(targets(0));
  BOOST_TEST(back.converged());
  BOOST_TEST(std::abs(back.energy - 1) <= 1e-8);
}

BOOST_AUTO_TEST_SUITE_END() // test_deform
