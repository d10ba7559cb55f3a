// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps a surface as rigidly as possible by CGAL's package Surface_mesh_parameterization, which flips triangles,
// and repairs the map.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cstdlib>
#include <iostream>

namespace FFM = CGAL::Flip_free_maps;
namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  // The hill of the example surface, five times as high.
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh, 40);
  for(const auto v : mesh.vertices())
    mesh.point(v) = Kernel::Point_3(mesh.point(v).x(), mesh.point(v).y(), 5 * mesh.point(v).z());

  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::ARAP_parameterizer_3<Mesh> as_rigid_as_possible;
  if(SMP::parameterize(mesh, as_rigid_as_possible, border_halfedge, uv) != SMP::OK)
    return EXIT_FAILURE;
  std::cout << FFM::number_of_flipped_elements(mesh, uv) << " flipped triangles" << std::endl;

  //! [repair]
  const FFM::Summary summary = FFM::repair_map(mesh, border_halfedge, uv);
  //! [repair]
  std::cout << summary;
  return summary.is_valid() && FFM::number_of_flipped_elements(mesh, uv) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
