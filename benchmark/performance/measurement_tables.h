// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASUREMENT_TABLES_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASUREMENT_TABLES_H

#include "../support/Table.h"
#include "measured_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace benchmark_support {

// Equal runs, one after the other.
struct Measurement
{
  std::string rule;
  int threads;
  std::vector<Measured_run> runs;

  // The median over the runs of what a function says of each.
  template <typename Function>
  double median(Function&& value) const
  {
    std::vector<double> values;
    for(const Measured_run& run : runs)
      values.push_back(value(run));
    return quantile(values, 0.5);
  }

  // The first run that did not converge, or the first of all: they differ by time only, unless a limit ended one.
  const Measured_run& reported_run() const
  {
    const auto found = std::find_if(runs.begin(), runs.end(), [](const Measured_run& run) { return !run.summary.converged(); });
    return found != runs.end() ? *found : runs.front();
  }

  // The run whose CPU time is the median, or next to it.
  const Measured_run& typical_run() const
  {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), 0);
    const std::size_t middle = (runs.size() - 1) / 2;
    std::nth_element(order.begin(), order.begin() + middle, order.end(),
                     [this](std::size_t a, std::size_t b) { return runs[a].summary.cpu_seconds < runs[b].summary.cpu_seconds; });
    return runs[order[middle]];
  }
};

inline const std::vector<std::string>& run_columns()
{
  static const std::vector<std::string> columns = {"mesh",
                                                   "set",
                                                   "rule",
                                                   "threads",
                                                   "repeats",
                                                   "status",
                                                   "faces",
                                                   "vertices",
                                                   "flips",
                                                   "energy_initial",
                                                   "energy",
                                                   "energy_above_best",
                                                   "iterations",
                                                   "factorizations",
                                                   "units",
                                                   "units_to_1e-2",
                                                   "units_to_1e-4",
                                                   "units_to_1e-6",
                                                   "units_to_end",
                                                   "cpu_seconds",
                                                   "factorization_cpu_seconds",
                                                   "factorization_seconds",
                                                   "seconds",
                                                   "seconds_load",
                                                   "seconds_start",
                                                   "seconds_analyze",
                                                   "seconds_assemble",
                                                   "seconds_factorize",
                                                   "seconds_solve",
                                                   "seconds_line_search",
                                                   "seconds_certify",
                                                   "speedup",
                                                   "memory_before_mb",
                                                   "memory_start_mb",
                                                   "memory_minimize_mb",
                                                   "peak_memory_mb",
                                                   "factor_entries",
                                                   "linear_solver",
                                                   "start",
                                                   "message"};
  return columns;
}

inline const std::vector<std::string>& trace_columns()
{
  static const std::vector<std::string> columns = {"mesh",   "rule",    "threads",     "iteration", "factorizations",
                                                   "energy", "seconds", "cpu_seconds", "units"};
  return columns;
}

// The lowest energy of all valid runs on a mesh, infinite if there are none.
inline double best_energy(const std::vector<Measurement>& measurements)
{
  double best = std::numeric_limits<double>::infinity();
  for(const Measurement& m : measurements)
    for(const Measured_run& run : m.runs)
      if(run.summary.is_valid())
        best = (std::min)(best, run.summary.energy);
  return best;
}

// What a measurement says, relative to the best energy known,
// and to the wall-clock seconds of the same with the first number of threads.
inline std::vector<std::string> run_row(const std::string& mesh, const Measurement& m, double best, double first_seconds)
{
  const FFM::Summary& s = m.reported_run().summary;
  const auto phase = [&m](double FFM::Phase_seconds::*part) {
    return format(m.median([part](const Measured_run& run) { return run.summary.seconds.*part; }));
  };
  const auto units_to = [&m, best](double relative) {
    return format(m.median([=](const Measured_run& run) { return run.units(run.cpu_seconds_to(best * (1 + relative))); }));
  };
  const auto median = [&m](auto&& value) { return format(m.median(value)); };
  const double seconds = m.median([](const Measured_run& run) { return run.summary.seconds.total; });
  return {mesh,
          set_of(mesh),
          m.rule,
          std::to_string(m.threads),
          std::to_string(m.runs.size()),
          FFM::status_name(s.status),
          std::to_string(s.elements),
          std::to_string(s.vertices),
          std::to_string(s.flips),
          format(s.energy_initial, 9),
          format(s.is_valid() ? s.energy : NOT_A_NUMBER, 12),
          format(s.is_valid() ? s.energy / best - 1 : NOT_A_NUMBER, 3),
          std::to_string(s.iterations),
          std::to_string(s.factorizations),
          median([](const Measured_run& run) { return run.units(run.summary.cpu_seconds); }),
          units_to(1e-2),
          units_to(1e-4),
          units_to(1e-6),
          median([](const Measured_run& run) { return run.trace.empty() ? NOT_A_NUMBER : run.units(run.trace.back().cpu_seconds); }),
          median([](const Measured_run& run) { return run.summary.cpu_seconds; }),
          median([](const Measured_run& run) { return run.factorization_cpu_seconds; }),
          median([](const Measured_run& run) { return run.factorization_seconds; }),
          format(seconds),
          phase(&FFM::Phase_seconds::load),
          phase(&FFM::Phase_seconds::start),
          phase(&FFM::Phase_seconds::analyze),
          phase(&FFM::Phase_seconds::assemble),
          phase(&FFM::Phase_seconds::factorize),
          phase(&FFM::Phase_seconds::solve),
          phase(&FFM::Phase_seconds::line_search),
          phase(&FFM::Phase_seconds::certify),
          format(s.is_valid() ? first_seconds / seconds : NOT_A_NUMBER, 3),
          median([](const Measured_run& run) { return run.memory_before_mb; }),
          median([](const Measured_run& run) { return run.memory_start_mb; }),
          median([](const Measured_run& run) { return run.memory_minimize_mb; }),
          median([](const Measured_run& run) { return run.summary.peak_memory_mb; }),
          std::to_string(s.factor_entries),
          s.linear_solver,
          s.start,
          s.message};
}

// Adds what was measured on one mesh to the tables of all. `best` is the lowest energy known from elsewhere, or infinite.
inline void add_measurements(const std::string& mesh, const std::vector<Measurement>& measurements, double best, Table& runs, Table& traces)
{
  best = (std::min)(best, best_energy(measurements));
  for(const Measurement& m : measurements) {
    const auto first = std::find_if(measurements.begin(), measurements.end(), [&m](const Measurement& n) { return n.rule == m.rule; });
    runs.add_row(run_row(mesh, m, best, first->median([](const Measured_run& run) { return run.summary.seconds.total; })));
    const Measured_run& typical = m.typical_run();
    for(const Trace_point& p : typical.trace)
      traces.add_row({mesh, m.rule, std::to_string(m.threads), std::to_string(p.iteration), std::to_string(p.factorizations),
                      format(p.energy, 13), format(p.seconds, 5), format(p.cpu_seconds, 5), format(typical.units(p.cpu_seconds), 5)});
  }
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_MEASUREMENT_TABLES_H
