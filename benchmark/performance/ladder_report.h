// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_LADDER_REPORT_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_LADDER_REPORT_H

#include "../support/Table.h"
#include "../support/html.h"
#include "../support/svg_plots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

inline std::string count_of_threads(const std::string& number) { return number + (number == "1" ? " thread" : " threads"); }

inline const std::vector<std::string>& phase_names()
{
  static const std::vector<std::string> names = {"load",  "start",       "analyze", "assemble", "factorize",
                                                 "solve", "line search", "certify", "other"};
  return names;
}

inline std::vector<Style> phase_styles()
{
  std::vector<Style> styles;
  for(std::size_t i = 0; i < phase_names().size(); ++i) {
    styles.push_back(style_of_series(i));
    styles.back().width = 8;
  }
  styles.back().color = "#d1d5db";
  return styles;
}

inline std::string phase_legend()
{
  std::vector<std::pair<std::string, Style>> series;
  for(std::size_t i = 0; i < phase_names().size(); ++i)
    series.push_back({phase_names()[i], phase_styles()[i]});
  return legend(series);
}

// Seconds of a run by phase, the rest as the last of them.
inline std::vector<double> phases_of(const Table& runs, std::size_t row)
{
  std::vector<double> parts;
  double rest = runs.number(row, "seconds");
  for(const char* column : {"seconds_load", "seconds_start", "seconds_analyze", "seconds_assemble", "seconds_factorize", "seconds_solve",
                            "seconds_line_search", "seconds_certify"}) {
    parts.push_back(runs.number(row, column));
    rest -= parts.back();
  }
  parts.push_back((std::max)(0., rest));
  return parts;
}

// A plot of a column of the converged runs of each series over their faces, with a line of linear growth.
inline std::string plot_over_faces(const Table& runs, const std::vector<std::vector<std::size_t>>& rows, const std::vector<Style>& styles,
                                   const std::string& column, const std::string& label)
{
  Line_plot plot;
  plot.x_label = "triangles";
  plot.y_label = label;
  plot.x_low = plot.y_low = std::numeric_limits<double>::infinity();
  plot.x_high = plot.y_high = 0;
  for(std::size_t i = 0; i < rows.size(); ++i) {
    Line_plot::Line line{styles[i], {}};
    for(std::size_t row : rows[i]) {
      const double x = runs.number(row, "faces"), y = runs.number(row, column);
      if(!(x > 0) || !(y > 0) || runs.text(row, "status") != "success")
        continue;
      line.points.push_back({x, y});
      plot.dots.push_back({x, y, styles[i].color, runs.text(row, "mesh") + ": " + format(y), true});
      plot.x_low = (std::min)(plot.x_low, 0.7 * x);
      plot.x_high = (std::max)(plot.x_high, 1.4 * x);
      plot.y_low = (std::min)(plot.y_low, 0.5 * y);
      plot.y_high = (std::max)(plot.y_high, 2 * y);
    }
    if(!line.points.empty())
      plot.lines.push_back(line);
  }
  if(plot.lines.empty())
    return std::string();
  const auto first = plot.lines.front().points.front();
  plot.lines.insert(plot.lines.begin(),
                    {{"#9ca3af", "4 3", 1},
                     {{plot.x_low, first.second * plot.x_low / first.first}, {plot.x_high, first.second * plot.x_high / first.first}}});
  return plot.svg();
}

// Time, memory and their growth on the refinements of one surface, for each rule and number of threads. Empty without a ladder.
inline std::string ladder_section(const Table& runs)
{
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> by_series;
  for(std::size_t i = 0; i < runs.number_of_rows(); ++i)
    if(runs.text(i, "set") == "ladder" && std::isfinite(runs.number(i, "energy")))
      by_series[{runs.text(i, "rule"), runs.text(i, "threads")}].push_back(i);
  if(by_series.empty())
    return std::string();
  std::vector<std::vector<std::size_t>> rows;
  std::vector<Style> styles;
  std::vector<std::pair<std::string, Style>> series;
  for(const auto& entry : by_series) {
    Style style = style_of_series(rows.size());
    style.dashes = entry.first.first == "default" ? "" : "6 3";
    rows.push_back(entry.second);
    styles.push_back(style);
    series.push_back({"rule " + entry.first.first + ", " + count_of_threads(entry.first.second), style});
  }
  series.push_back({"linear growth", {"#9ca3af", "4 3", 1}});
  std::string html =
    "<h2>Resolution ladder</h2>\n<p class='muted'>One generated surface, refined. Memory is that of the process, which may keep what it once "
    "had: steps are run in ascending order, and the peak is reset before each run where the system allows it (Linux). <em>Before</em>: resident "
    "before the run, mostly the mesh; <em>start</em>: peak until the first matrix is to be factorized; <em>minimize</em>: peak from there on. "
    "Exponents of growth are those from the step above: 1 is linear. Runs that a limit ended are not drawn.</p>\n" +
    legend(series) + "<div class='pair'><div>" + plot_over_faces(runs, rows, styles, "seconds", "seconds, wall clock") + "</div><div>" +
    plot_over_faces(runs, rows, styles, "peak_memory_mb", "peak memory, MB") + "</div></div>\n";
  std::vector<std::string> columns = {"triangles", "rule", "threads", "E", "iterations", "factorizations", "units", "seconds"};
  columns.insert(columns.end(), phase_names().begin(), phase_names().end());
  for(const char* column : {"speedup", "MB: before", "start", "minimize", "bytes / triangle", "growth: time", "memory"})
    columns.push_back(column);
  html += header(columns);
  const auto has_converged = [&runs](std::size_t row) { return runs.text(row, "status") == "success"; };
  for(const auto& entry : by_series)
    for(std::size_t k = 0; k < entry.second.size(); ++k) {
      const std::size_t row = entry.second[k];
      const auto value = [&runs, row](const char* column, int digits = 3) { return cell(format(runs.number(row, column), digits)); };
      html += std::string("<tr") + (k == 0 ? " class='set'>" : ">") + value("faces", 9) + cell(entry.first.first) +
              cell(entry.first.second) + value("energy", 8) + value("iterations") + value("factorizations") + value("units") +
              value("seconds");
      for(double part : phases_of(runs, row))
        html += cell(format(part, 3));
      html += value("speedup") + value("memory_before_mb", 4) + value("memory_start_mb", 4) + value("memory_minimize_mb", 4) +
              cell(format(runs.number(row, "peak_memory_mb") * 1024 * 1024 / runs.number(row, "faces"), 4));
      const bool has_growth = k > 0 && has_converged(entry.second[k - 1]) && has_converged(row);
      for(const char* column : {"seconds", "peak_memory_mb"}) {
        const auto ratio = [&](const char* name) { return runs.number(row, name) / runs.number(entry.second[k - 1], name); };
        html += cell(has_growth ? format(std::log(ratio(column)) / std::log(ratio("faces")), 3) : "");
      }
      html += "</tr>\n";
    }
  return html + "</table></div>\n";
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_LADDER_REPORT_H
