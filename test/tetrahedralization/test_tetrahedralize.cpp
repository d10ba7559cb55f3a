// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Closed surfaces are filled with tetrahedra that cover what they enclose.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/tetrahedralize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetrahedralize)

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;

namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Twelve triangles around the box from `low` to `low` + `size` in all directions.
void add_cube(Mesh& mesh, double low, double size)
{
  std::array<Mesh::Vertex_index, 8> v;
  for(int i = 0; i < 8; ++i)
    v[i] = mesh.add_vertex(Point(low + size * (i & 1), low + size * (i >> 1 & 1), low + size * (i >> 2 & 1)));
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for(const auto& q : quads) {
    mesh.add_face(v[q[0]], v[q[1]], v[q[2]]);
    mesh.add_face(v[q[0]], v[q[2]], v[q[3]]);
  }
}

double volume_of(const FFM::Tetrahedral_mesh& mesh)
{
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  BOOST_TEST(!domain.is_reflected());
  return std::pow(domain.domain().scale, 3);
}

} // namespace

BOOST_AUTO_TEST_CASE(cube_keeps_its_edges)
{
  Mesh surface;
  surface.add_vertex(Point(100, 100, 100));
  add_cube(surface, 3, 2);
  FFM::Tetrahedralization_options options;
  options.cell_size = 0.15;
  options.facet_distance = 0.01;
  FFM::Tetrahedral_mesh mesh;
  std::string message;
  BOOST_TEST_REQUIRE((FFM::tetrahedralize(surface, mesh, options, message) == Status::success), message);
  BOOST_TEST(std::abs(volume_of(mesh) - 8) < 1e-9);
  BOOST_TEST(mesh.tetrahedra.size() > 50);
  BOOST_TEST((mesh.triangles == FFM::boundary_triangles(mesh)));
  // The boundary encloses the same volume, seen from outside counterclockwise.
  double sum = 0;
  for(const auto& t : mesh.triangles) {
    Eigen::Matrix3d corners;
    for(int k = 0; k < 3; ++k)
      corners.col(k) = Eigen::Map<const Eigen::Vector3d>(mesh.points[t[k]].data());
    sum += corners.determinant() / 6;
  }
  BOOST_TEST(std::abs(sum - 8) < 1e-9);
}

BOOST_AUTO_TEST_CASE(inner_surface_bounds_a_void)
{
  Mesh surface;
  add_cube(surface, 0, 3);
  add_cube(surface, 1, 1);
  FFM::Tetrahedralization_options options;
  options.cell_size = 0.15;
  options.facet_distance = 0.02;
  FFM::Tetrahedral_mesh mesh;
  std::string message;
  BOOST_TEST_REQUIRE((FFM::tetrahedralize(surface, mesh, options, message) == Status::success), message);
  BOOST_TEST(std::abs(volume_of(mesh) - 26) < 1e-9);
}

BOOST_AUTO_TEST_CASE(surfaces_that_cannot_be_filled)
{
  const FFM::Tetrahedralization_options options;
  FFM::Tetrahedral_mesh mesh;
  mesh.points = {{{1, 2, 3}}};
  std::string message;
  const auto status_of = [&](const Mesh& surface) {
    message.clear();
    return FFM::tetrahedralize(surface, mesh, options, message);
  };
  BOOST_TEST((status_of(Mesh()) == Status::empty_mesh));

  Mesh cube;
  add_cube(cube, 0, 1);
  Mesh open = cube;
  CGAL::Euler::remove_face(open.halfedge(Mesh::Face_index(3)), open);
  BOOST_TEST((status_of(open) == Status::non_manifold));
  BOOST_TEST(message.find("not closed") != std::string::npos);

  Mesh quad = cube;
  for(const auto h : halfedges(quad))
    if(CGAL::squared_distance(quad.point(source(h, quad)), quad.point(target(h, quad))) > 1.5) {
      CGAL::Euler::join_face(h, quad);
      break;
    }
  BOOST_TEST((status_of(quad) == Status::not_triangular));

  Mesh crossed = cube;
  add_cube(crossed, 0.5, 1);
  BOOST_TEST((status_of(crossed) == Status::non_manifold));
  BOOST_TEST(message.find("intersects itself") != std::string::npos);

  Mesh flat = cube;
  flat.point(Mesh::Vertex_index(1)) = flat.point(Mesh::Vertex_index(0));
  BOOST_TEST((status_of(flat) == Status::degenerate_rest_element));
  Mesh not_a_number = cube;
  not_a_number.point(Mesh::Vertex_index(5)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  BOOST_TEST((status_of(not_a_number) == Status::non_finite_input));
  BOOST_TEST(!message.empty());
  BOOST_TEST(mesh.points.size() == 1u);

  for(double size : {0., -1., 1e-9, 2., std::numeric_limits<double>::quiet_NaN()}) {
    FFM::Tetrahedralization_options bad;
    bad.cell_size = size;
    BOOST_TEST((FFM::tetrahedralize(cube, mesh, bad, message) == Status::invalid_option));
    BOOST_TEST(message.find("cell_size") != std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_tetrahedralize
