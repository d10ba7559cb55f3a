// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_REPORT_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_REPORT_H

#include "../support/Table.h"
#include "../support/html.h"
#include "../support/machine.h"
#include "../support/svg_plots.h"

#include <CGAL/Flip_free_maps/report/Summary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

namespace FFM = CGAL::Flip_free_maps;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// What a report of methods on a solid says about their common problem.
struct Volume_experiment
{
  std::string text;   // the solid, its handles and the energy, in one line
  std::string energy; // as --energy has it
  int iterations;     // limit of each run
};

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

  // The objective after so many iterations, or that of the end.
  double objective_at(int iteration) const
  {
    for(const Volume_trace_point& point : trace)
      if(point.iteration == iteration)
        return point.objective;
    return objective();
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

inline Style line_style(const std::string& method)
{
  Style style = style_of(method.find("killing") == std::string::npos ? method : "akvf");
  if(method == "stiff-killing")
    style.dashes = "6 3";
  return style;
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

// Over iterations or seconds: the objectives if `best` is 0, otherwise what they exceed it by, relative to it.
inline std::string objective_plot(const std::vector<Volume_run>& runs, bool over_seconds, double best)
{
  const bool is_excess = best > 0;
  Line_plot plot;
  plot.x_label = over_seconds ? "CPU seconds" : "iteration";
  plot.y_label = is_excess ? "objective / best - 1" : "objective";
  plot.x_low = plot.y_low = std::numeric_limits<double>::infinity();
  plot.x_high = plot.y_high = 0;
  for(const Volume_run& run : runs) {
    Line_plot::Line line{line_style(run.method), {}};
    for(const Volume_trace_point& p : run.trace) {
      const double x = over_seconds ? p.cpu_seconds : p.iteration, y = is_excess ? p.objective / best - 1 : p.objective;
      // The start has no place on a logarithmic axis, nor has the best objective itself.
      if(p.iteration == 0 || !(x > 0) || !(y > (is_excess ? 1e-9 : 0)))
        continue;
      line.points.push_back({x, y});
      plot.x_low = (std::min)(plot.x_low, x);
      plot.x_high = (std::max)(plot.x_high, x);
      plot.y_low = (std::min)(plot.y_low, 0.9 * y);
      plot.y_high = (std::max)(plot.y_high, 1.2 * y);
    }
    if(!line.points.empty())
      plot.lines.push_back(std::move(line));
  }
  return plot.lines.empty() ? std::string() : "<div>" + plot.svg() + "</div>\n";
}

// What SLIM's own program reached, if this is the same problem: the objectives of the starts agree then.
inline std::string published_table(const std::vector<Volume_run>& runs, const Volume_experiment& experiment, const std::string& path)
{
  Table published;
  std::string energy = experiment.energy;
  std::replace(energy.begin(), energy.end(), '-', '_');
  if(!published.read(path))
    return "<p>" + escape(path) + " cannot be read: no published figures.</p>\n";
  std::vector<std::string> columns = {"iteration", "SLIM, published program"};
  for(const Volume_run& run : runs)
    columns.push_back(description(run.method));
  std::string rows;
  bool is_same = !runs.empty();
  for(std::size_t i = 0; i < published.number_of_rows(); ++i) {
    const double iteration = published.number(i, "iteration");
    if(published.text(i, "energy") != energy || !(iteration <= experiment.iterations))
      continue;
    if(iteration == 0)
      is_same = is_same && std::abs(published.number(i, "objective") / runs[0].objective_at(0) - 1) < 1e-3;
    rows += "<tr>" + cell(published.text(i, "iteration")) + cell(published.text(i, "objective"));
    for(const Volume_run& run : runs)
      rows += cell(format(run.objective_at(static_cast<int>(iteration)), 6), iteration > run.summary.iterations ? "off" : "");
    rows += "</tr>\n";
  }
  if(!is_same || rows.empty())
    return "";
  std::string text = "<h2>Objectives beside those of SLIM's own program</h2>\n" + header(columns) + rows +
                     "</table></div>\n<p class='muted'>Grey: converged before. ";
  for(const std::string& comment : published.comments())
    text += escape(comment) + ". ";
  return text + "</p>\n";
}

// `results` is what results_of() makes of the runs, `published` the path of a table.
inline bool write_volume_html(const std::string& path, const Volume_experiment& experiment, const std::vector<Volume_run>& runs,
                              const Table& results, const std::string& published)
{
  const double best = best_objective(runs);
  std::ofstream out(path);
  out << html_head("Methods on a solid with soft handles") << "<p>" << escape(experiment.text) << "; at most " << experiment.iterations
      << " iterations from the rest shape, where the objective is " << format(runs[0].objective_at(0), 7)
      << ". The experiment is that of Claici et al. 2017, section 6.2.</p>\n<p class='muted'>" << escape(machine()) << "</p>\n";
  std::vector<std::pair<std::string, Style>> series;
  for(const Volume_run& run : runs)
    series.push_back({escape(description(run.method)), line_style(run.method)});
  out << "<h2>Results</h2>\n"
      << header({"method", "objective", "energy of elements", "iterations", "factori&shy;zations", "CPU seconds", "iterations to 1 %",
                 "CPU seconds to 1 %", "flips", "linear solver", "status"});
  for(std::size_t i = 0; i < runs.size(); ++i) {
    out << "<tr>" << cell(escape(description(runs[i].method)))
        << cell(results.text(i, "objective"), runs[i].objective() <= best * (1 + 1e-6) ? "best" : "");
    for(const char* column : {"energy", "iterations", "factorizations", "cpu_s", "iterations_to_1_percent", "cpu_s_to_1_percent", "flips",
                              "linear_solver", "status"})
      out << cell(escape(results.text(i, column)));
    out << "</tr>\n";
  }
  out << "</table></div>\n<p class='muted'>Objective: mean energy of the elements and the term of the handles. To 1 %: until it is within "
         "1 % of the best of all for good. CPU seconds are of all threads, with the analysis of the matrix.</p>\n"
      << "<h2>Objectives</h2>\n"
      << legend(series) << "<div class='pair'>" << objective_plot(runs, false, 0) << objective_plot(runs, true, 0)
      << "</div>\n<h2>How far from the best</h2>\n"
      << legend(series) << "<div class='pair'>" << objective_plot(runs, false, best) << objective_plot(runs, true, best) << "</div>\n"
      << published_table(runs, experiment, published) << "</body></html>\n";
  return bool(out.flush());
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_VOLUME_REPORT_H
