// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Flattens every given mesh by every method and writes a CSV row for each pair.
//
// usage: compare_methods [--methods NAME,NAME,..] [--seconds LIMIT] MESH...
//
// Columns: what the Summary says; "to_1_percent" and "to_1e-4" are the iterations after which the energy stays within that relative
// distance of the run's final energy.

#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/version.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using D = CGAL::Default;

namespace {

struct Run
{
  FFM::Summary summary;
  std::vector<double> energies;

  std::size_t iterations_to(double relative) const
  {
    std::size_t i = energies.size();
    while(i > 0 && energies[i - 1] <= summary.energy * (1 + relative))
      --i;
    return i;
  }
};

template <typename Traits>
Run run(Mesh& mesh, double seconds, bool from_tutte = false)
{
  Run result;
  Traits traits;
  if(from_tutte)
    traits.start.multilevel_size = -1;
  traits.options.max_seconds = seconds;
  traits.options.observer = [&result](const FFM::Iteration_report& report) {
    result.energies.push_back(report.energy);
    return true;
  };
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  result.summary = FFM::parameterize(mesh, border, uv, traits);
  return result;
}

// The papers' methods: a factorization for each iteration, beginning with a Tutte embedding.
template <typename Preconditioner>
Run run_plain(Mesh& mesh, double seconds)
{
  return run<FFM::Flip_free_map_traits<D, D, Preconditioner, D, D, FFM::No_acceleration, FFM::Every_iteration>>(mesh, seconds, true);
}

std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

} // namespace

int main(int argc, char** argv)
{
  const std::map<std::string, std::function<Run(Mesh&, double)>> all = {
    {"default", [](Mesh& mesh, double limit) { return run<FFM::Flip_free_map_traits<>>(mesh, limit); }},
    {"default_from_tutte", [](Mesh& mesh, double limit) { return run<FFM::Flip_free_map_traits<>>(mesh, limit, true); }},
    {"laplacian", run_plain<FFM::Laplacian>},
    {"killing", run_plain<FFM::Killing>},
    {"slim", run_plain<FFM::Slim>},
    {"cm", run_plain<FFM::Composite_majorization<>>},
    {"cm_ungathered", run_plain<FFM::Composite_majorization<false>>},
    {"newton", run_plain<FFM::Projected_newton>}};
  std::vector<std::string> methods, files;
  double seconds = 300;
  for(int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if(argument == "--seconds" && i + 1 < argc) {
      seconds = std::atof(argv[++i]);
    } else if(argument == "--methods" && i + 1 < argc) {
      std::string names = std::string(argv[++i]) + ",";
      for(std::size_t end; (end = names.find(',')) != std::string::npos; names.erase(0, end + 1))
        methods.push_back(names.substr(0, end));
    } else {
      files.push_back(argument);
    }
  }
  if(methods.empty())
    for(const auto& method : all)
      methods.push_back(method.first);
  for(const std::string& method : methods)
    if(all.find(method) == all.end()) {
      std::cerr << "no method " << method << '\n';
      return EXIT_FAILURE;
    }
  if(files.empty()) {
    std::cerr << "usage: compare_methods [--methods NAME,NAME,..] [--seconds LIMIT] MESH...\n";
    return EXIT_FAILURE;
  }

  std::cout << "# " << processor() << ", " << std::thread::hardware_concurrency() << " threads; compiler " << __VERSION__ << "; CGAL "
            << CGAL_VERSION_STR << "; Eigen " << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << '\n'
            << "mesh,method,status,faces,iterations,to_1_percent,to_1e-4,factorizations,linear_solves,energy,flips,min_singular_value,"
               "max_singular_value,seconds,cpu_seconds,factorize_cpu_seconds,factorization_units,peak_memory_mb,start\n";
  std::cout.precision(9);
  int failures = 0;
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
      std::cerr << "cannot read " << file << '\n';
      ++failures;
      continue;
    }
    for(const std::string& method : methods) {
      const Run result = all.at(method)(mesh, seconds);
      const FFM::Summary& s = result.summary;
      failures += s.is_valid() ? 0 : 1;
      const double unit = s.factorizations > 0 ? s.factorize_cpu_seconds / s.factorizations : 0;
      std::cout << file.substr(file.rfind('/') + 1) << ',' << method << ',' << FFM::status_name(s.status) << ',' << s.elements << ','
                << s.iterations << ',' << result.iterations_to(1e-2) << ',' << result.iterations_to(1e-4) << ',' << s.factorizations << ','
                << s.linear_solves << ',' << s.energy << ',' << s.flips << ',' << s.min_singular_value << ',' << s.max_singular_value << ','
                << s.seconds.total << ',' << s.cpu_seconds << ',' << s.factorize_cpu_seconds << ',' << (unit > 0 ? s.cpu_seconds / unit : 0)
                << ',' << s.peak_memory_mb << ",\"" << s.start << "\"" << std::endl;
    }
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
