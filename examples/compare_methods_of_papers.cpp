// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The methods of the literature side by side, chosen by name.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  std::cout << std::setw(18) << "method" << std::setw(12) << "iterations" << std::setw(16) << "factorizations" << std::setw(12) << "energy"
            << "  end" << std::endl;
  //! [methods]
  for(const char* method : {"default", "pp", "cm", "slim", "akvf", "p-slim", "p-akvf", "projected-newton", "newton", "aqp", "sobolev"}) {
    FFM::Any_map_traits traits;
    traits.use_method(method);
    traits.options.max_iterations = 300;
    const FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv, traits);
    if(!summary.is_valid())
      return EXIT_FAILURE;
    std::cout << std::setw(18) << method << std::setw(12) << summary.iterations << std::setw(16) << summary.factorizations << std::setw(12)
              << summary.energy << "  " << FFM::status_name(summary.status) << std::endl;
  }
  //! [methods]
  return EXIT_SUCCESS;
}
