// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Chooses a preconditioner, the weights of the start and stopping rules, and watches the iterations.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef FFM::Flip_free_map_traits<CGAL::Default, FFM::Symmetric_dirichlet, FFM::Killing> Traits;

int main()
{
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  Traits traits;
  traits.start.weights = FFM::Tutte_weights::mean_value;
  traits.options.max_seconds = 60;

  // A preview is good enough as soon as a step gains less than a thousandth.
  double last_energy = 0;
  traits.options.observer = [&last_energy](const FFM::Iteration_report& report) {
    std::cout << report.iteration << ": energy " << report.energy << ", step " << report.step << std::endl;
    const bool is_good_enough = report.iteration > 0 && report.energy > 0.999 * last_energy;
    last_energy = report.energy;
    return !is_good_enough;
  };

  const FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv, traits);
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
