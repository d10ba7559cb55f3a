// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL::Face_filtered_graph: a part of a larger surface.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <vector>

BOOST_AUTO_TEST_SUITE(test_face_filtered_graph)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Part = CGAL::Face_filtered_graph<Mesh>;

namespace {

const Plain_point_2 sentinel(12345, -54321);

boost::graph_traits<Part>::halfedge_descriptor border_of(const Part& part)
{
  for(const auto h : halfedges(part))
    if(face(h, part) == boost::graph_traits<Part>::null_face())
      return h;
  return boost::graph_traits<Part>::null_halfedge();
}

// The chosen faces as a mesh of their own, by the corners' numbers.
Soup part_of(const Soup& soup, const std::vector<Face>& faces)
{
  Soup part;
  std::vector<int> numbers(soup.points.size(), -1);
  for(const Face f : faces) {
    auto t = soup.triangles[f];
    for(int& v : t) {
      if(numbers[v] < 0) {
        numbers[v] = static_cast<int>(part.points.size());
        part.points.push_back(soup.points[v]);
      }
      v = numbers[v];
    }
    part.triangles.push_back(t);
  }
  return part;
}

} // namespace

BOOST_AUTO_TEST_CASE(middle_of_a_sheet)
{
  const Soup soup = bumpy_soup();
  Mesh mesh;
  const auto vertices = add_soup(soup, mesh);
  std::vector<Face> chosen;
  for(const Face f : mesh.faces()) {
    const auto& p = mesh.point(mesh.target(mesh.halfedge(f)));
    if(p.x() > 0.15 && p.x() < 0.8 && p.y() > 0.15 && p.y() < 0.6)
      chosen.push_back(f);
  }
  const Part part(mesh, chosen);
  BOOST_TEST_REQUIRE(part.is_selection_valid());
  const Soup alone_soup = part_of(soup, chosen);
  Mesh alone;
  add_soup(alone_soup, alone);
  auto alone_uv = alone.add_property_map<Vertex, Plain_point_2>("v:uv").first;
  Mesh::Halfedge_index alone_border;
  for(const auto h : alone.halfedges())
    if(alone.is_border(h))
      alone_border = h;
  const FFM::Summary expected = FFM::parameterize(alone, alone_border, alone_uv, tight_traits());
  BOOST_TEST_REQUIRE(expected.converged());

  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv", sentinel).first;
  const FFM::Summary summary = FFM::parameterize(part, border_of(part), uv, tight_traits());
  check_map(part, uv, summary, expected.energy);
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(chosen.size()));
  BOOST_TEST(summary.vertices == expected.vertices);
  for(const auto v : vertices)
    BOOST_TEST((uv[v] == sentinel) == !part.is_in_cc(v));
}

BOOST_AUTO_TEST_CASE(northern_half_of_a_sphere)
{
  Mesh mesh;
  add_soup(sphere_soup(), mesh);
  std::vector<Face> chosen;
  for(const Face f : mesh.faces()) {
    double z = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z();
    if(z > 0.3)
      chosen.push_back(f);
  }
  const Part part(mesh, chosen);
  BOOST_TEST_REQUIRE(part.is_selection_valid());
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv", sentinel).first;
  const FFM::Summary summary = FFM::parameterize(part, border_of(part), uv, tight_traits());
  check_map(part, uv, summary, summary.energy);
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(chosen.size()));
}

BOOST_AUTO_TEST_CASE(belt_of_a_sphere)
{
  Mesh mesh;
  add_soup(sphere_soup(), mesh);
  std::vector<Face> chosen;
  for(const Face f : mesh.faces()) {
    double z = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z() / 3;
    if(std::abs(z) < 0.4)
      chosen.push_back(f);
  }
  const Part part(mesh, chosen);
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv", sentinel).first;
  const FFM::Summary summary = FFM::parameterize(part, border_of(part), uv);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::success));
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(chosen.size()));
  BOOST_TEST(FFM::number_of_flipped_elements(part, uv) == 0);
}

BOOST_AUTO_TEST_SUITE_END() // test_face_filtered_graph
