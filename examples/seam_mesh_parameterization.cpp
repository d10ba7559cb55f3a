// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A closed surface for programs that use CGAL's package Surface_mesh_parameterization: seams are found by cut_to_disk(),
// CGAL::Seam_mesh cuts the surface along them, and the parameterizer of this package takes the place of another one.
//
// usage: seam_mesh_parameterization [FILE]   (a closed, connected mesh: OFF, OBJ, PLY or STL;
// without a file a torus is generated)

#include <CGAL/Flip_free_maps/Flip_free_parameterizer_3.h>
#include <CGAL/Flip_free_maps/cut_to_disk.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seam_edges;
typedef Mesh::Property_map<Mesh::Vertex_index, bool> Seam_vertices;
typedef CGAL::Seam_mesh<Mesh, Seam_edges, Seam_vertices> Seam_mesh;

void make_torus(Mesh& mesh, int n = 40, int m = 20)
{
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / m, radius = 2 + std::cos(b);
      v.push_back(mesh.add_vertex({radius * std::cos(a), radius * std::sin(a), std::sin(b)}));
    }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const int i1 = (i + 1) % n, j1 = (j + 1) % m;
      mesh.add_face(v[i * m + j], v[i1 * m + j], v[i1 * m + j1]);
      mesh.add_face(v[i * m + j], v[i1 * m + j1], v[i * m + j1]);
    }
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    make_torus(mesh);
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "Cannot read " << argv[1] << std::endl;
    return EXIT_FAILURE;
  }

  //! [seams]
  Seam_edges seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto cut = CGAL::Flip_free_maps::cut_to_disk(mesh, seam_edges);
  std::cout << cut;
  if(!cut.is_valid() || cut.pieces != 1)
    return EXIT_FAILURE;
  Seam_vertices seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  for(const auto edge : mesh.edges())
    if(seam_edges[edge])
      seam_vertices[mesh.vertex(edge, 0)] = seam_vertices[mesh.vertex(edge, 1)] = true;
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  //! [seams]

  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto border = PMP::longest_border(seam_mesh).first;
  const SMP::Error_code code = SMP::parameterize(seam_mesh, CGAL::Flip_free_maps::Flip_free_parameterizer_3<Seam_mesh>(), border, uv);
  std::cout << (code == SMP::OK ? "mapped" : "not mapped") << std::endl;
  return code == SMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
