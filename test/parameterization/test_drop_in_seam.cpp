// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL's package Surface_mesh_parameterization on a surface that is cut along seams, with its parameterizer exchanged.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_parameterizer_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

BOOST_AUTO_TEST_SUITE(test_drop_in_seam)

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Polyhedron_3<Kernel> PolyMesh;
typedef boost::graph_traits<PolyMesh>::edge_descriptor SM_edge_descriptor;
typedef boost::graph_traits<PolyMesh>::halfedge_descriptor SM_halfedge_descriptor;
typedef boost::graph_traits<PolyMesh>::vertex_descriptor SM_vertex_descriptor;

typedef CGAL::Unique_hash_map<SM_halfedge_descriptor, Point_2> UV_uhm;
typedef CGAL::Unique_hash_map<SM_edge_descriptor, bool> Seam_edge_uhm;
typedef CGAL::Unique_hash_map<SM_vertex_descriptor, bool> Seam_vertex_uhm;
typedef boost::associative_property_map<UV_uhm> UV_pmap;
typedef boost::associative_property_map<Seam_edge_uhm> Seam_edge_pmap;
typedef boost::associative_property_map<Seam_vertex_uhm> Seam_vertex_pmap;

typedef CGAL::Seam_mesh<PolyMesh, Seam_edge_pmap, Seam_vertex_pmap> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace FFM = CGAL::Flip_free_maps;

typedef FFM::Flip_free_parameterizer_3<Mesh> Parameterizer;

BOOST_AUTO_TEST_CASE(closed_surface_with_a_seam)
{
  PolyMesh sm;
  test_support::add_soup(test_support::sphere_soup(), sm);

  Seam_edge_uhm seam_edge_uhm(false);
  Seam_edge_pmap seam_edge_pm(seam_edge_uhm);
  Seam_vertex_uhm seam_vertex_uhm(false);
  Seam_vertex_pmap seam_vertex_pm(seam_vertex_uhm);
  Mesh mesh(sm, seam_edge_pm, seam_vertex_pm);

  // Down from the highest vertex.
  SM_vertex_descriptor v = *vertices(sm).begin();
  for(SM_vertex_descriptor w : CGAL::vertices(sm))
    if(w->point().z() > v->point().z())
      v = w;
  int seams = 0;
  for(;; ++seams) {
    SM_vertex_descriptor lowest = v;
    for(SM_vertex_descriptor w : CGAL::vertices_around_target(v, sm))
      if(w->point().z() < lowest->point().z())
        lowest = w;
    if(lowest == v)
      break;
    BOOST_TEST_REQUIRE(mesh.add_seam(v, lowest));
    v = lowest;
  }
  BOOST_TEST_REQUIRE(seams >= 4);

  UV_uhm uv_uhm;
  UV_pmap uv_pm(uv_uhm);
  halfedge_descriptor bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;

  FFM::Summary summary;
  BOOST_TEST(SMP::parameterize(mesh, Parameterizer(&summary), bhd, uv_pm) == SMP::OK);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.vertices == static_cast<std::int64_t>(sm.size_of_vertices()) + seams - 1);
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv_pm) == 0);
  BOOST_TEST(std::abs(FFM::measure_distortion(mesh, uv_pm).energy - summary.energy) <= 1e-10);

  // The plain function gives the same.
  UV_uhm uv_plain_uhm;
  UV_pmap uv_plain(uv_plain_uhm);
  const FFM::Summary plain = FFM::parameterize(mesh, bhd, uv_plain);
  BOOST_TEST(plain.converged());
  BOOST_TEST(std::abs(plain.energy - summary.energy) <= 1e-6);
}

BOOST_AUTO_TEST_SUITE_END() // test_drop_in_seam
