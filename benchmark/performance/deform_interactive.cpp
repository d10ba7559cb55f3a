// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A planar shape follows the mouse: a square of about 5000 vertices with four handles, one of which makes 50 small moves on a
// half circle. Writes milliseconds per iteration and per move as CSV. The first move, in which the pattern of the matrix is
// analysed, is a row of its own.
//
// usage: deform_interactive [CELLS]        (of the square in each direction, 70)

#include "../support/Table.h"
#include "../support/generated_shapes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;

int main(int argc, char** argv)
{
  const int cells = argc > 1 ? std::atoi(argv[1]) : 70;
  if(cells < 4) {
    std::cerr << "usage: deform_interactive [CELLS]\n";
    return EXIT_FAILURE;
  }
  const Planar_shape square = make_rectangle(cells, cells, 0.2);
  const FFM::Positions<2> rest = square.domain.scale * square.x;
  const auto vertex = [cells](double u, double v) {
    return static_cast<std::int32_t>(std::lround(v * cells) * (cells + 1) + std::lround(u * cells));
  };
  const std::vector<std::int32_t> handles = {vertex(0.1, 0.1), vertex(0.9, 0.1), vertex(0.1, 0.9), vertex(0.8, 0.8)};

  std::cout << "# " << machine() << "\n# " << rest.cols()
            << " vertices; a move ends when the relative decrease of the energy is below 1e-4\n"
            << "method,moves,iterations,factorizations,iteration_median_ms,iteration_worst_ms,move_median_ms,move_worst_ms,first_move_ms,"
               "worst_move_has_iterations,energy,min_singular_value,flips,failed_moves\n";
  int failures = 0;
  for(const char* method : {"default", "projected-newton", "akvf"}) {
    FFM::Any_map_traits traits;
    traits.use_method(method);
    traits.options.characteristic_gradient_tolerance = 0;
    traits.options.relative_energy_tolerance = 1e-4;
    // From one report to the next; the time before the first report of a move belongs to the first iteration.
    std::vector<double> iterations, moves;
    auto last = std::chrono::steady_clock::now();
    const auto lap = [&last] {
      const auto now = std::chrono::steady_clock::now();
      const double milliseconds = 1e3 * std::chrono::duration<double>(now - last).count();
      last = now;
      return milliseconds;
    };
    double carried = 0, first_move = 0;
    int last_iteration = 0;
    traits.options.observer = [&](const FFM::Iteration_report& report) {
      carried += lap();
      if(report.iteration > last_iteration) {
        iterations.push_back(carried);
        carried = 0;
      }
      last_iteration = report.iteration;
      return true;
    };
    FFM::Deformation<2, FFM::Any_map_traits> deformation(square.domain, rest, handles, traits);

    FFM::Positions<2> targets(2, 4);
    for(int i = 0; i < 4; ++i)
      targets.col(i) = rest.col(handles[i]);
    const Eigen::Vector2d home = targets.col(3);
    FFM::Summary summary;
    int total_iterations = 0, factorizations = 0, failed = 0, worst_iterations = 0;
    const int number_of_moves = 50;
    for(int i = 1; i <= number_of_moves; ++i) {
      const double angle = 3.14159265358979323846 * i / number_of_moves, radius = 0.15 * cells;
      targets.col(3) = home + radius * Eigen::Vector2d(std::cos(angle) - 1, std::sin(angle));
      if(i == 2)
        iterations.clear();
      last_iteration = 0;
      carried = 0;
      lap();
      const auto begin = last;
      summary = deformation.move(targets);
      const double milliseconds = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if(i == 1) {
        first_move = milliseconds;
      } else {
        if(milliseconds > quantile(moves, 1) || moves.empty())
          worst_iterations = summary.iterations;
        moves.push_back(milliseconds);
        total_iterations += summary.iterations;
        factorizations += summary.factorizations;
      }
      failed += summary.is_valid() ? 0 : 1;
    }
    failures += failed;
    std::cout << method << ',' << moves.size() << ',' << total_iterations << ',' << factorizations << ','
              << format(quantile(iterations, 0.5)) << ',' << format(quantile(iterations, 1)) << ',' << format(quantile(moves, 0.5)) << ','
              << format(quantile(moves, 1)) << ',' << format(first_move) << ',' << worst_iterations << ',' << format(summary.energy, 8)
              << ',' << format(summary.min_singular_value) << ',' << summary.flips << ',' << failed << std::endl;
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
