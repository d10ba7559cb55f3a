// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Flattens every given mesh, or some generated ones, by every chosen method of the literature, and writes what happened as CSV
// files, of which report.py makes a page: see `--help`.

#include "../support/Table.h"
#include "../support/generated_meshes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CLI/CLI.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Trace_point
{
  int iteration;
  int factorizations;
  double seconds;
  double energy;
};

// Iterations after which the energy stays within a relative distance of a limit, NaN if it never does.
double iterations_to(const std::vector<Trace_point>& trace, double limit, double relative)
{
  std::size_t i = trace.size();
  while(i > 0 && trace[i - 1].energy <= limit * (1 + relative))
    --i;
  return i < trace.size() ? trace[i].iteration : std::numeric_limits<double>::quiet_NaN();
}

const std::vector<std::string> RESULT_COLUMNS = {"mesh",
                                                 "method",
                                                 "status",
                                                 "faces",
                                                 "vertices",
                                                 "iterations",
                                                 "eta",
                                                 "to_0.1_percent",
                                                 "to_1e-4",
                                                 "to_1e-5",
                                                 "eta_of_best",
                                                 "to_1e-4_of_best",
                                                 "factorizations",
                                                 "factorization_units",
                                                 "linear_solves",
                                                 "energy_initial",
                                                 "energy",
                                                 "min_singular_value",
                                                 "max_singular_value",
                                                 "flips",
                                                 "seconds",
                                                 "seconds_start",
                                                 "seconds_assemble",
                                                 "seconds_analyze",
                                                 "seconds_factorize",
                                                 "seconds_solve",
                                                 "seconds_line_search",
                                                 "seconds_certify",
                                                 "cpu_seconds",
                                                 "factorize_cpu_seconds",
                                                 "peak_memory_mb",
                                                 "start"};
const std::vector<std::string> TRACE_COLUMNS = {"mesh", "method", "iteration", "factorizations", "seconds", "energy"};

std::vector<std::string> result_row(const std::string& mesh, const std::string& method, const FFM::Summary& s,
                                    const std::vector<Trace_point>& trace)
{
  const auto steps = [&](double relative) { return format(iterations_to(trace, s.energy, relative), 6); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool has_unit = s.factorizations > 0 && s.factorize_cpu_seconds > 0;
  return {mesh,
          method,
          FFM::status_name(s.status),
          std::to_string(s.elements),
          std::to_string(s.vertices),
          std::to_string(s.iterations),
          steps(1e-2),
          steps(1e-3),
          steps(1e-4),
          steps(1e-5),
          "",
          "",
          std::to_string(s.factorizations),
          format(has_unit ? s.cpu_seconds * s.factorizations / s.factorize_cpu_seconds : nan),
          std::to_string(s.linear_solves),
          format(s.energy_initial, 9),
          format(s.is_valid() ? s.energy : nan, 12),
          format(s.min_singular_value, 6),
          format(s.max_singular_value, 6),
          std::to_string(s.flips),
          format(s.seconds.total),
          format(s.seconds.start),
          format(s.seconds.assemble),
          format(s.seconds.analyze),
          format(s.seconds.factorize),
          format(s.seconds.solve),
          format(s.seconds.line_search),
          format(s.seconds.certify),
          format(s.cpu_seconds),
          format(s.factorize_cpu_seconds),
          format(s.peak_memory_mb),
          s.start};
}

// Fills the columns that are relative to the best energy of any method on a mesh, from given rows on.
void compare_with_best(Table& results, std::size_t first_result, const Table& traces, std::size_t first_point)
{
  std::map<std::string, double> best;
  for(std::size_t i = first_result; i < results.number_of_rows(); ++i) {
    const double energy = results.number(i, "energy");
    const auto entry = best.insert({results.text(i, "mesh"), std::numeric_limits<double>::infinity()}).first;
    entry->second = energy < entry->second ? energy : entry->second;
  }
  std::map<std::pair<std::string, std::string>, std::vector<Trace_point>> all;
  for(std::size_t i = first_point; i < traces.number_of_rows(); ++i)
    all[{traces.text(i, "mesh"), traces.text(i, "method")}].push_back({static_cast<int>(traces.number(i, "iteration")),
                                                                       static_cast<int>(traces.number(i, "factorizations")),
                                                                       traces.number(i, "seconds"), traces.number(i, "energy")});
  for(std::size_t i = first_result; i < results.number_of_rows(); ++i) {
    const std::string mesh = results.text(i, "mesh");
    const std::vector<Trace_point>& trace = all[{mesh, results.text(i, "method")}];
    results.set(i, "eta_of_best", format(iterations_to(trace, best[mesh], 1e-2), 6));
    results.set(i, "to_1e-4_of_best", format(iterations_to(trace, best[mesh], 1e-4), 6));
  }
}

struct Settings
{
  std::vector<std::string> methods = {"default", "pp", "cm", "p-cm", "slim", "p-slim", "akvf", "p-akvf", "projected-newton", "aqp"};
  std::string criterion = "energy";
  double tolerance = 1e-6;
  double seconds = 60;
  std::string start = "circle";
  bool begins_with_largest_step = false;
  double backtracking = 0;
};

// In results and traces.
std::string name_of(const Settings& settings, const std::string& method)
{
  return method + (settings.begins_with_largest_step ? " from the largest step" : "") +
         (settings.backtracking > 0 ? " with factor " + format(settings.backtracking) : "");
}

FFM::Any_map_traits make_traits(const Settings& settings, const std::string& method)
{
  FFM::Any_map_traits traits;
  traits.use_method(method);
  FFM::Map_options& options = traits.options;
  if(settings.criterion != "published" || !traits.stop_as_published()) {
    options.characteristic_gradient_tolerance = settings.criterion == "characteristic" ? settings.tolerance : 0;
    options.relative_energy_tolerance = settings.criterion == "characteristic" ? 0 : settings.tolerance;
  }
  options.max_seconds = settings.seconds;
  options.max_iterations = (std::numeric_limits<int>::max)();
  if(settings.begins_with_largest_step)
    options.begin_with_largest_step = options.extend_steps = true;
  if(settings.backtracking > 0)
    options.backtracking = settings.backtracking;
  const std::map<std::string, int> corners = {{"triangle", 3}, {"square", 4}, {"octagon", 8}};
  const auto found = corners.find(settings.start);
  if(found == corners.end())
    return traits;
  traits.start.border = FFM::Border_shape::polygon;
  for(int i = 0; i < found->second; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / found->second;
    traits.start.polygon.push_back({{std::cos(angle), std::sin(angle)}});
  }
  return traits;
}

// Runs all methods on one mesh.
void run_all(Mesh& mesh, const std::string& name, const Settings& settings, Table& results, Table& traces)
{
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const std::size_t first_result = results.number_of_rows(), first_point = traces.number_of_rows();
  for(const std::string& method : settings.methods) {
    FFM::Any_map_traits traits = make_traits(settings, method);
    std::vector<Trace_point> trace;
    reset_peak_memory();
    const auto begin = std::chrono::steady_clock::now();
    traits.options.observer = [&](const FFM::Iteration_report& report) {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      trace.push_back({report.iteration, report.factorizations, seconds, report.energy});
      return true;
    };
    auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const FFM::Summary summary = FFM::parameterize(mesh, border, uv, traits);
    mesh.remove_property_map(uv);
    const std::string shown = name_of(settings, method);
    std::cerr << name << ' ' << shown << ": " << FFM::status_name(summary.status) << ", " << summary.iterations << " iterations, "
              << summary.factorizations << " factorizations, energy " << summary.energy << ", " << summary.seconds.total << " s\n";
    results.add_row(result_row(name, shown, summary, trace));
    for(const Trace_point& p : trace)
      traces.add_row(
        {name, shown, std::to_string(p.iteration), std::to_string(p.factorizations), format(p.seconds, 5), format(p.energy, 13)});
  }
  compare_with_best(results, first_result, traces, first_point);
}

std::string stem(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.rfind('.'));
}

std::string traces_file(const std::string& csv) { return csv.substr(0, csv.rfind('.')) + "_traces.csv"; }

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  std::string csv = "methods.csv";
  std::vector<std::string> files, earlier;
  int threads = 0;
  CLI::App app("Compares methods on meshes that are topological disks, by default on generated ones.");
  app.add_option("MESH", files, "files with one disk each; names begin with the name of their set: d1_cat.off");
  app.add_option("--methods", settings.methods, "names as in Any_map_traits::use_method()")
    ->allow_extra_args(false)
    ->delimiter(',')
    ->capture_default_str();
  app
    .add_option(
      "--criterion", settings.criterion,
      "stop by the characteristic gradient, by the relative decrease of the energy, or by the rules of each method's paper where there "
      "are some")
    ->check(CLI::IsMember({"characteristic", "energy", "published"}))
    ->capture_default_str();
  app.add_option("--tolerance", settings.tolerance, "its tolerance")->capture_default_str();
  app.add_option("--seconds", settings.seconds, "limit of each run")->capture_default_str();
  app.add_option("--start", settings.start, "shape of the border of the start")
    ->check(CLI::IsMember({"circle", "triangle", "square", "octagon"}))
    ->capture_default_str();
  app.add_flag("--largest-step", settings.begins_with_largest_step,
               "line searches begin with the longest step without flips, and go beyond it, whatever the method says");
  app.add_option("--backtracking", settings.backtracking, "the factor of line searches, in place of the method's");
  app.add_option("--csv", csv, "results; iteration by iteration in the file with _traces.csv at its end")->capture_default_str();
  app.add_option("--threads", threads, "0: as many as there are")->capture_default_str();
  app.add_option("--from", earlier, "CSV files of earlier runs: nothing is run, their results are put together");
  CLI11_PARSE(app, argc, argv);
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> control;
  if(threads > 0)
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
#endif
  for(const std::string& method : settings.methods)
    if(!FFM::Any_map_traits().use_method(method)) {
      std::cerr << "There is no method " << method << ".\n";
      return EXIT_FAILURE;
    }

  Table results(RESULT_COLUMNS), traces(TRACE_COLUMNS);
  int failures = 0;
  if(earlier.empty()) {
    results.comments() = {
      machine(), "stopped by " +
                   std::string(settings.criterion == "published" ? "the rules of the method's paper, or the relative decrease of the energy"
                               : settings.criterion == "energy"  ? "the relative decrease of the energy"
                                                                 : "the characteristic gradient norm") +
                   " below " + format(settings.tolerance) + " or " + format(settings.seconds) + " s per run; start: " + settings.start};
    const auto run = [&](Mesh& mesh, const std::string& name) {
      run_all(mesh, name, settings, results, traces);
      // Written after every mesh: long comparisons are interrupted.
      if(!results.write(csv) || !traces.write(traces_file(csv)))
        std::cerr << "Cannot write " << csv << ".\n";
    };
    for(const std::string& file : files) {
      Mesh mesh;
      if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
        std::cerr << "Cannot read " << file << ".\n";
        ++failures;
        continue;
      }
      run(mesh, stem(file));
    }
    if(files.empty())
      for(const auto& entry : generated_meshes<Mesh>()) {
        Mesh mesh;
        entry.second(mesh);
        run(mesh, entry.first);
      }
  }
  for(const std::string& file : earlier) {
    Table more, more_traces;
    if(!more.read(file) || !more_traces.read(traces_file(file))) {
      std::cerr << "Cannot read " << file << " or " << traces_file(file) << ".\n";
      return EXIT_FAILURE;
    }
    results.append(more);
    traces.append(more_traces);
  }
  if(!earlier.empty()) {
    compare_with_best(results, 0, traces, 0);
    if(!results.write(csv) || !traces.write(traces_file(csv)))
      std::cerr << "Cannot write " << csv << ".\n";
  }
  for(std::size_t i = 0; i < results.number_of_rows(); ++i)
    failures += std::isfinite(results.number(i, "energy")) ? 0 : 1;
  std::cerr << csv << " written, " << failures << " runs or files failed.\n";
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
