// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Flattens a CGAL::Polyhedron_3 whose vertices have no numbers: the result goes to a map from vertices to points.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <unordered_map>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef std::unordered_map<vertex_descriptor, Kernel::Point_2> UV_map;

int main()
{
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);

  UV_map uv;
  const auto summary = CGAL::Flip_free_maps::parameterize(mesh, border_halfedge, boost::associative_property_map<UV_map>(uv));

  std::cout << summary;
  return summary.is_valid() && uv.size() == num_vertices(mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
