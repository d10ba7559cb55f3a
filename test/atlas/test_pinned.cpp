// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What is pinned stays where it is, bit for bit, and all else keeps its distance from it.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/atlas/internal/Packing_obstacles.h>
#include <CGAL/Flip_free_maps/pack_charts.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_pinned)

namespace {

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Obstacles = FFM::internal::Packing_obstacles;
using Positions = FFM::Positions<2>;
using Image = std::array<double, 2>;
using Images = std::vector<std::vector<Image>>;
using Polygons = std::vector<std::vector<std::size_t>>;

Positions box(double x, double y, double width, double height)
{
  Positions result(2, 4);
  result << x, x + width, x + width, x, y, y, y + height, y + height;
  return result;
}

double distance(const Image& p, const Image& a, const Image& b)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1], length = dx * dx + dy * dy;
  const double t = length > 0 ? (std::min)(1., (std::max)(0., ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length)) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

// Between sides of polygons that do not cross.
double distance(const std::vector<Image>& p, const std::vector<Image>& q)
{
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < p.size(); ++i)
    for(std::size_t j = 0; j < q.size(); ++j)
      least = (std::min)({least, distance(p[i], q[j], q[(j + 1) % q.size()]), distance(q[j], p[i], p[(i + 1) % p.size()])});
  return least;
}

bool do_overlap(const std::vector<Image>& p, const std::vector<Image>& q)
{
  const auto point = [](const Image& image) { return Kernel::Point_2(image[0], image[1]); };
  for(std::size_t i = 1; i + 1 < p.size(); ++i)
    for(std::size_t j = 1; j + 1 < q.size(); ++j)
      if(CGAL::do_intersect(Kernel::Triangle_2(point(p[0]), point(p[i]), point(p[i + 1])),
                            Kernel::Triangle_2(point(q[0]), point(q[j]), point(q[j + 1]))))
        return true;
  return false;
}

// Squares of two triangles each, that touch nowhere, with images of their own.
FFM::Textured_mesh squares(const std::vector<std::array<double, 3>>& corner_and_size)
{
  FFM::Textured_mesh mesh;
  for(std::size_t i = 0; i < corner_and_size.size(); ++i) {
    const auto& [x, y, size] = corner_and_size[i];
    const int n = static_cast<int>(mesh.points.size());
    for(const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      mesh.points.push_back({2. * static_cast<double>(i) + dx, 1. * dy, 0});
      mesh.texture.push_back({x + size * dx, y + size * dy});
    }
    for(const std::array<int, 3>& t : {std::array<int, 3>{n, n + 1, n + 2}, {n, n + 2, n + 3}}) {
      mesh.triangles.push_back(t);
      mesh.texture_triangles.push_back(t);
    }
  }
  return mesh;
}

std::vector<Image> images_of(const FFM::Textured_mesh& mesh, std::size_t triangle)
{
  std::vector<Image> images;
  for(const int t : mesh.texture_triangles[triangle])
    images.push_back(mesh.texture[t]);
  return images;
}

// A cube's corners and quads, each with an image of a third of the side in a grid of three times three.
const std::vector<std::array<double, 3>> cube_points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const Polygons cube_faces{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

} // namespace

BOOST_AUTO_TEST_CASE(cells_near_obstacles_are_taken)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-0.4, 1.4), part(0, 1);
  const int cells = 96;
  for(int trial = 0; trial < 60; ++trial) {
    // In any direction, and partly outside.
    std::vector<Image> triangle(3);
    Positions polygon(2, 3);
    for(int k = 0; k < 3; ++k) {
      triangle[k] = {coordinate(random), coordinate(random)};
      polygon.col(k) << triangle[k][0], triangle[k][1];
    }
    const double gap = 6 * part(random);
    Obstacles obstacles;
    obstacles.add(polygon);
    FFM::internal::Cell_grid grid(cells);
    obstacles.take(grid, Eigen::Vector2d::Zero(), cells, gap);
    // A figure of one cell has room where nothing is taken.
    FFM::internal::Chart_outline dot;
    dot.sources = box(0.25, 0.25, 0.5, 0.5);
    dot.targets.resize(2, 4);
    dot.targets << dot.sources.rightCols(3), dot.sources.leftCols(1);
    const FFM::internal::Cell_figure one = FFM::internal::Cell_figure::quarter_turns(dot, cells)[0];
    BOOST_TEST_REQUIRE(one.width() == 1);
    for(int y = 0; y < cells; ++y) {
      std::vector<char> is_free(cells, 0);
      FFM::internal::Cell_grid row = grid;
      for(int x = row.first_place(one, y); x >= 0; x = row.first_place(one, y)) {
        is_free[x] = 1;
        row.take(one, x, y, 0);
      }
      for(int x = 0; x < cells; ++x) {
        const double side = 1. / cells;
        const std::vector<Image> cell{
          {x * side, y * side}, {(x + 1) * side, y * side}, {(x + 1) * side, (y + 1) * side}, {x * side, (y + 1) * side}};
        const bool touches = do_overlap(cell, triangle);
        const double between = touches ? 0 : distance(cell, triangle);
        if(is_free[x])
          BOOST_TEST_REQUIRE((!touches && between * cells >= gap - 1e-6));
        else
          // Two cells in either direction are rounding.
          BOOST_TEST_REQUIRE(between * cells <= gap + 2 * std::sqrt(2.));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(areas_and_squares_that_obstacles_leave)
{
  Obstacles obstacles;
  BOOST_TEST(obstacles.largest_square(0.1).side == 1);
  BOOST_TEST(obstacles.area() == 0);
  obstacles.add(box(-3, -0.5, 8, 0.75)); // a quarter is in the unit square
  obstacles.add(box(2, 2, 1, 1));        // nothing
  Positions mirrored = box(0.5, 0.5, 0.5, 0.25);
  mirrored.col(1).swap(mirrored.col(3));
  obstacles.add(mirrored);
  BOOST_TEST(obstacles.area() == 0.25 + 0.125, boost::test_tools::tolerance(1e-14));
  // Left is [0, .5] x [.25, 1].
  for(const double margin : {0.001, 0.05}) {
    const Obstacles::Square square = obstacles.largest_square(margin);
    // Of its sides two are at the square's, and two half a margin from obstacles.
    BOOST_TEST(square.side <= 0.5 - margin / 2 + 1e-12);
    BOOST_TEST(square.side >= 0.5 - margin / 2 - 0.015);
    BOOST_TEST(square.lower_left[0] == 0);
    BOOST_TEST(square.lower_left[1] >= 0.25 + margin / 2);
  }
  obstacles.add(box(0, 0, 1, 1));
  BOOST_TEST(obstacles.largest_square(0.01).side == 0);
}

BOOST_AUTO_TEST_CASE(exact_contact)
{
  const std::vector<std::array<std::int32_t, 3>> one{{{0, 1, 2}}};
  Positions x(2, 3);
  x << 0, 1, 0, 0, 0, 1;
  const auto is_touched = [&](const Positions& polygon) {
    Obstacles obstacles;
    obstacles.add(polygon);
    return obstacles.are_touched(one, x);
  };
  const double tiny = std::numeric_limits<double>::epsilon();
  BOOST_TEST(is_touched(box(-1, -1, 3, 3)));       // around
  BOOST_TEST(is_touched(box(0.1, 0.1, 0.1, 0.1))); // within
  BOOST_TEST(is_touched(box(-1, 0.25, 1, 0.25)));  // a side
  BOOST_TEST(is_touched(box(0.5, 0.5, 1, 1)));     // a corner
  BOOST_TEST(!is_touched(box(0.5 + tiny, 0.5, 1, 1)));
  BOOST_TEST(!is_touched(box(-1 - tiny, 0.25, 1, 0.25)));
  // Points and segments.
  BOOST_TEST(is_touched(box(0.25, 0.25, 0, 0)));
  BOOST_TEST(!is_touched(box(0.75, 0.75, 0, 0)));
  BOOST_TEST(is_touched(box(-1, 0.25, 3, 0)));
}

// Three squares beside one that takes a quarter.
BOOST_AUTO_TEST_CASE(charts_are_packed_around_a_pinned_one)
{
  for(const bool is_mirrored : {false, true}) {
    FFM::Textured_mesh mesh = squares({{0, 0, 0.5}, {7, 7, 2}, {7, 7, 2}, {-3, 0, 2}});
    if(is_mirrored)
      for(int t = 0; t < 4; ++t)
        std::swap(mesh.texture[t][0], mesh.texture[t][1]);
    const FFM::Textured_mesh before = mesh;
    FFM::Packing_options options;
    options.margin = 0.004;
    // One of its two triangles tells.
    const FFM::Packing_summary summary = FFM::pack_charts(mesh, options, {0, 1, 0, 0, 0, 0, 0, 0});
    BOOST_TEST_REQUIRE(summary.status == Status::success);
    BOOST_TEST(summary.charts == 4);
    BOOST_TEST(summary.pinned_charts == 1);
    BOOST_TEST(2 * summary.scale <= 0.5 - options.margin / 2);
    BOOST_TEST(2 * summary.scale >= 0.47);
    BOOST_TEST(summary.occupancy == 0.25 + 3 * 4 * summary.scale * summary.scale, boost::test_tools::tolerance(1e-9));
    for(std::size_t t = 0; t < 2; ++t)
      BOOST_TEST((images_of(mesh, t) == images_of(before, t)));
    for(std::size_t t = 2; t < mesh.triangles.size(); ++t)
      for(std::size_t u = 0; u < t; ++u)
        if(t / 2 != u / 2) {
          BOOST_TEST(!do_overlap(images_of(mesh, t), images_of(mesh, u)));
          BOOST_TEST(distance(images_of(mesh, t), images_of(mesh, u)) >= options.margin - 1e-12);
        }
    for(std::size_t t = 2; t < mesh.triangles.size(); ++t)
      for(const Image& p : images_of(mesh, t))
        for(const double c : p)
          BOOST_TEST((std::min)(c, 1 - c) >= options.margin / 2 - 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(pinned_charts_elsewhere_leave_the_square_free)
{
  FFM::Textured_mesh mesh = squares({{3, -1, 1}, {0, 0, 5}});
  FFM::Packing_options options;
  options.margin = 0.01;
  const FFM::Packing_summary summary = FFM::pack_charts(mesh, options, {1, 1, 0, 0});
  BOOST_TEST_REQUIRE(summary.status == Status::success);
  BOOST_TEST(5 * summary.scale <= 1 - options.margin + 1e-12);
  BOOST_TEST(5 * summary.scale >= 0.97);
}

BOOST_AUTO_TEST_CASE(no_room_leaves_all_untouched)
{
  FFM::Textured_mesh mesh = squares({{0, 0, 1}, {0, 0, 5}});
  const FFM::Textured_mesh before = mesh;
  const FFM::Packing_summary summary = FFM::pack_charts(mesh, FFM::Packing_options(), {1, 1, 0, 0});
  BOOST_TEST(summary.status == Status::invalid_option);
  BOOST_TEST(summary.message.find("pinned") != std::string::npos);
  BOOST_TEST((mesh.texture == before.texture && mesh.texture_triangles == before.texture_triangles));
  // The wrong number of flags, and nothing to do.
  BOOST_TEST(FFM::pack_charts(mesh, FFM::Packing_options(), {1}).status == Status::invalid_option);
  const FFM::Packing_summary all = FFM::pack_charts(mesh, FFM::Packing_options(), {1, 0, 0, 1});
  BOOST_TEST(all.status == Status::success);
  BOOST_TEST(all.pinned_charts == 2);
  for(std::size_t t = 0; t < 4; ++t)
    BOOST_TEST((images_of(mesh, t) == images_of(before, t)));
}

// The bottom of a cube, mirrored, and two sides that are joined.
BOOST_AUTO_TEST_CASE(pinned_faces_of_an_atlas)
{
  const Image a{0.1, 0.1}, b{0.3, 0.1}, c{0.3, 0.3}, d{0.1, 0.3}, e{0.5, 0.1}, f{0.5, 0.3};
  Images images(6);
  images[0] = {{0.9, 0.6}, {0.7, 0.6}, {0.7, 0.8}, {0.9, 0.8}}; // clockwise
  images[2] = {a, b, c, d};                                     // 0 1 5 4
  images[3] = {b, e, f, c};                                     // 1 2 6 5
  const std::vector<char> is_pinned{1, 0, 1, 1, 0, 0};
  const auto pinned = boost::make_function_property_map<std::size_t>([&](std::size_t p) { return is_pinned[p] != 0; });
  Images given = images;
  std::vector<int> charts(6, 7);
  std::map<std::pair<std::size_t, std::size_t>, bool> seams;
  const auto np = FFM::parameters::face_is_pinned_map(
    pinned, FFM::parameters::face_chart_map(charts.data(), FFM::parameters::edge_is_seam_map(boost::make_assoc_property_map(seams))));
  const FFM::Unwrap_summary summary = FFM::unwrap(cube_points, cube_faces, images, np);
  BOOST_TEST_REQUIRE(summary.status == Status::success);
  BOOST_TEST(summary.faces == 6);
  BOOST_TEST(summary.pinned_faces == 3);
  BOOST_TEST(summary.energy == 1, boost::test_tools::tolerance(1e-6));
  const double margin = FFM::Packing_options().margin;
  for(std::size_t p = 0; p < 6; ++p) {
    BOOST_TEST((charts[p] == -1) == (is_pinned[p] != 0));
    if(is_pinned[p])
      BOOST_TEST((images[p] == given[p]));
    else
      for(std::size_t q = 0; q < 6; ++q)
        if(is_pinned[q]) {
          BOOST_TEST(!do_overlap(images[p], images[q]));
          BOOST_TEST(distance(images[p], images[q]) >= margin - 1e-12);
        }
  }
  // Where a pinned face meets any other but with the same images; the three free ones are a strip that is not cut.
  BOOST_TEST(seams.size() == 12u);
  const std::map<std::pair<std::size_t, std::size_t>, bool> joined{{{1, 5}, false}, {{4, 7}, false}, {{6, 7}, false}, {{3, 7}, false}};
  int cut = 0;
  for(const auto& [edge, is_seam] : seams) {
    cut += is_seam;
    if(edge == std::make_pair(std::size_t(1), std::size_t(5)))
      BOOST_TEST(!is_seam);
    if(joined.count(edge) == 0)
      BOOST_TEST(is_seam);
  }
  // Three squares around a corner are opened by one edge.
  BOOST_TEST(cut == 12 - 3);

  // The door for meshes does the same.
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  Mesh mesh;
  for(const auto& p : cube_points)
    mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto for_each_corner = [&](auto&& visit) {
    for(std::size_t p = 0; p < 6; ++p)
      for(const auto h : halfedges_around_face(halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(p)), mesh), mesh)) {
        const std::size_t v = target(h, mesh);
        visit(p, std::find(cube_faces[p].begin(), cube_faces[p].end(), v) - cube_faces[p].begin(), h);
      }
  };
  for(const auto& face : cube_faces) {
    std::vector<Mesh::Vertex_index> corners;
    for(const std::size_t v : face)
      corners.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    mesh.add_face(corners);
  }
  for_each_corner([&](std::size_t p, std::size_t k, Mesh::Halfedge_index h) {
    if(is_pinned[p])
      uv[h] = Point_2(given[p][k][0], given[p][k][1]);
  });
  const auto by_face = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index face) { return is_pinned[face] != 0; });
  const FFM::Unwrap_summary same = FFM::unwrap(mesh, uv, FFM::parameters::face_is_pinned_map(by_face));
  BOOST_TEST_REQUIRE(same.status == Status::success);
  BOOST_TEST(same.occupancy == summary.occupancy, boost::test_tools::tolerance(1e-6));
  for_each_corner([&](std::size_t p, std::size_t k, Mesh::Halfedge_index h) {
    if(is_pinned[p])
      BOOST_TEST((uv[h] == Point_2(given[p][k][0], given[p][k][1])));
  });
}

BOOST_AUTO_TEST_CASE(pins_that_cannot_be)
{
  const auto all = boost::make_function_property_map<std::size_t>([](std::size_t) { return true; });
  const auto first = boost::make_function_property_map<std::size_t>([](std::size_t p) { return p == 0; });
  Images images(6, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Images before = images;
  const FFM::Unwrap_summary done = FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::face_is_pinned_map(all));
  BOOST_TEST(done.status == Status::success);
  BOOST_TEST(done.pinned_faces == 6);
  BOOST_TEST(done.flips == 0);
  BOOST_TEST(done.energy == 1);
  BOOST_TEST(done.scale == 1);
  BOOST_TEST(done.charts.empty());
  BOOST_TEST(done.seconds > 0);
  BOOST_TEST((images == before));
  FFM::Unwrap_options impossible;
  impossible.max_distortion = 0.5;
  BOOST_TEST(
    (FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::unwrap_options(impossible, FFM::parameters::face_is_pinned_map(all)))
       .status == Status::invalid_option));
  // No room.
  BOOST_TEST((FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::face_is_pinned_map(first)).status == Status::invalid_option));
  BOOST_TEST((images == before));
  FFM::Unwrap_options unpacked;
  unpacked.pack = false;
  const FFM::Unwrap_summary refused =
    FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::unwrap_options(unpacked, FFM::parameters::face_is_pinned_map(first)));
  BOOST_TEST(refused.status == Status::invalid_option);
  images[0][2][1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::face_is_pinned_map(first)).status == Status::non_finite_input));
  images[0].pop_back();
  BOOST_TEST((FFM::unwrap(cube_points, cube_faces, images, FFM::parameters::face_is_pinned_map(first)).status == Status::invalid_option));
  Images none;
  BOOST_TEST((FFM::unwrap(cube_points, cube_faces, none, FFM::parameters::face_is_pinned_map(first)).status == Status::invalid_option));
  BOOST_TEST(none.empty());
}

BOOST_AUTO_TEST_SUITE_END() // test_pinned
