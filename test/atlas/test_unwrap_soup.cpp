// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// unwrap() of polygon soups: whatever people's files hold. Images are checked as polygons, with exact predicates, without knowledge
// of the triangles that they consist of.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_type_config.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_unwrap_soup)

namespace {

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = std::array<double, 3>;
using Polygon = std::vector<std::size_t>;
using Images = std::vector<std::vector<std::array<double, 2>>>;

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;

  std::size_t add(double x, double y, double z)
  {
    points.push_back({{x, y, z}});
    return points.size() - 1;
  }

  // As files without indices have it.
  Soup unwelded() const
  {
    Soup soup;
    for(const Polygon& polygon : polygons) {
      soup.polygons.emplace_back();
      for(const std::size_t v : polygon)
        soup.polygons.back().push_back(soup.add(points[v][0], points[v][1], points[v][2]));
    }
    return soup;
  }

  void append(const Soup& other, const Point& move)
  {
    const std::size_t n = points.size();
    for(const Point& p : other.points)
      add(p[0] + move[0], p[1] + move[1], p[2] + move[2]);
    for(Polygon polygon : other.polygons) {
      for(std::size_t& v : polygon)
        v += n;
      polygons.push_back(polygon);
    }
  }
};

// The image of a polygon, without corners that are at the same place as the one before.
std::vector<Exact::Point_2> ring_of(const std::vector<std::array<double, 2>>& image)
{
  std::vector<Exact::Point_2> ring;
  for(std::size_t k = 0; k < image.size(); ++k)
    if(image[k] != image[(k + image.size() - 1) % image.size()])
      ring.emplace_back(image[k][0], image[k][1]);
  return ring;
}

// Whether no two sides of polygons have more in common than ends, or than being the two sides of an edge, and no polygon is in
// another one.
bool are_disjoint(const std::vector<std::vector<Exact::Point_2>>& rings)
{
  using Segment = Exact::Segment_2;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  std::vector<Segment> sides;
  std::vector<Box> boxes, ring_boxes;
  for(std::size_t r = 0; r < rings.size(); ++r) {
    ring_boxes.emplace_back(CGAL::bbox_2(rings[r].begin(), rings[r].end()), r);
    for(std::size_t k = 0; k < rings[r].size(); ++k) {
      sides.emplace_back(rings[r][k], rings[r][(k + 1) % rings[r].size()]);
      boxes.emplace_back(sides.back().bbox(), sides.size() - 1);
    }
  }
  bool result = true;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const Segment s = sides[a.info()], t = sides[b.info()];
    if(s.target() == t.source() && s.source() == t.target())
      return;
    const bool is_touching = s.source() == t.source() || s.source() == t.target() || s.target() == t.source() || s.target() == t.target();
    if(!is_touching) {
      result = result && !CGAL::do_intersect(s, t);
      return;
    }
    result = result && s != t;
    // From the common end.
    const auto is_on = [](const Segment& segment, const Exact::Point_2& p) {
      return p != segment.source() && p != segment.target() && segment.has_on(p);
    };
    result = result && !is_on(s, t.source()) && !is_on(s, t.target()) && !is_on(t, s.source()) && !is_on(t, s.target());
  });
  CGAL::box_self_intersection_d(ring_boxes.begin(), ring_boxes.end(), [&](const Box& a, const Box& b) {
    for(const auto& [inner, outer] : {std::make_pair(a.info(), b.info()), std::make_pair(b.info(), a.info())})
      for(const Exact::Point_2& p : rings[inner])
        result = result && CGAL::bounded_side_2(rings[outer].begin(), rings[outer].end(), p) != CGAL::ON_BOUNDED_SIDE;
  });
  return result;
}

struct Atlas
{
  FFM::Unwrap_summary summary;
  Images images;
  std::vector<int> charts;
};

// Unwraps, and checks everything that an atlas must be.
Atlas checked(const Soup& soup, std::int64_t without_area = 0)
{
  Atlas atlas;
  atlas.charts.assign(soup.polygons.size(), -2);
  atlas.summary = FFM::unwrap(soup.points, soup.polygons, atlas.images, FFM::parameters::face_chart_map(atlas.charts.data()));
  BOOST_TEST_REQUIRE(atlas.summary.is_valid(), atlas.summary.message);
  BOOST_TEST_REQUIRE(atlas.images.size() == soup.polygons.size());
  BOOST_TEST(atlas.summary.faces == static_cast<std::int64_t>(soup.polygons.size()));
  BOOST_TEST(atlas.summary.faces_without_area == without_area);
  BOOST_TEST(atlas.summary.flips == 0);
  bool is_simple = true, is_positive = true, is_inside = true;
  std::vector<std::vector<Exact::Point_2>> rings;
  std::vector<std::int64_t> sizes(atlas.summary.charts.size(), 0);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    BOOST_TEST_REQUIRE(atlas.images[p].size() == soup.polygons[p].size());
    for(const auto& q : atlas.images[p])
      is_inside = is_inside && q[0] >= 0 && q[0] <= 1 && q[1] >= 0 && q[1] <= 1;
    BOOST_TEST_REQUIRE((atlas.charts[p] >= -1 && atlas.charts[p] < static_cast<int>(sizes.size())));
    if(atlas.charts[p] < 0)
      continue;
    ++sizes[atlas.charts[p]];
    rings.push_back(ring_of(atlas.images[p]));
    is_simple = is_simple && CGAL::is_simple_2(rings.back().begin(), rings.back().end());
    is_positive = is_positive && is_simple && CGAL::orientation_2(rings.back().begin(), rings.back().end()) == CGAL::COUNTERCLOCKWISE;
  }
  BOOST_TEST(is_inside);
  BOOST_TEST(is_simple);
  BOOST_TEST(is_positive);
  BOOST_TEST(are_disjoint(rings));
  for(std::size_t c = 0; c < sizes.size(); ++c)
    BOOST_TEST(atlas.summary.charts[c].faces == sizes[c]);
  return atlas;
}

// Whether the common edge of two polygons has one image.
bool is_joined(const Soup& soup, const Atlas& atlas, std::size_t p, std::size_t q)
{
  int common = 0;
  for(std::size_t i = 0; i < soup.polygons[p].size(); ++i)
    for(std::size_t j = 0; j < soup.polygons[q].size(); ++j)
      common += soup.points[soup.polygons[p][i]] == soup.points[soup.polygons[q][j]] && atlas.images[p][i] == atlas.images[q][j];
  return common >= 2;
}

Soup sheet(int columns, int rows, double height = 0)
{
  Soup soup;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i)
      soup.add(i, j, height * std::sin(1.3 * i + 0.7 * j * j));
  for(std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j)
    for(std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) {
      const std::size_t v = j * (columns + 1) + i;
      soup.polygons.push_back({v, v + 1, v + columns + 2, v + columns + 1});
    }
  return soup;
}

// The surface of some cells of a grid, of quads, which may meet along edges and at corners. `noise` makes them crooked.
template <typename IsSolid>
Soup voxels(int n, const IsSolid& is_solid, double noise = 0)
{
  Soup soup;
  std::mt19937 random(5);
  for(int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
    const auto moved = [&](int c) { return c + noise * (random() / 4294967296. - 0.5); };
    const double x = moved(i % (n + 1)), y = moved(i / (n + 1) % (n + 1)), z = moved(i / (n + 1) / (n + 1));
    soup.add(x, y, z);
  }
  const auto index = [n](std::array<int, 3> p) { return static_cast<std::size_t>(p[0] + (n + 1) * (p[1] + (n + 1) * p[2])); };
  const auto solid = [&](std::array<int, 3> p) {
    return *std::min_element(p.begin(), p.end()) >= 0 && *std::max_element(p.begin(), p.end()) < n && is_solid(p[0], p[1], p[2]);
  };
  for(int i = 0; i < n * n * n; ++i) {
    const std::array<int, 3> cell{{i % n, i / n % n, i / n / n}};
    if(!solid(cell))
      continue;
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side) {
        std::array<int, 3> other = cell;
        other[axis] += 2 * side - 1;
        if(solid(other))
          continue;
        std::array<int, 3> a = cell;
        a[axis] += side;
        std::array<int, 3> b = a, c = a, d = a;
        ++b[(axis + 1) % 3];
        ++c[(axis + 1) % 3];
        ++c[(axis + 2) % 3];
        ++d[(axis + 2) % 3];
        soup.polygons.push_back({index(a), index(b), index(c), index(d)});
        if(side == 0)
          std::reverse(soup.polygons.back().begin(), soup.polygons.back().end());
      }
  }
  return soup;
}

Soup cube()
{
  return voxels(1, [](int, int, int) { return true; });
}

} // namespace

BOOST_AUTO_TEST_CASE(polygons_of_all_shapes)
{
  const Atlas box = checked(cube());
  BOOST_TEST(std::abs(box.summary.energy - 1) <= 1e-6);

  // A plate with the outlines of letters and stars, thick: concave faces, planar.
  for(const std::vector<std::array<double, 2>>& outline :
      {std::vector<std::array<double, 2>>{{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1}}, {{1, 4}}, {{0, 4}}},
       std::vector<std::array<double, 2>>{
         {{0, 0}}, {{5, 0}}, {{5, 4}}, {{4, 4}}, {{4, 1}}, {{1, 1}}, {{1, 3}}, {{3, 3}}, {{3, 4}}, {{0, 4}}}}) {
    Soup plate;
    const std::size_t n = outline.size();
    for(int z = 0; z < 2; ++z)
      for(const auto& p : outline)
        plate.add(p[0], p[1], z);
    Polygon bottom, top;
    for(std::size_t i = 0; i < n; ++i) {
      top.push_back(n + i);
      bottom.push_back(n - 1 - i);
      plate.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    plate.polygons.push_back(bottom);
    plate.polygons.push_back(top);
    const Atlas atlas = checked(plate);
    BOOST_TEST(std::abs(atlas.summary.energy - 1) <= 1e-6);
  }

  // Stars of so many corners that the best triangles are not looked for; alone, with an energy that tells the shape.
  for(const int n : {10, 200}) {
    Soup star;
    star.polygons.emplace_back();
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n, radius = i % 2 == 0 ? 1 : 0.6;
      star.polygons[0].push_back(star.add(radius * std::cos(angle), radius * std::sin(angle), 0.5 * radius * std::cos(angle)));
    }
    BOOST_TEST(std::abs(checked(star).summary.energy - 1) <= 1e-6);
  }

  // Crooked quads, and crooked polygons of eight corners over the whole of a sheet.
  checked(sheet(9, 7, 0.3));
  Soup large;
  const int n = 8;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      large.add(i, j, 0.4 * std::sin(1.1 * i) * std::cos(0.9 * j));
  for(std::size_t j = 0; j < n; j += 2)
    for(std::size_t i = 0; i < n; i += 2) {
      const std::size_t v = j * (n + 1) + i, w = v + 2 * (n + 1);
      large.polygons.push_back({v, v + 1, v + 2, v + 2 + n + 1, w + 2, w + 1, w, v + n + 1});
    }
  checked(large);
}

BOOST_AUTO_TEST_CASE(polygons_that_cannot_be_laid_flat_as_they_are)
{
  // A ramp of more than two turns in one polygon overlaps itself when it is unrolled; a quad that crosses itself; a ring that is
  // closed by an edge which it passes twice; a polygon that comes back along its own side.
  Soup ramp;
  ramp.polygons.emplace_back();
  const int n = 30;
  for(int i = 0; i < 2 * n; ++i) {
    const double angle = 5 * CGAL_PI * (i < n ? i : 2 * n - 1 - i) / (n - 1), radius = i < n ? 2 : 1;
    ramp.polygons[0].push_back(ramp.add(radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle));
  }
  checked(ramp);
  Soup odd;
  odd.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
  odd.polygons = {{0, 2, 1, 3}};
  checked(odd);
  for(const int corners : {5, 101, 501}) {
    Soup star;
    star.polygons.emplace_back();
    for(int i = 0; i < corners; ++i) {
      const double angle = 4 * CGAL_PI * i / corners;
      star.polygons[0].push_back(star.add(std::cos(angle), std::sin(angle), 0));
    }
    checked(star);
  }
  Soup ring;
  for(int i = 0; i < 4; ++i)
    ring.add(i % 3 == 0 ? -2 : 2, i < 2 ? -2 : 2, 0);
  for(int i = 0; i < 4; ++i)
    ring.add(i % 3 == 0 ? -1 : 1, i < 2 ? -1 : 1, 0);
  ring.polygons = {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}};
  checked(ring);
  ring.polygons = {{0, 1, 5, 1, 2, 3}};
  checked(ring);
  // With the hole filled the image passes the end of the edge twice.
  ring.polygons = {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, {4, 5, 6, 7}};
  Atlas filled;
  filled.summary = FFM::unwrap(ring.points, ring.polygons, filled.images);
  BOOST_TEST_REQUIRE(filled.summary.is_valid(), filled.summary.message);
  const std::vector<Exact::Point_2> outer = ring_of(filled.images[0]), inner = ring_of(filled.images[1]);
  BOOST_TEST(CGAL::polygon_area_2(outer.begin(), outer.end(), Exact()) > 0);
  BOOST_TEST(CGAL::orientation_2(inner.begin(), inner.end()) == CGAL::COUNTERCLOCKWISE);
}

BOOST_AUTO_TEST_CASE(diagonals_double_no_edge)
{
  // A quad before two triangles, whose common edge is between two corners of the quad; and two quads before each other.
  Soup soup;
  soup.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}, {{0.5, 0.5, -1}}};
  soup.polygons = {{0, 1, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  BOOST_TEST(checked(soup).summary.charts.size() == 1u);
  soup.polygons = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  BOOST_TEST(checked(soup).summary.charts.size() == 1u);
  // Two faces that have two edges in common, whose middle point no other face has.
  soup.polygons = {{0, 1, 2, 3}, {2, 1, 0, 4}};
  BOOST_TEST(checked(soup).summary.charts.size() == 1u);
  // All edges between four points are there.
  soup.points[2] = {{1, 1, 1}};
  soup.polygons = {{0, 1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {1, 3, 0}, {1, 2, 3}};
  checked(soup);
}

BOOST_AUTO_TEST_CASE(the_same_surface_without_indices)
{
  for(const Soup& soup : {cube(), sheet(6, 5, 0.2),
                          voxels(
                            3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; }, 0.3)}) {
    const Atlas a = checked(soup), b = checked(soup.unwelded());
    BOOST_TEST(a.summary.charts.size() == b.summary.charts.size());
    BOOST_TEST(a.summary.energy == b.summary.energy);
    BOOST_TEST((a.images == b.images));
    BOOST_TEST(b.summary.parted_edges == 0);
  }
  // Both zeros are the same place.
  Soup zeros;
  zeros.points = {{{0., 0., 0.}}, {{1, 0., 0.}}, {{0., 1, 0.}}, {{-0., -0., -0.}}, {{-0., 1, 0.}}, {{-1, 0., 0.}}};
  zeros.polygons = {{0, 1, 2}, {3, 4, 5}};
  BOOST_TEST(checked(zeros).summary.charts.size() == 1u);
}

BOOST_AUTO_TEST_CASE(sheets_that_meet)
{
  const auto along_edge = [](int x, int y, int z) { return z == 0 && x == y; };
  const auto at_corner = [](int x, int y, int z) { return x == y && y == z; };
  const Atlas edge = checked(voxels(2, along_edge));
  BOOST_TEST(edge.summary.parted_edges == 1);
  BOOST_TEST(edge.summary.cut.components == 2);
  BOOST_TEST(edge.summary.cut.genus == 0);
  BOOST_TEST(checked(voxels(2, at_corner)).summary.cut.components == 2);
  // Without indices, too: what bounds a solid is one surface.
  const Atlas soup = checked(voxels(2, along_edge).unwelded());
  BOOST_TEST(soup.summary.cut.components == 2);
  BOOST_TEST(soup.summary.cut.borders == 0);
  // Two cubes with a face in common are two surfaces if they are written so.
  Soup face = cube();
  face.append(cube(), {{1, 0, 0}});
  BOOST_TEST(checked(face).summary.cut.components == 2);
  BOOST_TEST(checked(face.unwelded()).summary.cut.borders == 0);
  // Three and five half planes at an edge, and a sheet that stands on the middle of another.
  for(const int n : {3, 5}) {
    Soup fan;
    fan.add(0, 0, 0);
    fan.add(0, 0, 1);
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n;
      const std::size_t v = fan.add(std::cos(angle), std::sin(angle), 0), w = fan.add(std::cos(angle), std::sin(angle), 1);
      fan.polygons.push_back(i % 2 == 0 ? Polygon{0, v, w, 1} : Polygon{0, 1, w, v});
    }
    const Atlas atlas = checked(fan);
    BOOST_TEST(atlas.summary.parted_edges == 1);
    BOOST_TEST(atlas.summary.cut.components == (n + 1) / 2);
  }
  Soup standing;
  standing.points = {{{0, 0, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{-1, 0, 0}}, {{-1, 1, 0}}, {{0, 0, 1}}, {{0, 1, 1}}};
  standing.polygons = {{0, 1, 7, 6}, {0, 2, 3, 1}, {1, 5, 4, 0}};
  const Atlas flat = checked(standing);
  BOOST_TEST(is_joined(standing, flat, 1, 2));
  // Shells of quads that touch in all ways, crooked ones, of any genus.
  for(unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    std::vector<bool> is_solid;
    for(int i = 0; i < 27; ++i)
      is_solid.push_back(random() % 2 == 0);
    const Soup shells = voxels(
      3, [&](int x, int y, int z) { return is_solid[x + 3 * (y + 3 * z)]; }, 0.2 * (seed % 3));
    const Atlas atlas = checked(shells);
    BOOST_TEST(atlas.summary.cut.borders == 0);
  }
}

BOOST_AUTO_TEST_CASE(windings)
{
  // A face that is turned over is a chart of its own, and no image is mirrored.
  Soup turned = sheet(5, 5, 0.1);
  std::reverse(turned.polygons[12].begin(), turned.polygons[12].end());
  const Atlas atlas = checked(turned);
  BOOST_TEST(atlas.summary.parted_edges == 4);
  for(std::size_t p = 0; p < turned.polygons.size(); ++p)
    BOOST_TEST((p == 12 || atlas.charts[p] != atlas.charts[12]));

  // Sheets with two sides: the sides are two surfaces, or one that is folded.
  Soup two = sheet(4, 3, 0.2), back = two;
  for(Polygon& polygon : back.polygons)
    std::reverse(polygon.begin(), polygon.end());
  two.append(back, {{0, 0, 0}});
  const Atlas sides = checked(two);
  BOOST_TEST(sides.summary.energy < 1.02);
  for(Polygon& polygon : back.polygons)
    two.polygons[&polygon - back.polygons.data() + back.polygons.size()] = polygon;
  const Atlas same_points = checked(two);
  BOOST_TEST(same_points.summary.energy < 1.02);
  // Neighbours are neighbours on the same side.
  BOOST_TEST(same_points.summary.cut.components <= 2);

  // A Moebius band is cut once.
  Soup band;
  const int n = 24;
  for(int i = 0; i < n; ++i)
    for(const double t : {-0.3, 0.3}) {
      const double angle = 2 * CGAL_PI * i / n, r = 1 + t * std::cos(angle / 2);
      band.add(r * std::cos(angle), r * std::sin(angle), t * std::sin(angle / 2));
    }
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, b = 2 * i + 1;
    band.polygons.push_back(i + 1 < n ? Polygon{a, b, b + 2, a + 2} : Polygon{a, b, 0, 1});
  }
  BOOST_TEST(checked(band).summary.parted_edges == 1);
}

BOOST_AUTO_TEST_CASE(faces_without_area)
{
  // Needles and caps on an edge between good faces; faces with a corner twice, all corners at a place, or less than three corners.
  Soup soup = sheet(4, 4);
  for(Point& p : soup.points)
    p = {{p[0] * 0.1, p[1] * 0.4, 0.3 * p[0]}};
  const std::size_t n = soup.polygons.size();
  soup.polygons.push_back({0, 1, 1});
  soup.polygons.push_back({7, 7, 7, 7});
  soup.polygons.push_back({3, 4});
  soup.polygons.push_back({});
  const std::size_t again = soup.add(soup.points[8][0], soup.points[8][1], soup.points[8][2]);
  soup.polygons.push_back({8, 9, again});
  const Atlas atlas = checked(soup, 5);
  BOOST_TEST((atlas.summary.first_faces_without_area == std::vector<std::int64_t>{16, 17, 18, 19, 20}));
  BOOST_TEST(atlas.summary.charts.size() == 1u);
  BOOST_TEST(atlas.summary.message.find("16, 17, 18, 19, 20") != std::string::npos);
  BOOST_TEST((atlas.images[n][1] == atlas.images[n][2]));
  BOOST_TEST((atlas.images[n][0] == atlas.images[0][0]));

  // A needle between two faces that are neighbours without it, and a cap that makes a vertex on an edge fit: no seam opens.
  Soup cap;
  cap.points = {{{0, 0, 0}}, {{1, 0.1, 0.3}}, {{0.5, 0.05, 0.15}}, {{0, 1, 0}}, {{0.5, -1, 0.4}}};
  cap.polygons = {{0, 1, 3}, {0, 4, 2}, {2, 4, 1}, {0, 2, 1}};
  const Atlas whole = checked(cap, 1);
  BOOST_TEST(whole.summary.charts.size() == 1u);
  BOOST_TEST(whole.summary.seam_edges == 0);
  BOOST_TEST(whole.summary.energy < 1.01);

  // In numbers of single precision, and with a cap that is very thin before it is nothing.
  for(const double place : {0.5, 1e-6, 1e-12}) {
    for(int i = 0; i < 3; ++i)
      cap.points[2][i] = cap.points[0][i] + place * (cap.points[1][i] - cap.points[0][i]);
    std::vector<std::array<std::array<float, 2>, 3>> images;
    const FFM::Unwrap_summary summary = FFM::unwrap(cap.points, cap.polygons, images);
    BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
    BOOST_TEST(summary.charts.size() == 1u);
    std::vector<std::vector<Exact::Point_2>> rings;
    for(const auto& image : images) {
      rings.emplace_back();
      for(const auto& q : image)
        rings.back().emplace_back(q[0], q[1]);
      BOOST_TEST(CGAL::orientation(rings.back()[0], rings.back()[1], rings.back()[2]) == CGAL::LEFT_TURN);
    }
    BOOST_TEST(are_disjoint(rings));
  }

  // A fan whose corners are all on a line, as programs make it of an edge with vertices on it; and nothing but a line.
  for(const bool is_alone : {false, true}) {
    Soup fan;
    const std::size_t m = 30;
    for(std::size_t i = 0; i <= m; ++i)
      fan.add(0.1 * i, 0.3 * i, 0.7 * i);
    for(std::size_t i = 1; i < m; ++i)
      fan.polygons.push_back({0, i, i + 1});
    if(!is_alone) {
      const std::size_t top = fan.add(5, 0, 0);
      fan.polygons.push_back({0, m, top});
    }
    checked(fan, m - 1);
  }

  // A polygon with corners on its sides has an area, however it is cut to triangles.
  Soup sides;
  for(int i = 0; i <= 6; ++i)
    sides.add(0.1 * i, 0.3 * i, 0);
  sides.add(1, 0, 0);
  sides.polygons = {{7, 6, 5, 4, 3, 2, 1, 0}};
  BOOST_TEST(std::abs(checked(sides).summary.energy - 1) <= 1e-6);

  // Nothing that can be mapped.
  soup.polygons = {{0, 1, 1}, {2, 2, 3}};
  Images images;
  const FFM::Unwrap_summary nothing = FFM::unwrap(soup.points, soup.polygons, images);
  BOOST_TEST(FFM::status_name(nothing.status) == FFM::status_name(Status::degenerate_rest_element));
  BOOST_TEST(images.empty());
}

BOOST_AUTO_TEST_CASE(duplicated_faces_and_isolated_points)
{
  Soup soup = cube();
  soup.add(7, 8, 9);
  soup.add(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  soup.polygons.push_back(soup.polygons[2]);
  const Atlas atlas = checked(soup);
  BOOST_TEST(atlas.summary.charts.size() >= 2u);
  BOOST_TEST(atlas.charts[6] != atlas.charts[2]);
  BOOST_TEST(atlas.summary.cut.components == 2);
  // All faces twice.
  Soup twice = sheet(5, 4, 0.2);
  const std::vector<Polygon> once = twice.polygons;
  twice.polygons.insert(twice.polygons.end(), once.begin(), once.end());
  const Atlas both = checked(twice);
  BOOST_TEST(both.summary.cut.components == 2);
}

BOOST_AUTO_TEST_CASE(soups_without_order)
{
  std::mt19937 random(11);
  const auto number = [&random] { return random() / 4294967296.; };
  // Triangles with nothing in common.
  Soup apart;
  for(int i = 0; i < 300; ++i) {
    Polygon polygon;
    for(int k = 0; k < 3; ++k)
      polygon.push_back(apart.add(number(), number(), number()));
    apart.polygons.push_back(polygon);
  }
  BOOST_TEST(checked(apart).summary.charts.size() == 300u);
  // Polygons with all in common.
  for(int trial = 0; trial < 20; ++trial) {
    Soup wild;
    const std::size_t points = 4 + random() % 12;
    for(std::size_t i = 0; i < points; ++i)
      wild.add(std::floor(4 * number()), std::floor(4 * number()), std::floor(3 * number()));
    for(int i = 0; i < 15; ++i) {
      wild.polygons.emplace_back();
      for(std::size_t k = 0; k < 3 + random() % 5; ++k)
        wild.polygons.back().push_back(random() % points);
    }
    Images images;
    const FFM::Unwrap_summary summary = FFM::unwrap(wild.points, wild.polygons, images);
    BOOST_TEST_CONTEXT("trial " << trial) { checked(wild, summary.faces_without_area); }
  }
  // Thousands of tiny shells.
  Soup shells;
  for(int i = 0; i < 3000; ++i) {
    const std::size_t v = shells.points.size();
    const double x = 10 * number(), y = 10 * number(), z = 10 * number();
    shells.add(x, y, z);
    for(int k = 0; k < 3; ++k)
      shells.add(x + 0.01 * (k == 0), y + 0.01 * (k == 1), z + 0.01 * (k == 2));
    shells.polygons.push_back({v, v + 2, v + 1});
    shells.polygons.push_back({v, v + 3, v + 2});
    shells.polygons.push_back({v, v + 1, v + 3});
    shells.polygons.push_back({v + 1, v + 2, v + 3});
  }
  checked(shells);
}

BOOST_AUTO_TEST_CASE(seams_of_the_user)
{
  // All edges of a cube, by pairs of indices.
  const Soup soup = cube();
  Images images;
  using Key = std::pair<std::size_t, std::size_t>;
  const auto all = boost::make_function_property_map<Key>([](const Key& key) { return key.first < key.second; });
  const FFM::Unwrap_summary summary = FFM::unwrap(soup.points, soup.polygons, images, CGAL::parameters::edge_is_constrained_map(all));
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  BOOST_TEST(summary.charts.size() == 6u);
  BOOST_TEST(summary.seam_edges == 12);
}

BOOST_AUTO_TEST_CASE(meshes_of_polygons)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  const Soup soup = voxels(
    3, [](int x, int y, int z) { return x == 1 || y == 1 || z == 1; }, 0.3);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(const Point& p : soup.points)
    vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for(const Polygon& polygon : soup.polygons) {
    std::vector<Mesh::Vertex_index> corners;
    for(const std::size_t v : polygon)
      corners.push_back(vertices[v]);
    BOOST_TEST_REQUIRE(mesh.add_face(corners).is_valid());
  }
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const FFM::Unwrap_summary summary =
    FFM::unwrap(mesh, uv, FFM::Unwrap_options(), FFM::parameters::edge_is_seam_map(seams, CGAL::parameters::default_values()));
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  std::vector<std::vector<Exact::Point_2>> rings;
  for(const auto f : mesh.faces()) {
    rings.emplace_back();
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      rings.back().emplace_back(uv[h].x(), uv[h].y());
    BOOST_TEST_REQUIRE(CGAL::is_simple_2(rings.back().begin(), rings.back().end()));
    BOOST_TEST(CGAL::orientation_2(rings.back().begin(), rings.back().end()) == CGAL::COUNTERCLOCKWISE);
  }
  BOOST_TEST(are_disjoint(rings));
  std::int64_t number = 0;
  for(const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e), g = mesh.opposite(h);
    const bool is_seam = uv[h] != uv[mesh.prev(g)] || uv[g] != uv[mesh.prev(h)];
    BOOST_TEST(seams[e] == is_seam);
    number += is_seam;
  }
  BOOST_TEST(summary.seam_edges == number);
}

BOOST_AUTO_TEST_CASE(refused)
{
  const auto expect = [](const Soup& soup, Status status, const std::string& part, bool is_strict = false) {
    Images images(1);
    FFM::Unwrap_options options;
    options.strict = is_strict;
    const FFM::Unwrap_summary summary = FFM::unwrap(soup.points, soup.polygons, images, FFM::parameters::unwrap_options(options));
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST(summary.message.find(part) != std::string::npos, summary.message);
    BOOST_TEST((images.size() == 1 && images[0].empty()));
  };
  Soup soup = sheet(3, 3);
  soup.points[6][1] = std::numeric_limits<double>::infinity();
  expect(soup, Status::non_finite_input, "corner 2 of face number 1, point number 6,");
  soup = sheet(3, 3);
  soup.polygons[4][1] = 16;
  expect(soup, Status::invalid_option, "face number 4 has the vertex 16, but there are 16 points");
  expect(Soup(), Status::empty_mesh, "no faces");
  for(Point& p : soup.points)
    p = {{1, 2, 3}};
  soup.polygons.resize(3);
  expect(soup, Status::degenerate_rest_element, "coincide");

  // What else is taken is refused on request.
  expect(sheet(3, 3), Status::not_triangular, "face number 0", true);
  soup.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}};
  soup.polygons = {{0, 1, 2}, {0, 3, 4}};
  expect(soup, Status::non_manifold, "several sheets", true);
  soup.polygons = {{0, 1, 2}, {0, 1, 5}};
  expect(soup, Status::non_manifold, "face number 1", true);
  soup.polygons = {{0, 1, 2}, {0, 3, 3}};
  expect(soup, Status::non_manifold, "face number 1", true);
  soup.polygons = {{0, 1, 2}, {0, 1, 3}};
  std::swap(soup.polygons[1][0], soup.polygons[1][1]);
  expect(soup, Status::degenerate_rest_element, "face number 1", true);
  soup.polygons = {{0, 1, 2}};
  std::vector<std::array<std::array<double, 2>, 3>> triples;
  BOOST_TEST(FFM::unwrap(soup.points, soup.polygons, triples).is_valid());
  BOOST_TEST(triples.size() == 1u);
  soup.polygons = {{0, 1, 2, 3}};
  const FFM::Unwrap_summary summary = FFM::unwrap(soup.points, soup.polygons, triples);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::invalid_option));
}

BOOST_AUTO_TEST_SUITE_END() // test_unwrap_soup
