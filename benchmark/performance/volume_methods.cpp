// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The experiment of Claici et al. 2017, section 6.2: methods deform a solid from the same start by soft handles, with the
// diagonal of their matrices raised by 1e-4. Objectives iteration by iteration go to volume_methods.csv, and an
// account of each run to the standard output, as CSV; report.py makes a page of both.

#include "../support/machine.h"
#include "volume_tables.h"

#include "program/formats/Handles.h"
#include "program/formats/volume_files.h"
#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/energies/Exponential_amips.h>
#include <CGAL/Flip_free_maps/energies/Exponential_symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;

namespace {

constexpr double PI = 3.14159265358979323846;

struct Settings
{
  std::vector<std::string> files;
  std::string output = ".";
  int iterations = 100;
  double weight = 1e5;
  std::string energy = "exponential-symmetric-dirichlet";
  std::string linear_solver = "automatic";
};

// A solid, and the places of its handles in the units of the domain.
struct Problem
{
  std::string name;
  FFM::Tetrahedral_domain domain;
  std::vector<FFM::Soft_position<3>> handles;
};

// Soft positions that remember their value where they were differentiated last, which is where an observer is called.
class Watched_soft_positions : public FFM::Soft_positions<3>
{
public:
  using FFM::Soft_positions<3>::Soft_positions;

  void add_derivatives(const FFM::Positions<3>& x, FFM::Positions<3>& gradient, FFM::Term_matrix<3>* matrix) const override
  {
    m_last_value = value(x);
    FFM::Soft_positions<3>::add_derivatives(x, gradient, matrix);
  }

  double last_value() const { return m_last_value; }

private:
  mutable double m_last_value = 0;
};

const std::vector<std::string>& method_names()
{
  static const std::vector<std::string> names = {"killing", "stiff-killing", "slim", "projected-newton", "aqp", "default"};
  return names;
}

std::map<std::string, FFM::Any_energy> energies()
{
  // The mean over 2D squares is what the package takes the exponential of, the paper that of their sum.
  FFM::Exponential_symmetric_dirichlet exponential;
  exponential.factor = 6;
  return {{"exponential-symmetric-dirichlet", FFM::Any_energy(exponential)},
          {"symmetric-dirichlet", FFM::Any_energy(FFM::Symmetric_dirichlet())},
          {"exponential-amips", FFM::Any_energy(FFM::Exponential_amips())},
          {"symmetric-gradient", FFM::Any_energy(FFM::Symmetric_gradient())},
          {"neo-hookean", FFM::Any_energy(FFM::Neo_hookean())}};
}

void choose_linear_solver(const std::string& name, FFM::Any_map_traits& traits)
{
  if(name == "cg")
    traits.use_linear_solver<FFM::Conjugate_gradient_solver<>>();
  else if(name == "direct")
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
    traits.use_linear_solver<FFM::Cholmod_solver>();
#else
    traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
#endif
}

void choose_method(const std::string& method, FFM::Any_map_traits& traits)
{
  traits.use_method(method.find("killing") == std::string::npos ? method : "akvf+");
  if(method == "stiff-killing")
    traits.preconditioner = FFM::Any_preconditioner(FFM::Killing{FFM::Killing_weight::stiffness});
}

// The unit cube, six tetrahedra in each of cells x cells x cells cubes. Four parallel edges are to be turned around the axis
// between them, one end against the other by a right angle, and stretched.
bool make_cube(int cells, double weight, Problem& problem, std::string& message)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> handles;
  const auto number = [cells](const std::array<int, 3>& p) { return (p[0] * (cells + 1) + p[1]) * (cells + 1) + p[2]; };
  for(int i = 0; i <= cells; ++i)
    for(int j = 0; j <= cells; ++j)
      for(int k = 0; k <= cells; ++k) {
        const double x = 1. * i / cells - 0.5, y = 1. * j / cells - 0.5, z = 1. * k / cells - 0.5, angle = 0.5 * PI * z;
        if(i % cells == 0 && j % cells == 0)
          handles.emplace_back(
            points.size(), Eigen::Vector3d(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, 1.4 * z));
        points.push_back({x, y, z});
      }
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  for(int i = 0; i < cells; ++i)
    for(int j = 0; j < cells; ++j)
      for(int k = 0; k < cells; ++k)
        for(int o = 0; o < 6; ++o) {
          std::array<int, 3> corner{i, j, k};
          std::array<int, 4> t{number(corner), 0, 0, 0};
          for(int step = 0; step < 3; ++step) {
            ++corner[orders[o][step]];
            t[step + 1] = number(corner);
          }
          if(o >= 3)
            std::swap(t[2], t[3]);
          tetrahedra.push_back(t);
        }
  problem.name = "generated cube";
  if(problem.domain.load(points, tetrahedra, message) != FFM::Status::success)
    return false;
  for(const auto& handle : handles)
    problem.handles.push_back({problem.domain.number(handle.first), problem.domain.to_domain(handle.second), weight});
  return true;
}

bool read_problem(const std::vector<std::string>& files, double weight, Problem& problem, std::string& message)
{
  FFM::Tetrahedral_mesh mesh;
  if(!FFM::read_volume(files[0], mesh, &message) || problem.domain.load(mesh.points, mesh.tetrahedra, message) != FFM::Status::success)
    return false;
  const auto& vertices = problem.domain.vertices();
  FFM::Positions<3> points(3, vertices.size());
  for(std::size_t v = 0; v < vertices.size(); ++v)
    points.col(v) = Eigen::Map<const Eigen::Vector3d>(mesh.points[vertices[v]].data());
  FFM::Handles<3> read;
  if(!FFM::read_handles<3>(files[1], points, read, &message))
    return false;
  for(std::size_t i = 0; i < read.vertices.size(); ++i)
    problem.handles.push_back({read.vertices[i], problem.domain.to_domain(Eigen::Vector3d(read.targets.col(i))), weight});
  problem.name = files[0].substr(files[0].rfind('/') + 1);
  return true;
}

Volume_run run_method(const std::string& method, const Problem& problem, const Settings& settings)
{
  Volume_run run;
  run.method = method;
  FFM::Any_map_traits traits;
  choose_method(method, traits);
  traits.energy = energies().at(settings.energy);
  choose_linear_solver(settings.linear_solver, traits);
  traits.options.max_iterations = settings.iterations;
  traits.options.tikhonov = 1e-4;
  const auto soft = std::make_shared<Watched_soft_positions>(problem.handles);
  const double begin = benchmark_support::cpu_seconds();
  traits.options.observer = [&run, soft, begin](const FFM::Iteration_report& report) {
    run.trace.push_back({report.iteration, benchmark_support::cpu_seconds() - begin, report.energy, report.energy - soft->last_value(),
                         report.flips, report.factorizations});
    return true;
  };
  FFM::Map_minimizer<3, FFM::Any_map_traits> minimizer(problem.domain.domain(), traits);
  minimizer.add_term(soft);
  FFM::Positions<3> x = problem.domain.domain().rest_points;
  minimizer.minimize(x, run.summary);
  run.summary.cpu_seconds = benchmark_support::cpu_seconds() - begin;
  return run;
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  std::vector<std::string> energy_names;
  for(const auto& energy : energies())
    energy_names.push_back(energy.first);
  CLI::App app("Deforms a solid by soft handles with several methods, from the same start.");
  app
    .add_option("FILES", settings.files,
                "files that read_volume() and read_handles() read; by default a generated cube, four edges of which are twisted")
    ->expected(2)
    ->option_text("MESH HANDLES");
  app.add_option("--output", settings.output, "folder for volume_methods.csv")->capture_default_str();
  app.add_option("--iterations", settings.iterations, "limit of each run")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--weight", settings.weight, "of the handles")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--energy", settings.energy, "what is minimised")->check(CLI::IsMember(energy_names))->capture_default_str();
  app
    .add_option("--linear-solver", settings.linear_solver,
                "the package's choice, a direct one, or conjugate gradients, whose directions are inexact as those of the paper")
    ->check(CLI::IsMember({"automatic", "direct", "cg"}))
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  Problem problem;
  std::string message;
  if(!(settings.files.empty() ? make_cube(9, settings.weight, problem, message)
                              : read_problem(settings.files, settings.weight, problem, message))) {
    std::cerr << message << '\n';
    return EXIT_FAILURE;
  }
  const FFM::Simplicial_domain<3>& domain = problem.domain.domain();
  const std::string experiment = problem.name + ": " + std::to_string(domain.number_of_elements()) + " tetrahedra, " +
                                 std::to_string(domain.number_of_vertices) + " vertices, " + std::to_string(problem.handles.size()) +
                                 " handles of weight " + format(settings.weight) + "; energy " + settings.energy;
  std::vector<Volume_run> runs;
  bool all_valid = true;
  for(const std::string& method : method_names()) {
    std::cerr << description(method) << " ..." << std::flush;
    runs.push_back(run_method(method, problem, settings));
    const Volume_run& run = runs.back();
    std::cerr << ' ' << format(run.objective(), 8) << " after " << run.summary.iterations << " iterations, "
              << format(run.summary.cpu_seconds) << " s\n";
    all_valid = all_valid && run.summary.is_valid();
  }
  Table results = results_of(runs), traces = traces_of(runs);
  results.comments() = traces.comments() = {machine(), experiment};
  results.write(std::cout);
  const std::string path = settings.output + "/volume_methods.csv";
  if(!traces.write(path)) {
    std::cerr << "cannot write " << path << '\n';
    return EXIT_FAILURE;
  }
  return all_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}
