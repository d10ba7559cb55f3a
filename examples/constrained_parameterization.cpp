// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Moves a detail of a finished parameterization while its border stays where it is.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <tuple>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;

int main()
{
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv);
  std::cout << summary;
  if(!summary.is_valid())
    return EXIT_FAILURE;

  const Vertex top = *std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                                       [&mesh](Vertex v, Vertex w) { return mesh.point(v).z() < mesh.point(w).z(); });

  //! [constraints]
  // Continues with the map found so far: the border is fixed, and the top of the hill pulled to a place nearby.
  const Kernel::Point_2 place = uv[top] + Kernel::Vector_2(0.05, 0.1);
  const std::vector<std::tuple<Vertex, Kernel::Point_2, double>> soft{{top, place, 10.}};
  auto moved = mesh.add_property_map<Vertex, Kernel::Point_2>("v:moved").first;
  summary =
    FFM::parameterize(mesh, border_halfedge, moved,
                      FFM::parameters::start_map(uv, FFM::parameters::border_is_fixed(true, FFM::parameters::soft_positions(soft))));
  //! [constraints]
  std::cout << summary;
  if(!summary.is_valid())
    return EXIT_FAILURE;

  bool border_has_stayed = true;
  for(Vertex v : mesh.vertices())
    border_has_stayed = border_has_stayed && (!mesh.is_border(v) || moved[v] == uv[v]);
  std::cout << "The top was " << std::sqrt(CGAL::squared_distance(uv[top], place)) << " away from its place, and is "
            << std::sqrt(CGAL::squared_distance(moved[top], place)) << " away now; the border has "
            << (border_has_stayed ? "stayed" : "moved") << std::endl;
  return border_has_stayed ? EXIT_SUCCESS : EXIT_FAILURE;
}
