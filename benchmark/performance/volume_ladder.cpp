// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A bar of tetrahedra, refined again and again, is twisted by its ends: seconds by phase and memory as the mesh grows, as CSV.
//
// usage: volume_ladder [TETRAHEDRA...]     (about so many, ascending; 40000 320000 by default)
//   FFM_MEMORY_BUDGET   GiB for the factor; by default half of the memory

#include "../support/machine.h"

#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

namespace {

struct Bar
{
  std::vector<Point_3> points;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::pair<std::size_t, Point_3>> handles; // both ends, one turned by a right angle
};

// Cubes along a bar of length 5 and width 1, each of them six tetrahedra around a diagonal.
Bar make_bar(int width)
{
  Bar bar;
  const int length = 5 * width;
  const auto number = [width](int i, int j, int k) { return (i * (width + 1) + j) * (width + 1) + k; };
  for(int i = 0; i <= length; ++i)
    for(int j = 0; j <= width; ++j)
      for(int k = 0; k <= width; ++k) {
        const double x = 1. * i / width, y = 1. * j / width - 0.5, z = 1. * k / width - 0.5;
        if(i == 0)
          bar.handles.emplace_back(bar.points.size(), Point_3(x, y, z));
        else if(i == length)
          bar.handles.emplace_back(bar.points.size(), Point_3(x, -z, y));
        bar.points.emplace_back(x, y, z);
      }
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < width; ++j)
      for(int k = 0; k < width; ++k)
        for(int o = 0; o < 6; ++o) {
          std::array<int, 3> corner{i, j, k};
          std::array<int, 4> t{number(i, j, k), 0, 0, 0};
          for(int step = 0; step < 3; ++step) {
            ++corner[orders[o][step]];
            t[step + 1] = number(corner[0], corner[1], corner[2]);
          }
          if(o >= 3)
            std::swap(t[2], t[3]);
          bar.tetrahedra.push_back(t);
        }
  return bar;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<double> sizes;
  for(int i = 1; i < argc; ++i)
    sizes.push_back(std::atof(argv[i]));
  if(sizes.empty())
    sizes = {40000, 320000};
  const char* budget = std::getenv("FFM_MEMORY_BUDGET");
  std::cout
    << "# " << benchmark_support::machine() << '\n'
    << "tetrahedra,vertices,status,energy,min_singular_value,flips,iterations,factorizations,inner_iterations,linear_solver,ordering,"
       "factor_entries,load_s,assemble_s,analyze_s,factorize_s,solve_s,line_search_s,certify_s,total_s,cpu_s,peak_mb\n";
  bool all_valid = true;
  for(double size : sizes) {
    const Bar bar = make_bar((std::max)(2, static_cast<int>(std::lround(std::cbrt(size / 30)))));
    FFM::Tetrahedral_domain domain;
    std::string message;
    double load_seconds = 0;
    {
      const FFM::internal::Phase_timer timer(load_seconds);
      if(domain.load(bar.points, bar.tetrahedra, message) != FFM::Status::success) {
        std::cerr << message << '\n';
        return EXIT_FAILURE;
      }
    }
    FFM::Flip_free_map_traits<> traits;
    traits.options.relative_energy_tolerance = 1e-6;
    if(budget != nullptr)
      traits.options.memory_budget = std::atof(budget) * 1024 * 1024 * 1024;
    std::vector<Point_3> result(bar.points.size());
    const FFM::Summary s = FFM::deform_volume(domain, bar.handles, CGAL::make_property_map(result), traits);
    std::cout << s.elements << ',' << s.vertices << ',' << FFM::status_name(s.status) << ',' << s.energy << ',' << s.min_singular_value
              << ',' << s.flips << ',' << s.iterations << ',' << s.factorizations << ',' << s.inner_iterations << ',' << s.linear_solver
              << ',' << s.ordering << ',' << s.factor_entries << ',' << load_seconds << ',' << s.seconds.assemble << ','
              << s.seconds.analyze << ',' << s.seconds.factorize << ',' << s.seconds.solve << ',' << s.seconds.line_search << ','
              << s.seconds.certify << ',' << s.seconds.total << ',' << s.cpu_seconds << ',' << s.peak_memory_mb << std::endl;
    all_valid = all_valid && s.is_valid();
  }
  return all_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}
