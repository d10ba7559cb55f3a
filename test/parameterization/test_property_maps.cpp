// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Property maps of other kinds than the mesh' own, for the points and for the map.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/io.h>

#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <array>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_property_maps)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Index_map = boost::property_map<Mesh, boost::vertex_index_t>::type;

namespace {

struct Fixture
{
  Soup soup = bumpy_soup();
  Plain_result plain = plain_result(soup);
  Mesh mesh;
  std::vector<Vertex> vertices = add_soup(soup, mesh);
  Mesh::Halfedge_index border = corner_halfedge(mesh);
  Index_map index = get(boost::vertex_index, mesh);

  template <typename UV>
  void check(UV uv)
  {
    check_map(mesh, uv, FFM::parameterize(mesh, border, uv, tight_traits()), plain.summary.energy);
    BOOST_TEST(is_same_map(vertices, uv, plain));
  }
};

struct Doubling_points
{
  using key_type = Vertex;
  using value_type = std::array<double, 3>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const Soup* soup;

  friend value_type get(const Doubling_points& map, Vertex v)
  {
    value_type p = map.soup->points[v];
    for(double& c : p)
      c *= 2;
    return p;
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(uv_in_a_vector, Fixture)
{
  std::vector<Plain_point_2> uv(soup.points.size());
  check(boost::make_iterator_property_map(uv.begin(), index));
}

BOOST_FIXTURE_TEST_CASE(uv_behind_a_raw_pointer, Fixture)
{
  std::vector<Plain_point_2> uv(soup.points.size());
  check(boost::make_iterator_property_map(uv.data(), index));
  // Surface_mesh' vertices convert to numbers, which suits a plain pointer as a property map.
  std::vector<Plain_point_2> bare(soup.points.size());
  Plain_point_2* const pointer = bare.data();
  BOOST_TEST(FFM::parameterize(mesh, border, pointer, tight_traits()).converged());
  for(std::size_t i = 0; i < bare.size(); ++i)
    BOOST_TEST((bare[i] == plain.uv[i]));
}

BOOST_FIXTURE_TEST_CASE(uv_in_a_map, Fixture)
{
  std::map<Vertex, Plain_point_2> uv;
  check(boost::make_assoc_property_map(uv));
  BOOST_TEST(uv.size() == soup.points.size());
  std::unordered_map<Vertex, Plain_point_2> hashed;
  check(boost::make_assoc_property_map(hashed));
  BOOST_TEST(hashed.size() == soup.points.size());
}

BOOST_FIXTURE_TEST_CASE(uv_in_a_growing_vector, Fixture) { check(boost::make_vector_property_map<Plain_point_2>(index)); }

BOOST_FIXTURE_TEST_CASE(uv_in_a_dynamic_property, Fixture) { check(get(CGAL::dynamic_vertex_property_t<Plain_point_2>(), mesh)); }

BOOST_FIXTURE_TEST_CASE(uv_without_cgal_points, Fixture)
{
  std::vector<Eigen::Vector2d> vectors(soup.points.size());
  check(boost::make_iterator_property_map(vectors.begin(), index));
  std::vector<std::array<double, 2>> arrays(soup.points.size());
  check(boost::make_iterator_property_map(arrays.begin(), index));
}

BOOST_FIXTURE_TEST_CASE(points_by_named_parameter, Fixture)
{
  std::vector<Mesh::Point> points;
  for(const auto v : mesh.vertices()) {
    points.push_back(mesh.point(v));
    mesh.point(v) = Mesh::Point(std::numeric_limits<double>::quiet_NaN(), 1e308, 0);
  }
  const auto point_map = boost::make_iterator_property_map(points.begin(), index);
  const auto np = CGAL::parameters::vertex_point_map(point_map);
  std::vector<Plain_point_2> uv_points(soup.points.size());
  const auto uv = boost::make_iterator_property_map(uv_points.begin(), index);
  check_map(mesh, uv, FFM::parameterize(mesh, border, uv, tight_traits(), np), plain.summary.energy, np);
  BOOST_TEST(is_same_map(vertices, uv, plain));

  // The default method takes named parameters alone; several of them chain.
  BOOST_TEST(FFM::parameterize(mesh, border, uv, np).converged());
  BOOST_TEST(FFM::parameterize(mesh, border, uv, np.number_of_iterations(2)).iterations == 2);
  BOOST_TEST(FFM::parameterize(mesh, border, uv, CGAL::parameters::number_of_iterations(2).vertex_point_map(point_map)).iterations == 2);

  // Without it the garbage counts.
  const FFM::Summary summary = FFM::parameterize(mesh, border, uv, tight_traits());
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::non_finite_input));

  const FFM::Textured_mesh textured = FFM::textured_mesh(mesh, uv, np);
  BOOST_TEST(textured.points.size() == points.size());
  const auto& first = textured.points[textured.triangles[0][0]];
  const auto v = mesh.target(mesh.halfedge(*mesh.faces().begin()));
  BOOST_TEST((points[v] == Mesh::Point(first[0], first[1], first[2])));
}

BOOST_FIXTURE_TEST_CASE(points_computed_when_read, Fixture)
{
  // Twice the size gives twice the map.
  const auto np = CGAL::parameters::vertex_point_map(Doubling_points{&soup});
  std::vector<Plain_point_2> uv_points(soup.points.size());
  const auto uv = boost::make_iterator_property_map(uv_points.begin(), index);
  check_map(mesh, uv, FFM::parameterize(mesh, border, uv, tight_traits(), np), plain.summary.energy, np);
  for(std::size_t i = 0; i < uv_points.size(); ++i)
    BOOST_TEST((uv_points[i] == Plain_point_2(2 * plain.uv[i].x(), 2 * plain.uv[i].y())));
}

BOOST_AUTO_TEST_SUITE_END() // test_property_maps
