// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL::Seam_mesh: closed surfaces that are cut along seams. The map is keyed by halfedges of the uncut mesh.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/io.h>

#include <CGAL/boost/graph/Seam_mesh.h>

#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seam_mesh)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_map = Mesh::Property_map<Vertex, bool>;
using Seam = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;
using UV = Mesh::Property_map<Halfedge, Plain_point_2>;

namespace {

const Plain_point_2 sentinel(12345, -54321);

struct Cut_sphere
{
  Mesh mesh;
  Edge_map edges;
  Vertex_map vertices;
  UV uv;
  int length = 0;

  Cut_sphere()
  {
    add_soup(sphere_soup(), mesh);
    edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    vertices = mesh.add_property_map<Vertex, bool>("v:seam", false).first;
    uv = mesh.add_property_map<Halfedge, Plain_point_2>("h:uv", sentinel).first;
  }

  // Marks up to `most` edges of the way of steepest descent from the highest to the lowest vertex.
  void cut_downwards(Seam& seam, int most)
  {
    Vertex v = *mesh.vertices().begin();
    for(const auto w : mesh.vertices())
      if(mesh.point(w).z() > mesh.point(v).z())
        v = w;
    for(bool lower = true; lower && length < most;) {
      Vertex next = v;
      for(const auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        if(mesh.point(w).z() < mesh.point(next).z())
          next = w;
      lower = next != v;
      if(lower) {
        BOOST_TEST_REQUIRE(seam.add_seam(v, next));
        ++length;
      }
      v = next;
    }
  }

  // A halfedge on the virtual border, or null without a seam.
  boost::graph_traits<Seam>::halfedge_descriptor border(const Seam& seam) const
  {
    for(const auto h : halfedges(seam))
      if(is_border(h, seam))
        return h;
    return boost::graph_traits<Seam>::null_halfedge();
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(sphere_cut_from_pole_to_pole, Cut_sphere)
{
  Seam seam(mesh, edges, vertices);
  cut_downwards(seam, 1000);
  BOOST_TEST_REQUIRE(length >= 4);
  const FFM::Summary summary = FFM::parameterize(seam, border(seam), uv, tight_traits());
  // The ends of the cut stay single, the vertices between them are doubled.
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(mesh.number_of_vertices()) + length - 1);
  check_map(seam, uv, summary, summary.energy);

  // Each vertex of the cut mesh has one point, at its canonical halfedge.
  std::set<Halfedge> canonical;
  for(const auto v : CGAL::vertices(seam))
    canonical.insert(Halfedge(v));
  BOOST_TEST(canonical.size() == static_cast<std::size_t>(summary.vertices));
  for(const auto h : mesh.halfedges())
    BOOST_TEST((uv[h] == sentinel) == (canonical.count(h) == 0));

  // The same as the cut surface built without a seam mesh.
  const FFM::Textured_mesh textured = FFM::textured_mesh(seam, uv);
  BOOST_TEST(textured.points.size() == canonical.size());
  BOOST_TEST(std::abs(FFM::measure_distortion(textured).energy - summary.energy) <= 1e-9);
  Soup soup;
  soup.points = textured.points;
  soup.triangles = textured.triangles;
  Mesh copy;
  add_soup(soup, copy);
  auto copy_uv = copy.add_property_map<Vertex, Plain_point_2>("v:uv").first;
  Halfedge h;
  for(const auto g : copy.halfedges())
    if(copy.is_border(g))
      h = g;
  const FFM::Summary copied = FFM::parameterize(copy, h, copy_uv, tight_traits());
  check_map(copy, copy_uv, copied, summary.energy);
}

BOOST_FIXTURE_TEST_CASE(no_seam, Cut_sphere)
{
  Seam seam(mesh, edges, vertices);
  for(const auto h : {border(seam), boost::graph_traits<Seam>::halfedge_descriptor(*mesh.halfedges().begin())}) {
    const FFM::Summary summary = FFM::parameterize(seam, h, uv);
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::no_border));
    BOOST_TEST(!summary.message.empty());
  }
  for(const auto h : mesh.halfedges())
    BOOST_TEST((uv[h] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(seam_of_one_edge, Cut_sphere)
{
  // A border of two edges has no convex image with an inside.
  Seam seam(mesh, edges, vertices);
  cut_downwards(seam, 1);
  const FFM::Summary summary = FFM::parameterize(seam, border(seam), uv);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::start_not_flip_free));
  BOOST_TEST(!summary.message.empty());
  for(const auto h : mesh.halfedges())
    BOOST_TEST((uv[h] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(seam_of_two_edges, Cut_sphere)
{
  Seam seam(mesh, edges, vertices);
  cut_downwards(seam, 2);
  const FFM::Summary summary = FFM::parameterize(seam, border(seam), uv, tight_traits());
  check_map(seam, uv, summary, summary.energy);
}

BOOST_AUTO_TEST_SUITE_END() // test_seam_mesh
