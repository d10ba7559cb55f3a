// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Bends a planar bar by its ends: once by a single call, then step by step as an interactive program would.

#include <CGAL/Flip_free_maps/deform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_2> Mesh;
typedef Mesh::Vertex_index Vertex;

int main()
{
  // A bar from (0, 0) to (8, 1), whose ends are the handles.
  Mesh mesh;
  const auto point = [](double i, double j) { return Kernel::Point_2(i / 10, j / 10); };
  CGAL::make_grid(80, 10, mesh, point, true);

  //! [deform]
  std::vector<std::pair<Vertex, Kernel::Point_2>> handles;
  for(Vertex v : mesh.vertices()) {
    const Kernel::Point_2 p = mesh.point(v);
    if(p.x() == 0)
      handles.emplace_back(v, p);
    else if(p.x() == 8)
      handles.emplace_back(v, Kernel::Point_2(4 + p.y(), 3)); // a quarter turn to the right
  }
  auto bent = mesh.add_property_map<Vertex, Kernel::Point_2>("v:bent").first;
  const FFM::Summary summary = FFM::deform(mesh, handles, bent);
  //! [deform]
  std::cout << summary;

  //! [session]
  FFM::Face_graph_domain<Mesh> graph; // flat arrays
  FFM::Positions<2> rest;             // the rest shape, first in their units, then in the user's
  std::string message;
  graph.load_planar(mesh, mesh.points(), rest, message);
  rest = (graph.domain().scale * rest).colwise() + graph.domain().origin;

  std::vector<std::int32_t> numbers;
  for(const auto& handle : handles)
    numbers.push_back(graph.number_of(handle.first));
  FFM::Deformation<2> deformation(graph.domain(), rest, numbers);

  FFM::Positions<2> targets(2, numbers.size());
  for(int step = 1; step <= 10; ++step) {
    for(std::size_t i = 0; i < handles.size(); ++i) {
      const Kernel::Point_2 from = mesh.point(handles[i].first), to = handles[i].second;
      const double t = 0.1 * step;
      targets.col(i) << (1 - t) * from.x() + t * to.x(), (1 - t) * from.y() + t * to.y();
    }
    const FFM::Summary move = deformation.move(targets); // deformation.positions() is what to draw
    std::cout << "step " << step << ": " << move.iterations << " iterations, energy " << move.energy << std::endl;
    if(!move.is_valid())
      return EXIT_FAILURE;
  }
  //! [session]
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
