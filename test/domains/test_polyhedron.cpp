// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL::Polyhedron_3 without ids, and a seam through one.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/property_map/property_map.hpp>

#include <map>
#include <unordered_map>

BOOST_AUTO_TEST_SUITE(test_polyhedron)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
using Halfedge = boost::graph_traits<Polyhedron>::halfedge_descriptor;
using Edge = boost::graph_traits<Polyhedron>::edge_descriptor;

BOOST_AUTO_TEST_CASE(without_ids)
{
  const Soup soup = bumpy_soup();
  const Plain_result plain = plain_result(soup);
  Polyhedron mesh;
  const auto vertices = add_soup(soup, mesh);
  std::unordered_map<Vertex, Plain_point_2> uv_points;
  const auto uv = boost::make_assoc_property_map(uv_points);
  check_map(mesh, uv, FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits()), plain.summary.energy);
  BOOST_TEST(uv_points.size() == soup.points.size());
  BOOST_TEST(is_same_map(vertices, uv, plain));
}

BOOST_AUTO_TEST_CASE(unsuitable_halfedges)
{
  Polyhedron mesh;
  add_soup(bumpy_soup(2, 2), mesh);
  std::unordered_map<Vertex, Plain_point_2> uv_points;
  const auto uv = boost::make_assoc_property_map(uv_points);
  for(const Halfedge h : {Halfedge(), opposite(corner_halfedge(mesh), mesh)})
    BOOST_TEST(FFM::status_name(FFM::parameterize(mesh, h, uv).status) == FFM::status_name(FFM::Status::no_border));
  BOOST_TEST(uv_points.empty());
}

BOOST_AUTO_TEST_CASE(seam_through_a_polyhedron)
{
  // A slit from the border into the sheet; its first vertex has two points in the map.
  const Soup soup = bumpy_soup();
  Polyhedron mesh;
  const auto vertices = add_soup(soup, mesh);
  std::map<Edge, bool> seam_edges;
  std::map<Vertex, bool> seam_vertices;
  const auto edge_map = boost::make_assoc_property_map(seam_edges);
  const auto vertex_map = boost::make_assoc_property_map(seam_vertices);
  for(const auto e : edges(mesh))
    seam_edges[e] = false;
  for(const auto v : CGAL::vertices(mesh))
    seam_vertices[v] = false;
  using Seam = CGAL::Seam_mesh<Polyhedron, decltype(edge_map), decltype(vertex_map)>;
  Seam seam(mesh, edge_map, vertex_map);
  const int slit[] = {5, 17, 29, 41};
  for(int i = 0; i < 3; ++i)
    BOOST_TEST_REQUIRE(seam.add_seam(vertices[slit[i]], vertices[slit[i + 1]]));

  // The same surface with the slit's vertices doubled where its sides part: on its left side,
  // the triangles of the cells before it.
  Soup cut = soup;
  const int doubled[] = {5, 17, 29};
  for(int v : doubled)
    cut.points.push_back(soup.points[v]);
  for(auto& t : cut.triangles) {
    double center = 0;
    for(int v : t)
      center += soup.points[v][0] / 3;
    if(center < soup.points[5][0])
      for(int& v : t)
        for(int k = 0; k < 3; ++k)
          if(v == doubled[k])
            v = static_cast<int>(soup.points.size()) + k;
  }
  const Plain_result plain = plain_result(cut);

  std::unordered_map<Halfedge, Plain_point_2> uv_points;
  const auto uv = boost::make_assoc_property_map(uv_points);
  using Seam_halfedge = boost::graph_traits<Seam>::halfedge_descriptor;
  const FFM::Summary summary = FFM::parameterize(seam, Seam_halfedge(corner_halfedge(mesh)), uv, tight_traits());
  check_map(seam, uv, summary, plain.summary.energy);
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(cut.points.size()));
  BOOST_TEST(uv_points.size() == cut.points.size());
}

BOOST_AUTO_TEST_SUITE_END() // test_polyhedron
