// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What parameterize() costs with its default method: runs it on every given mesh and on refinements of a generated surface, by
// two stopping rules and with several numbers of threads, and writes CSV files, of which report.py makes a page, published
// figures beside ours where there are any: see `--help`.

#include "../support/Table.h"
#include "../support/generated_meshes.h"
#include "../support/machine.h"
#include "measured_run.h"
#include "measurement_tables.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CLI/CLI.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace benchmark_support;

namespace {

// A run that takes longer is not repeated.
constexpr double LONGEST_REPEATED_RUN = 60;

struct Settings
{
  std::vector<std::string> files;
  std::string output = ".";
  std::vector<int> threads = {1};
  std::vector<double> ladder;
  int repeats = 1;
  double budget = 0; // seconds, 0: no limit
  std::string published = FLIP_FREE_MAPS_BENCHMARK_DATA "/progressive_parameterizations_measured.csv";
};

struct Input
{
  std::string name;
  std::function<bool(Mesh&)> make;
  double ladder_faces = 0;
};

std::vector<Input> inputs_of(const Settings& settings)
{
  std::vector<Input> inputs;
  for(const std::string& file : settings.files)
    inputs.push_back({std::filesystem::path(file).stem().string(), [file](Mesh& mesh) { return CGAL::IO::read_polygon_mesh(file, mesh); }});
  std::vector<double> ladder = settings.ladder;
  if(settings.files.empty()) {
    if(ladder.empty())
      ladder = {25000, 100000};
    for(const auto& generated : generated_meshes<Mesh>())
      inputs.push_back({generated.first, [generated](Mesh& mesh) {
                          generated.second(mesh);
                          return true;
                        }});
  }
  // Peak memory is that of the process, hence the ascending order.
  std::sort(ladder.begin(), ladder.end());
  for(double faces : ladder)
    inputs.push_back({"ladder_" + format(faces, 10),
                      [faces](Mesh& mesh) {
                        make_bumpy_sheet(mesh, faces);
                        return true;
                      },
                      faces});
  return inputs;
}

class Benchmark
{
public:
  explicit Benchmark(const Settings& settings)
    : m_settings(settings), m_begin(FFM::internal::wall_seconds()), m_runs(run_columns()), m_traces(trace_columns())
  {
    const char* blas_threads = std::getenv("OPENBLAS_NUM_THREADS");
    std::string threads;
    for(int number : settings.threads)
      threads += (threads.empty() ? "" : ", ") + std::to_string(number);
    m_runs.comments() = {machine(), "measured with numbers of threads: " + threads + "; medians of " + std::to_string(settings.repeats) +
                                      " runs; those of more than " + format(LONGEST_REPEATED_RUN) +
                                      " s are not repeated; OPENBLAS_NUM_THREADS: " + (blas_threads != nullptr ? blas_threads : "not set")};
    if(settings.budget > 0)
      m_runs.comments().push_back("budget of " + format(settings.budget) + " s for all runs together");
    m_has_published = m_published.read(settings.published);
  }

  bool has_published() const { return m_has_published; }
  int failures() const { return m_failures; }

  // Measures, and writes what is known so far: long series are interrupted.
  bool run(const Input& input)
  {
    if(remaining() <= 0 || !fits_into_budget(input)) {
      note("left out, since the budget is spent: " + input.name);
      return write();
    }
    Mesh mesh;
    if(!input.make(mesh)) {
      std::cerr << "Cannot read " << input.name << ".\n";
      note("not readable: " + input.name);
      ++m_failures;
      return write();
    }
    const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    std::vector<Measurement> measurements;
    for(const Stopping_rule& rule : stopping_rules())
      for(int threads : m_settings.threads) {
#ifdef CGAL_LINKED_WITH_TBB
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
        const std::string name =
          input.name + ", rule " + rule.name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
        Measurement measurement{rule.name, threads, {}};
        for(int i = 0; i < m_settings.repeats && remaining() > 0; ++i) {
          measurement.runs.push_back(measure_run(mesh, border, rule, remaining()));
          if(measurement.runs.back().summary.seconds.total > LONGEST_REPEATED_RUN)
            break;
        }
        if(measurement.runs.empty()) {
          note("left out, since the budget is spent: " + name);
          continue;
        }
        const FFM::Summary& s = measurement.runs.front().summary;
        m_failures += s.is_valid() ? 0 : 1;
        if(input.ladder_faces > 0) {
          m_last_ladder_faces = input.ladder_faces;
          m_last_ladder_seconds = s.seconds.total;
        }
        std::cerr << name << ": " << FFM::status_name(s.status) << ", energy " << s.energy << ", " << s.iterations << " iterations, "
                  << s.factorizations << " factorizations, " << s.seconds.total << " s\n";
        measurements.push_back(std::move(measurement));
      }
    if(!measurements.empty())
      add_measurements(input.name, measurements, published_energy(input.name, measurements), m_runs, m_traces);
    return write();
  }

private:
  double remaining() const
  {
    return m_settings.budget > 0 ? m_settings.budget - (FFM::internal::wall_seconds() - m_begin) : std::numeric_limits<double>::infinity();
  }

  // A step of the ladder is begun only if there is time for one run,
  // which needs at least as much time per face as one of the last step.
  bool fits_into_budget(const Input& input) const
  {
    return input.ladder_faces == 0 || m_last_ladder_faces == 0 ||
           m_last_ladder_seconds * input.ladder_faces / m_last_ladder_faces <= remaining();
  }

  void note(const std::string& text) { m_runs.comments().push_back(text); }

  // Infinite where there is none for a mesh with this name and as many faces.
  double published_energy(const std::string& mesh, const std::vector<Measurement>& measurements) const
  {
    for(std::size_t i = 0; i < m_published.number_of_rows(); ++i)
      if(m_published.text(i, "mesh") == mesh &&
         m_published.number(i, "faces") == static_cast<double>(measurements.front().runs.front().summary.elements) &&
         m_published.number(i, "energy") > 0)
        return m_published.number(i, "energy");
    return std::numeric_limits<double>::infinity();
  }

  bool write() const
  {
    const std::filesystem::path folder = m_settings.output;
    return m_runs.write((folder / "parameterize.csv").string()) && m_traces.write((folder / "parameterize_traces.csv").string());
  }

  const Settings& m_settings;
  double m_begin;
  Table m_runs, m_traces, m_published;
  bool m_has_published = false;
  int m_failures = 0;
  double m_last_ladder_faces = 0;
  double m_last_ladder_seconds = 0; // of the last run on it
};

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  CLI::App app("Measures parameterize() with its default method: time by phase, memory, work in factorizations, speedup by threads.");
  app.add_option("MESH", settings.files,
                 "files of surfaces with a border, the longest of which is the outer one; names begin with that of their set: d1_cat.off. "
                 "Without any: generated meshes and, unless there is another, a ladder of 25000,100000");
  app.add_option("--output", settings.output, "folder for parameterize.csv and parameterize_traces.csv")->capture_default_str();
  app.add_option("--threads", settings.threads, "numbers of threads, each of which is measured")
    ->allow_extra_args(false)
    ->delimiter(',')
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--ladder", settings.ladder, "numbers of triangles of a generated surface")
    ->allow_extra_args(false)
    ->delimiter(',')
    ->check(CLI::PositiveNumber);
  app.add_option("--repeat", settings.repeats, "equal runs, of which medians are reported")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--budget", settings.budget, "seconds for all runs together; what does not fit is left out or cut short; 0: no limit")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  app.add_option("--published", settings.published, "CSV file of the figures of a published program")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
#ifndef CGAL_LINKED_WITH_TBB
  if(settings.threads != std::vector<int>{1}) {
    std::cerr << "Built without TBB: one thread is all there is.\n";
    settings.threads = {1};
  }
#endif
  std::error_code error;
  std::filesystem::create_directories(settings.output, error);

  Benchmark benchmark(settings);
  if(!benchmark.has_published())
    std::cerr << "Cannot read " << settings.published << ": no published figures.\n";
  for(const Input& input : inputs_of(settings))
    if(!benchmark.run(input)) {
      std::cerr << "Cannot write to " << settings.output << ".\n";
      return EXIT_FAILURE;
    }
  std::cout << (std::filesystem::path(settings.output) / "parameterize.csv").string() << " written, " << benchmark.failures()
            << " runs or files failed.\n";
  return benchmark.failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
