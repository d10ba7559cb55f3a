// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The doors for plain arrays give what those for meshes give, bit for bit, and refuse what is no surface; options and methods may be
// named parameters.

#include "support/unit_test.h"

#include "support/mesh_checks.h"
#include "support/volume_checks.h"

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_arrays)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

namespace np = FFM::parameters;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Point_2 = Plain_point_2;
using Pair = std::array<double, 2>;
using Triple = std::array<double, 3>;
using Triangles = std::vector<std::array<int, 3>>;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A sheet of 6 x 4 squares in the plane; its first triangle has a corner at vertex 0.
struct Sheet
{
  Sheet()
  {
    for(int j = 0; j <= 4; ++j)
      for(int i = 0; i <= 6; ++i)
        points.push_back({10 + 0.5 * i, -5 + 0.25 * j + 0.03 * i, 0.});
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 6; ++i) {
        const int a = 7 * j + i;
        triangles.push_back({a, a + 1, a + 8});
        triangles.push_back({a, a + 8, a + 7});
      }
    fill();
  }

  void fill()
  {
    mesh.clear();
    for(const Triple& p : points)
      mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    for(const auto& t : triangles)
      mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  }

  std::vector<Triple> points;
  Triangles triangles;
  Mesh mesh;
};

// The surface of a cube, closed.
struct Cube : Sheet
{
  Cube()
  {
    points.clear();
    for(int i = 0; i < 8; ++i)
      points.push_back({1. * (i & 1), 1. * (i >> 1 & 1), 1. * (i >> 2)});
    triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    fill();
  }
};

Triangles with_first_twice(const Sheet& sheet)
{
  Triangles result = sheet.triangles;
  result.push_back(result.front());
  return result;
}

// Calls `run(points, triangles)` with surfaces that are none.
template <typename Run>
void check_rejections(const Sheet& sheet, Run&& run)
{
  BOOST_TEST(run(std::vector<Triple>(), Triangles()) == Status::empty_mesh);
  for(const int wrong : {-1, static_cast<int>(sheet.points.size())}) {
    Triangles triangles = sheet.triangles;
    triangles[7][1] = wrong;
    BOOST_TEST(run(sheet.points, triangles) == Status::invalid_option);
  }
  std::vector<Triple> points = sheet.points;
  points[4][1] = not_a_number;
  BOOST_TEST(run(points, sheet.triangles) == Status::non_finite_input);
  Triangles folded = sheet.triangles;
  folded[3][0] = folded[3][1];
  BOOST_TEST(run(sheet.points, folded) == Status::non_manifold);
  // Two triangles with nothing but a vertex in common.
  const std::vector<Triple> bow{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  BOOST_TEST(run(bow, Triangles{{0, 1, 2}, {0, 3, 4}}) == Status::non_manifold);
}

} // namespace

BOOST_AUTO_TEST_CASE(planar_shapes)
{
  const Sheet sheet;
  std::vector<std::pair<int, Pair>> handles;
  std::vector<std::pair<Vertex, Point_2>> mesh_handles;
  for(const int v : {0, 7, 14, 21, 28, 6, 13, 20, 27, 34}) {
    const bool is_right = v % 7 == 6;
    const Pair place{sheet.points[v][0] + (is_right ? 0.4 : 0), sheet.points[v][1] + (is_right ? 0.7 : 0)};
    handles.emplace_back(v, place);
    mesh_handles.emplace_back(Vertex(v), Point_2(place[0], place[1]));
  }
  Mesh mesh = sheet.mesh;
  auto expected = mesh.add_property_map<Vertex, Point_2>("v:result").first;
  const FFM::Summary by_mesh = FFM::deform(mesh, mesh_handles, expected);
  BOOST_TEST_REQUIRE(by_mesh.is_valid(), by_mesh);
  std::vector<Pair> result;
  const FFM::Summary summary = FFM::deform(sheet.points, sheet.triangles, handles, result);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary);
  BOOST_TEST(summary.energy == by_mesh.energy);
  BOOST_TEST(summary.iterations == by_mesh.iterations);
  BOOST_TEST_REQUIRE(result.size() == sheet.points.size());
  for(const Vertex v : mesh.vertices())
    BOOST_TEST((result[v][0] == expected[v].x() && result[v][1] == expected[v].y()));

  // Options as named parameters of both.
  FFM::Map_options options;
  options.max_iterations = 1;
  BOOST_TEST(FFM::deform(mesh, mesh_handles, expected, np::map_options(options)).status == Status::iteration_limit);
  FFM::Flip_free_map_traits<> traits;
  traits.options = options;
  const auto chained = np::map_traits(traits).vertex_point_map(mesh.points());
  BOOST_TEST(FFM::deform(mesh, mesh_handles, expected, chained).status == Status::iteration_limit);
  BOOST_TEST(FFM::deform(sheet.points, sheet.triangles, handles, result, np::map_traits(traits)).status == Status::iteration_limit);
  BOOST_TEST(
    FFM::deform(sheet.points, sheet.triangles, handles, result, np::map_options(FFM::Map_options(), np::map_traits(traits))).converged());

  // Points that no triangle has may be anything, and stay.
  std::vector<Triple> more = sheet.points;
  more.push_back({not_a_number, 3, 0});
  BOOST_TEST(FFM::deform(more, sheet.triangles, handles, result).converged());
  BOOST_TEST(result.back()[1] == 3);

  // A face that is there twice counts once, unless it is to be refused.
  std::vector<Pair> once;
  BOOST_TEST(FFM::deform(sheet.points, sheet.triangles, handles, once).converged());
  BOOST_TEST(FFM::deform(sheet.points, with_first_twice(sheet), handles, result).converged());
  BOOST_TEST((result == once));

  const std::vector<Pair> before(3, Pair{1, 2});
  result = before;
  BOOST_TEST(FFM::deform(sheet.points, with_first_twice(sheet), handles, result, np::strict(true)).status == Status::non_manifold);
  BOOST_TEST((result == before));
  for(const int wrong : {-1, 35, 1000000}) {
    std::vector<std::pair<int, Pair>> elsewhere = handles;
    elsewhere[2].first = wrong;
    BOOST_TEST(FFM::deform(sheet.points, sheet.triangles, elsewhere, result).status == Status::invalid_option);
  }
  handles.clear();
  check_rejections(sheet, [&](const auto& points, const auto& triangles) {
    const Status status = FFM::deform(points, triangles, handles, result).status;
    BOOST_TEST((result == before));
    return status;
  });
}

BOOST_AUTO_TEST_CASE(solids)
{
  const FFM::Tetrahedral_mesh solid = as_mesh(block());
  FFM::Tetrahedral_domain volume;
  std::string message;
  BOOST_TEST_REQUIRE((volume.load(solid.points, solid.tetrahedra, message) == Status::success), message);
  std::vector<std::pair<std::size_t, Triple>> handles;
  for(const int v : solid.tetrahedra[0])
    handles.emplace_back(v, Triple{solid.points[v][0], solid.points[v][1], solid.points[v][2]});
  std::vector<Triple> expected(solid.points.size()), result;
  const FFM::Summary direct = FFM::deform_volume(volume, handles, FFM::internal::Array_map<Triple>{&expected});
  BOOST_TEST_REQUIRE(direct.is_valid(), direct);
  const FFM::Summary summary = FFM::deform_volume(solid.points, solid.tetrahedra, handles, result);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary);
  BOOST_TEST(summary.dimension == 3);
  BOOST_TEST((result == expected));

  FFM::Deform_volume_options soft;
  soft.soft_weight = 0.5;
  handles.back().second[0] += 1;
  const FFM::Summary by_mesh =
    FFM::deform_volume(volume, handles, FFM::internal::Array_map<Triple>{&expected}, FFM::Flip_free_map_traits<>(), soft);
  BOOST_TEST(by_mesh.is_valid());
  BOOST_TEST(FFM::deform_volume(solid.points, solid.tetrahedra, handles, result, np::volume_options(soft)).is_valid());
  BOOST_TEST((result == expected));

  const std::vector<Triple> before = result;
  std::vector<std::array<int, 4>> tetrahedra(solid.tetrahedra.begin(), solid.tetrahedra.end());
  tetrahedra[3][2] = -1;
  BOOST_TEST(FFM::deform_volume(solid.points, tetrahedra, handles, result).status == Status::invalid_option);
  tetrahedra.clear();
  BOOST_TEST(FFM::deform_volume(solid.points, tetrahedra, handles, result).status == Status::empty_mesh);
  std::vector<Triple> points(solid.points.begin(), solid.points.end());
  points[5][0] = not_a_number;
  BOOST_TEST(FFM::deform_volume(points, solid.tetrahedra, handles, result).status == Status::non_finite_input);
  handles[0].first = solid.points.size();
  BOOST_TEST(FFM::deform_volume(solid.points, solid.tetrahedra, handles, result).status == Status::invalid_option);
  BOOST_TEST((result == before));
}

// A line of handles may turn around itself by any angle: it is left alone.
BOOST_AUTO_TEST_CASE(handles_on_a_line)
{
  const FFM::Tetrahedral_mesh solid = as_mesh(block());
  const auto check = [&](const std::array<int, 2>& vertices, const Triple& shift) {
    std::vector<std::pair<int, Triple>> handles;
    for(const int v : vertices)
      handles.emplace_back(v, Triple{solid.points[v][0] + shift[0], solid.points[v][1] + shift[1], solid.points[v][2] + shift[2]});
    std::vector<Triple> result;
    const FFM::Summary summary = FFM::deform_volume(solid.points, solid.tetrahedra, handles, result);
    BOOST_TEST_CONTEXT("the handles " << vertices[0] << " and " << vertices[1])
    BOOST_TEST_REQUIRE(summary.converged(), summary);
    BOOST_TEST(std::abs(summary.energy - 1) <= 1e-6);
    for(const auto& handle : handles)
      BOOST_TEST((result[handle.first] == handle.second));
  };
  for(const auto& t : solid.tetrahedra)
    for(int k = 0; k < 4; ++k)
      for(int l = 0; l < k; ++l)
        for(const Triple& shift : {Triple{0, 0, 0}, Triple{0.3, -2, 1}})
          check({t[k], t[l]}, shift);
}

BOOST_AUTO_TEST_CASE(stretched_edge)
{
  // Handles at an edge of a pyramid of two tetrahedra, one of them its tip.
  const std::vector<Triple> points{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 0.5, 0.5}};
  const std::vector<std::array<int, 4>> tetrahedra{{0, 1, 3, 4}, {0, 3, 2, 4}};
  const std::vector<std::pair<int, Triple>> handles{{0, {1, 0, 0}}, {4, {2.2, 0.5, 0.7}}};
  std::vector<Triple> result;
  const FFM::Summary summary = FFM::deform_volume(points, tetrahedra, handles, result);
  BOOST_TEST_REQUIRE(summary.converged(), summary);
  BOOST_TEST(summary.energy < 1.1);
  BOOST_TEST((result[4] == handles[1].second));
}

BOOST_AUTO_TEST_CASE(maps_with_flips)
{
  const Sheet sheet;
  Mesh mesh = sheet.mesh;
  auto expected = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  std::vector<Pair> uv;
  for(const Vertex v : mesh.vertices()) {
    uv.push_back({sheet.points[v][0], sheet.points[v][1]});
    if(v == Vertex(16))
      uv.back()[0] += 0.8; // beyond its neighbor
    expected[v] = Point_2(uv.back()[0], uv.back()[1]);
  }
  const std::vector<Pair> before = uv;
  FFM::Distortion_report report = FFM::measure_distortion(sheet.points, sheet.triangles, uv);
  BOOST_TEST(report.flips == FFM::number_of_flipped_elements(mesh, expected));
  BOOST_TEST(report.flips > 0);
  BOOST_TEST(!FFM::is_bijective(sheet.triangles, uv));

  const auto border = CGAL::halfedges_around_face(mesh.halfedge(*mesh.faces().begin()), mesh);
  Mesh::Halfedge_index on_border;
  for(const auto h : border)
    if(mesh.is_border(mesh.opposite(h)))
      on_border = mesh.opposite(h);
  const FFM::Summary by_mesh = FFM::repair_map(mesh, on_border, expected);
  const FFM::Summary summary = FFM::repair_map(sheet.points, sheet.triangles, uv);
  BOOST_TEST_REQUIRE(by_mesh.is_valid(), by_mesh);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary);
  BOOST_TEST(summary.cpu_seconds > 0);
  BOOST_TEST(by_mesh.seconds.load > 0);
  for(const Vertex v : mesh.vertices())
    BOOST_TEST((uv[v][0] == expected[v].x() && uv[v][1] == expected[v].y()));
  BOOST_TEST(FFM::is_bijective(sheet.triangles, uv) == FFM::is_bijective(mesh, expected));
  report = FFM::measure_distortion(sheet.points, sheet.triangles, uv);
  const FFM::Distortion_report same = FFM::measure_distortion(mesh, expected);
  BOOST_TEST(report.flips == 0);
  BOOST_TEST(report.energy == same.energy);
  BOOST_TEST(report.image_area == same.image_area);
  BOOST_TEST(report.max_singular_value == same.max_singular_value);

  FFM::Repair_options options;
  options.polish = false;
  std::vector<Pair> rough = before;
  BOOST_TEST(FFM::repair_map(sheet.points, sheet.triangles, rough, np::repair_options(options)).is_valid());
  BOOST_TEST((rough != uv));

  // A face that is there twice counts once, unless it is to be refused.
  std::vector<Pair> twice = before;
  BOOST_TEST(FFM::repair_map(sheet.points, with_first_twice(sheet), twice).is_valid());
  BOOST_TEST((twice == uv));
  twice = before;
  BOOST_TEST(FFM::repair_map(sheet.points, with_first_twice(sheet), twice, np::strict(true)).status == Status::non_manifold);
  BOOST_TEST((twice == before));

  uv = before;
  check_rejections(sheet, [&](const auto& points, const auto& triangles) {
    std::vector<Pair> map(points.size(), Pair{0, 0});
    return FFM::repair_map(points, triangles, map).status;
  });
  uv.pop_back();
  BOOST_TEST(FFM::repair_map(sheet.points, sheet.triangles, uv).status == Status::invalid_option);
  BOOST_TEST(FFM::measure_distortion(sheet.points, sheet.triangles, uv).status == Status::invalid_option);
  BOOST_TEST(FFM::measure_distortion(std::vector<Triple>(), Triangles(), std::vector<Pair>()).status == Status::empty_mesh);
  std::string message;
  BOOST_TEST(!FFM::is_bijective(sheet.triangles, uv, &message));
  BOOST_TEST(message == "an index is out of range in triangle number 46");
  uv = before;
  uv[9][0] = not_a_number;
  BOOST_TEST(!FFM::is_bijective(sheet.triangles, uv));
  BOOST_TEST(FFM::measure_distortion(sheet.points, sheet.triangles, uv).status == Status::non_finite_input);
  BOOST_TEST(!FFM::repair_map(sheet.points, sheet.triangles, uv).is_valid());
  const Cube closed;
  uv.assign(closed.points.size(), Pair{0, 0});
  BOOST_TEST(FFM::repair_map(closed.points, closed.triangles, uv).status == Status::no_border);
}

BOOST_AUTO_TEST_CASE(seams)
{
  const Cube cube;
  Mesh mesh = cube.mesh;
  auto is_cut = mesh.add_property_map<Edge, bool>("e:cut", false).first;
  const FFM::Cut_summary by_mesh = FFM::cut_to_disk(mesh, is_cut);
  BOOST_TEST_REQUIRE(by_mesh.is_valid(), by_mesh);
  std::vector<std::array<int, 2>> seams;
  const FFM::Cut_summary summary = FFM::cut_to_disk(cube.points, cube.triangles, seams);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary);
  BOOST_TEST(summary.seam_edges == by_mesh.seam_edges);
  BOOST_TEST(summary.seam_length == by_mesh.seam_length);
  std::vector<std::array<int, 2>> expected;
  const auto ordered = [](int a, int b) { return std::array<int, 2>{(std::min)(a, b), (std::max)(a, b)}; };
  for(const Edge e : mesh.edges())
    if(is_cut[e])
      expected.push_back(ordered(mesh.vertex(e, 0), mesh.vertex(e, 1)));
  for(auto& seam : seams)
    seam = ordered(seam[0], seam[1]);
  std::sort(expected.begin(), expected.end());
  std::sort(seams.begin(), seams.end());
  BOOST_TEST((seams == expected));

  // The user's seams stay where they are.
  seams = {{0, 3}};
  BOOST_TEST(FFM::cut_to_disk(cube.points, cube.triangles, seams, np::cut_options(FFM::Cut_options())).user_seam_edges == 1);
  BOOST_TEST((seams.front() == std::array<int, 2>{0, 3}));
  for(const std::array<int, 2>& wrong : {std::array<int, 2>{0, 7}, std::array<int, 2>{-1, 0}, std::array<int, 2>{0, 8}}) {
    seams = {wrong};
    BOOST_TEST(FFM::cut_to_disk(cube.points, cube.triangles, seams).status == Status::invalid_option);
    BOOST_TEST(seams.size() == 1u);
  }
  seams.clear();
  BOOST_TEST(FFM::cut_to_disk(Sheet().points, with_first_twice(Sheet()), seams).status == Status::non_manifold);
  check_rejections(Sheet(), [&](const auto& points, const auto& triangles) {
    seams.clear();
    const Status status = FFM::cut_to_disk(points, triangles, seams).status;
    BOOST_TEST(seams.empty());
    return status;
  });
}

BOOST_AUTO_TEST_SUITE_END() // test_arrays
