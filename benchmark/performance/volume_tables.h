// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_TABLES_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_TABLES_H

#include "../support/Table.h"

#include <CGAL/Flip_free_maps/report/Summary.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace benchmark_support {

namespace FFM = CGAL::Flip_free_maps;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// What was known after an accepted step.
struct Volume_trace_point
{
  int iteration;
  double cpu_seconds;
  double objective;
  double energy; // of the elements alone
  std::int64_t flips;
  int factorizations;
};

// A method's run.
struct Volume_run
{
  std::string method;
  FFM::Summary summary;
  std::vector<Volume_trace_point> trace;

  double objective() const { return trace.empty() ? NOT_A_NUMBER : trace.back().objective; }

  // The number of the first entry from which on the objective is `bound` or less; that of entries if there is none.
  std::size_t first_within(double bound) const
  {
    std::size_t i = trace.size();
    while(i > 0 && trace[i - 1].objective <= bound)
      --i;
    return i;
  }
};

inline std::string description(const std::string& method)
{
  static const std::map<std::string, std::string> descriptions = {{"killing", "Killing, the weights of the paper"},
                                                                  {"stiff-killing", "Killing, stiffness weights"},
                                                                  {"slim", "SLIM"},
                                                                  {"projected-newton", "analytic projected Newton"},
                                                                  {"aqp", "AQP: Laplacian, Nesterov"},
                                                                  {"default", "default method"}};
  return descriptions.at(method);
}

inline double best_objective(const std::vector<Volume_run>& runs)
{
  double best = std::numeric_limits<double>::infinity();
  for(const Volume_run& run : runs)
    if(run.summary.is_valid())
      best = (std::min)(best, run.objective());
  return best;
}

inline Table results_of(const std::vector<Volume_run>& runs)
{
  Table table({"method", "status", "objective", "energy", "iterations", "factorizations", "inner_iterations", "cpu_s",
               "iterations_to_1_percent", "cpu_s_to_1_percent", "flips", "linear_solver"});
  const double best = best_objective(runs);
  for(const Volume_run& run : runs) {
    const FFM::Summary& s = run.summary;
    const std::size_t i = run.first_within(1.01 * best);
    const bool is_near = i < run.trace.size();
    table.add_row({run.method, FFM::status_name(s.status), format(run.objective(), 8),
                   format(run.trace.empty() ? NOT_A_NUMBER : run.trace.back().energy, 8), std::to_string(s.iterations),
                   std::to_string(s.factorizations), std::to_string(s.inner_iterations), format(s.cpu_seconds),
                   is_near ? std::to_string(run.trace[i].iteration) : "-", is_near ? format(run.trace[i].cpu_seconds) : "-",
                   std::to_string(s.flips), s.linear_solver});
  }
  return table;
}

inline Table traces_of(const std::vector<Volume_run>& runs)
{
  Table table({"method", "iteration", "cpu_s", "objective", "energy", "flips", "factorizations", "linear_solver"});
  for(const Volume_run& run : runs)
    for(const Volume_trace_point& p : run.trace)
      table.add_row({run.method, std::to_string(p.iteration), format(p.cpu_seconds), format(p.objective, 12), format(p.energy, 12),
                     std::to_string(p.flips), std::to_string(p.factorizations), run.summary.linear_solver});
  return table;
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_TABLES_H
