// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Writes an open, bumpy surface of 20000 triangles, a disk to try the package on.
//
// usage: generate_surface [FILE.off]

#include "bumpy_surface.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string file_name = (argc > 1) ? argv[1] : "generated_surface.off";

  Mesh mesh;
  make_bumpy_surface(mesh, 100);

  if(!CGAL::IO::write_OFF(file_name, mesh, CGAL::parameters::stream_precision(17))) {
    std::cerr << "Cannot write " << file_name << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << file_name << ": " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " triangles" << std::endl;
  return EXIT_SUCCESS;
}
