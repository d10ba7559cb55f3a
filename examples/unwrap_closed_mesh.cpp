// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// From a closed mesh to an OBJ with a texture: Blender and MeshLab show unwrapped.obj with a checkerboard.
//
// usage: unwrap_closed_mesh [FILE]   (OFF, OBJ, PLY or STL; without a file a ball is unwrapped)

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1) {
    CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "Cannot read " << argv[1] << std::endl;
    return EXIT_FAILURE;
  }

  //! [unwrap]
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto summary = CGAL::Flip_free_maps::unwrap(mesh, uv);
  std::cout << summary;
  if(!summary.is_valid())
    return EXIT_FAILURE;
  CGAL::Flip_free_maps::write_textured_OBJ("unwrapped.obj", CGAL::Flip_free_maps::textured_atlas(mesh, uv));
  //! [unwrap]
  return EXIT_SUCCESS;
}
