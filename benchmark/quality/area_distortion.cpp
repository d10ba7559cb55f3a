// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Which energy's maps change areas less: flattens each of the given disks, or two generated ones, with the symmetric gradient and
// with the symmetric Dirichlet energy, and writes a row of CSV for each. Areas of the map are first scaled so that their sum is
// that of the surface; with the ratio r = area in the map / area on the surface of each triangle,
// the columns are the means over the surface of |r - 1| and
// |log r|, and the largest |log r|, for both energies.
//
// usage: area_distortion [MESH...]        (disks: OFF, OBJ, PLY)

#include "../support/Table.h"
#include "../support/generated_meshes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace benchmark_support;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Area_distortion
{
  double mean_difference = 0;
  double mean_logarithm = 0;
  double largest_logarithm = 0;
};

template <typename UVMap>
Area_distortion area_distortion(const Mesh& mesh, const UVMap& uv)
{
  std::vector<double> areas, images;
  double area = 0, image = 0;
  for(const auto face : mesh.faces()) {
    const auto h = mesh.halfedge(face);
    areas.push_back(PMP::face_area(face, mesh));
    images.push_back(CGAL::area(uv[mesh.source(h)], uv[mesh.target(h)], uv[mesh.target(mesh.next(h))]));
    area += areas.back();
    image += images.back();
  }
  Area_distortion result;
  for(std::size_t i = 0; i < areas.size(); ++i) {
    const double ratio = images[i] / areas[i] * area / image, logarithm = std::abs(std::log(ratio));
    result.mean_difference += areas[i] / area * std::abs(ratio - 1);
    result.mean_logarithm += areas[i] / area * logarithm;
    result.largest_logarithm = (std::max)(result.largest_logarithm, logarithm);
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  std::cout << "# " << machine()
            << "\nmesh,triangles,gradient_mean_difference,dirichlet_mean_difference,gradient_mean_logarithm,dirichlet_mean_logarithm,"
               "gradient_largest_logarithm,dirichlet_largest_logarithm\n";
  int failures = 0, meshes = 0;
  std::vector<double> ratios;
  const auto run = [&](Mesh& mesh, const std::string& name) {
    auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const FFM::Any_energy energies[] = {FFM::Any_energy(FFM::Symmetric_gradient()), FFM::Any_energy(FFM::Symmetric_dirichlet())};
    Area_distortion result[2];
    bool is_valid = true;
    for(int i = 0; i < 2 && is_valid; ++i) {
      FFM::Any_map_traits traits;
      traits.energy = energies[i];
      traits.options.max_seconds = 60;
      is_valid = FFM::parameterize(mesh, PMP::longest_border(mesh).first, uv, traits).converged();
      result[i] = area_distortion(mesh, uv);
    }
    if(!is_valid) {
      std::cerr << name << " was not flattened.\n";
      ++failures;
      return;
    }
    ++meshes;
    // A developable surface has no distortion to compare.
    if(result[1].mean_difference > 1e-6)
      ratios.push_back(result[0].mean_difference / result[1].mean_difference);
    std::cout << name << ',' << mesh.number_of_faces() << ',' << format(result[0].mean_difference, 5) << ','
              << format(result[1].mean_difference, 5) << ',' << format(result[0].mean_logarithm, 5) << ','
              << format(result[1].mean_logarithm, 5) << ',' << format(result[0].largest_logarithm, 5) << ','
              << format(result[1].largest_logarithm, 5) << std::endl;
  };
  for(int i = 1; i < argc; ++i) {
    Mesh mesh;
    const std::string path = argv[i];
    if(CGAL::IO::read_polygon_mesh(path, mesh))
      run(mesh, path.substr(path.rfind('/') + 1));
    else {
      std::cerr << "Cannot read " << path << ".\n";
      ++failures;
    }
  }
  if(argc == 1) {
    Mesh bumpy, ball;
    make_bumpy_surface(bumpy, 30);
    run(bumpy, "generated_bumpy");
    make_ball(ball, 40);
    run(ball, "generated_ball");
  }
  std::cout << "# " << meshes << " meshes; gradient over dirichlet, mean |r - 1|: median " << format(quantile(ratios, 0.5)) << ", least "
            << format(quantile(ratios, 0)) << ", greatest " << format(quantile(ratios, 1)) << std::endl;
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
