// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Patches as people have them, of polygons, with faces without area, in pieces: what a flat sheet is mapped to is known, and faces
// without area change nothing for the others.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_dirty_meshes)

namespace FFM = CGAL::Flip_free_maps;
namespace parameters = CGAL::Flip_free_maps::parameters;
using FFM::Status;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Point = std::array<double, 3>;
using Planar_point = std::array<double, 2>;
using Images = std::vector<Planar_point>;
using Polygons = std::vector<std::vector<int>>;

namespace {

struct Soup
{
  std::vector<Point> points;
  Polygons polygons;
};

// A sheet of n x n quadrilaterals in a skew plane, or on a hill.
Soup quads(int n, double height = 0)
{
  Soup soup;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double x = i + 0.2 * std::sin(3. * i + j), y = j + 0.2 * std::cos(2. * j - i);
      soup.points.push_back({0.6 * x, y, 0.8 * x + height * std::sin(x) * std::cos(y)});
    }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const int a = (n + 1) * i + j;
      soup.polygons.push_back({a, a + n + 1, a + n + 2, a + 1});
    }
  return soup;
}

Soup triangles(int n, double height = 0)
{
  const Soup sheet = quads(n, height);
  Soup soup{sheet.points, {}};
  for(const auto& q : sheet.polygons) {
    soup.polygons.push_back({q[0], q[1], q[2]});
    soup.polygons.push_back({q[0], q[2], q[3]});
  }
  return soup;
}

// The middle of an edge becomes a corner of the triangle `f` only, of which two are made; between them and what was across the edge
// there is a triangle without area.
void add_cap(Soup& soup, std::size_t f)
{
  const std::vector<int> t = soup.polygons[f];
  const int middle = static_cast<int>(soup.points.size());
  Point p;
  for(int c = 0; c < 3; ++c)
    p[c] = 0.5 * (soup.points[t[0]][c] + soup.points[t[1]][c]);
  soup.points.push_back(p);
  soup.polygons[f] = {t[0], middle, t[2]};
  soup.polygons.push_back({middle, t[1], t[2]});
  soup.polygons.push_back({t[0], t[1], middle});
}

// A vertex becomes four at the same place, with two triangles between them that have no extent at all, and needles around.
void add_point_faces(Soup& soup, std::size_t f)
{
  const std::vector<int> t = soup.polygons[f];
  const int a = static_cast<int>(soup.points.size());
  for(int k = 0; k < 3; ++k) {
    Point p;
    for(int c = 0; c < 3; ++c)
      p[c] = (soup.points[t[0]][c] + soup.points[t[1]][c] + soup.points[t[2]][c]) / 3;
    soup.points.push_back(k == 0 ? p : soup.points[a]);
  }
  soup.polygons[f] = {a, a + 1, a + 2};
  for(int k = 0; k < 3; ++k) {
    soup.polygons.push_back({t[k], t[(k + 1) % 3], a + (k + 1) % 3});
    soup.polygons.push_back({t[k], a + (k + 1) % 3, a + k});
  }
}

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }
double distance(const Planar_point& p, const Planar_point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

CGAL::Orientation orientation(const Images& uv, const std::vector<int>& polygon, std::size_t i, std::size_t j, std::size_t k)
{
  const auto point = [&](std::size_t c) { return Kernel::Point_2(uv[polygon[c]][0], uv[polygon[c]][1]); };
  return CGAL::orientation(point(i), point(j), point(k));
}

// Whether some triangulation of a polygon of up to four corners is positive.
bool is_positive(const Images& uv, const std::vector<int>& p)
{
  if(p.size() == 3)
    return orientation(uv, p, 0, 1, 2) == CGAL::LEFT_TURN;
  return (orientation(uv, p, 0, 1, 2) == CGAL::LEFT_TURN && orientation(uv, p, 0, 2, 3) == CGAL::LEFT_TURN) ||
         (orientation(uv, p, 0, 1, 3) == CGAL::LEFT_TURN && orientation(uv, p, 1, 2, 3) == CGAL::LEFT_TURN);
}

// A map that is valid, and of the first `size` points an isometry up to `tolerance`.
void check_sheet(const Soup& soup, const Images& uv, const FFM::Summary& summary, std::int64_t without_area, double tolerance,
                 std::size_t size)
{
  BOOST_TEST_CONTEXT(summary.message)
  {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::success));
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(summary.faces_without_area == without_area);
    BOOST_TEST_REQUIRE(uv.size() == soup.points.size());
    for(const auto& polygon : soup.polygons)
      BOOST_TEST(is_positive(uv, polygon));
    double worst = 0;
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < i; ++j)
        worst = (std::max)(worst, std::abs(distance(uv[i], uv[j]) - distance(soup.points[i], soup.points[j])));
    BOOST_TEST(worst <= tolerance);
  }
}

Images mapped(const Soup& soup, FFM::Summary& summary)
{
  Images uv;
  summary = FFM::parameterize(soup.points, soup.polygons, uv);
  return uv;
}

Mesh mesh_of(const Soup& soup)
{
  Mesh mesh;
  for(const Point& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& polygon : soup.polygons) {
    std::vector<Vertex> corners;
    for(const int v : polygon)
      corners.emplace_back(static_cast<Mesh::size_type>(v));
    BOOST_TEST_REQUIRE(mesh.add_face(corners).is_valid());
  }
  return mesh;
}

Mesh::Halfedge_index border_of(const Mesh& mesh)
{
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h))
      return h;
  return Mesh::null_halfedge();
}

} // namespace

BOOST_AUTO_TEST_CASE(polygons)
{
  FFM::Summary summary;
  const Soup flat = quads(6);
  check_sheet(flat, mapped(flat, summary), summary, 0, 1e-5, flat.points.size());
  BOOST_TEST(summary.elements == 72);
  const Soup hill = quads(6, 0.5);
  check_sheet(hill, mapped(hill, summary), summary, 0, 10, hill.points.size());

  // The same by a mesh, in which a polygon is concave: two neighbours of five without the side between them.
  Soup concave = flat;
  concave.polygons[0] = {0, 7, 14, 15, 8, 1};
  concave.polygons.erase(concave.polygons.begin() + 6);
  concave.polygons[1] = {1, 8, 9, 2};
  Mesh mesh = mesh_of(concave);
  const auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  summary = FFM::parameterize(mesh, border_of(mesh), uv);
  Images images;
  for(const Vertex v : mesh.vertices())
    images.push_back({uv[v].x(), uv[v].y()});
  concave.polygons.erase(concave.polygons.begin()); // six corners
  check_sheet(concave, images, summary, 0, 1e-5, images.size());
}

BOOST_AUTO_TEST_CASE(triangles_without_area)
{
  Soup soup = triangles(7);
  const std::size_t size = soup.points.size();
  for(const std::size_t f : {11, 40, 55, 70, 97})
    add_cap(soup, f);
  FFM::Summary summary;
  check_sheet(soup, mapped(soup, summary), summary, 5, 2e-3, size);
  BOOST_TEST((summary.first_faces_without_area == std::vector<std::int64_t>{99, 101, 103, 105, 107}));
  BOOST_TEST(summary.message.find("without area: 5 faces, numbers 99, 101, 103, 105, 107") != std::string::npos);
  // Those at one place, and needles.
  add_point_faces(soup, 20);
  add_point_faces(soup, 64);
  check_sheet(soup, mapped(soup, summary), summary, 5 + 2 * 4, 2e-3, size);

  Images uv{{7, 7}};
  summary = FFM::parameterize(soup.points, soup.polygons, uv, parameters::strict(true));
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::degenerate_rest_element));
  BOOST_TEST(uv.size() == 1u);
}

// A triangle without area at the border changes nothing.
BOOST_AUTO_TEST_CASE(the_rest_stays)
{
  const Soup clean = triangles(6, 0.7);
  FFM::Summary of_clean, summary;
  const Images expected = mapped(clean, of_clean);
  Soup soup = clean;
  soup.points.push_back({0.5 * (clean.points[1][0] + clean.points[2][0]), 0.5 * (clean.points[1][1] + clean.points[2][1]),
                         0.5 * (clean.points[1][2] + clean.points[2][2])});
  soup.polygons.push_back({2, 49, 1});
  const Images uv = mapped(soup, summary);
  check_sheet(soup, uv, summary, 1, 10, clean.points.size());
  BOOST_TEST(std::abs(summary.energy - of_clean.energy) <= 1e-4);
  double worst = 0;
  for(std::size_t i = 0; i < expected.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      worst = (std::max)(worst, std::abs(distance(uv[i], uv[j]) - distance(expected[i], expected[j])));
  BOOST_TEST(worst <= 5e-3);
}

// What has an area is left as it is, however thin.
BOOST_AUTO_TEST_CASE(clean_meshes)
{
  Soup thin = triangles(5, 0.5);
  add_cap(thin, 12);
  thin.points.back()[1] += 1e-9;
  const Soup thinnest{{{0, 0, 0}, {1, 1e-14, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 4, 2}}};
  for(const Soup& soup : {triangles(5, 0.5), thin, thinnest}) {
    Images uv, strictly;
    const FFM::Summary summary = FFM::parameterize(soup.points, soup.polygons, uv);
    BOOST_TEST(FFM::parameterize(soup.points, soup.polygons, strictly, parameters::strict(true)).is_valid());
    BOOST_TEST(summary.faces_without_area == 0);
    BOOST_TEST((uv == strictly));
  }
}

// Each corner with a point of its own, points that no face has, faces twice, and faces with a corner twice.
BOOST_AUTO_TEST_CASE(soups)
{
  const Soup soup = triangles(5, 0.5);
  FFM::Summary summary;
  const Images expected = mapped(soup, summary);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Soup wild{{{nan, nan, nan}}, {}};
  for(const auto& t : soup.polygons) {
    wild.polygons.emplace_back();
    for(const int v : t) {
      wild.polygons.back().push_back(static_cast<int>(wild.points.size()));
      wild.points.push_back(soup.points[v]);
    }
  }
  wild.polygons.push_back({1, 1, 2});
  wild.polygons.push_back(wild.polygons[4]);
  std::vector<char> is_fixed(wild.points.size(), 0);
  const auto fixed = boost::make_iterator_property_map(is_fixed.begin(), boost::typed_identity_property_map<std::size_t>());
  Images uv;
  summary = FFM::parameterize(wild.points, wild.polygons, uv, CGAL::parameters::vertex_is_constrained_map(fixed));
  BOOST_TEST_REQUIRE(summary.is_valid());
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(soup.polygons.size()));
  BOOST_TEST((summary.first_faces_without_area == std::vector<std::int64_t>{50}));
  bool is_same = true;
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    for(int k = 0; k < 3; ++k)
      is_same = is_same && distance(uv[wild.polygons[f][k]], expected[soup.polygons[f][k]]) <= 1e-9;
  BOOST_TEST(is_same);
  BOOST_TEST((uv[0] == Planar_point{0, 0}));

  // A point that stands for others is fixed if one of them is.
  wild.polygons.pop_back();
  Images start = uv;
  for(std::size_t v = 0; v < start.size(); ++v)
    start[v] = {2 * uv[v][0], uv[v][1]};
  const int late = wild.polygons[40][1];
  is_fixed[late] = 1;
  is_fixed[wild.polygons[0][0]] = 1;
  const auto given = boost::make_iterator_property_map(start.begin(), boost::typed_identity_property_map<std::size_t>());
  Images held;
  summary =
    FFM::parameterize(wild.points, wild.polygons, held, parameters::start_map(given, CGAL::parameters::vertex_is_constrained_map(fixed)));
  BOOST_TEST_REQUIRE(summary.is_valid());
  BOOST_TEST((held[late] == start[late]));
  BOOST_TEST((held[wild.polygons[0][0]] == start[wild.polygons[0][0]]));
}

// The sides of a cut have points at the same places, and stay apart.
BOOST_AUTO_TEST_CASE(cuts_stay)
{
  Soup soup = triangles(4);
  const int doubled = static_cast<int>(soup.points.size());
  soup.points.push_back(soup.points[12]);
  soup.points.push_back(soup.points[2]);
  // From the border over vertex 7 to vertex 12, which both ends keep: the copies are on one side of it.
  soup.points[doubled] = soup.points[7];
  for(auto& t : soup.polygons) {
    const bool is_right = std::any_of(t.begin(), t.end(), [](int v) { return v % 5 > 2; });
    for(int& v : t)
      if(is_right && (v == 7 || v == 2))
        v = v == 7 ? doubled : doubled + 1;
  }
  FFM::Summary summary;
  const Images uv = mapped(soup, summary);
  BOOST_TEST_REQUIRE(summary.is_valid());
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(soup.points.size()));
}

BOOST_AUTO_TEST_CASE(maps_are_repaired)
{
  Soup soup = triangles(6, 0.3);
  for(const std::size_t f : {9, 30, 51})
    add_cap(soup, f);
  FFM::Summary summary;
  const Images good = mapped(soup, summary);
  Images bad = good;
  std::swap(bad[16], bad[17]);
  std::vector<char> is_fixed(bad.size(), 0);
  is_fixed[24] = is_fixed[0] = is_fixed[48] = 1;
  Images repaired = bad;
  const auto fixed = boost::make_iterator_property_map(is_fixed.begin(), boost::typed_identity_property_map<std::size_t>());
  summary = FFM::repair_map(soup.points, soup.polygons, repaired, CGAL::parameters::vertex_is_constrained_map(fixed));
  BOOST_TEST_CONTEXT(summary.message)
  {
    BOOST_TEST_REQUIRE(summary.is_valid());
    BOOST_TEST(summary.faces_without_area == 3);
    for(const auto& t : soup.polygons)
      BOOST_TEST(is_positive(repaired, t));
    for(const int v : {0, 24, 48})
      BOOST_TEST((repaired[v] == bad[v]));
  }
}

BOOST_AUTO_TEST_CASE(shapes_are_deformed)
{
  Soup soup = triangles(6);
  for(Point& p : soup.points)
    p = {p[0] / 0.6, p[1], 0};
  const std::size_t size = soup.points.size();
  for(const std::size_t f : {9, 30, 51})
    add_cap(soup, f);
  add_point_faces(soup, 40);
  const std::vector<std::pair<std::size_t, Planar_point>> rest{{0, {soup.points[0][0], soup.points[0][1]}},
                                                               {48, {soup.points[48][0], soup.points[48][1]}}};
  Images result;
  FFM::Summary summary = FFM::deform(soup.points, soup.polygons, rest, result);
  check_sheet(soup, result, summary, 3 + 4, 2e-3, size);
  // Turned as a whole.
  auto turned = rest;
  for(auto& handle : turned)
    handle.second = {-handle.second[1] + 5, handle.second[0]};
  summary = FFM::deform(soup.points, soup.polygons, turned, result);
  check_sheet(soup, result, summary, 3 + 4, 2e-3, size);
  BOOST_TEST((result[48] == turned[1].second));

  Soup of_quads = quads(4);
  for(Point& p : of_quads.points)
    p = {p[0] / 0.6, p[1], 0};
  summary = FFM::deform(of_quads.points, of_quads.polygons, std::vector<std::pair<std::size_t, Planar_point>>{{0, {1, 1}}}, result);
  check_sheet(of_quads, result, summary, 0, 1e-5, of_quads.points.size());
  summary = FFM::deform(of_quads.points, of_quads.polygons, std::vector<std::pair<std::size_t, Planar_point>>{{0, {1, 1}}}, result,
                        parameters::strict(true));
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::not_triangular));
}

BOOST_AUTO_TEST_SUITE_END() // test_dirty_meshes
