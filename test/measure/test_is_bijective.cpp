// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// is_bijective() on cases made by hand, and against the intersections of all pairs of triangles.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/is_bijective.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_is_bijective)

namespace FFM = CGAL::Flip_free_maps;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
using Triangle = std::array<std::int32_t, 3>;

namespace {

struct Map
{
  std::vector<Triangle> triangles;
  std::vector<std::array<double, 2>> points;

  FFM::Positions<2> positions() const
  {
    FFM::Positions<2> x(2, points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      x.col(i) << points[i][0], points[i][1];
    return x;
  }

  bool is_bijective() const { return FFM::internal::is_bijective(triangles, positions()); }

  Exact::Point_2 point(std::int32_t v) const { return Exact::Point_2(points[v][0], points[v][1]); }

  // No two triangles have a point in common but the images of what they share.
  bool is_bijective_by_pairs() const
  {
    const auto shape = [&](const Triangle& t) { return Exact::Triangle_2(point(t[0]), point(t[1]), point(t[2])); };
    for(const Triangle& t : triangles)
      if(shape(t).orientation() != CGAL::POSITIVE)
        return false;
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const Triangle& s = triangles[i];
        const Triangle& t = triangles[j];
        std::vector<int> common;
        for(int k = 0; k < 3; ++k)
          if(std::count(t.begin(), t.end(), s[k]) > 0)
            common.push_back(k);
        if(common.empty() && CGAL::do_intersect(shape(s), shape(t)))
          return false;
        if(common.size() == 1) {
          // Beyond a common corner they meet on the opposite side of one of them.
          const std::size_t k = common[0], l = std::find(t.begin(), t.end(), s[k]) - t.begin();
          if(CGAL::do_intersect(Exact::Segment_2(point(s[(k + 1) % 3]), point(s[(k + 2) % 3])), shape(t)) ||
             CGAL::do_intersect(Exact::Segment_2(point(t[(l + 1) % 3]), point(t[(l + 2) % 3])), shape(s)))
            return false;
        }
        // Across a common edge positive triangles lie on different sides, if they have it in opposite directions.
        if(common.size() == 2) {
          const bool is_next = (common[0] + 1) % 3 == common[1];
          const std::int32_t a = s[common[is_next ? 0 : 1]], b = s[common[is_next ? 1 : 0]];
          const std::size_t l = std::find(t.begin(), t.end(), a) - t.begin();
          if(t[(l + 1) % 3] == b)
            return false;
        }
      }
    return true;
  }
};

// A strip of 2 n triangles between two curves c(i, side).
template <typename Curve>
Map strip(int n, bool is_closed, Curve&& curve)
{
  Map map;
  const int columns = is_closed ? n : n + 1;
  for(int i = 0; i < columns; ++i)
    for(int side = 0; side < 2; ++side)
      map.points.push_back(curve(i, side));
  for(int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1, c = 2 * ((i + 1) % columns), d = c + 1;
    map.triangles.push_back({a, b, c});
    map.triangles.push_back({c, b, d});
  }
  return map;
}

// A band around the origin that turns by `turns` and moves outwards by `pitch` with each turn.
Map spiral(double turns, double pitch, int n = 40)
{
  return strip(n, false, [=](int i, int side) {
    const double angle = 2 * CGAL_PI * turns * i / n, radius = 1 + pitch * turns * i / n + (side == 0 ? 0. : 0.5);
    return std::array<double, 2>{{radius * std::cos(angle), radius * std::sin(angle)}};
  });
}

// A fan of n triangles around an inner vertex, which winds `turns` times around it.
Map fan(int n, int turns)
{
  Map map;
  map.points.push_back({0, 0});
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * turns * i / n;
    map.points.push_back({(1 + 0.01 * i) * std::cos(angle), (1 + 0.01 * i) * std::sin(angle)});
    map.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return map;
}

Map square(double x, double y, double side)
{
  return {{{{0, 1, 2}}, {{0, 2, 3}}}, {{{x, y}}, {{x + side, y}}, {{x + side, y + side}}, {{x, y + side}}}};
}

// A square frame around a square hole.
Map frame(double x, double y, double side, double hole)
{
  const double w = (side - hole) / 2;
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return strip(4, true, [=](int i, int inside) {
    const double s = inside ? side : hole, o = inside ? 0 : w;
    return std::array<double, 2>{{x + o + s * corners[i][0], y + o + s * corners[i][1]}};
  });
}

Map together(const Map& a, const Map& b)
{
  Map map = a;
  const std::int32_t n = static_cast<std::int32_t>(a.points.size());
  map.points.insert(map.points.end(), b.points.begin(), b.points.end());
  for(const Triangle& t : b.triangles)
    map.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return map;
}

void expect(const Map& map, bool answer)
{
  BOOST_TEST(map.is_bijective() == answer);
  BOOST_TEST(map.is_bijective_by_pairs() == answer);
}

} // namespace

BOOST_AUTO_TEST_CASE(spirals_without_flips)
{
  expect(spiral(0.9, 0), true);
  expect(spiral(1.5, 0.6), true);  // the band's width is 0.5
  expect(spiral(1.5, 0.4), false); // overlaps itself along half a turn
  expect(spiral(3, 0.7, 60), true);
  // Two of two crossing places: the last turn is pulled in.
  Map map = spiral(1.5, 0.6);
  map.points.back() = {{-1.2, 0.01}};
  BOOST_TEST(map.is_bijective() == map.is_bijective_by_pairs());
}

BOOST_AUTO_TEST_CASE(borders_that_touch)
{
  // Both ends of a frame that is cut open meet in an edge, in a part of an edge, in a point, not at all.
  const auto open_frame = [](double y_low, double y_high) {
    const double x[5][2][2] = {{{1, 0}, {2, 0}}, {{0, 1}, {0, 2}}, {{-1, 0}, {-2, 0}}, {{0, -1}, {0, -2}}, {{1, y_low}, {2, y_high}}};
    return strip(4, false, [&](int i, int side) { return std::array<double, 2>{{x[i][side][0], x[i][side][1]}}; });
  };
  expect(open_frame(0, 0), false);
  expect(open_frame(-0.25, -0.25), true);
  expect(open_frame(0, -0.25), false);
  expect(open_frame(-0.25, 0), false);
  expect(open_frame(-std::numeric_limits<double>::min(), -0.25), true);
  expect(open_frame(0.125, -0.25), false);

  // Squares side by side, corner to corner, a corner on a side, and apart by one unit in the last place.
  expect(together(square(0, 0, 1), square(1, 0, 1)), false);
  expect(together(square(0, 0, 1), square(1, 1, 1)), false);
  expect(together(square(0, 0, 1), square(1, 0.5, 1)), false);
  expect(together(square(0, 0, 1), square(std::nextafter(1., 2.), 0, 1)), true);

  // Neighbouring border edges folded onto each other: a triangle fan that closes exactly without being glued.
  Map map;
  map.points = {{{0, 0}}, {{1, 0}}, {{0, 1}}, {{-1, -1}}, {{1, 0}}};
  map.triangles = {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}};
  expect(map, false);
  map.points[4] = {{1, -0.125}};
  expect(map, true);
  map.points[4] = {{1, 0.125}};
  expect(map, false);
}

BOOST_AUTO_TEST_CASE(windings)
{
  expect(fan(7, 1), true);
  // Around an inner vertex twice, with all triangles positive.
  const Map twice = fan(14, 2);
  for(const Triangle& t : twice.triangles)
    BOOST_TEST(CGAL::orientation(twice.point(t[0]), twice.point(t[1]), twice.point(t[2])) == CGAL::LEFT_TURN);
  expect(twice, false);
  // A ring that winds twice: its outer border crosses itself, as does its inner one.
  expect(strip(12, true,
               [](int i, int side) {
                 const double angle = 4 * CGAL_PI * i / 12, radius = side == 0 ? 1 + 0.01 * i : 2 + 0.01 * i;
                 return std::array<double, 2>{{radius * std::cos(angle), radius * std::sin(angle)}};
               }),
         false);
}

BOOST_AUTO_TEST_CASE(components_and_holes)
{
  const Map ring = frame(0, 0, 4, 2);
  expect(ring, true);
  expect(together(ring, square(1.5, 1.5, 1)), true);                                          // within the hole
  expect(together(square(1.5, 1.5, 1), ring), true);                                          // whatever the order
  expect(together(ring, square(1, 1, 2)), false);                                             // fills the hole exactly
  expect(together(ring, square(0.25, 0.25, 0.5)), false);                                     // upon the frame
  expect(together(square(0, 0, 4), square(1, 1, 1)), false);                                  // nested without a hole
  expect(together(square(0, 0, 4), square(5, 1, 1)), true);                                   // beside
  expect(together(square(-1, -1, 6), ring), false);                                           // beneath the frame
  expect(together(together(ring, frame(1.25, 1.25, 1.5, 1)), square(1.75, 1.75, 0.5)), true); // three deep
  expect(together(together(frame(1.25, 1.25, 1.5, 1), ring), square(1.25, 1.25, 0.125)), false);
  expect(together(ring, frame(0.5, 0.5, 3, 2.5)), false); // upon the frame, around its hole
}

BOOST_AUTO_TEST_CASE(bad_triangles_and_arrays)
{
  Map map = square(0, 0, 1);
  std::swap(map.triangles[1][0], map.triangles[1][1]);
  expect(map, false);
  map = square(0, 0, 1);
  map.points[3] = {{0.5, 0.5}};
  expect(map, false);
  map = square(0, 0, 1);
  map.points[2][0] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!map.is_bijective());
  // The same triangle twice, and two squares that share a vertex only.
  map = square(0, 0, 1);
  map.triangles.push_back(map.triangles[0]);
  BOOST_TEST(!map.is_bijective());
  map = together(square(0, 0, 1), square(1, 1, 1));
  map.triangles[2][0] = map.triangles[3][0] = 2;
  BOOST_TEST(!map.is_bijective());
  std::string message;
  BOOST_TEST(!FFM::internal::is_bijective(map.triangles, map.positions(), &message));
  BOOST_TEST(!message.empty());
}

BOOST_AUTO_TEST_CASE(random_maps)
{
  // A grid whose vertices are moved at random, by so much that about half of the maps without flips overlap,
  // and strips at random angles.
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int counts[2] = {0, 0};
  for(int run = 0; run < 400; ++run) {
    const double bend = 0.9 + 0.8 * uniform(generator);
    std::vector<double> angles(13, 0);
    for(int i = 1; i < 13; ++i)
      angles[i] = angles[i - 1] + bend;
    double x = 0, y = 0;
    std::vector<std::array<double, 2>> centers;
    for(double angle : angles) {
      centers.push_back({x, y});
      x += std::cos(angle) * (1 + 0.5 * uniform(generator));
      y += std::sin(angle) * (1 + 0.5 * uniform(generator));
    }
    const Map map = strip(12, false, [&](int i, int side) {
      const double w = (side == 0 ? 0.2 : -0.2) * (1 + 0.2 * uniform(generator));
      const double angle = i == 0 ? angles[0] : (angles[i] + angles[i - 1]) / 2;
      return std::array<double, 2>{{centers[i][0] - w * std::sin(angle), centers[i][1] + w * std::cos(angle)}};
    });
    bool has_flips = false;
    for(const Triangle& t : map.triangles)
      has_flips = has_flips || CGAL::orientation(map.point(t[0]), map.point(t[1]), map.point(t[2])) != CGAL::LEFT_TURN;
    const bool answer = map.is_bijective_by_pairs();
    BOOST_TEST(map.is_bijective() == answer);
    if(!has_flips)
      ++counts[answer];
  }
  BOOST_TEST_MESSAGE(counts[0] << " overlap, " << counts[1] << " do not");
  BOOST_TEST(counts[0] >= 50);
  BOOST_TEST(counts[1] >= 50);
}

BOOST_AUTO_TEST_CASE(maps_of_meshes_and_files)
{
  // The side faces of a cube, mapped by vertices or by corners.
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 8; ++i)
    v.push_back(mesh.add_vertex({double(i % 4 == 1 || i % 4 == 2), double(i % 4 >= 2), double(i / 4)}));
  FFM::Textured_mesh textured;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  auto vertex_uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  for(const auto w : mesh.vertices()) {
    const auto p = mesh.point(w);
    textured.points.push_back({p.x(), p.y(), p.z()});
    vertex_uv[w] = Point_2((2 - p.z()) * (p.x() - 0.5), (2 - p.z()) * (p.y() - 0.5));
  }
  const auto corner = [&](Mesh::Face_index f, Mesh::Vertex_index w, double x, double y) {
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      if(mesh.target(h) == w)
        uv[h] = Point_2(x, y);
  };
  for(int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    const auto f = mesh.add_face(v[i], v[j], v[4 + j]), g = mesh.add_face(v[i], v[4 + j], v[4 + i]);
    for(const auto& [face, column, row, w] :
        {std::tuple{f, 0, 0, i}, {f, 1, 0, j}, {f, 1, 1, 4 + j}, {g, 0, 0, i}, {g, 1, 1, 4 + j}, {g, 0, 1, 4 + i}})
      corner(face, v[w], i + column, row);
    textured.triangles.push_back({i, j, 4 + j});
    textured.triangles.push_back({i, 4 + j, 4 + i});
  }
  std::string message;
  BOOST_TEST(FFM::is_bijective(mesh, vertex_uv, &message)); // seen from above, in perspective
  BOOST_TEST(FFM::is_atlas_bijective(mesh, uv, &message));  // unrolled, cut at one edge
  vertex_uv[v[0]] = Point_2(3, 3);
  BOOST_TEST(!FFM::is_bijective(mesh, vertex_uv, &message));
  BOOST_TEST(!message.empty());
  // Vertex 0 and its image as a vertex of the last face, which lies upon the first one now.
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h) && mesh.face(h).idx() >= 6)
      uv[h] = Point_2(uv[h].x() - 3, uv[h].y());
  BOOST_TEST(!FFM::is_atlas_bijective(mesh, uv));

  // In files, what is the same image of the same point is the same, however often it is written.
  for(int i = 0; i < 8; ++i) {
    const auto& t = textured.triangles[i];
    std::array<int, 3> corners;
    for(int k = 0; k < 3; ++k) {
      corners[k] = static_cast<int>(textured.texture.size());
      textured.texture.push_back({double(i / 2 + (t[k] % 4 != i / 2)), double(t[k] / 4)});
    }
    textured.texture_triangles.push_back(corners);
  }
  BOOST_TEST(FFM::is_bijective(textured, &message));
  textured.texture[0][0] = 1.5;
  BOOST_TEST(!FFM::is_bijective(textured, &message));
}

BOOST_AUTO_TEST_SUITE_END() // test_is_bijective
