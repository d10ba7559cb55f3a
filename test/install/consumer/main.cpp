// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>

int main()
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

  auto bump = [](const double i, const double j) {
    return Kernel::Point_3(i, j, 5. * std::exp(-((i - 10.) * (i - 10.) + (j - 10.) * (j - 10.)) / 20.));
  };

  Mesh mesh;
  Mesh::Halfedge_index border = CGAL::make_grid(20, 20, mesh, bump, true);
  if(!CGAL::is_border(border, mesh))
    border = mesh.opposite(border);

  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  return CGAL::Flip_free_maps::parameterize(mesh, border, uv).converged() ? 0 : 1;
}
