// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Handle files in both forms, the rule of the nearest vertex against a search through all vertices, and broken files.

#include "support/unit_test.h"

#include "support/volume_checks.h"

#include "program/formats/Handles.h"
#include <CGAL/Flip_free_maps/IO/Medit.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_handles)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
std::string message_for(const std::string& content, const FFM::Positions<D>& points, FFM::Handles<D>& handles,
                        const std::vector<bool>& may_be_handle = {})
{
  const Directory directory;
  std::string message = "old";
  const bool is_read = FFM::read_handles<D>(directory.write("a.handles", content), points, handles, &message, may_be_handle);
  BOOST_TEST(is_read == message.empty());
  return message;
}

// The same lines through a search of all vertices, the first of the nearest ones.
template <int D>
std::int32_t nearest(const FFM::Positions<D>& points, const Eigen::Matrix<double, D, 1>& place)
{
  std::int32_t best = 0;
  for(std::int32_t v = 1; v < points.cols(); ++v)
    if((points.col(v) - place).squaredNorm() < (points.col(best) - place).squaredNorm())
      best = v;
  return best;
}

FFM::Positions<2> square()
{
  FFM::Positions<2> points(2, 4);
  points << 0, 1, 1, 0, 0, 0, 1, 1;
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(both_forms)
{
  FFM::Handles<2> handles;
  BOOST_TEST(message_for<2>("# three handles\n\n2 5 6\r\n0.9 -0.2 -> 7 8e0 # the second vertex\n  0 -1 +2.5", square(), handles) == "");
  BOOST_TEST((handles.vertices == std::vector<std::int32_t>{2, 1, 0}));
  Eigen::Matrix<double, 2, 3> targets;
  targets << 5, 7, -1, 6, 8, 2.5;
  BOOST_TEST((handles.targets == targets));
  // Of vertices at the same distance the first one.
  BOOST_TEST(message_for<2>("0.5 0.5 -> 1 1\n", square(), handles) == "");
  BOOST_TEST(handles.vertices[0] == 0);
  BOOST_TEST(message_for<2>("1.5 0.5 -> 1 1\n", square(), handles) == "");
  BOOST_TEST(handles.vertices[0] == 1);

  FFM::Positions<3> points(3, 2);
  points << 0, 4, 0, 5, 0, 6;
  FFM::Handles<3> spatial;
  BOOST_TEST(message_for<3>("4 5 7 -> 1 2 3\n0 9 8 7\n", points, spatial) == "");
  BOOST_TEST((spatial.vertices == std::vector<std::int32_t>{1, 0}));
  BOOST_TEST((spatial.targets.col(1) == Eigen::Vector3d(9, 8, 7)));
}

BOOST_AUTO_TEST_CASE(vertices_of_no_element)
{
  FFM::Handles<2> handles;
  const std::vector<bool> may_be_handle = {false, true, false, true};
  BOOST_TEST(message_for<2>("3 1 1\n0.1 0 -> 2 2\n", square(), handles, may_be_handle) == "");
  BOOST_TEST((handles.vertices == std::vector<std::int32_t>{3, 1}));
  BOOST_TEST(message_for<2>("3 1 1\n2 1 1\n", square(), handles, may_be_handle).find("line 2: vertex 2 is not") != std::string::npos);
  BOOST_TEST((handles.vertices == std::vector<std::int32_t>{3, 1}));
  BOOST_TEST(message_for<2>("0 0 -> 1 1\n", square(), handles, {false, false, false, false}) != "");
}

// Squares of such lengths are 0 or infinite.
BOOST_AUTO_TEST_CASE(nearest_vertex_at_any_magnitude)
{
  for(const double unit : {1e-200, 1e200}) {
    FFM::Handles<2> handles;
    const FFM::Positions<2> points = unit * square();
    const std::string text = unit < 1 ? "0.9e-200 0.1e-200 -> 0 0\n" : "0.9e200 0.1e200 -> 0 0\n";
    BOOST_TEST(message_for<2>(text, points, handles) == "");
    BOOST_TEST(handles.vertices[0] == nearest<2>(square(), Eigen::Vector2d(0.9, 0.1)));
    FFM::Handles<3> spatial;
    FFM::Positions<3> corners(3, 2);
    corners << 0, 0, 0, 0, 0, unit;
    BOOST_TEST(message_for<3>(unit < 1 ? "0 0 0.6e-200 -> 1 2 3\n" : "0 0 0.6e200 -> 1 2 3\n", corners, spatial) == "");
    BOOST_TEST(spatial.vertices[0] == 1);
  }
}

BOOST_AUTO_TEST_CASE(nearest_vertex_among_many)
{
  Random random(6);
  // A coarse grid, so that ties are frequent; some vertices coincide.
  FFM::Positions<3> points(3, 2000);
  for(Eigen::Index i = 0; i < points.size(); ++i)
    points.data()[i] = std::floor(random(-8, 8));
  const FFM::internal::Nearest_point<3> search(points);
  for(int i = 0; i < 3000; ++i) {
    Eigen::Vector3d place(random(-12, 12), random(-12, 12), random(-12, 12));
    if(i % 2 == 0)
      place = (2 * place).array().floor() / 2;
    BOOST_TEST_REQUIRE(search(place) == nearest<3>(points, place));
  }
}

BOOST_AUTO_TEST_CASE(broken_files)
{
  const std::pair<std::string, std::string> cases[] = {{"", "no handle"},
                                                       {"# nothing\n", "no handle"},
                                                       {"1 5 6\n\n4 0 0\n", "line 3: vertex index 4 is out of range, there are 4 vertices"},
                                                       {"-1 5 6\n", "line 1: vertex index -1"},
                                                       {"99999999999999999999 5 6\n", "line 1"},
                                                       {"1.5 5 6\n", "line 1: '1.5' is not the index of a vertex"},
                                                       {"1 5\n", "line 1: expected 'index x y'"},
                                                       {"1 5 6 7\n", "line 1"},
                                                       {"0 0 0 -> 1 1 1\n", "line 1"},
                                                       {"0 0 - > 1 1\n", "line 1"},
                                                       {"0 0 => 1 1\n", "line 1"},
                                                       {"0 0 -> 1\n1\n", "line 1"},
                                                       {"0 nan -> 1 1\n", "line 1: 'nan' is not a finite number"},
                                                       {"0 0 -> 1 inf\n", "line 1: 'inf' is not a finite number"},
                                                       {"0 x y\n", "line 1: 'x' is not a finite number"},
                                                       {"0.1 0 -> 1 1\n0 0.2 -> 2 2\n", "line 2: this is vertex 0, as in line 1"},
                                                       {"1 1 1\n3 3 3\n0.9 0.1 -> 2 2\n", "line 3: this is vertex 1, as in line 1"}};
  for(const auto& broken : cases) {
    FFM::Handles<2> handles;
    handles.vertices = {77};
    const std::string message = message_for<2>(broken.first, square(), handles);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
    BOOST_TEST((handles.vertices == std::vector<std::int32_t>{77}));
  }
  FFM::Handles<2> handles;
  std::string message;
  BOOST_TEST(!FFM::read_handles<2>("/no/such/file", square(), handles, &message));
  BOOST_TEST(contains(message, "/no/such/file"));
  BOOST_TEST(!FFM::read_handles<2>("/no/such/file", square(), handles));
  BOOST_TEST(contains(message_for<2>("0 1 1\n", FFM::Positions<2>(2, 0), handles), "no vertices"));
}

BOOST_AUTO_TEST_CASE(handles_of_real_meshes, *boost::unit_test::label("needs_data"))
{
  const std::string root = std::string(FLIP_FREE_MAPS_SHARED_DATA_DIR) + "/";
  const struct
  {
    const char* mesh;
    const char* handles;
    std::size_t count;
  } cases[] = {{"cases/tet/spot.mesh", "cases/handles/spot.handles", 9},
               {"cases/tet/bar_twist.mesh", "cases/handles/bar_twist.handles", 162},
               {"tet_bar.mesh", "tet_bar_twist.handles", 50}};
  for(const auto& c : cases) {
    if(!std::filesystem::exists(root + c.handles)) {
      skip_case("there is no " + root + c.handles);
      continue;
    }
    FFM::Tetrahedral_mesh mesh;
    std::string message;
    BOOST_TEST_REQUIRE(FFM::read_Medit(root + c.mesh, mesh, &message), message);
    const FFM::Positions<3> points = Eigen::Map<const FFM::Positions<3>>(mesh.points[0].data(), 3, mesh.points.size());
    FFM::Handles<3> handles;
    BOOST_TEST_REQUIRE(FFM::read_handles<3>(root + c.handles, points, handles, &message), message);
    BOOST_TEST(handles.vertices.size() == c.count);
    BOOST_TEST(handles.targets.cols() == static_cast<Eigen::Index>(c.count));
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_handles
