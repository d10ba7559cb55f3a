// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_QUALITY_HTML_REPORT_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_QUALITY_HTML_REPORT_H

#include "../support/Table.h"
#include "../support/html.h"
#include "../support/svg_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

// The results of run_methods as one page of HTML that needs nothing from anywhere else.
class Html_report
{
public:
  Html_report(const Table& results, const Table& traces, const Table& reference, const std::string& published)
    : m_results(results), m_reference(reference), m_published(published)
  {
    for(std::size_t i = 0; i < results.number_of_rows(); ++i) {
      const std::string mesh = results.text(i, "mesh"), method = results.text(i, "method");
      if(m_rows[mesh].empty())
        m_meshes.push_back(mesh);
      if(std::find(m_methods.begin(), m_methods.end(), method) == m_methods.end())
        m_methods.push_back(method);
      const std::string set = set_of(mesh);
      if(std::find(m_sets.begin(), m_sets.end(), set) == m_sets.end())
        m_sets.push_back(set);
      m_rows[mesh][method] = i;
    }
    for(std::size_t i = 0; i < traces.number_of_rows(); ++i)
      m_traces[traces.text(i, "mesh")][traces.text(i, "method")].push_back(
        {traces.number(i, "iteration"), traces.number(i, "seconds"), traces.number(i, "energy")});
    std::sort(m_meshes.begin(), m_meshes.end());
    std::sort(m_sets.begin(), m_sets.end());
    static const std::vector<std::string> order = {"default", "pp", "cm", "p-cm", "slim", "p-slim", "akvf", "p-akvf"};
    std::stable_sort(m_methods.begin(), m_methods.end(), [](const std::string& a, const std::string& b) {
      return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
    });
  }

  std::string html()
  {
    m_html = html_head("Flip_free_maps: methods compared") + "<p class='muted'>";
    for(const std::string& comment : m_results.comments())
      m_html += escape(comment) + "<br>\n";
    m_html += "</p>\n";
    write_overview();
    write_medians();
    write_pairs();
    write_claims();
    write_reference();
    write_summary_table();
    write_published();
    write_plots();
    return m_html + "</body></html>\n";
  }

private:
  struct Point
  {
    double iteration;
    double seconds;
    double energy;
  };

  bool has(const std::string& mesh, const std::string& method) const { return m_rows.at(mesh).count(method) > 0; }

  // A column of the results, NaN where there was no run or, unless it is the energy that is asked for, where it did not converge.
  double number(const std::string& mesh, const std::string& method, const std::string& column) const
  {
    const auto found = m_rows.at(mesh).find(method);
    return found == m_rows.at(mesh).end() ? std::numeric_limits<double>::quiet_NaN() : m_results.number(found->second, column);
  }

  bool converged(const std::string& mesh, const std::string& method) const
  {
    return has(mesh, method) && m_results.text(m_rows.at(mesh).at(method), "status") == "success";
  }

  double best_energy(const std::string& mesh) const
  {
    double best = std::numeric_limits<double>::infinity();
    for(const std::string& method : m_methods) {
      const double energy = number(mesh, method, "energy");
      best = energy < best ? energy : best;
    }
    return best;
  }

  // Whether a run ended in the optimum as far as any method found it.
  bool is_optimal(const std::string& mesh, const std::string& method) const
  {
    return number(mesh, method, "energy") <= best_energy(mesh) * (1 + GOOD);
  }

  // The values of a column over a set (all sets if empty); runs that did not get close to the best energy count as infinite.
  std::vector<double> values(const std::string& set, const std::string& method, const std::string& column) const
  {
    std::vector<double> result;
    for(const std::string& mesh : m_meshes)
      if((set.empty() || set_of(mesh) == set) && has(mesh, method)) {
        const double value = number(mesh, method, column);
        result.push_back(is_optimal(mesh, method) && std::isfinite(value) ? value : std::numeric_limits<double>::infinity());
      }
    return result;
  }

  // Shares of meshes over iterations, and boxes of factorizations.
  void write_overview()
  {
    m_html += "<h2>Overview</h2>\n<p>Share of the meshes on which a method is within 1 % and 0.01 % of the best energy that any "
              "method found, over its iterations. A method that ends too high never gets there.</p>\n" +
              legend(m_methods) + "<div class='pair'>";
    const std::vector<std::pair<const char*, const char*>> columns = {{"eta_of_best", "1 %"}, {"to_1e-4_of_best", "0.01 %"}};
    for(const auto& column : columns) {
      Line_plot plot;
      plot.x_label = "1 + iterations";
      plot.y_label = std::string("share of meshes within ") + column.second;
      plot.y_is_logarithmic = false;
      plot.is_staircase = true;
      plot.x_high = 2000;
      for(const std::string& method : m_methods) {
        std::vector<double> steps;
        double number_of_runs = 0;
        for(const std::string& mesh : m_meshes) {
          number_of_runs += has(mesh, method) ? 1 : 0;
          const double value = number(mesh, method, column.first);
          if(std::isfinite(value))
            steps.push_back(1 + value);
        }
        std::sort(steps.begin(), steps.end());
        Line_plot::Line line{style_of(method), {{1, 0}}};
        for(std::size_t i = 0; i < steps.size(); ++i)
          line.points.push_back({steps[i], static_cast<double>(i + 1) / number_of_runs});
        line.points.push_back({plot.x_high, line.points.back().second});
        plot.lines.push_back(line);
      }
      m_html += "<div>" + plot.svg() + "</div>";
    }
    m_html +=
      "</div>\n<h3>Factorizations</h3>\n<p class='muted'>Of runs that end within 0.1 % of the best energy: box from quartile to quartile, "
      "line at the median, whiskers to the extremes, a dot for each mesh.</p>\n<div class='pair'>";
    std::vector<std::string> sets = m_sets;
    if(sets.size() > 1)
      sets.push_back("");
    for(const std::string& set : sets) {
      std::map<std::string, std::vector<double>> boxes;
      for(const std::string& method : m_methods)
        for(double v : values(set, method, "factorizations"))
          if(std::isfinite(v))
            boxes[method].push_back(v);
      m_html += "<div>" + box_plot(m_methods, boxes, "factorizations, " + (set.empty() ? "all sets" : "set " + set)) + "</div>";
    }
    m_html += "</div>\n";
  }

  void write_medians()
  {
    m_html +=
      "<h2>Medians for each set</h2>\n<p class='muted'>Runs that do not end within 0.1 % of the best energy count as infinite. Units: all "
      "CPU time of the run over that of one factorization.</p>\n" +
      header({"set", "method", "runs", "converged", "within 0.1 % of best", "iterations", "&eta; (1 %)", "to 10<sup>-4</sup>",
              "factorizations", "units", "CPU s", "E / best E, median", "E / best E, largest", "flips"});
    std::vector<std::string> sets = m_sets;
    if(sets.size() > 1)
      sets.push_back("");
    for(const std::string& set : sets) {
      bool is_first = true;
      for(const std::string& method : m_methods) {
        double runs = 0, good = 0, optimal = 0, flips = 0;
        std::vector<double> ratios;
        for(const std::string& mesh : m_meshes)
          if((set.empty() || set_of(mesh) == set) && has(mesh, method)) {
            ++runs;
            good += converged(mesh, method) ? 1 : 0;
            optimal += is_optimal(mesh, method) ? 1 : 0;
            const double ratio = number(mesh, method, "energy") / best_energy(mesh);
            ratios.push_back(std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio);
            flips += std::isfinite(number(mesh, method, "energy")) ? number(mesh, method, "flips") : 0;
          }
        if(runs == 0)
          continue;
        const auto median = [&](const char* column, int digits = 3) {
          return cell(format(quantile(values(set, method, column), 0.5), digits));
        };
        m_html += std::string("<tr") + (is_first ? " class='set'>" : ">") + cell(is_first ? (set.empty() ? "all" : set) : "") +
                  cell(method) + cell(format(runs)) + cell(format(good)) + cell(format(optimal)) + median("iterations") + median("eta") +
                  median("to_1e-4") + median("factorizations") + median("factorization_units") + median("cpu_seconds") +
                  cell(format(quantile(ratios, 0.5), 6)) + cell(format(quantile(ratios, 1), 5)) + cell(format(flips)) + "</tr>\n";
        is_first = false;
      }
    }
    m_html += "</table></div>\n";
  }

  // For meshes on which both methods end in the optimum: ratios of a column, wins of the first, ties and losses. A method that
  // alone ends in the optimum wins.
  struct Duel
  {
    int wins = 0, ties = 0, losses = 0;
    std::vector<double> ratios;
  };

  Duel duel(const std::string& a, const std::string& b, const std::string& column) const
  {
    Duel result;
    for(const std::string& mesh : m_meshes) {
      if(!has(mesh, a) || !has(mesh, b))
        continue;
      const bool good_a = is_optimal(mesh, a), good_b = is_optimal(mesh, b);
      const double x = number(mesh, a, column), y = number(mesh, b, column);
      if(good_a && good_b && y > 0)
        result.ratios.push_back(x / y);
      const int sign = good_a && good_b ? (x > y) - (x < y) : int(good_b) - int(good_a);
      ++(sign < 0 ? result.wins : sign > 0 ? result.losses : result.ties);
    }
    return result;
  }

  void write_pairs()
  {
    std::vector<std::pair<std::string, std::string>> pairs;
    const auto is_there = [this](const std::string& m) { return std::find(m_methods.begin(), m_methods.end(), m) != m_methods.end(); };
    for(const std::string& method : m_methods)
      if(is_there("p-" + method))
        pairs.push_back({"p-" + method, method});
    for(const char* other : {"projected-newton", "slim", "aqp"})
      pairs.push_back({"cm", other});
    for(const char* other : {"p-cm", "cm", "akvf", "slim"})
      pairs.push_back({"pp", other});
    pairs.push_back({"akvf", "slim"});
    pairs.push_back({"default", "pp"});
    m_html +=
      "<h2>Pairs of methods</h2>\n<p class='muted'>Over all meshes. A method that alone ends within 0.1 % of the best energy wins; median "
      "ratios are those of meshes on which both do.</p>\n" +
      header({"first", "second", "iterations, median ratio", "wins, ties, losses", "&eta;, median ratio", "wins, ties, losses",
              "factorizations, median ratio", "wins, ties, losses", "CPU, median ratio", "wins, ties, losses"});
    for(const auto& pair : pairs) {
      if(!is_there(pair.first) || !is_there(pair.second))
        continue;
      m_html += "<tr>" + cell(pair.first) + cell(pair.second);
      for(const char* column : {"iterations", "eta", "factorizations", "cpu_seconds"}) {
        const Duel d = duel(pair.first, pair.second, column);
        m_html += cell(format(quantile(d.ratios, 0.5), 3)) +
                  cell(std::to_string(d.wins) + ", " + std::to_string(d.ties) + ", " + std::to_string(d.losses));
      }
      m_html += "</tr>\n";
    }
    m_html += "</table></div>\n";
  }

  // Statements of the papers beside the same figures of these runs.
  void write_claims()
  {
    std::vector<std::array<std::string, 4>> claims;
    const auto add = [&claims](const std::string& place, const std::string& claim, double theirs, double ours) {
      if(std::isfinite(ours) && std::isfinite(theirs))
        claims.push_back({{place, claim, format(theirs, 5), format(ours, 5)}});
    };
    const auto mean_ratio = [this](const std::string& method) {
      std::vector<double> ratios;
      for(const std::string& mesh : m_meshes)
        if(set_of(mesh)[0] == 'd' && converged(mesh, "pp") && converged(mesh, method))
          ratios.push_back(number(mesh, method, "energy") / number(mesh, "pp", "energy"));
      double sum = 0;
      for(double ratio : ratios)
        sum += ratio;
      return sum / static_cast<double>(ratios.size());
    };
    Table liu, shtengel, liu_table;
    if(liu.read(m_published + "/liu_2018_statements.csv"))
      for(std::size_t i = 0; i < liu.number_of_rows(); ++i) {
        const std::string statement = liu.text(i, "statement"), method = liu.text(i, "method");
        const std::string place = "Liu et al. 2018, " + liu.text(i, "place");
        const double value = liu.number(i, "value");
        if(statement == "largest eta on D1")
          add(place, statement + ", " + method, value, largest_eta("d1", method));
        if(statement == "average energy over that of pp")
          add(place, statement + " (here: sets d*), " + method, value, mean_ratio(method));
        if(statement == "iterations on a Hilbert curve")
          add(place, statement + " (here: median of special_hilbert*), " + method, value,
              quantile(values_of_meshes("special_hilbert", method), 0.5));
      }
    const auto published_ratio = [](const Table& table, const std::string& a, const std::string& b) {
      std::vector<double> ratios;
      for(std::size_t i = 0; i < table.number_of_rows(); ++i)
        ratios.push_back(table.number(i, a) / table.number(i, b));
      return quantile(ratios, 0.5);
    };
    if(shtengel.read(m_published + "/shtengel_2017_table_1.csv"))
      for(const char* method : {"projected-newton", "slim", "aqp"}) {
        std::string column = method;
        std::replace(column.begin(), column.end(), '-', '_');
        add("Shtengel et al. 2017, table 1", std::string("iterations of ") + method + " over those of cm, median",
            published_ratio(shtengel, column + "_iterations", "cm_iterations"), quantile(duel(method, "cm", "iterations").ratios, 0.5));
      }
    if(liu_table.read(m_published + "/liu_2018_table_1.csv"))
      for(const char* method : {"cm", "akvf", "slim"}) {
        add("Liu et al. 2018, table 1", std::string("iterations of ") + method + " over those of pp, median",
            published_ratio(liu_table, std::string(method) + "_iterations", "pp_iterations"),
            quantile(duel(method, "pp", "iterations").ratios, 0.5));
        add("Liu et al. 2018, table 1", std::string("&eta; of ") + method + " over that of pp, median",
            published_ratio(liu_table, std::string(method) + "_eta", "pp_eta"), quantile(duel(method, "pp", "eta").ratios, 0.5));
      }
    if(claims.empty())
      return;
    m_html +=
      "<h2>Statements of the papers</h2>\n<p class='muted'>Their meshes are not these; similar figures are what can be expected.</p>\n" +
      header({"source", "statement", "published", "here"});
    for(const auto& claim : claims)
      m_html += "<tr>" + cell(claim[0]) + "<td style='text-align:left'>" + claim[1] + "</td>" + cell(claim[2]) + cell(claim[3]) + "</tr>\n";
    m_html += "</table></div>\n";
  }

  double largest_eta(const std::string& set, const std::string& method) const
  {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for(const std::string& mesh : m_meshes)
      if(set_of(mesh) == set && converged(mesh, method))
        largest = std::fmax(largest, number(mesh, method, "eta"));
    return largest;
  }

  std::vector<double> values_of_meshes(const std::string& prefix, const std::string& method) const
  {
    std::vector<double> result;
    for(const std::string& mesh : m_meshes)
      if(mesh.compare(0, prefix.size(), prefix) == 0 && has(mesh, method))
        result.push_back(is_optimal(mesh, method) ? number(mesh, method, "iterations") : std::numeric_limits<double>::infinity());
    return result;
  }

  void write_reference()
  {
    if(m_reference.number_of_rows() == 0)
      return;
    m_html +=
      "<h2>Beside the published program of progressive parameterizations</h2>\n<p class='muted'>Red: more than the published program. "
      "&eta; and iterations to 10<sup>-4</sup> are relative to each run's own final energy.</p>\n" +
      header({"mesh", "program: factorizations", "units", "&eta;", "to 10<sup>-4</sup>", "E", "pp: factorizations", "units", "&eta;",
              "to 10<sup>-4</sup>", "E", "default: factorizations", "units", "E"});
    const auto compared = [](double ours, double theirs, int digits, double tolerance = 0) {
      return cell(format(ours, digits), ours > theirs * (1 + tolerance) ? "worse" : "");
    };
    for(std::size_t i = 0; i < m_reference.number_of_rows(); ++i) {
      const std::string mesh = m_reference.text(i, "mesh");
      if(m_rows.count(mesh) == 0)
        continue;
      const double f = m_reference.number(i, "factorizations"), u = m_reference.number(i, "units"), e = m_reference.number(i, "energy");
      const double eta = m_reference.number(i, "to_1_percent_it(units)"), to = m_reference.number(i, "to_1e-4_it(units)");
      m_html += "<tr>" + cell(mesh) + (std::isnan(f) ? cell("fails", "off") : cell(format(f))) + cell(format(u)) + cell(format(eta)) +
                cell(format(to)) + cell(format(e, 7));
      const auto ours = [&](const char* method, const char* column) { return number(mesh, method, column); };
      m_html += compared(ours("pp", "factorizations"), f, 4) + compared(ours("pp", "factorization_units"), u, 3) +
                compared(ours("pp", "eta"), eta, 4) + compared(ours("pp", "to_1e-4"), to, 4) + compared(ours("pp", "energy"), e, 7, 1e-5) +
                compared(ours("default", "factorizations"), f, 4) + compared(ours("default", "factorization_units"), u, 3) +
                compared(ours("default", "energy"), e, 7, 1e-5) + "</tr>\n";
    }
    m_html += "</table></div>\n";
  }

  void write_summary_table()
  {
    std::vector<std::string> columns = {"mesh", "faces"};
    columns.insert(columns.end(), m_methods.begin(), m_methods.end());
    m_html +=
      "<h2>All runs</h2>\n<p class='muted'>Iterations / &eta; / energy. Bold: fewest iterations among the runs within 0.1 % of the best "
      "energy; red: more than 0.1 % above it; grey: stopped by the time limit, or failed.</p>\n" +
      header(columns);
    std::string last_set;
    for(const std::string& mesh : m_meshes) {
      double fewest = std::numeric_limits<double>::infinity();
      for(const std::string& method : m_methods)
        if(is_optimal(mesh, method))
          fewest = (std::min)(fewest, number(mesh, method, "iterations"));
      m_html += std::string("<tr") + (set_of(mesh) != last_set ? " class='set'>" : ">") + cell(mesh) +
                cell(m_results.text(m_rows.at(mesh).begin()->second, "faces"));
      last_set = set_of(mesh);
      for(const std::string& method : m_methods) {
        if(!has(mesh, method)) {
          m_html += cell("");
          continue;
        }
        const double energy = number(mesh, method, "energy"), iterations = number(mesh, method, "iterations");
        const std::string style = !is_optimal(mesh, method)  ? (converged(mesh, method) ? "worse" : "off")
                                  : iterations == fewest     ? "best"
                                  : !converged(mesh, method) ? "off"
                                                             : "";
        const std::string status = m_results.text(m_rows.at(mesh).at(method), "status");
        m_html += cell(std::isfinite(energy) ? format(iterations) + " / " + format(number(mesh, method, "eta")) + " / " + format(energy, 6)
                                             : escape(status),
                       style);
      }
      m_html += "</tr>\n";
    }
    m_html += "</table></div>\n";
  }

  // The papers' tables, and our figures where a mesh of theirs has as many vertices and faces as one of ours.
  void write_published()
  {
    m_html += "<h2>Published tables</h2>\n";
    for(const char* file : {"claici_2017_table_1.csv", "shtengel_2017_table_1.csv", "liu_2018_table_1.csv"}) {
      Table table;
      if(!table.read(m_published + "/" + file))
        continue;
      for(std::size_t i = 0; i < table.comments().size(); ++i)
        m_html += (i == 0 ? "<h3>" : "<p class='muted'>") + escape(table.comments()[i]) + (i == 0 ? "</h3>\n" : "</p>\n");
      std::vector<std::string> columns;
      for(std::string column : table.columns()) {
        std::replace(column.begin(), column.end(), '_', ' ');
        columns.push_back(column);
      }
      const bool has_sizes = table.has_column("faces");
      if(has_sizes)
        columns.push_back("here, on the same numbers of vertices and faces");
      m_html += header(columns);
      for(std::size_t i = 0; i < table.number_of_rows(); ++i) {
        m_html += "<tr>";
        for(const std::string& text : table.row(i))
          m_html += cell(text.empty() ? "-" : escape(text));
        if(has_sizes)
          m_html += cell(corresponding_runs(table.text(i, "vertices"), table.text(i, "faces")));
        m_html += "</tr>\n";
      }
      m_html += "</table></div>\n";
    }
  }

  std::string corresponding_runs(const std::string& vertices, const std::string& faces) const
  {
    std::string text;
    for(const std::string& mesh : m_meshes) {
      const std::size_t any = m_rows.at(mesh).begin()->second;
      if(m_results.text(any, "vertices") != vertices || m_results.text(any, "faces") != faces)
        continue;
      text += "<b>" + mesh + "</b>";
      for(const std::string& method : m_methods)
        if(has(mesh, method))
          text += "<br>" + method + ": " + format(number(mesh, method, "iterations")) + " iterations, " +
                  format(number(mesh, method, "seconds"), 3) + " s, E = " + format(number(mesh, method, "energy"), 6);
    }
    return text;
  }

  void write_plots()
  {
    m_html +=
      "<h2>Convergence</h2>\n<p class='muted'>Relative distance of the energy to the best one that any method found, over iterations and "
      "over wall-clock seconds, the start included. Lines that end low have found the best energy.</p>\n";
    for(const std::string& mesh : m_meshes) {
      const auto found = m_traces.find(mesh);
      if(found == m_traces.end())
        continue;
      double best = best_energy(mesh);
      for(const auto& entry : found->second)
        for(const Point& p : entry.second)
          best = p.energy < best ? p.energy : best;
      Line_plot by_iteration, by_time;
      by_iteration.x_label = "1 + iterations";
      by_time.x_label = "seconds";
      by_iteration.y_label = by_time.y_label = "(E - best E) / best E";
      double top = 0.1;
      by_iteration.x_high = 10;
      by_time.x_low = std::numeric_limits<double>::infinity();
      by_time.x_high = 0;
      std::vector<std::string> methods;
      for(const std::string& method : m_methods) {
        const auto trace = found->second.find(method);
        if(trace == found->second.end())
          continue;
        methods.push_back(method);
        Line_plot::Line a{style_of(method), {}}, b = a;
        for(const Point& p : trace->second) {
          const double gap = (std::min)(TOP, (std::max)(BOTTOM, (p.energy - best) / best));
          top = (std::max)(top, gap);
          a.points.push_back({1 + p.iteration, gap});
          b.points.push_back({(std::max)(p.seconds, 1e-4), gap});
        }
        if(a.points.empty())
          continue;
        by_iteration.x_high = (std::max)(by_iteration.x_high, a.points.back().first);
        by_time.x_low = (std::min)(by_time.x_low, b.points.front().first);
        by_time.x_high = (std::max)(by_time.x_high, b.points.back().first);
        by_iteration.lines.push_back(a);
        by_time.lines.push_back(b);
      }
      by_iteration.y_low = by_time.y_low = BOTTOM;
      by_iteration.y_high = by_time.y_high = std::pow(10., std::ceil(std::log10(top)));
      m_html += "<h3>" + mesh + ", " + m_results.text(m_rows.at(mesh).begin()->second, "faces") + " triangles, best energy " +
                format(best, 8) + "</h3>\n" + legend(methods) + "<div class='pair'><div>" + by_iteration.svg() + "</div><div>" +
                by_time.svg() + "</div></div>\n";
    }
  }

  // Of the best energy: what counts as optimal, and the range of plots.
  static constexpr double GOOD = 1e-3;
  static constexpr double BOTTOM = 1e-8;
  static constexpr double TOP = 1e6;

  const Table& m_results;
  const Table& m_reference;
  std::string m_published;
  std::vector<std::string> m_meshes, m_methods, m_sets;
  std::map<std::string, std::map<std::string, std::size_t>> m_rows; // by mesh and method
  std::map<std::string, std::map<std::string, std::vector<Point>>> m_traces;
  std::string m_html;
};

inline bool write_html_report(const std::string& path, const Table& results, const Table& traces, const Table& reference,
                              const std::string& published)
{
  std::ofstream file(path);
  file << Html_report(results, traces, reference, published).html();
  return bool(file);
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_QUALITY_HTML_REPORT_H
