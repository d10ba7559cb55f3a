// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Arrays of points and tetrahedra: the same shape whatever the convention, faulty arrays, and the way back.

#include "support/unit_test.h"

#include "support/volume_checks.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetrahedral_domain)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

typedef std::array<float, 3> Float_point;

const double infinity = std::numeric_limits<double>::infinity();

Status load(const FFM::Tetrahedral_mesh& mesh, std::string& message)
{
  FFM::Tetrahedral_domain domain;
  message.clear();
  return domain.load(mesh.points, mesh.tetrahedra, message);
}

} // namespace

BOOST_AUTO_TEST_CASE(arrays_become_the_domain)
{
  const FFM::Tetrahedral_mesh mesh = as_mesh(block());
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  BOOST_TEST(Fingerprint::of(domain).distance(fingerprint_of_block()) < 1e-12);
  BOOST_TEST(domain.number_of_components() == 1);
  BOOST_TEST(!domain.is_reflected());
  BOOST_TEST_REQUIRE(domain.vertices().size() == mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v) {
    BOOST_TEST(domain.vertices()[v] == v);
    BOOST_TEST(domain.number(v) == static_cast<int>(v));
    const Eigen::Vector3d p(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
    BOOST_TEST((domain.from_domain(domain.domain().rest_points.col(v)) - p).norm() < 1e-13 * p.norm());
    BOOST_TEST((domain.to_domain(p) - domain.domain().rest_points.col(v)).norm() < 1e-13);
  }
  // At rest every Jacobian is the identity.
  for(std::int64_t e = 0; e < domain.domain().number_of_elements(); ++e)
    BOOST_TEST((domain.domain().jacobian(e, domain.domain().rest_points) - Eigen::Matrix3d::Identity()).norm() < 1e-13);
}

BOOST_AUTO_TEST_CASE(other_orientation_and_unused_points)
{
  FFM::Tetrahedral_mesh mesh = as_mesh(block());
  for(auto& t : mesh.tetrahedra)
    std::swap(t[0], t[1]);
  mesh.points.insert(mesh.points.begin(), {{infinity, 0, 0}});
  mesh.points.push_back({{1e9, 1e9, 1e9}});
  for(auto& t : mesh.tetrahedra)
    for(int& v : t)
      ++v;
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  BOOST_TEST(domain.is_reflected());
  BOOST_TEST(Fingerprint::of(domain).distance(fingerprint_of_block()) < 1e-12);
  BOOST_TEST(domain.number(0) == -1);
  BOOST_TEST(domain.number(1) == 0);
  BOOST_TEST(domain.number(mesh.points.size() - 1) == -1);
  BOOST_TEST(domain.vertices().size() == mesh.points.size() - 2);
}

BOOST_AUTO_TEST_CASE(coordinates_of_every_size)
{
  for(double size : {1e-100, 1e-12, 1e12, 1e100}) {
    FFM::Tetrahedral_mesh mesh = as_mesh(block());
    for(auto& p : mesh.points)
      for(double& c : p)
        c *= size;
    FFM::Tetrahedral_domain domain;
    std::string message;
    BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
    BOOST_TEST(std::abs(domain.domain().scale / size / fingerprint_of_block().scale - 1) < 1e-12);
    for(std::int64_t e = 0; e < domain.domain().number_of_elements(); ++e)
      BOOST_TEST((domain.domain().jacobian(e, domain.domain().rest_points) - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(faulty_arrays)
{
  const FFM::Tetrahedral_mesh good = as_mesh(block());
  std::string message;
  BOOST_TEST((load(FFM::Tetrahedral_mesh(), message) == Status::empty_mesh));
  BOOST_TEST(!message.empty());

  for(int index : {-1, static_cast<int>(good.points.size()), std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    FFM::Tetrahedral_mesh mesh = good;
    mesh.tetrahedra[7][2] = index;
    BOOST_TEST((load(mesh, message) == Status::invalid_option));
    BOOST_TEST(contains(message, "tetrahedron number 7 has the vertex " + std::to_string(index)));
  }
  for(double coordinate : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    FFM::Tetrahedral_mesh mesh = good;
    mesh.points[good.tetrahedra[3][1]][2] = coordinate;
    BOOST_TEST((load(mesh, message) == Status::non_finite_input));
  }
  {
    FFM::Tetrahedral_mesh mesh = good;
    mesh.tetrahedra[5][0] = mesh.tetrahedra[5][3];
    BOOST_TEST((load(mesh, message) == Status::degenerate_rest_element));
    BOOST_TEST(contains(message, "number 5"));
  }
  {
    // Four points of a plane, exactly; then so close to it that the volume is below the rounding errors.
    FFM::Tetrahedral_mesh mesh;
    mesh.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0.25, 0.5, 0}}};
    mesh.tetrahedra = {{{0, 1, 2, 3}}};
    BOOST_TEST((load(mesh, message) == Status::degenerate_rest_element));
    mesh.points[3][2] = 1e-17;
    BOOST_TEST((load(mesh, message) == Status::degenerate_rest_element));
    mesh.points[3][2] = 1e-12;
    BOOST_TEST((load(mesh, message) == Status::success));
  }
  {
    FFM::Tetrahedral_mesh mesh = good;
    std::swap(mesh.tetrahedra[4][1], mesh.tetrahedra[4][2]);
    BOOST_TEST((load(mesh, message) == Status::degenerate_rest_element));
    BOOST_TEST(contains(message, "1 of " + std::to_string(good.tetrahedra.size()) + " tetrahedra are inverted"));
    BOOST_TEST(contains(message, "number 4"));
  }
  {
    FFM::Tetrahedral_mesh mesh = good;
    mesh.points[good.tetrahedra[0][0]][0] = 1.7e308;
    mesh.points[good.tetrahedra[0][1]][0] = -1.7e308;
    BOOST_TEST((load(mesh, message) != Status::success));
    BOOST_TEST(!message.empty());
  }
}

BOOST_AUTO_TEST_CASE(components_are_counted_and_the_domain_is_complete)
{
  FFM::Tetrahedral_mesh mesh = as_mesh(block());
  const std::size_t points = mesh.points.size(), tetrahedra = mesh.tetrahedra.size();
  for(int copy = 1; copy < 3; ++copy)
    for(std::size_t v = 0; v < points; ++v)
      mesh.points.push_back({{mesh.points[v][0] + 100 * copy, mesh.points[v][1], mesh.points[v][2]}});
  for(int copy = 1; copy < 3; ++copy)
    for(std::size_t e = 0; e < tetrahedra; ++e) {
      mesh.tetrahedra.push_back(mesh.tetrahedra[e]);
      for(int& v : mesh.tetrahedra.back())
        v += static_cast<int>(copy * points);
    }
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST((domain.load(mesh.points, mesh.tetrahedra, message) == Status::several_components));
  BOOST_TEST(contains(message, "3 components"));
  BOOST_TEST(domain.number_of_components() == 3);
  double volume = 0;
  for(double measure : domain.domain().measures)
    volume += measure;
  BOOST_TEST(domain.domain().measures.size() == 3 * tetrahedra);
  BOOST_TEST(std::abs(volume - 1) < 1e-13);

  // A failed load leaves nothing of the mesh before.
  BOOST_TEST((domain.load(mesh.points, std::vector<std::array<int, 4>>(), message) == Status::empty_mesh));
  BOOST_TEST(domain.vertices().empty());
  BOOST_TEST(domain.number_of_components() == 0);
}

BOOST_AUTO_TEST_CASE(results_go_back_to_the_users_coordinates)
{
  FFM::Tetrahedral_mesh mesh = as_mesh(block());
  mesh.points.push_back({{5, 5, 5}});
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);

  // A rotation about the origin of the user's coordinates.
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  FFM::Positions<3> x(3, domain.domain().number_of_vertices);
  for(Eigen::Index v = 0; v < x.cols(); ++v)
    x.col(v) = domain.to_domain(R * domain.from_domain(domain.domain().rest_points.col(v)));

  std::vector<std::array<double, 3>> result(mesh.points.size(), {{-1, -1, -1}});
  const Eigen::Vector3d exact = R * Eigen::Vector3d(mesh.points[2][0], mesh.points[2][1], mesh.points[2][2]);
  BOOST_TEST((domain.write_back(x, boost::make_iterator_property_map(result.begin(), boost::typed_identity_property_map<std::size_t>()),
                                message, {{2, exact}}) == Status::success));
  for(std::size_t v = 0; v + 1 < mesh.points.size(); ++v) {
    const Eigen::Vector3d p(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]), q(result[v][0], result[v][1], result[v][2]);
    BOOST_TEST((q - R * p).norm() < 1e-13 * p.norm());
  }
  BOOST_TEST((result[2] == std::array<double, 3>{{exact[0], exact[1], exact[2]}}));
  BOOST_TEST((result.back() == std::array<double, 3>{{-1, -1, -1}}));

  // Other types of points, other keys.
  std::map<std::size_t, Float_point> float_result;
  BOOST_TEST((domain.write_back(x, boost::make_assoc_property_map(float_result), message) == Status::success));
  BOOST_TEST(float_result.size() == x.cols());
  BOOST_TEST(std::abs(float_result[3][1] - result[3][1]) < 1e-4);
}

BOOST_AUTO_TEST_CASE(nothing_is_written_when_elements_flip)
{
  const FFM::Tetrahedral_mesh mesh = as_mesh(block());
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  std::map<std::size_t, Float_point> result;
  const auto map = boost::make_assoc_property_map(result);

  FFM::Positions<3> x = domain.domain().rest_points;
  x.row(1) *= -1;
  BOOST_TEST((domain.write_back(x, map, message) == Status::result_not_representable));
  x = domain.domain().rest_points;
  x(2, 4) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((domain.write_back(x, map, message) == Status::result_not_representable));
  // So thin that float numbers cannot tell its sides apart, though doubles can.
  x = domain.domain().rest_points;
  x.row(0) *= 1e-9;
  BOOST_TEST((domain.write_back(x, map, message) == Status::result_not_representable));
  BOOST_TEST(!message.empty());
  BOOST_TEST(result.empty());
  std::map<std::size_t, std::array<double, 3>> double_result;
  BOOST_TEST((domain.write_back(x, boost::make_assoc_property_map(double_result), message) == Status::success));
}

BOOST_AUTO_TEST_SUITE_END() // test_tetrahedral_domain
