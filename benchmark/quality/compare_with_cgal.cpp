// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The parameterizers of CGAL's package Surface_mesh_parameterization and this package on the same surfaces, with their default
// settings: how they end, how many triangles are flipped, whether the map is bijective, how distorted it is after the best
// scaling, and how long it takes.
//
// usage: compare_with_cgal OUTPUT.csv MESH...   (disks: OFF, OBJ, PLY or STL)

#include "../support/Table.h"

#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
namespace SMP = CGAL::Surface_mesh_parameterization;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;
// Maps a mesh and says how it ended.
using Method = std::function<std::string(Mesh&, Mesh::Halfedge_index, UV_map)>;

template <typename Parameterizer>
std::string run_cgal(Mesh& mesh, Mesh::Halfedge_index border, UV_map uv)
{
  const SMP::Error_code code = SMP::parameterize(mesh, Parameterizer(), border, uv);
  return code == SMP::OK ? "OK" : "error " + std::to_string(static_cast<int>(code));
}

std::string text(double value)
{
  std::ostringstream out;
  out.precision(6);
  out << value;
  return out.str();
}

int main(int argc, char* argv[])
{
  if(argc < 3) {
    std::cerr << "usage: compare_with_cgal OUTPUT.csv MESH..." << std::endl;
    return EXIT_FAILURE;
  }
  const std::vector<std::pair<std::string, Method>> methods{
    {"Mean_value_coordinates", run_cgal<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>},
    {"Discrete_conformal_map", run_cgal<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>},
    {"Discrete_authalic", run_cgal<SMP::Discrete_authalic_parameterizer_3<Mesh>>},
    {"Iterative_authalic", run_cgal<SMP::Iterative_authalic_parameterizer_3<Mesh>>},
    {"LSCM", run_cgal<SMP::LSCM_parameterizer_3<Mesh>>},
    {"ARAP", run_cgal<SMP::ARAP_parameterizer_3<Mesh>>},
    {"Flip_free_maps", [](Mesh& mesh, Mesh::Halfedge_index border,
                          UV_map uv) { return std::string(FFM::status_name(FFM::parameterize(mesh, border, uv).status)); }},
    {"Flip_free_maps bijective", [](Mesh& mesh, Mesh::Halfedge_index border, UV_map uv) {
       return std::string(FFM::status_name(FFM::parameterize(mesh, border, uv, FFM::parameters::bijective(true)).status));
     }}};
  benchmark_support::Table table({"mesh", "faces", "method", "status", "flips", "bijective", "energy", "seconds"});
  table.comments().push_back("energy: mean symmetric Dirichlet energy after the best scaling, 1 for an isometry");
  for(int i = 2; i < argc; ++i) {
    std::string name = argv[i];
    name = name.substr(name.rfind('/') + 1);
    for(const auto& method : methods) {
      Mesh mesh;
      if(!CGAL::IO::read_polygon_mesh(argv[i], mesh)) {
        std::cerr << "cannot read " << argv[i] << std::endl;
        return EXIT_FAILURE;
      }
      const Mesh::Halfedge_index border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
      UV_map uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", Kernel::Point_2(0, 0)).first;
      std::string status;
      const double begin = FFM::internal::wall_seconds();
      try {
        status = method.second(mesh, border, uv);
      } catch(const std::exception& exception) {
        status = std::string("exception ") + exception.what();
      }
      const double seconds = FFM::internal::wall_seconds() - begin;
      const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
      const bool is_bijective = report.status == FFM::Status::success && FFM::is_bijective(mesh, uv);
      table.add_row({name, std::to_string(mesh.number_of_faces()), method.first, status, std::to_string(report.flips),
                     is_bijective ? "yes" : "no", text(report.energy_of_similarity), text(seconds)});
      if(!table.write(argv[1])) {
        std::cerr << "cannot write " << argv[1] << std::endl;
        return EXIT_FAILURE;
      }
    }
  }
  return EXIT_SUCCESS;
}
