// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_PERFORMANCE_REPORT_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_PERFORMANCE_REPORT_H

#include "../support/Table.h"
#include "../support/html.h"
#include "../support/svg_plots.h"
#include "ladder_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace benchmark_support {

// The tables of parameterize_report as one page of HTML.
class Performance_report
{
public:
  Performance_report(const Table& runs, const Table& traces, const Table& published) : m_runs(runs), m_published(published)
  {
    const auto add = [](std::vector<std::string>& names, const std::string& name) {
      if(std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    };
    for(std::size_t i = 0; i < runs.number_of_rows(); ++i) {
      add(m_meshes, runs.text(i, "mesh"));
      add(m_sets, runs.text(i, "set"));
      add(m_rules, runs.text(i, "rule"));
      add(m_threads, runs.text(i, "threads"));
      m_rows[key(runs.text(i, "mesh"), runs.text(i, "rule"), runs.text(i, "threads"))] = i;
    }
    for(std::size_t i = 0; i < traces.number_of_rows(); ++i)
      m_traces[key(traces.text(i, "mesh"), traces.text(i, "rule"), traces.text(i, "threads"))].push_back(
        {traces.number(i, "units"), traces.number(i, "energy")});
    for(std::size_t i = 0; i < published.number_of_rows(); ++i)
      for(const std::string& mesh : m_meshes)
        if(published.text(i, "mesh") == mesh &&
           (published.number(i, "faces") == number(mesh, m_rules[0], "faces") || std::isnan(published.number(i, "faces"))))
          m_published_rows[mesh] = i; // it failed where it says nothing about faces
  }

  std::string html()
  {
    m_html = html_head("Flip_free_maps: performance of parameterize()") + "<p class='muted'>";
    for(const std::string& comment : m_runs.comments())
      m_html += escape(comment) + "<br>\n";
    m_html +=
      "</p>\n<p>A <em>unit</em> is the CPU time of one numeric factorization of the matrix of the full mesh in the same run; where a run "
      "needs none, one is timed after it. All-in units are the CPU time of all threads from the mesh in memory to the certified map, over "
      "the unit. Units to 1 %, 10<sup>-4</sup> and 10<sup>-6</sup> are those spent, the start included, until the energy is within that "
      "relative distance of the lowest energy that this report knows for the mesh, published figures included. Rule <em>default</em>: "
      "stopped by the characteristic gradient, as the package does unless told otherwise. Rule <em>energy</em>: stopped by the relative "
      "decrease of the energy, 10<sup>-6</sup>, as the published programs do.</p>\n";
    write_load();
    write_medians();
    write_published();
    m_html += ladder_section(m_runs);
    write_phases();
    write_all_runs();
    write_convergence();
    return m_html + "</body></html>\n";
  }

private:
  using Key = std::tuple<std::string, std::string, std::string>;

  static Key key(const std::string& mesh, const std::string& rule, const std::string& threads) { return Key(mesh, rule, threads); }

  // A column for a mesh, by default with the first number of threads, NaN where there is none.
  double number(const std::string& mesh, const std::string& rule, const std::string& column, std::size_t threads = 0) const
  {
    const auto found = m_rows.find(key(mesh, rule, m_threads[threads]));
    return found == m_rows.end() ? NAN : m_runs.number(found->second, column);
  }

  bool has_converged(const std::string& mesh, const std::string& rule, std::size_t threads) const
  {
    const auto found = m_rows.find(key(mesh, rule, m_threads[threads]));
    return found != m_rows.end() && m_runs.text(found->second, "status") == "success";
  }

  bool has_published(const std::string& mesh) const { return m_published_rows.count(mesh) > 0; }

  double published(const std::string& mesh, const std::string& column) const
  {
    const auto found = m_published_rows.find(mesh);
    return found == m_published_rows.end() ? NAN : m_published.number(found->second, column);
  }

  // The number in parentheses of a cell such as "7 (6.6)".
  double published_units_to(const std::string& mesh, const std::string& column) const
  {
    const auto found = m_published_rows.find(mesh);
    const std::string text = found == m_published_rows.end() ? "" : m_published.text(found->second, column);
    const std::size_t open = text.find('(');
    return open == std::string::npos ? NAN : std::strtod(text.c_str() + open + 1, nullptr);
  }

  // Medians over the meshes of a set, or of all sets but the ladder. What was not reached counts as infinite.
  void write_medians()
  {
    std::vector<std::string> columns = {"set",
                                        "rule",
                                        "meshes",
                                        "valid",
                                        "flips",
                                        "iterations",
                                        "factorizations",
                                        "units",
                                        "to 1 %",
                                        "to 10<sup>-4</sup>",
                                        "to 10<sup>-6</sup>",
                                        "to the end",
                                        "CPU s",
                                        "seconds"};
    for(std::size_t t = 1; t < m_threads.size(); ++t)
      columns.push_back("speedup, " + count_of_threads(m_threads[t]));
    for(const char* column : {"published: factorizations", "units", "theirs / ours: units", "CPU s"})
      columns.push_back(column);
    m_html +=
      "<h2>Medians</h2>\n<p class='muted'>With " + count_of_threads(m_threads[0]) +
      " where nothing else is said. What a run does not reach counts as infinite, as does all of a run that did not end by its rule. "
      "Published figures are medians over those meshes of the set for which there are any; ratios are medians of those of each "
      "mesh.</p>\n" +
      header(columns);
    std::vector<std::string> sets = m_sets;
    if(sets.size() > 1)
      sets.push_back("");
    for(const std::string& set : sets)
      for(const std::string& rule : m_rules)
        write_medians(set, rule, rule == m_rules[0]);
    m_html += "</table></div>\n";
  }

  // Says when the processor had other work to do: with one thread, a run should take as long as its CPU time.
  void write_load()
  {
    std::vector<double> ratios;
    for(std::size_t i = 0; i < m_runs.number_of_rows(); ++i)
      if(m_runs.text(i, "threads") == "1" && m_runs.number(i, "cpu_seconds") > 0.01)
        ratios.push_back(m_runs.number(i, "seconds") / m_runs.number(i, "cpu_seconds"));
    const double ratio = quantile(ratios, 0.5);
    if(ratio > 1.1)
      m_html +=
        "<p class='worse'>The machine had other work to do: with one thread, runs took " + format(ratio, 3) +
        " times their CPU time (median). Wall-clock seconds and speedups tell little here; units and CPU seconds suffer less.</p>\n";
  }

  void write_medians(const std::string& set, const std::string& rule, bool is_first)
  {
    std::vector<std::string> meshes;
    for(const std::string& mesh : m_meshes)
      if((set.empty() ? set_of(mesh) != "ladder" : set_of(mesh) == set) && m_rows.count(key(mesh, rule, m_threads[0])) > 0)
        meshes.push_back(mesh);
    if(meshes.empty())
      return;
    const auto median = [&](auto&& value) {
      std::vector<double> values;
      for(const std::string& mesh : meshes)
        values.push_back(value(mesh));
      return cell(format(quantile(values, 0.5), 3));
    };
    const auto ours = [&](const char* column, std::size_t threads = 0) {
      return median([&](const std::string& mesh) {
        const double value = number(mesh, rule, column, threads);
        return std::isnan(value) || !has_converged(mesh, rule, threads) ? std::numeric_limits<double>::infinity() : value;
      });
    };
    double valid = 0, flips = 0;
    for(const std::string& mesh : meshes) {
      valid += std::isfinite(number(mesh, rule, "energy")) ? 1 : 0;
      flips += (std::max)(0., number(mesh, rule, "flips"));
    }
    m_html += std::string("<tr") + (is_first ? " class='set'>" : ">") + cell(is_first ? (set.empty() ? "all but ladder" : set) : "") +
              cell(rule) + cell(format(static_cast<double>(meshes.size()))) + cell(format(valid)) + cell(format(flips));
    for(const char* column : {"iterations", "factorizations", "units", "units_to_1e-2", "units_to_1e-4", "units_to_1e-6", "units_to_end",
                              "cpu_seconds", "seconds"})
      m_html += ours(column);
    for(std::size_t t = 1; t < m_threads.size(); ++t)
      m_html += ours("speedup", t);
    m_html += median([&](const std::string& mesh) { return published(mesh, "factorizations"); }) +
              median([&](const std::string& mesh) { return published(mesh, "units"); }) +
              median([&](const std::string& mesh) { return published(mesh, "units") / number(mesh, rule, "units"); }) +
              median([&](const std::string& mesh) { return published(mesh, "cpu_s") / number(mesh, rule, "cpu_seconds"); }) + "</tr>\n";
  }

  void write_published()
  {
    if(m_published_rows.empty())
      return;
    m_html += "<h2>Beside the published program</h2>\n";
    for(const std::string& comment : m_published.comments())
      m_html += "<p class='muted'>" + escape(comment) + "</p>\n";
    Line_plot plot;
    plot.x_label = "units, published program";
    plot.y_label = "units, here";
    plot.height = 400;
    plot.x_low = std::numeric_limits<double>::infinity();
    plot.x_high = 0;
    std::vector<std::pair<std::string, Style>> series;
    for(std::size_t i = 0; i < m_sets.size(); ++i) {
      const Style style = style_of_series(i);
      const std::size_t before = plot.dots.size();
      for(const std::string& mesh : m_meshes)
        for(const std::string& rule : m_rules) {
          const double theirs = published(mesh, "units"), ours = number(mesh, rule, "units");
          if(set_of(mesh) != m_sets[i] || !(theirs > 0) || !(ours > 0))
            continue;
          plot.dots.push_back({theirs, ours, style.color, mesh + ", rule " + rule, rule != m_rules[0]});
          plot.x_low = (std::min)({plot.x_low, 0.8 * theirs, 0.8 * ours});
          plot.x_high = (std::max)({plot.x_high, 1.25 * theirs, 1.25 * ours});
        }
      if(plot.dots.size() > before)
        series.push_back({m_sets[i], style});
    }
    plot.y_low = plot.x_low;
    plot.y_high = plot.x_high;
    for(double factor : {1., 2., 4.})
      plot.lines.push_back({{factor == 1 ? "#111827" : "#9ca3af", factor == 1 ? "" : "4 3", 1}, {}});
    for(std::size_t i = 0; i < 3; ++i) {
      const double factor = i == 0 ? 1 : i == 1 ? 2 : 4;
      plot.lines[i].points = {{plot.x_low, plot.x_low / factor}, {plot.x_high, plot.x_high / factor}};
    }
    if(!plot.dots.empty())
      m_html += "<p class='muted'>A dot for each mesh: filled by the rule of the published program, hollow by the default rule. Below the "
                "line we need less work; dashed: half and a quarter of it.</p>\n" +
                legend(series) + "<div style='max-width:640px'>" + plot.svg() + "</div>\n";
    m_html +=
      "<p class='muted'>The units of each program are its own factorizations. CPU seconds of theirs are those of the machine and the "
      "day on which they were measured.</p>\n" +
      header({"mesh",
              "published: factorizations",
              "CPU s",
              "unit, CPU s",
              "units",
              "to 1 %",
              "to 10<sup>-4</sup>",
              "E",
              "here, rule energy: factorizations",
              "CPU s",
              "unit, CPU s",
              "units",
              "to 1 %",
              "to 10<sup>-4</sup>",
              "E / published - 1",
              "rule default: factorizations",
              "units",
              "E / published - 1",
              "theirs / ours: units",
              "CPU s"});
    for(const std::string& mesh : m_meshes)
      if(has_published(mesh))
        write_published(mesh);
    m_html += "</table></div>\n";
  }

  void write_published(const std::string& mesh)
  {
    const double f = published(mesh, "factorizations"), u = published(mesh, "units"), e = published(mesh, "energy");
    const auto ours = [&](const char* rule, const char* column) { return number(mesh, rule, column); };
    const auto compared = [](double x, double bound, int digits) { return cell(format(x, digits), x > bound ? "worse" : ""); };
    const auto excess = [&](const char* rule) { return compared(ours(rule, "energy") / e - 1, 1e-5, 2); };
    const auto plain = [](double x) { return cell(format(x, 3)); };
    m_html += "<tr>" + cell(mesh) + (std::isnan(f) ? cell("fails", "off") : cell(format(f))) + plain(published(mesh, "cpu_s")) +
              plain(published(mesh, "unit_s")) + plain(u) + plain(published_units_to(mesh, "to_1_percent_it(units)")) +
              plain(published_units_to(mesh, "to_1e-4_it(units)")) + cell(format(e, 8)) + compared(ours("energy", "factorizations"), f, 4) +
              plain(ours("energy", "cpu_seconds")) + plain(ours("energy", "factorization_cpu_seconds")) +
              compared(ours("energy", "units"), u, 3) + plain(ours("energy", "units_to_1e-2")) + plain(ours("energy", "units_to_1e-4")) +
              excess("energy") + compared(ours("default", "factorizations"), f, 4) + compared(ours("default", "units"), u, 3) +
              excess("default") + plain(u / ours("energy", "units")) + plain(published(mesh, "cpu_s") / ours("energy", "cpu_seconds")) +
              "</tr>\n";
  }

  void write_phases()
  {
    std::vector<std::string> names;
    std::vector<std::vector<double>> values;
    for(const std::string& mesh : m_meshes) {
      const auto found = m_rows.find(key(mesh, m_rules[0], m_threads[0]));
      if(found == m_rows.end())
        continue;
      const double unit = m_runs.number(found->second, "factorization_seconds");
      std::vector<double> parts = phases_of(m_runs, found->second);
      for(double& part : parts)
        part /= unit;
      if(unit > 0) {
        names.push_back(mesh);
        values.push_back(parts);
      }
    }
    if(names.empty())
      return;
    m_html += "<h2>Where the time goes</h2>\n<p class='muted'>Wall-clock seconds of each phase over those of one factorization; rule " +
              m_rules[0] + ", " + count_of_threads(m_threads[0]) + ".</p>\n" + phase_legend() +
              stacked_bars(names, values, phase_styles(), "factorizations' worth of time") + "\n";
  }

  void write_all_runs()
  {
    m_html +=
      "<h2>All runs</h2>\n<p class='muted'>Medians over the repeats. Peak memory is that of the process; grey: the map is not valid, or "
      "a limit ended the run.</p>\n" +
      header({"mesh",
              "rule",
              "threads",
              "status",
              "faces",
              "flips",
              "iterations",
              "factorizations",
              "E",
              "E / best - 1",
              "units",
              "to 1 %",
              "to 10<sup>-4</sup>",
              "to 10<sup>-6</sup>",
              "to the end",
              "seconds",
              "CPU s",
              "unit, CPU s",
              "speedup",
              "peak MB"});
    std::string last;
    for(std::size_t i = 0; i < m_runs.number_of_rows(); ++i) {
      const std::string mesh = m_runs.text(i, "mesh");
      const std::string style = m_runs.text(i, "status") == "success" ? "" : "off";
      m_html += std::string("<tr") + (mesh != last ? " class='set'>" : ">") + cell(mesh != last ? mesh : "");
      last = mesh;
      for(const char* column : {"rule", "threads", "status", "faces", "flips", "iterations", "factorizations"})
        m_html += cell(m_runs.text(i, column), style);
      m_html += cell(format(m_runs.number(i, "energy"), 9), style);
      for(const char* column : {"energy_above_best", "units", "units_to_1e-2", "units_to_1e-4", "units_to_1e-6", "units_to_end", "seconds",
                                "cpu_seconds", "factorization_cpu_seconds", "speedup"})
        m_html += cell(format(m_runs.number(i, column), 3), style);
      m_html += cell(format(m_runs.number(i, "peak_memory_mb"), 4), style) + "</tr>\n";
    }
    m_html += "</table></div>\n";
  }

  // Distance to the best energy over units.
  void write_convergence()
  {
    const std::array<Style, 2> styles = {{{"#111827", "", 2.2}, {"#d62728", "6 3", 1.8}}};
    const Style theirs = {"#1f77b4", "", 1.6};
    std::vector<std::pair<std::string, Style>> series;
    for(std::size_t i = 0; i < m_rules.size(); ++i)
      series.push_back({"rule " + m_rules[i], styles[i % 2]});
    if(!m_published_rows.empty())
      series.push_back({"published program (dots)", theirs});
    m_html += "<h2>Convergence</h2>\n<p class='muted'>Relative distance of the energy to the lowest known one, over units of CPU time, the "
              "start included. The lines of both rules differ by where they end, and by noise of the clock.</p>\n" +
              legend(series) + "<div class='pair'>";
    for(const std::string& mesh : m_meshes) {
      double best = published(mesh, "energy");
      for(const std::string& rule : m_rules)
        for(std::size_t t = 0; t < m_threads.size(); ++t)
          best = std::fmin(best, number(mesh, rule, "energy", t));
      Line_plot plot;
      plot.x_label = "units";
      plot.y_label = "(E - best E) / best E";
      plot.y_low = BOTTOM;
      plot.x_low = std::numeric_limits<double>::infinity();
      plot.x_high = 0;
      double top = 0.01;
      const auto add = [&](double x, double energy) {
        const double gap = (std::max)(BOTTOM, energy / best - 1);
        plot.x_low = (std::min)(plot.x_low, 0.8 * x);
        plot.x_high = (std::max)(plot.x_high, 1.25 * x);
        top = (std::max)(top, (std::min)(gap, 1e6));
        return std::make_pair(x, gap);
      };
      for(std::size_t i = 0; i < m_rules.size(); ++i) {
        Line_plot::Line line{styles[i % 2], {}};
        const auto trace = m_traces.find(key(mesh, m_rules[i], m_threads[0]));
        if(trace != m_traces.end())
          for(const auto& p : trace->second)
            if(p.first > 0)
              line.points.push_back(add(p.first, p.second));
        if(!line.points.empty())
          plot.lines.push_back(line);
      }
      if(plot.lines.empty() || !std::isfinite(best))
        continue;
      const double last = published(mesh, "energy");
      const std::array<std::pair<double, double>, 3> known = {{{published_units_to(mesh, "to_1_percent_it(units)"), 1.01 * last},
                                                               {published_units_to(mesh, "to_1e-4_it(units)"), 1.0001 * last},
                                                               {published(mesh, "units"), last}}};
      for(const auto& p : known)
        if(p.first > 0) {
          const auto q = add(p.first, p.second);
          plot.dots.push_back({q.first, q.second, theirs.color, "published program", true});
        }
      plot.y_high = std::pow(10., std::ceil(std::log10(top)));
      m_html += "<div><h3>" + mesh + ", " + format(number(mesh, m_rules[0], "faces"), 9) + " triangles, lowest energy " + format(best, 8) +
                "</h3>" + plot.svg() + "</div>\n";
    }
    m_html += "</div>\n";
  }

  static constexpr double BOTTOM = 1e-9;

  const Table& m_runs;
  const Table& m_published;
  std::vector<std::string> m_meshes, m_sets, m_rules, m_threads;
  std::map<Key, std::size_t> m_rows;
  std::map<Key, std::vector<std::pair<double, double>>> m_traces; // units and energy
  std::map<std::string, std::size_t> m_published_rows;            // by mesh
  std::string m_html;
};

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_PERFORMANCE_PERFORMANCE_REPORT_H
