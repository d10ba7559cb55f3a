// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Writes an open, bumpy surface of 20000 triangles, a disk to try the package on.
//
// usage: generate_surface [FILE.off]

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef Kernel::Point_3                     Point_3;
typedef CGAL::Surface_mesh<Point_3>         Surface_mesh;

// A sheet over the unit square: a high hill, a dent beside it, and waves.
struct Bumpy_sheet
{
  static constexpr int cells_per_side = 100;

  static double hill(const double x, const double y, const double cx, const double cy, const double width)
  {
    return std::exp(-((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (width * width));
  }

  Point_3 operator()(const int i, const int j) const
  {
    const double x = double(i) / cells_per_side;
    const double y = double(j) / cells_per_side;
    const double z = 0.5 * hill(x, y, 0.35, 0.4, 0.15) - 0.3 * hill(x, y, 0.7, 0.65, 0.12)
                   + 0.02 * std::sin(20. * x) * std::cos(17. * y);
    return Point_3(x, y, z);
  }
};

int main(int argc, char* argv[])
{
  const std::string file_name = (argc > 1) ? argv[1] : "generated_surface.off";

  Surface_mesh mesh;
  CGAL::make_grid(Bumpy_sheet::cells_per_side, Bumpy_sheet::cells_per_side, mesh, Bumpy_sheet(), true);

  if(!CGAL::IO::write_OFF(file_name, mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "Cannot write " << file_name << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << file_name << ": " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " triangles" << std::endl;
  return EXIT_SUCCESS;
}
