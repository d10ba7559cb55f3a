// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Flattens a surface with the default method.
//
// usage: simple_parameterization [FILE]   (OFF, OBJ, PLY or STL; without a file a generated surface is flattened)

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    make_bumpy_surface(mesh);
  // Not the reader of Polygon_mesh_processing: it would sew up the cuts of a surface that was cut open.
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "Cannot read " << argv[1] << std::endl;
    return EXIT_FAILURE;
  }

  //! [two lines]
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto summary = CGAL::Flip_free_maps::parameterize(mesh, PMP::longest_border(mesh).first, uv);
  //! [two lines]

  std::cout << summary;
  if(!summary.is_valid())
    return EXIT_FAILURE;
  std::cout << "The first vertex is at " << uv[*vertices(mesh).begin()] << std::endl;
  return EXIT_SUCCESS;
}
