// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Two experiments of Shtengel et al. 2017, section 5.2, on a bar of 10 x 1:
//
// - released: a bent bar returns to its rest shape under the symmetric ARAP energy (their Fig. 1). It is bent along an arc, or by
//   turning its ends;
// - stretched: Neo-Hookean rubber, mu / kappa = 0.002, both ends held at places further apart (their Fig. 4). The start stretches
//   the bar evenly, or only its last third.
//
// usage: bar_experiments [ROWS [SECONDS [WIDTH]]]
//
// ROWS: rows of cells in the bar (20), SECONDS: limit of each run (60), WIDTH: of a cell over its height (1).
//
// Iterations are counted until E - E* <= t (E_0 - E*) for several t, with E_0 the energy of the start and E* the energy at the
// end of a converged run, 0 for the released bar; a run that did not converge is measured by the least energy of the others. The
// paper searches steps by Armijo's rule from the full step ("armijo"); the package begins with the longest step without flips
// ("longest"). `vertex-space-newton` is the paper's projected Newton, which clamps 6 x 6 matrices; `projected-newton` clamps
// analytically. Writes CSV, and the paper's statements beside the same figures of these runs as comments.

#include "../support/Table.h"
#include "../support/generated_shapes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_arap.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;
using Minimizer = FFM::Map_minimizer<2, FFM::Any_map_traits>;

namespace {

struct Experiment
{
  std::string name;
  FFM::Any_energy energy;
  FFM::Position_constraints<2> constraints;
  FFM::Positions<2> start;
  bool ends_at_zero;
};

struct Outcome
{
  std::string method;
  FFM::Summary summary;
  std::vector<std::pair<double, double>> trace; // seconds and energy after each iteration

  // The first iteration at which the energy is at most `energy`; -1 if there is none.
  int iterations_to(double energy) const
  {
    for(std::size_t i = 0; i < trace.size(); ++i)
      if(trace[i].second <= energy)
        return static_cast<int>(i);
    return -1;
  }
};

// `search`: "" for the line search of the papers, "+" for the package's own.
bool choose_method(const std::string& method, const std::string& search, FFM::Any_map_traits& traits)
{
  if(traits.use_method(method + search))
    return true;
  if(method == "vertex-space-newton" && traits.use_method("projected-newton" + search))
    traits.preconditioner = FFM::Any_preconditioner(FFM::Vertex_space_newton());
  else if(method == "cm-ungathered" && traits.use_method("cm" + search))
    traits.preconditioner = FFM::Any_preconditioner(FFM::Composite_majorization<false>());
  else
    return false;
  return true;
}

Outcome run(const Planar_shape& bar, const Experiment& experiment, const std::string& method, bool begins_with_longest_step, double seconds)
{
  Outcome outcome;
  outcome.method = method;
  FFM::Any_map_traits traits;
  choose_method(method, begins_with_longest_step ? "+" : "", traits);
  traits.energy = experiment.energy;
  FFM::Map_options& options = traits.options;
  options.characteristic_gradient_tolerance = 1e-13;
  options.max_seconds = seconds;
  options.max_iterations = 20000;
  options.observer = [&](const FFM::Iteration_report& report) {
    outcome.trace.push_back({report.seconds, report.energy});
    return !experiment.ends_at_zero || report.energy > 0.99e-9 * outcome.trace.front().second;
  };
  Minimizer minimizer(bar.domain, traits, experiment.constraints);
  FFM::Positions<2> x = experiment.start;
  minimizer.minimize(x, outcome.summary);
  return outcome;
}

// The bar's ends, turned against each other by handles until the bar is a half circle.
FFM::Positions<2> bend_by_handles(const Planar_shape& bar, const std::vector<std::int32_t>& ends, double length)
{
  FFM::Any_map_traits traits;
  traits.options.relative_energy_tolerance = 1e-6;
  Minimizer minimizer(bar.domain, traits, FFM::Position_constraints<2>{ends, {}});
  FFM::Positions<2> x = bar.x;
  const int moves = 8;
  for(int i = 1; i <= moves; ++i) {
    const double angle = 0.5 * 3.14159265358979323846 * i / moves, radius = 0.5 * length / angle;
    FFM::Positions<2> targets = bar.x;
    for(std::int32_t v : ends) {
      const double side = bar.x(0, v) > 0 ? 1 : -1, t = angle * side;
      const double along = bar.x(0, v) - side * 0.5 * length, across = bar.x(1, v);
      targets.col(v) << (radius - across) * std::sin(t) + along * std::cos(t),
        radius - (radius - across) * std::cos(t) + along * std::sin(t);
    }
    minimizer.move_fixed_vertices(x, targets);
  }
  return x;
}

} // namespace

int main(int argc, char** argv)
{
  const int rows = argc > 1 ? std::atoi(argv[1]) : 20;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 60;
  const double width = argc > 3 ? std::atof(argv[3]) : 1;
  if(rows < 2 || !(seconds > 0) || !(width > 0 && width < rows)) {
    std::cerr << "usage: bar_experiments [ROWS [SECONDS [WIDTH]]]\n";
    return EXIT_FAILURE;
  }
  const Planar_shape bar = make_rectangle(static_cast<int>(std::lround(10 * rows / width)), rows, 0.2, width);
  const double length = bar.x.row(0).maxCoeff() - bar.x.row(0).minCoeff();
  std::vector<std::int32_t> ends;
  for(std::int32_t v = 0; v < bar.domain.number_of_vertices; ++v)
    if(std::abs(bar.x(0, v)) > 0.499 * length)
      ends.push_back(v);

  std::vector<Experiment> experiments;
  const FFM::Any_energy arap{FFM::Symmetric_arap()};
  FFM::Neo_hookean rubber;
  rubber.mu = 2e-3;
  rubber.kappa = 1;
  const auto deformed = [&](auto&& map) {
    FFM::Positions<2> x = bar.x;
    for(Eigen::Index v = 0; v < x.cols(); ++v)
      x.col(v) = map(bar.x(0, v), bar.x(1, v));
    return x;
  };
  for(double turns : {0.5, 0.9}) {
    const double radius = length / (2 * 3.14159265358979323846 * turns);
    experiments.push_back({"released from an arc of " + format(360 * turns) + " degrees",
                           arap,
                           {},
                           deformed([radius](double x, double y) {
                             return Eigen::Vector2d((radius - y) * std::sin(x / radius), radius - (radius - y) * std::cos(x / radius));
                           }),
                           true});
  }
  experiments.push_back({"released after bending by handles", arap, {}, bend_by_handles(bar, ends, length), true});
  for(double factor : {1.5, 3.})
    experiments.push_back({"stretched " + format(factor) + " times from an even start",
                           FFM::Any_energy(rubber),
                           {ends, {}},
                           deformed([factor](double x, double y) { return Eigen::Vector2d(factor * x, y); }),
                           false});
  experiments.push_back({"stretched 2 times from an uneven start",
                         FFM::Any_energy(rubber),
                         {ends, {}},
                         deformed([length](double x, double y) {
                           const double bound = length / 6;
                           return Eigen::Vector2d(x > bound ? x + 3 * (x - bound) : x, y);
                         }),
                         false});

  std::cout
    << "# " << machine() << "\n# bar of " << bar.domain.number_of_elements() << " triangles\n"
    << "experiment,steps,method,status,iterations_to_1e-9,seconds_to_1e-9,iterations_to_1e-6,iterations_to_1e-3,gap_after_1_iteration,"
       "final_energy\n";
  const std::vector<std::string> methods = {"cm", "cm-ungathered", "projected-newton", "vertex-space-newton", "slim", "aqp"};
  std::string statements;
  for(const Experiment& experiment : experiments)
    for(bool longest : {false, true}) {
      std::vector<Outcome> outcomes;
      double best = std::numeric_limits<double>::infinity();
      for(const std::string& method : methods) {
        outcomes.push_back(run(bar, experiment, method, longest, seconds));
        const FFM::Summary& summary = outcomes.back().summary;
        if(summary.converged() && summary.energy < best)
          best = summary.energy;
      }
      std::map<std::string, std::vector<double>> figures;
      for(const Outcome& outcome : outcomes) {
        if(outcome.trace.empty()) {
          std::cerr << experiment.name << ", " << outcome.method << ": " << outcome.summary.message << '\n';
          return EXIT_FAILURE;
        }
        const double end = experiment.ends_at_zero ? 0 : outcome.summary.converged() ? outcome.summary.energy : best;
        const double first = outcome.trace.front().second - end;
        const int to_9 = outcome.iterations_to(end + 1e-9 * first), to_6 = outcome.iterations_to(end + 1e-6 * first);
        const int to_3 = outcome.iterations_to(end + 1e-3 * first);
        const double time = to_9 >= 0 ? outcome.trace[to_9].first : -1;
        std::cout << experiment.name << ',' << (longest ? "longest" : "armijo") << ',' << outcome.method << ','
                  << FFM::status_name(outcome.summary.status) << ',' << to_9 << ',' << format(time) << ',' << to_6 << ',' << to_3 << ','
                  << format((outcome.trace[outcome.trace.size() > 1 ? 1 : 0].second - end) / first) << ','
                  << format(outcome.summary.energy, 10) << std::endl;
        figures[outcome.method] = {double(to_9), double(to_6), double(to_3), time};
      }
      const std::vector<double>&cm = figures["cm"], &newton = figures["vertex-space-newton"];
      const auto ratio = [&](int i) { return cm[i] > 0 && newton[i] > 0 ? format(newton[i] / cm[i], 3) : std::string("-"); };
      statements += "# " + experiment.name + ", " + (longest ? "longest" : "armijo") +
                    ": projected Newton (6 x 6) over cm: iterations to 1e-3 " + ratio(2) + ", to 1e-6 " + ratio(1) + ", to 1e-9 " +
                    ratio(0) + "; time to 1e-9 " + ratio(3) +
                    (experiment.ends_at_zero ? " (paper: time more than 4)\n" : " (paper: iterations more than 2)\n");
    }
  std::cout << statements;
  return EXIT_SUCCESS;
}
