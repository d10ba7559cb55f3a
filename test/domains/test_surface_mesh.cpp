// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL::Surface_mesh: with gaps in its indices, other components beside, isolated vertices, and named parameters.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_surface_mesh)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using UV = Mesh::Property_map<Vertex, Plain_point_2>;

namespace {

const Plain_point_2 sentinel(12345, -54321);

struct Fixture
{
  Soup soup = bumpy_soup();
  Plain_result plain = plain_result(soup);
  Mesh mesh;

  UV add_uv() { return mesh.add_property_map<Vertex, Plain_point_2>("v:uv", sentinel).first; }
};

Soup shifted(Soup soup, double x)
{
  for(auto& p : soup.points)
    p[0] += x;
  return soup;
}

} // namespace

BOOST_FIXTURE_TEST_CASE(whole_mesh, Fixture)
{
  const auto vertices = add_soup(soup, mesh);
  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  check_map(mesh, uv, summary, plain.summary.energy);
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(soup.points.size()));
  BOOST_TEST(is_same_map(vertices, uv, plain));
  BOOST_TEST(summary.energy < summary.energy_initial);
  BOOST_TEST(summary.energy > 1);
}

BOOST_FIXTURE_TEST_CASE(any_halfedge_of_the_border_will_do, Fixture)
{
  add_soup(soup, mesh);
  const UV uv = add_uv();
  auto h = corner_halfedge(mesh);
  for(int i = 0; i < 7; ++i)
    h = mesh.next(h);
  check_map(mesh, uv, FFM::parameterize(mesh, h, uv, tight_traits()), plain.summary.energy);
}

BOOST_FIXTURE_TEST_CASE(garbage, Fixture)
{
  // Removed elements have indices before, between and behind those that remain.
  add_soup(shifted(bumpy_soup(2, 2), 10), mesh);
  const auto vertices = add_soup(soup, mesh);
  add_soup(shifted(bumpy_soup(3, 2), -10), mesh);
  std::vector<Mesh::Face_index> removed;
  for(const auto f : mesh.faces())
    if(std::abs(mesh.point(mesh.target(mesh.halfedge(f))).x() - 0.5) > 2)
      removed.push_back(f);
  for(const auto f : removed)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  BOOST_TEST_REQUIRE(mesh.has_garbage());
  BOOST_TEST_REQUIRE(mesh.number_of_faces() == soup.triangles.size());
  BOOST_TEST_REQUIRE(num_vertices(mesh) > soup.points.size());

  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  // CGAL counts removed faces in the size of a range.
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(mesh.number_of_faces()));
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(mesh.number_of_vertices()));
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  BOOST_TEST(std::abs(FFM::measure_distortion(mesh, uv).energy - plain.summary.energy) <= 1e-9);
  BOOST_TEST(is_same_map(vertices, uv, plain));
}

BOOST_FIXTURE_TEST_CASE(removed_faces_make_another_border, Fixture)
{
  // A row of cells less: the map is that of the smaller sheet built anew.
  const auto vertices = add_soup(soup, mesh);
  for(std::size_t i = soup.triangles.size() - 22; i < soup.triangles.size(); ++i)
    CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(i))), mesh);
  BOOST_TEST_REQUIRE(mesh.has_garbage());
  Soup smaller = soup;
  smaller.triangles.resize(soup.triangles.size() - 22);
  smaller.points.resize(soup.points.size() - 12);
  const Plain_result expected = plain_result(smaller);
  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(smaller.triangles.size()));
  BOOST_TEST(std::abs(summary.energy - expected.summary.energy) <= 1e-9);
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  BOOST_TEST(FFM::measure_distortion(mesh, uv).elements == summary.elements);
}

BOOST_FIXTURE_TEST_CASE(only_the_component_of_the_halfedge, Fixture)
{
  const auto others = add_soup(shifted(bumpy_soup(5, 4), 10), mesh);
  const auto vertices = add_soup(soup, mesh);
  const auto more = add_soup(shifted(bumpy_soup(3, 2), 20), mesh);
  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(soup.triangles.size()));
  BOOST_TEST(is_same_map(vertices, uv, plain));
  for(const auto& untouched : {others, more})
    for(const auto v : untouched)
      BOOST_TEST((uv[v] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(faults_of_other_components_do_not_matter, Fixture)
{
  Soup faulty = shifted(bumpy_soup(2, 2), 10);
  faulty.points[4][2] = std::numeric_limits<double>::quiet_NaN();
  add_soup(faulty, mesh);
  const auto vertices = add_soup(soup, mesh);
  const UV uv = add_uv();
  BOOST_TEST(FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits()).converged());
  BOOST_TEST(is_same_map(vertices, uv, plain));
}

BOOST_FIXTURE_TEST_CASE(isolated_vertices, Fixture)
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto first = mesh.add_vertex(Mesh::Point(not_a_number, 0, 0));
  const auto vertices = add_soup(soup, mesh);
  const auto last = mesh.add_vertex(Mesh::Point(1e300, 1, 1));
  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  check_map(mesh, uv, summary, plain.summary.energy);
  BOOST_TEST(is_same_map(vertices, uv, plain));
  BOOST_TEST((uv[first] == sentinel && uv[last] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(number_of_iterations, Fixture)
{
  add_soup(soup, mesh);
  const UV uv = add_uv();
  const auto h = corner_halfedge(mesh);
  for(unsigned int limit : {0u, 1u, 3u}) {
    const FFM::Summary summary = FFM::parameterize(mesh, h, uv, CGAL::parameters::number_of_iterations(limit));
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::iteration_limit));
    BOOST_TEST(summary.iterations == static_cast<int>(limit));
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(!summary.converged());
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
    BOOST_TEST(std::abs(FFM::measure_distortion(mesh, uv).energy - summary.energy) <= 1e-11 * summary.energy);
  }
  // It overrides the traits' own limit.
  auto traits = tight_traits();
  traits.options.max_iterations = 1;
  BOOST_TEST(FFM::parameterize(mesh, h, uv, traits).iterations == 1);
  BOOST_TEST(FFM::parameterize(mesh, h, uv, traits, CGAL::parameters::number_of_iterations(5000)).converged());
}

BOOST_FIXTURE_TEST_CASE(default_method_converges, Fixture)
{
  add_soup(soup, mesh);
  const UV uv = add_uv();
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv);
  BOOST_TEST(summary.converged());
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  BOOST_TEST(std::abs(summary.energy - plain.summary.energy) <= 1e-6);
}

BOOST_AUTO_TEST_SUITE_END() // test_surface_mesh
