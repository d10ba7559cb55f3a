// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// unwrap() and pack_charts().

#include "support/unit_test.h"

#include "support/dense_algebra.h"

#include "atlas/atlas_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/internal/for_each_index_watched.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/pack_charts.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_unwrap)

using namespace test_support;
using FFM::Status;
using Float_point_2 = CGAL::Simple_cartesian<float>::Point_2;

// The borders of different charts keep a distance from each other, and half of it from the sides of the square.
static void check_distances(const Atlas_surface& surface, double distance)
{
  using Segment = CGAL::Simple_cartesian<double>::Segment_2;
  std::vector<std::pair<int, Segment>> borders;
  double least = std::numeric_limits<double>::infinity();
  for(const Halfedge h : surface.mesh.halfedges())
    if(!surface.mesh.is_border(h) && (surface.seam[surface.mesh.edge(h)] || surface.mesh.is_border(surface.mesh.opposite(h)))) {
      borders.emplace_back(surface.chart[surface.mesh.face(h)], Segment(surface.uv[surface.mesh.prev(h)], surface.uv[h]));
      const Point_2 p = surface.uv[h];
      least = (std::min)({least, 2 * p.x(), 2 * p.y(), 2 * (1 - p.x()), 2 * (1 - p.y())});
    }
  for(std::size_t i = 0; i < borders.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(borders[i].first != borders[j].first)
        least = (std::min)(least, std::sqrt(CGAL::squared_distance(borders[i].second, borders[j].second)));
  BOOST_TEST(least >= distance * (1 - 1e-6));
}

BOOST_AUTO_TEST_CASE(closed_surfaces_of_every_genus)
{
  for(int genus : {0, 1, 2, 5}) {
    Atlas_surface surface(genus == 0 ? ball_soup() : plate_soup(genus));
    const FFM::Unwrap_summary summary = surface.unwrap();
    BOOST_TEST_CONTEXT("genus " << genus)
    {
      check_atlas(surface, summary);
      BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::success));
      BOOST_TEST(summary.cut.genus == genus);
      BOOST_TEST(summary.energy < 1.5);
      BOOST_TEST(summary.occupancy > 0.15);
    }
  }
}

BOOST_AUTO_TEST_CASE(components_and_holes)
{
  Atlas_surface several(together(together(ball_soup(), plate_soup(1)), sheet_soup(6, 5, {{2, 2}, {4, 1}})));
  const FFM::Unwrap_summary summary = several.unwrap();
  check_atlas(several, summary);
  BOOST_TEST(summary.charts.size() >= 3u);

  // A flat sheet with many holes needs no seam.
  std::set<std::array<int, 2>> holes;
  for(int i = 0; i < 9; ++i)
    for(int j = 0; j < 9; ++j)
      if(i % 2 == 1 && j % 2 == 1)
        holes.insert({i, j});
  Soup soup = sheet_soup(9, 9, holes);
  for(auto& p : soup.points)
    p = Mesh::Point(p.x(), p.y(), 0);
  Atlas_surface flat(soup);
  const FFM::Unwrap_summary isometric = flat.unwrap();
  check_atlas(flat, isometric);
  BOOST_TEST(isometric.seam_edges == 0);
  BOOST_TEST(isometric.energy <= 1 + 1e-4);
  // A tube has two borders, too, but must be cut.
  soup = voxel_soup(3, 3, 6, [](int, int, int) { return true; });
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(),
                                      [&](const std::array<int, 3>& t) {
                                        const double z = soup.points[t[0]].z();
                                        return z == soup.points[t[1]].z() && z == soup.points[t[2]].z();
                                      }),
                       soup.triangles.end());
  Atlas_surface tube(soup);
  const FFM::Unwrap_summary unrolled = tube.unwrap();
  check_atlas(tube, unrolled);
  BOOST_TEST(unrolled.seam_edges == 6);
  BOOST_TEST(std::abs(unrolled.energy - 1) <= 1e-6);
}

BOOST_AUTO_TEST_CASE(splits)
{
  // A band that is rolled up on a cone's surface overlaps itself when it is laid flat:
  // 18 right triangles' worth of angle around a point.
  Soup soup;
  const int n = 60;
  for(int i = 0; i <= n; ++i)
    for(int side = 0; side < 2; ++side) {
      // A helix with steps so steep that the angle around the axis in the developed surface is 2.5 turns.
      const double angle = 5 * CGAL_PI * i / n, radius = 1 + side;
      soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle);
    }
  for(int i = 0; i < n; ++i) {
    const int a = 2 * i;
    soup.triangles.push_back({a, a + 1, a + 2});
    soup.triangles.push_back({a + 2, a + 1, a + 3});
  }
  Atlas_surface ramp(soup);
  const FFM::Unwrap_summary summary = ramp.unwrap();
  check_atlas(ramp, summary);
  BOOST_TEST(summary.splits_of_overlaps >= 1);
  BOOST_TEST(summary.charts.size() >= 3u);
  BOOST_TEST(summary.charts.size() <= 8u);

  // Distortion is bounded on request.
  FFM::Unwrap_options options;
  options.cut.branches = FFM::Cut_options::Branches::none;
  options.max_distortion = std::numeric_limits<double>::infinity();
  Atlas_surface free(ball_soup()), bounded(ball_soup());
  const FFM::Unwrap_summary whole = free.unwrap(options);
  check_atlas(free, whole);
  options.max_distortion = 1.03;
  options.crease_angle = std::numeric_limits<double>::infinity();
  const FFM::Unwrap_summary parts = bounded.unwrap(options);
  check_atlas(bounded, parts);
  BOOST_TEST(whole.energy > 1.03);
  BOOST_TEST(parts.splits_of_distortion >= 1);
  for(const FFM::Chart_summary& chart : parts.charts)
    BOOST_TEST(chart.energy <= 1.03);
}

// A sphere with a hole at a pole.
static Soup open_sphere_soup()
{
  Soup soup;
  const int around = 24, rings = 18;
  for(int j = 1; j <= rings; ++j)
    for(int i = 0; i < around; ++i) {
      const double latitude = CGAL_PI * j / (rings + 1), longitude = 2 * CGAL_PI * i / around;
      soup.points.emplace_back(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    }
  soup.points.emplace_back(0, 0, 1);
  for(int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    soup.triangles.push_back({around * rings, i, next});
    for(int j = 0; j + 1 < rings; ++j) {
      const int a = around * j + i, b = around * j + next;
      soup.triangles.push_back({a, a + around, b + around});
      soup.triangles.push_back({a, b + around, b});
    }
  }
  return soup;
}

BOOST_AUTO_TEST_CASE(distortion_is_bounded_by_default)
{
  // Disks, too.
  Atlas_surface open(open_sphere_soup());
  FFM::Unwrap_options options;
  options.max_distortion = std::numeric_limits<double>::infinity();
  const FFM::Unwrap_summary whole = open.unwrap(options);
  check_atlas(open, whole);
  BOOST_TEST(whole.charts.size() == 1u);
  BOOST_TEST(whole.energy > 1.5);
  const FFM::Unwrap_summary bounded = open.unwrap();
  check_atlas(open, bounded);
  for(const FFM::Chart_summary& chart : bounded.charts)
    BOOST_TEST(chart.energy <= 1.025);
}

// The part of a chart's area that no direction is stretched or compressed in by more than the given factor, by the lengths on the
// surface of the images of the directions (1, 0) and (0, 1).
static double part_within(const Atlas_surface& surface, const FFM::Unwrap_summary& summary, int chart, double factor)
{
  double within = 0, area = 0;
  for(const auto f : surface.mesh.faces()) {
    if(surface.chart[f] != chart)
      continue;
    const Halfedge h = surface.mesh.halfedge(f);
    const auto point = [&](Halfedge g) {
      const Mesh::Point p = surface.mesh.point(surface.mesh.target(g));
      return Eigen::Vector3d(p.x(), p.y(), p.z());
    };
    const auto image = [&](Halfedge g) { return Eigen::Vector2d(surface.uv[g].x() / summary.scale, surface.uv[g].y() / summary.scale); };
    Eigen::Matrix<double, 3, 2> edges;
    Eigen::Matrix2d images;
    edges << point(surface.mesh.next(h)) - point(h), point(surface.mesh.prev(h)) - point(h);
    images << image(surface.mesh.next(h)) - image(h), image(surface.mesh.prev(h)) - image(h);
    const Eigen::Matrix<double, 3, 2> back = edges * images.inverse();
    const Eigen::VectorXd squares = eigenvalues(back.transpose() * back);
    const double face_area = edges.col(0).cross(edges.col(1)).norm() / 2;
    area += face_area;
    if(squares[0] >= 1 / (factor * factor) && squares[1] <= factor * factor)
      within += face_area;
  }
  return within / area;
}

BOOST_AUTO_TEST_CASE(stretch_is_bounded)
{
  Atlas_surface sphere(open_sphere_soup());
  FFM::Unwrap_options options;
  options.max_distortion = std::numeric_limits<double>::infinity();
  const FFM::Unwrap_summary whole = sphere.unwrap(options);
  BOOST_TEST_REQUIRE(whole.charts.size() == 1u);
  // Charts are measured after the scaling that suits them best, which is that of the atlas but for the tolerance of the minimiser.
  const double tolerance = 1.005;
  BOOST_TEST(part_within(sphere, whole, 0, whole.charts[0].stretch_95 / tolerance) < 0.95);
  BOOST_TEST(part_within(sphere, whole, 0, whole.charts[0].stretch_95 * tolerance) >= 0.95);
  BOOST_TEST(part_within(sphere, whole, 0, 1.2) < 0.95);
  options.max_stretch = 1.15;
  const FFM::Unwrap_summary bounded = sphere.unwrap(options);
  check_atlas(sphere, bounded);
  for(std::size_t i = 0; i < bounded.charts.size(); ++i) {
    BOOST_TEST(bounded.charts[i].stretch_95 <= 1.15);
    BOOST_TEST(part_within(sphere, bounded, static_cast<int>(i), 1.15 * tolerance) >= 0.95);
  }
}

BOOST_AUTO_TEST_CASE(sharp_edges_are_seams)
{
  // A ridged sheet turns by 60 degrees at each ridge.
  Soup soup = sheet_soup(10, 5, {});
  for(auto& p : soup.points)
    p = Mesh::Point(p.x() * 0.5, p.y(), std::sqrt(0.75) * (std::lround(p.x()) % 2));
  Atlas_surface ridged(soup);
  FFM::Unwrap_options options;
  BOOST_TEST(ridged.unwrap(options).charts.size() == 1u);
  options.seam_angle = 119 * CGAL_PI / 180;
  const FFM::Unwrap_summary summary = ridged.unwrap(options);
  check_atlas(ridged, summary);
  BOOST_TEST(summary.charts.size() == 10u);
  BOOST_TEST(summary.seam_edges == 9 * 5);
  options.seam_angle = 121 * CGAL_PI / 180;
  BOOST_TEST(ridged.unwrap(options).charts.size() == 1u);
}

BOOST_AUTO_TEST_CASE(charts_are_split_for_packing)
{
  // An L of two long arms leaves most of any square empty; its halves lie side by side.
  std::set<std::array<int, 2>> missing;
  for(int i = 2; i < 16; ++i)
    for(int j = 2; j < 16; ++j)
      missing.insert({i, j});
  Soup soup = sheet_soup(16, 16, missing);
  for(auto& p : soup.points)
    p = Mesh::Point(p.x(), p.y(), 0.01 * (p.x() * p.x() + p.y() * p.y() + p.x() * p.y()));
  Atlas_surface angle(soup);
  FFM::Unwrap_options options;
  options.min_occupancy = 0;
  const FFM::Unwrap_summary whole = angle.unwrap(options);
  check_atlas(angle, whole);
  BOOST_TEST(whole.charts.size() == 1u);
  const FFM::Unwrap_summary split = angle.unwrap();
  check_atlas(angle, split);
  BOOST_TEST(split.splits_for_packing >= 1);
  BOOST_TEST(split.charts.size() == 1u + split.splits_for_packing);
  BOOST_TEST(split.occupancy > 1.2 * whole.occupancy);
  // What is square already stays whole, and so do planar faces.
  for(const auto& missing_cells : {std::set<std::array<int, 2>>(), missing}) {
    Soup flat = sheet_soup(16, 16, missing_cells);
    for(auto& p : flat.points)
      p = Mesh::Point(p.x(), p.y(), 0);
    BOOST_TEST(Atlas_surface(flat).unwrap().charts.size() == 1u);
  }
}

// A cube of side 2 whose edges and corners are cut off: six squares, twelve rectangles, eight triangles.
static Soup chamfered_cube_soup(double chamfer)
{
  Soup soup;
  // On the side of an axis with a sign, with signs along the next two.
  const auto number = [](int axis, int sign, int next, int last) { return ((axis * 2 + sign) * 2 + next) * 2 + last; };
  for(int axis = 0; axis < 3; ++axis)
    for(int signs = 0; signs < 8; ++signs) {
      std::array<double, 3> p;
      p[axis] = signs & 4 ? 1 : -1;
      p[(axis + 1) % 3] = (signs & 2 ? 1 : -1) * (1 - chamfer);
      p[(axis + 2) % 3] = (signs & 1 ? 1 : -1) * (1 - chamfer);
      soup.points.emplace_back(p[0], p[1], p[2]);
    }
  const auto add = [&soup](std::vector<int> face) {
    const Mesh::Point &p = soup.points[face[0]], &q = soup.points[face[1]], &r = soup.points[face[2]];
    if(CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) < 0)
      std::reverse(face.begin(), face.end());
    for(std::size_t k = 2; k < face.size(); ++k)
      soup.triangles.push_back({face[0], face[k - 1], face[k]});
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int i = 0; i < 2; ++i) {
      add({number(axis, i, 0, 0), number(axis, i, 0, 1), number(axis, i, 1, 1), number(axis, i, 1, 0)});
      const int next = (axis + 1) % 3;
      for(int j = 0; j < 2; ++j)
        add({number(axis, i, j, 0), number(axis, i, j, 1), number(next, j, 1, i), number(next, j, 0, i)});
    }
  for(int i = 0; i < 2; ++i)
    for(int j = 0; j < 2; ++j)
      for(int k = 0; k < 2; ++k)
        add({number(0, i, j, k), number(1, j, k, i), number(2, k, i, j)});
  return soup;
}

// A ring of `around` squares one way, `across` the other.
static Soup torus_soup(int around, int across)
{
  Soup soup;
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j) {
      const double u = 2 * CGAL_PI * i / around, v = 2 * CGAL_PI * j / across, radius = 1 + 0.3 * std::cos(v);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.3 * std::sin(v));
      const int next = (i + 1) % around * across, last = (j + 1) % across;
      soup.triangles.push_back({i * across + j, next + j, next + last});
      soup.triangles.push_back({i * across + j, next + last, i * across + last});
    }
  return soup;
}

BOOST_AUTO_TEST_CASE(coarse_meshes_of_round_shapes)
{
  // Edges of 30 to 60 degrees lie everywhere; a chart for each strip between them would be exact, and nobody would want it.
  for(const Soup& soup : {torus_soup(8, 6), torus_soup(16, 12), torus_soup(48, 12)}) {
    Atlas_surface ring(soup);
    const FFM::Unwrap_summary summary = ring.unwrap();
    check_atlas(ring, summary);
    BOOST_TEST(summary.charts.size() <= 8u);
    for(const FFM::Chart_summary& chart : summary.charts)
      BOOST_TEST(chart.energy <= 1.025);
  }
}

BOOST_AUTO_TEST_CASE(constructed_parts_unfold)
{
  // Boxes of two triangles a side, one of them flat; cubes with chamfers; a drum; a star with a hub, whose caps are flat and not convex.
  Soup cube = block_soup(1, 1, 1), plate = cube;
  for(auto& p : plate.points)
    p = Mesh::Point(3 * p.x(), 2 * p.y(), 0.1 * p.z());
  const auto prism = [](int n, double inner) {
    Soup soup;
    for(int z = 0; z < 2; ++z)
      for(int i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * i / n, radius = i % 2 == 0 ? 1 : inner;
        soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.5 * z);
      }
    soup.points.emplace_back(0, 0, 0);
    soup.points.emplace_back(0, 0, 0.5);
    for(int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      soup.triangles.push_back({i, j, j + n});
      soup.triangles.push_back({i, j + n, i + n});
      soup.triangles.push_back({j, i, 2 * n});
      soup.triangles.push_back({i + n, j + n, 2 * n + 1});
    }
    return soup;
  };
  for(const Soup& soup : {cube, plate, chamfered_cube_soup(0.1), chamfered_cube_soup(0.5), prism(48, 1), prism(40, 0.7)}) {
    Atlas_surface part(soup);
    const FFM::Unwrap_summary summary = part.unwrap();
    check_atlas(part, summary);
    BOOST_TEST(summary.energy <= 1 + 1e-6);
    for(const FFM::Chart_summary& chart : summary.charts)
      BOOST_TEST(chart.faces >= 2);
    // No seam divides a flat region.
    for(const auto e : part.mesh.edges()) {
      std::array<Mesh::Point, 4> p;
      for(int i = 0; i < 2; ++i) {
        const Halfedge h = part.mesh.halfedge(e, i);
        p[2 * i] = part.mesh.point(part.mesh.target(h));
        p[2 * i + 1] = part.mesh.point(part.mesh.target(part.mesh.next(h)));
      }
      if(std::abs(CGAL::determinant(p[1] - p[0], p[2] - p[0], p[3] - p[0])) < 1e-12)
        BOOST_TEST(!part.seam[e]);
    }
  }
}

BOOST_AUTO_TEST_CASE(charts_are_laid_into_holes)
{
  // A frame, and a square that has room in it: boxes beside each other would cover less than a third.
  std::set<std::array<int, 2>> hole;
  for(int i = 1; i < 9; ++i)
    for(int j = 1; j < 9; ++j)
      hole.insert({i, j});
  Soup soup = together(sheet_soup(10, 10, hole), sheet_soup(7, 7, {}));
  for(auto& p : soup.points)
    p = Mesh::Point(p.x(), p.y(), 0);
  Atlas_surface nested(soup);
  const FFM::Unwrap_summary summary = nested.unwrap();
  check_atlas(nested, summary);
  BOOST_TEST(summary.charts.size() == 2u);
  BOOST_TEST(summary.occupancy > 0.75);
  check_distances(nested, 1. / 512);
}

BOOST_AUTO_TEST_CASE(seams_of_the_user)
{
  // Each side of a block becomes a chart.
  Atlas_surface block(block_soup(3, 3, 3));
  for(const auto e : block.mesh.edges()) {
    const auto p = block.mesh.point(block.mesh.vertex(e, 0)), q = block.mesh.point(block.mesh.vertex(e, 1));
    int sides = 0;
    for(int c = 0; c < 3; ++c)
      sides += p[c] == q[c] && (p[c] == 0 || p[c] == 3);
    block.user[e] = sides == 2;
  }
  const FFM::Unwrap_summary summary = block.unwrap();
  check_atlas(block, summary);
  BOOST_TEST(summary.charts.size() == 6u);
  BOOST_TEST(summary.seam_edges == 36);
  BOOST_TEST(std::abs(summary.seam_length - 36) <= 1e-12);
  BOOST_TEST(std::abs(summary.energy - 1) <= 1e-9);
  // Six squares in a square.
  BOOST_TEST(summary.occupancy > 6. / 9 * 0.9);
  for(const auto e : block.mesh.edges())
    BOOST_TEST((!block.user[e] || block.seam[e]));
}

BOOST_AUTO_TEST_CASE(small_charts_are_joined)
{
  // Waves on a torus, whose tight bound leaves small charts at the ends of splits.
  Soup soup = torus_soup(60, 24);
  for(std::size_t i = 0; i < soup.points.size(); ++i) {
    const Mesh::Point& p = soup.points[i];
    const double wave = 1 + 0.1 * std::sin(14 * p.x() + 6 * p.y()) * std::sin(10 * p.y() - 8 * p.z());
    soup.points[i] = Mesh::Point(wave * p.x(), wave * p.y(), wave * p.z());
  }
  FFM::Unwrap_options options;
  options.max_distortion = 1.005;
  Atlas_surface torus(soup);
  const FFM::Unwrap_summary summary = torus.unwrap(options);
  check_atlas(torus, summary);
  BOOST_TEST(summary.joined_charts > 0);
  for(const FFM::Chart_summary& chart : summary.charts)
    BOOST_TEST(chart.energy <= options.max_distortion);

  // Not across seams that are asked for.
  Soup flat = sheet_soup(12, 12, {});
  for(auto& p : flat.points)
    p = Mesh::Point(p.x(), p.y(), 0);
  Atlas_surface sheet(flat);
  for(const auto e : sheet.mesh.edges()) {
    const auto p = sheet.mesh.point(sheet.mesh.vertex(e, 0)), q = sheet.mesh.point(sheet.mesh.vertex(e, 1));
    const auto is_side = [&](int c, double at) {
      return p[c] == at && q[c] == at && (std::min)(p[1 - c], q[1 - c]) >= 5 && (std::max)(p[1 - c], q[1 - c]) <= 6;
    };
    sheet.user[e] = is_side(0, 5) || is_side(0, 6) || is_side(1, 5) || is_side(1, 6);
  }
  const FFM::Unwrap_summary kept = sheet.unwrap();
  check_atlas(sheet, kept);
  BOOST_TEST(kept.charts.size() == 2u);
  BOOST_TEST(kept.joined_charts == 0);
  BOOST_TEST(kept.seam_edges == 4);
}

BOOST_AUTO_TEST_CASE(packing)
{
  Atlas_surface surface(together(plate_soup(2), ball_soup()));
  FFM::Unwrap_options options;
  options.packing.margin = 0.05;
  const FFM::Unwrap_summary wide = surface.unwrap(options);
  check_atlas(surface, wide);
  BOOST_TEST_REQUIRE(wide.charts.size() > 1u);
  check_distances(surface, 0.05);
  FFM::Unwrap_options pixels;
  pixels.packing.resolution = 100;
  pixels.packing.padding = 5;
  Atlas_surface same(together(plate_soup(2), ball_soup()));
  BOOST_TEST(same.unwrap(pixels).scale == wide.scale);
  pixels.packing.padding = 51;
  BOOST_TEST(FFM::status_name(same.unwrap(pixels).status) == FFM::status_name(Status::invalid_option));
  // The same charts closer together; without packing, in the units of the surface; packed afterwards.
  FFM::Packing_options closer;
  FFM::Textured_mesh textured = FFM::textured_atlas(surface.mesh, surface.uv);
  const FFM::Packing_summary packed = FFM::pack_charts(surface.mesh, surface.uv, closer);
  BOOST_TEST_REQUIRE(packed.is_valid(), packed.message);
  BOOST_TEST(packed.charts == static_cast<int>(wide.charts.size()));
  BOOST_TEST(packed.scale > 1);
  BOOST_TEST(std::abs(packed.occupancy - wide.occupancy * packed.scale * packed.scale) <= 1e-9);
  BOOST_TEST(!has_overlap(surface.mesh, surface.uv));
  // Flat arrays give the same atlas, with texture coordinates that corners of the same point and image share.
  FFM::Textured_mesh wrong = textured;
  wrong.texture_triangles.back()[2] = static_cast<int>(wrong.texture.size());
  BOOST_TEST(FFM::status_name(FFM::pack_charts(wrong, closer).status) == FFM::status_name(Status::invalid_option));
  BOOST_TEST((wrong.texture == textured.texture));
  BOOST_TEST_REQUIRE(FFM::pack_charts(textured, closer).is_valid());
  const FFM::Textured_mesh expected = FFM::textured_atlas(surface.mesh, surface.uv);
  BOOST_TEST((textured.texture == expected.texture));
  BOOST_TEST((textured.texture_triangles == expected.texture_triangles));
  options.pack = false;
  const FFM::Unwrap_summary loose = surface.unwrap(options);
  BOOST_TEST_REQUIRE(loose.is_valid());
  BOOST_TEST(loose.scale == 1);
  BOOST_TEST(std::abs(loose.energy - wide.energy) <= 1e-12);
  BOOST_TEST(FFM::pack_charts(surface.mesh, surface.uv, closer).is_valid());
  BOOST_TEST(!has_overlap(surface.mesh, surface.uv));

  // What cannot be packed stays as it is.
  const Point_2 before = surface.uv[Halfedge(0)];
  closer.margin = 0.5;
  BOOST_TEST(FFM::status_name(FFM::pack_charts(surface.mesh, surface.uv, closer).status) == FFM::status_name(Status::invalid_option));
  closer.margin = 0;
  BOOST_TEST(FFM::status_name(FFM::pack_charts(surface.mesh, surface.uv, closer).status) == FFM::status_name(Status::invalid_option));
  const Halfedge h = surface.mesh.halfedge(*surface.mesh.faces().begin());
  std::swap(surface.uv[h], surface.uv[surface.mesh.next(h)]);
  BOOST_TEST(FFM::status_name(FFM::pack_charts(surface.mesh, surface.uv).status) == FFM::status_name(Status::start_not_flip_free));
  std::swap(surface.uv[h], surface.uv[surface.mesh.next(h)]);
  BOOST_TEST((surface.uv[Halfedge(0)] == before));
}

BOOST_AUTO_TEST_CASE(numbers_of_low_precision)
{
  // A triangle that is 10^-9 thin is nothing to float numbers, and still not flipped.
  Soup soup = sheet_soup(8, 8, {});
  soup.points.push_back(CGAL::midpoint(soup.points[soup.triangles[40][0]], soup.points[soup.triangles[40][1]]) +
                        1e-9 * (soup.points[soup.triangles[40][2]] - soup.points[soup.triangles[40][1]]));
  const int m = static_cast<int>(soup.points.size()) - 1;
  const auto t = soup.triangles[40];
  soup.triangles[40] = {t[0], t[1], m};
  soup.triangles.push_back({t[1], t[2], m});
  soup.triangles.push_back({t[2], t[0], m});
  Atlas_surface surface(soup);
  check_atlas(surface, surface.unwrap());
  auto uv = surface.mesh.add_property_map<Halfedge, Float_point_2>("h:float").first;
  const FFM::Unwrap_summary summary = FFM::unwrap(surface.mesh, uv);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  BOOST_TEST(FFM::is_atlas_bijective(surface.mesh, uv));
  BOOST_TEST(!has_overlap(surface.mesh, uv));
}

BOOST_AUTO_TEST_CASE(polygons_for_files)
{
  // A box whose top and bottom are not convex: an L of six corners, and six rectangles around.
  const double outline[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  Mesh mesh;
  std::vector<Mesh::Vertex_index> low, high;
  for(const auto& p : outline) {
    low.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], 0)));
    high.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], 1)));
  }
  for(std::size_t i = 0; i < 6; ++i)
    mesh.add_face(low[i], low[(i + 1) % 6], high[(i + 1) % 6], high[i]);
  mesh.add_face(high);
  mesh.add_face(std::vector<Mesh::Vertex_index>(low.rbegin(), low.rend()));
  const Corner_map uv = mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
  const FFM::Unwrap_summary summary = FFM::unwrap(mesh, uv);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  const FFM::Textured_mesh textured = FFM::textured_atlas(mesh, uv);
  BOOST_TEST(textured.points.size() == 12u);
  BOOST_TEST(textured.triangles.size() == 2u * 4 + 6 * 2);
  BOOST_TEST(FFM::is_bijective(textured));
  // All of the surface is there: two L of area 5, and sides of height 1 and total length 12. Where the border would touch itself it is
  // moved by some millionths.
  const FFM::Distortion_report report = FFM::measure_distortion(textured);
  BOOST_TEST(std::abs(report.rest_area - 22) <= 1e-9);
  BOOST_TEST(std::abs(report.image_area - 22 * summary.scale * summary.scale) <= 2e-5);
}

BOOST_AUTO_TEST_CASE(limits)
{
  // When time is up, or the observer says so, the atlas is as valid as any.
  Atlas_surface late(together(plate_soup(5), ball_soup()));
  FFM::Unwrap_options options;
  options.max_seconds = 0;
  FFM::Unwrap_summary summary = late.unwrap(options);
  check_atlas(late, summary);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::time_limit));

  Atlas_surface stopped(together(plate_soup(5), ball_soup()));
  options = FFM::Unwrap_options();
  int calls = 0;
  options.observer = [&calls](const FFM::Unwrap_progress& progress) {
    BOOST_TEST(progress.faces_done <= progress.faces);
    BOOST_TEST(progress.charts_done <= progress.charts);
    return ++calls < 4;
  };
  summary = stopped.unwrap(options);
  check_atlas(stopped, summary);
  BOOST_TEST(calls == 4);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::stopped_by_observer));

  // Seams that the topology does not ask for are not looked for any more once the observer says so.
  Atlas_surface hurried(together(plate_soup(5), ball_soup()));
  options.crease_angle = std::numeric_limits<double>::infinity();
  options.observer = nullptr;
  const int points = hurried.unwrap(options).cut.points;
  options.observer = [](const FFM::Unwrap_progress&) { return false; };
  summary = hurried.unwrap(options);
  check_atlas(hurried, summary);
  BOOST_TEST(summary.cut.points <= 2);
  BOOST_TEST(points > 2);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::stopped_by_observer));

  // The method's observer ends all charts, too, not only the one that it is asked about.
  Atlas_surface ended(together(plate_soup(5), ball_soup()));
  FFM::Flip_free_map_traits<> traits;
  calls = 0;
  traits.options.observer = [&calls](const FFM::Iteration_report&) { return ++calls < 2; };
  summary = ended.unwrap(FFM::Unwrap_options(), traits);
  check_atlas(ended, summary);
  BOOST_TEST(calls == 2);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::stopped_by_observer));
}

BOOST_AUTO_TEST_CASE(observed_charts_are_flattened_at_the_same_time)
{
  Soup soup = ball_soup();
  for(int i = 0; i < 9; ++i)
    soup = together(ball_soup(), soup);
  Atlas_surface plain(soup), observed(soup);
  plain.unwrap();
  FFM::Unwrap_options options;
  std::vector<FFM::Unwrap_progress> told;
  const std::thread::id caller = std::this_thread::get_id();
  bool is_told_by_others = false;
  int pauses = 0;
  options.observer = [&](const FFM::Unwrap_progress& progress) {
    is_told_by_others = is_told_by_others || std::this_thread::get_id() != caller;
    told.push_back(progress);
    // Charts that are flattened elsewhere go on meanwhile.
    if(progress.phase == FFM::Unwrap_phase::flatten && ++pauses < 5)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return true;
  };
  const FFM::Unwrap_summary summary = observed.unwrap(options);
  check_atlas(observed, summary);
  for(const Halfedge h : plain.mesh.halfedges())
    BOOST_REQUIRE(plain.uv[h] == observed.uv[h]);
  BOOST_TEST(!is_told_by_others);
  int most_at_once = 0;
  for(std::size_t i = 0; i < told.size(); ++i) {
    BOOST_TEST(told[i].charts_done <= told[i].charts);
    BOOST_TEST(told[i].faces_done <= told[i].faces);
    if(i == 0)
      continue;
    BOOST_TEST((told[i].phase >= told[i - 1].phase));
    BOOST_TEST(told[i].faces_done >= told[i - 1].faces_done);
    most_at_once = (std::max)(most_at_once, told[i].charts_done - told[i - 1].charts_done);
  }
  BOOST_REQUIRE(!told.empty());
  BOOST_TEST(FFM::phase_name(told.front().phase) == std::string("cut"));
  BOOST_TEST(FFM::phase_name(told.back().phase) == std::string("pack"));
  BOOST_TEST(told.back().charts_done == static_cast<int>(summary.charts.size()));
  BOOST_TEST(told.back().faces_done == told.back().faces);
#ifdef CGAL_LINKED_WITH_TBB
  if(tbb::this_task_arena::max_concurrency() > 1)
    BOOST_TEST(most_at_once > 1);
#endif

  // What an observer throws ends the charts that are at work.
  struct Thrown
  {};
  options.observer = [](const FFM::Unwrap_progress& progress) {
    if(progress.phase == FFM::Unwrap_phase::flatten)
      throw Thrown();
    return true;
  };
  Atlas_surface thrown(soup);
  BOOST_CHECK_THROW(thrown.unwrap(options), Thrown);
  BOOST_TEST(thrown.is_untouched());
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(watched_calls)
{
  using Tag = CGAL::Parallel_tag;
  using FFM::internal::for_each_index_watched;
  const std::thread::id caller = std::this_thread::get_id();
  const bool is_alone = tbb::this_task_arena::max_concurrency() < 2;
  std::atomic<int> calls{0}, calls_by_caller{0};
  int watches = 0;
  const auto call = [&](std::size_t) {
    ++calls;
    if(std::this_thread::get_id() == caller)
      ++calls_by_caller;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  };
  for_each_index_watched<Tag>(1, call, [&] { ++watches; });
  BOOST_TEST(calls == 1);
  BOOST_TEST(calls_by_caller == 1);
  BOOST_TEST(watches == 0);
  for_each_index_watched<Tag>(8, call, [&] {
    ++watches;
    BOOST_TEST((std::this_thread::get_id() == caller));
  });
  BOOST_TEST(calls == 9);
  BOOST_TEST((is_alone || (calls_by_caller == 1 && watches > 0)));
  const auto fail = [](std::size_t i) {
    if(i == 3)
      throw std::runtime_error("3");
  };
  BOOST_CHECK_THROW(for_each_index_watched<Tag>(8, fail, [] {}), std::runtime_error);
  // All calls have ended when the exception of the watch comes out.
  calls = 0;
  if(!is_alone) {
    BOOST_CHECK_THROW(for_each_index_watched<Tag>(8, call, [] { throw std::runtime_error("watch"); }), std::runtime_error);
    BOOST_TEST(calls == 8);
  }
}
#endif

BOOST_AUTO_TEST_CASE(refused)
{
  const auto expect = [](const Soup& soup, const FFM::Unwrap_options& options, Status status) {
    Atlas_surface surface(soup);
    const FFM::Unwrap_summary summary = surface.unwrap(options);
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST(summary.message.size() > 10u);
    BOOST_TEST(surface.is_untouched());
  };
  FFM::Unwrap_options options;
  expect(Soup(), options, Status::empty_mesh);
  Soup soup = ball_soup();
  soup.points[soup.triangles[5][0]] = soup.points[soup.triangles[5][1]];
  FFM::Unwrap_options strict;
  strict.strict = true;
  expect(soup, strict, Status::degenerate_rest_element);
  soup.points[3] = Mesh::Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect(soup, options, Status::non_finite_input);
  for(double margin : {0., -1., 0.6}) {
    options.packing.margin = margin;
    expect(ball_soup(), options, Status::invalid_option);
  }
  options = FFM::Unwrap_options();
  options.max_distortion = 1;
  expect(ball_soup(), options, Status::invalid_option);
  options = FFM::Unwrap_options();
  options.packing.margin = 0.5;
  expect(together(together(together(ball_soup(), ball_soup()), ball_soup()), ball_soup()), options, Status::invalid_option);

  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 3, 4}};
  expect(soup, strict, Status::non_manifold);

  Atlas_surface square{Soup()};
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 4; ++i)
    v.push_back(square.mesh.add_vertex({double(i == 1 || i == 2), double(i >= 2), 0}));
  square.mesh.add_face(v);
  BOOST_TEST(FFM::status_name(square.unwrap(strict).status) == FFM::status_name(Status::not_triangular));
}

BOOST_AUTO_TEST_CASE(the_same_with_one_thread_and_written_to_files)
{
  Atlas_surface a(plate_soup(2)), b(plate_soup(2));
  check_atlas(a, a.unwrap());
  {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
#endif
    b.unwrap();
  }
  for(const auto h : a.mesh.halfedges())
    BOOST_TEST((a.uv[h] == b.uv[h]));
  const FFM::Textured_mesh textured = FFM::textured_atlas(a.mesh, a.uv);
  BOOST_TEST(FFM::is_bijective(textured));
  BOOST_TEST(textured.points.size() == a.mesh.number_of_vertices());
  BOOST_TEST(textured.triangles.size() == a.mesh.number_of_faces());
  // As many images as there are corners less those that are glued: V + the seams' doubles.
  BOOST_TEST(textured.texture.size() > textured.points.size());
}

BOOST_AUTO_TEST_SUITE_END() // test_unwrap
