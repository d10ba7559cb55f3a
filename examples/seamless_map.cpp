// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A closed surface is cut open and mapped such that the sides of each seam differ by a rotation by a multiple of 90 degrees: the
// lines of a chessboard cross the seams without a bend. Writes a textured OBJ file.
//
// usage: seamless_map [SURFACE RESULT.obj]

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/io.h>
#include <CGAL/Flip_free_maps/parameterize_with_seams.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seam_edge_map;
typedef Mesh::Property_map<Mesh::Vertex_index, bool> Seam_vertex_map;
typedef CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map> Seam_mesh;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc > 1) {
    if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
      std::cerr << "The file cannot be read." << std::endl;
      return EXIT_FAILURE;
    }
  } else {
    CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  }

  //! [seamless]
  Seam_edge_map seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_seam", false).first;
  Seam_vertex_map seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:on_seam", false).first;
  const FFM::Cut_summary cut = FFM::cut_to_disk(mesh, seam_edges);
  if(cut.status != FFM::Status::success) {
    std::cerr << cut.message << std::endl;
    return EXIT_FAILURE;
  }
  Mesh::Halfedge_index border;
  for(const Mesh::Edge_index e : mesh.edges())
    if(seam_edges[e]) {
      seam_vertices[mesh.vertex(e, 0)] = seam_vertices[mesh.vertex(e, 1)] = true;
      border = mesh.halfedge(e);
    }
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const FFM::Seam_summary summary =
    FFM::parameterize_with_seams(seam_mesh, boost::graph_traits<Seam_mesh>::halfedge_descriptor(border, true), uv);
  //! [seamless]
  std::cout << summary << "seams: " << summary.transformations.size() << ", apart by " << summary.residual << " of their lengths"
            << std::endl;
  if(!summary.is_valid())
    return EXIT_FAILURE;
  return argc < 3 || FFM::write_textured_OBJ(argv[2], FFM::textured_mesh(seam_mesh, uv)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
