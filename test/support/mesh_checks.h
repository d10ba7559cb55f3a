// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MESH_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MESH_CHECKS_H

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_support {

// Corners in space and the triangles between them.
struct Soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

// A sheet over a rectangle with a hill, a dent, waves and diagonals of both directions. The coordinates are float numbers, so
// that no number type of a mesh rounds them.
Soup bumpy_soup(int columns = 11, int rows = 9);

// The unit sphere between `rings` circles of latitude and two poles.
Soup sphere_soup(int around = 12, int rings = 9);

// Adds a soup to a model of MutableFaceGraph; returns its vertices in the order of the points.
template <typename Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> add_soup(const Soup& soup, Mesh& mesh)
{
  using Point = typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertices;
  auto points = get(CGAL::vertex_point, mesh);
  for(const auto& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), Point(p[0], p[1], p[2]));
  }
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(
      std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3>{{vertices[t[0]], vertices[t[1]], vertices[t[2]]}}, mesh);
  return vertices;
}

// The border halfedge that points to the corner of the sheet at the origin, or null.
template <typename Mesh, typename VertexPointMap>
typename boost::graph_traits<Mesh>::halfedge_descriptor corner_halfedge(const Mesh& mesh, VertexPointMap points)
{
  for(const auto h : halfedges(mesh)) {
    const auto& p = get(points, target(h, mesh));
    if(face(h, mesh) == boost::graph_traits<Mesh>::null_face() && p[0] == 0 && p[1] == 0)
      return h;
  }
  return boost::graph_traits<Mesh>::null_halfedge();
}

template <typename Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor corner_halfedge(const Mesh& mesh)
{
  return corner_halfedge(mesh, get(CGAL::vertex_point, mesh));
}

// Converged so far that the energy, whose error is of second order, has nearly all its digits.
CGAL::Flip_free_maps::Flip_free_map_traits<> tight_traits();

using Plain_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Plain_point_2 = CGAL::Simple_cartesian<double>::Point_2;

// What every mesh type is compared with: the map of a soup as a plain Surface_mesh, and its points in the order of the soup's.
struct Plain_result
{
  CGAL::Flip_free_maps::Summary summary;
  std::vector<Plain_point_2> uv;
};

Plain_result plain_result(const Soup& soup);

// A map of a whole mesh: valid, as good as the summary says, and of the surface's own size.
template <typename Mesh, typename VertexUVMap, typename NamedParameters>
void check_map(const Mesh& mesh, VertexUVMap uv, const CGAL::Flip_free_maps::Summary& summary, double energy, const NamedParameters& np)
{
  namespace FFM = CGAL::Flip_free_maps;
  BOOST_TEST_CONTEXT(summary.message)
  {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::success));
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(summary.elements == static_cast<std::int64_t>(faces(mesh).size()));
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
    BOOST_TEST(FFM::is_flip_free(mesh, uv));
    BOOST_TEST(std::abs(summary.energy - energy) <= 1e-9);
    const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv, np);
    BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(FFM::Status::success));
    BOOST_TEST(report.elements == summary.elements);
    BOOST_TEST(report.flips == 0);
    BOOST_TEST(std::abs(report.energy - energy) <= 1e-9);
    BOOST_TEST(std::abs(report.min_singular_value - summary.min_singular_value) <= 1e-9);
    BOOST_TEST(std::abs(report.max_singular_value - summary.max_singular_value) <= 1e-9);
    // At the optimum no scaling of the image is better than none.
    BOOST_TEST(std::abs(report.energy_of_similarity - report.energy) <= 1e-9);
    BOOST_TEST(std::abs(report.image_area / report.rest_area - 1) <= 0.5 * (energy - 1) + 1e-9);
  }
}

template <typename Mesh, typename VertexUVMap>
void check_map(const Mesh& mesh, VertexUVMap uv, const CGAL::Flip_free_maps::Summary& summary, double energy)
{
  check_map(mesh, uv, summary, energy, CGAL::parameters::default_values());
}

// Whether the points of some vertices are those of the plain result, to the last bit.
template <typename Vertices, typename VertexUVMap>
bool is_same_map(const Vertices& vertices, VertexUVMap uv, const Plain_result& plain)
{
  for(std::size_t i = 0; i < plain.uv.size(); ++i)
    if(get(uv, vertices[i])[0] != plain.uv[i][0] || get(uv, vertices[i])[1] != plain.uv[i][1])
      return false;
  return true;
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_MESH_CHECKS_H
