// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASURED_RUN_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASURED_RUN_H

#include "../support/machine.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace benchmark_support {

namespace FFM = CGAL::Flip_free_maps;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// When a run ends: by the default rule of the package, or by the relative decrease of the energy as the published programs do.
struct Stopping_rule
{
  std::string name;
  double relative_energy_tolerance; // 0: the default rule

  void apply(FFM::Map_options& options) const
  {
    if(relative_energy_tolerance > 0) {
      options.characteristic_gradient_tolerance = 0;
      options.relative_energy_tolerance = relative_energy_tolerance;
    }
  }
};

inline std::vector<Stopping_rule> stopping_rules() { return {{"default", 0}, {"energy", 1e-6}}; }

// What was known after an accepted step. Seconds count from the mesh in memory on.
struct Trace_point
{
  int iteration;
  int factorizations;
  double energy;
  double seconds;
  double cpu_seconds;
};

// A run of the default method.
struct Measured_run
{
  FFM::Summary summary;
  std::vector<Trace_point> trace;
  double factorization_seconds = NOT_A_NUMBER;     // of one numeric factorization on the full mesh
  double factorization_cpu_seconds = NOT_A_NUMBER; // the unit of work
  double memory_before_mb = -1;                    // resident, the mesh included
  double memory_start_mb = -1;                     // peak until the first matrix is to be factorized
  double memory_minimize_mb = -1;                  // peak from there on

  double units(double cpu_seconds) const { return cpu_seconds / factorization_cpu_seconds; }

  // CPU seconds until the energy is `energy` or less for good, NaN if it never is.
  double cpu_seconds_to(double energy) const
  {
    std::size_t i = trace.size();
    while(i > 0 && trace[i - 1].energy <= energy)
      --i;
    return i < trace.size() ? trace[i].cpu_seconds : NOT_A_NUMBER;
  }
};

// One factorization of a projected Newton matrix at a given map, for runs that needed none.
template <typename VertexUVMap>
void time_factorization(Mesh& mesh, Mesh::Halfedge_index border, VertexUVMap start, Measured_run& run)
{
  FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, CGAL::Default, FFM::No_acceleration,
                            FFM::Every_iteration>
    traits;
  traits.options.characteristic_gradient_tolerance = 0;
  traits.options.max_iterations = 1;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv_of_one_iteration").first;
  const FFM::Summary summary = FFM::parameterize(mesh, border, uv, traits, FFM::parameters::start_map(start));
  mesh.remove_property_map(uv);
  if(summary.factorizations > 0) {
    run.factorization_seconds = summary.seconds.factorize / summary.factorizations;
    run.factorization_cpu_seconds = summary.factorize_cpu_seconds / summary.factorizations;
  }
}

// Flattens a mesh by the default method within a limit of wall-clock time, which the start does not heed.
inline Measured_run measure_run(Mesh& mesh, Mesh::Halfedge_index border, const Stopping_rule& rule, double max_seconds)
{
  using FFM::internal::peak_memory_mb;
  using FFM::internal::wall_seconds;
  Measured_run run;
  FFM::Flip_free_map_traits<> traits;
  rule.apply(traits.options);
  traits.options.max_seconds = max_seconds;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  release_unused_memory();
  reset_peak_memory();
  run.memory_before_mb = peak_memory_mb();
  const double begin = wall_seconds(), cpu_begin = cpu_seconds();
  traits.options.observer = [&](const FFM::Iteration_report& report) {
    if(report.iteration == 0) {
      run.memory_start_mb = peak_memory_mb();
      reset_peak_memory();
    }
    run.trace.push_back({report.iteration, report.factorizations, report.energy, wall_seconds() - begin, cpu_seconds() - cpu_begin});
    return true;
  };
  run.summary = FFM::parameterize(mesh, border, uv, traits);
  run.memory_minimize_mb = run.summary.peak_memory_mb;
  run.summary.peak_memory_mb = (std::max)(run.memory_start_mb, run.memory_minimize_mb);
  if(run.summary.factorizations > 0) {
    run.factorization_seconds = run.summary.seconds.factorize / run.summary.factorizations;
    run.factorization_cpu_seconds = run.summary.factorize_cpu_seconds / run.summary.factorizations;
  } else if(run.summary.is_valid()) {
    time_factorization(mesh, border, uv, run);
  }
  mesh.remove_property_map(uv);
  return run;
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASURED_RUN_H
