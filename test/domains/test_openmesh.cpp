// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// OpenMesh, when it is there.

#include "support/unit_test.h"

#ifdef CGAL_USE_OPENMESH

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "support/mesh_checks.h"

#include <boost/property_map/property_map.hpp>

#include <unordered_map>

#endif

BOOST_AUTO_TEST_SUITE(test_openmesh)

#ifdef CGAL_USE_OPENMESH

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};

using Mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
using Float_mesh = OpenMesh::TriMesh_ArrayKernelT<>;

// Keyed by OpenMesh' own handles, with OpenMesh' own planar points.
template <typename OpenMesh_mesh>
void check()
{
  using Vertex = typename boost::graph_traits<OpenMesh_mesh>::vertex_descriptor;
  const Soup soup = bumpy_soup();
  const Plain_result plain = plain_result(soup);
  OpenMesh_mesh mesh;
  std::vector<Vertex> vertices;
  for(const auto& p : soup.points)
    vertices.push_back(mesh.add_vertex(typename OpenMesh_mesh::Point(p[0], p[1], p[2])));
  for(const auto& t : soup.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);

  std::unordered_map<Vertex, OpenMesh::Vec2d> uv_points;
  const auto uv = boost::make_assoc_property_map(uv_points);
  check_map(mesh, uv, FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits()), plain.summary.energy);
  BOOST_TEST(uv_points.size() == soup.points.size());
}

} // namespace

BOOST_AUTO_TEST_CASE(double_coordinates) { check<Mesh>(); }

BOOST_AUTO_TEST_CASE(float_coordinates) { check<Float_mesh>(); }

BOOST_AUTO_TEST_CASE(property_of_the_mesh)
{
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices;
  const Soup soup = bumpy_soup(3, 3);
  for(const auto& p : soup.points)
    vertices.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], p[2])));
  for(const auto& t : soup.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  const auto uv = get(CGAL::dynamic_vertex_property_t<Plain_point_2>(), mesh);
  check_map(mesh, uv, FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits()), plain_result(soup).summary.energy);
}

#else

BOOST_AUTO_TEST_CASE(needs_openmesh) { test_support::skip_case("built without OpenMesh"); }

#endif

BOOST_AUTO_TEST_SUITE_END() // test_openmesh
