// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Iterations per second of the splitting scheme in an interactive session: a square in the plane with four handles, and the map
// of a bumpy surface into the plane with four pins, of 1000, 5000 and 20000 vertices. One handle makes 50 small moves on a half
// circle, and each move has a few iterations, as between two pictures on the screen. Writes CSV; the first move, in which the
// pattern of the matrix is analysed, has a column of its own.
//
// usage: splitting_iterations [ITERATIONS]        (per move, 10)

#include "../support/Table.h"
#include "../support/generated_shapes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_map_traits.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;

namespace {

constexpr double PI = 3.14159265358979323846;

// Lifts the rest shape to a surface with four hills; the shape in the plane stays as a map of it.
void lift(Planar_shape& shape)
{
  FFM::Simplicial_domain<2>& domain = shape.domain;
  const auto place = [&shape](std::int32_t v) {
    const double x = shape.x(0, v), y = shape.x(1, v);
    return Eigen::Vector3d(x, y, 0.15 * std::sin(2 * PI * x) * std::sin(2 * PI * y));
  };
  double area = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const auto& t = domain.elements[e];
    const Eigen::Vector3d a = place(t[1]) - place(t[0]), b = place(t[2]) - place(t[0]);
    const double length = a.norm(), height = a.cross(b).norm() / length;
    Eigen::Matrix2d edges;
    edges << length, a.dot(b) / length, 0, height;
    domain.rest_inverses[e] = edges.inverse();
    domain.measures[e] = 0.5 * length * height;
    area += domain.measures[e];
  }
  for(double& measure : domain.measures)
    measure /= area;
  for(auto& inverse : domain.rest_inverses)
    inverse *= std::sqrt(area);
  shape.x /= std::sqrt(area);
  domain.scale *= std::sqrt(area);
}

} // namespace

int main(int argc, char** argv)
{
  const int iterations = argc > 1 ? std::atoi(argv[1]) : 10;
  if(iterations < 1) {
    std::cerr << "usage: splitting_iterations [ITERATIONS]\n";
    return EXIT_FAILURE;
  }
  std::cout << "# " << machine() << "\n# symmetric gradient energy, " << iterations << " iterations per move\n"
            << "shape,vertices,triangles,moves,iterations,iterations_per_second,iteration_median_ms,iteration_worst_ms,factorizations,"
               "first_move_ms,energy,flips,failed_moves\n";
  int failures = 0;
  for(const bool is_surface : {false, true})
    for(const int cells : {31, 70, 141}) {
      Planar_shape shape = make_rectangle(cells, cells, 0.2);
      if(is_surface)
        lift(shape);
      const FFM::Positions<2> rest = shape.domain.scale * shape.x;
      const auto vertex = [cells](double u, double v) {
        return static_cast<std::int32_t>(std::lround(v * cells) * (cells + 1) + std::lround(u * cells));
      };
      const std::vector<std::int32_t> handles = {vertex(0.1, 0.1), vertex(0.9, 0.1), vertex(0.1, 0.9), vertex(0.8, 0.8)};
      FFM::Splitting_map_traits<> traits;
      traits.splitting.max_iterations = iterations;
      FFM::Deformation<2, FFM::Splitting_map_traits<>> deformation(shape.domain, rest, handles, traits);

      FFM::Positions<2> targets(2, 4);
      for(int i = 0; i < 4; ++i)
        targets.col(i) = rest.col(handles[i]);
      const Eigen::Vector2d home = targets.col(3);
      const int moves = 50;
      double first_move = 0, seconds = 0;
      int total = 0, factorizations = 0, failed = 0;
      std::vector<double> milliseconds; // per iteration
      FFM::Summary summary;
      for(int i = 0; i <= moves; ++i) {
        const double angle = PI * i / moves, radius = 0.15 * cells;
        targets.col(3) = home + radius * Eigen::Vector2d(std::cos(angle) - 1, std::sin(angle));
        const auto begin = std::chrono::steady_clock::now();
        summary = deformation.move(targets);
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        failed += summary.is_valid() ? 0 : 1;
        if(i == 0) {
          first_move = 1e3 * elapsed;
          continue;
        }
        seconds += elapsed;
        total += summary.iterations;
        factorizations += summary.factorizations;
        if(summary.iterations > 0)
          milliseconds.push_back(1e3 * elapsed / summary.iterations);
      }
      failures += failed;
      std::cout << (is_surface ? "surface" : "planar") << ',' << rest.cols() << ',' << shape.domain.number_of_elements() << ',' << moves
                << ',' << total << ',' << format(total / seconds) << ',' << format(quantile(milliseconds, 0.5)) << ','
                << format(quantile(milliseconds, 1)) << ',' << factorizations << ',' << format(first_move) << ','
                << format(summary.energy, 8) << ',' << summary.flips << ',' << failed << std::endl;
    }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
