// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Mesh morphing: a box around a block, as meshed for a flow, whose block is turned. The surface of the box stays, that of the block
// turns, and the vertices between them follow so that every tetrahedron keeps a positive volume.
//
// usage: morph_mesh [DEGREES]

#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/morph_volume.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

namespace {

typedef std::array<double, 3> Point;

// Cubes of six tetrahedra each, without those of the block in the middle.
void make_box(std::vector<Point>& points, std::vector<std::array<int, 4>>& tetrahedra)
{
  const int n = 6;
  const auto number = [=](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for(int k = 0; k <= n; ++k)
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i)
        points.push_back({i - 0.5 * n, j - 0.5 * n, k - 0.5 * n});
  const auto is_middle = [](int i) { return i == 2 || i == 3; };
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  for(int k = 0; k < n; ++k)
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i)
        for(int o = 0; o < 6 && !(is_middle(i) && is_middle(j) && is_middle(k)); ++o) {
          int at[3] = {i, j, k};
          std::array<int, 4> tetrahedron = {number(i, j, k), 0, 0, 0};
          for(int s = 0; s < 3; ++s) {
            ++at[orders[o][s]];
            tetrahedron[s + 1] = number(at[0], at[1], at[2]);
          }
          if(o >= 3)
            std::swap(tetrahedron[2], tetrahedron[3]);
          tetrahedra.push_back(tetrahedron);
        }
}

} // namespace

int main(int argc, char** argv)
{
  const double angle = (argc > 1 ? std::atof(argv[1]) : 30) * 3.14159265358979323846 / 180;
  std::vector<Point> points;
  std::vector<std::array<int, 4>> tetrahedra;
  make_box(points, tetrahedra);

  //! [morph]
  FFM::Tetrahedral_domain volume;
  std::string message;
  if(volume.load(points, tetrahedra, message) != FFM::Status::success) {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }
  // The places of the vertices on the boundary: the box stays, the block turns.
  std::vector<std::pair<std::size_t, Point>> places;
  for(std::size_t v : volume.vertices()) {
    const Point& p = points[v];
    const double distance = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    if(distance == 3)
      places.emplace_back(v, p);
    else if(distance == 1)
      places.emplace_back(v, Point{std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]});
  }
  std::vector<Point> morphed = points;
  const FFM::Morph_summary summary = FFM::morph_volume(volume, places, morphed.data());
  //! [morph]
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
