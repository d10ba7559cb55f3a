// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Fills a closed surface with tetrahedra by TetGen, which keeps the surface as it is, and twists the solid by its ends.

#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/tetrahedralize_with_tetgen.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN
  // A ball, drawn out along the x-axis.
  Mesh surface;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(surface);
  CGAL::Subdivision_method_3::Loop_subdivision(surface, CGAL::parameters::number_of_iterations(3));
  for(const Mesh::Vertex_index v : surface.vertices())
    surface.point(v) = Kernel::Point_3(3 * surface.point(v).x(), surface.point(v).y(), surface.point(v).z());

  //! [fill]
  FFM::Tetrahedral_mesh mesh;
  std::string message;
  FFM::Tetrahedral_domain volume;
  if(FFM::tetrahedralize_with_tetgen(surface, mesh, FFM::Tetgen_options(), message) != FFM::Status::success ||
     volume.load(mesh.points, mesh.tetrahedra, message) != FFM::Status::success) {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }
  //! [fill]

  std::vector<std::pair<std::size_t, Kernel::Point_3>> handles;
  for(std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double x = mesh.points[v][0], y = mesh.points[v][1], z = mesh.points[v][2];
    if(x < -1.8)
      handles.emplace_back(v, Kernel::Point_3(x, y, z));
    else if(x > 1.8)
      handles.emplace_back(v, Kernel::Point_3(x, -z, y));
  }
  std::vector<Kernel::Point_3> result(mesh.points.size());
  const FFM::Summary summary = FFM::deform_volume(volume, handles, CGAL::make_property_map(result));
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  std::cout << "Built without TetGen." << std::endl;
  return EXIT_SUCCESS;
#endif
}
