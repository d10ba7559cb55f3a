// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_MESHES_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_MESHES_H

// Disks of several kinds for a comparison without any file.

#include "../../examples/bumpy_surface.h"

#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

// A strip that is rolled up to a spiral: developable, and its rulings are edges, so the mesh has an isometric map, whose energy
// is 1.
template <typename Mesh>
void make_roll(Mesh& mesh, int cells)
{
  using Point = typename Mesh::Point;
  CGAL::make_grid(
    8 * cells, cells, mesh,
    [cells](double i, double j) {
      const double angle = 3 * i / cells + 1.5;
      return Point(angle * std::cos(angle), angle * std::sin(angle), 4 * j / cells);
    },
    true);
}

// A surface of revolution between its pole and a circle around its axis. `radius` and `height` are functions of the arc from 0 to
// 1, and `radius` vanishes at 0.
template <typename Mesh, typename Radius, typename Height>
void make_revolution(Mesh& mesh, int around, int along, Radius&& radius, Height&& height)
{
  using Point = typename Mesh::Point;
  const double pi = 3.14159265358979323846;
  std::vector<typename Mesh::Vertex_index> vertices;
  const auto pole = mesh.add_vertex(Point(0, 0, height(0.)));
  for(int j = 1; j <= along; ++j)
    for(int i = 0; i < around; ++i) {
      const double angle = 2 * pi * (i + 0.5 * j) / around, t = static_cast<double>(j) / along;
      vertices.push_back(mesh.add_vertex(Point(radius(t) * std::cos(angle), radius(t) * std::sin(angle), height(t))));
    }
  for(int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    mesh.add_face(pole, vertices[i], vertices[next]);
    for(int j = 1; j < along; ++j) {
      const auto a = vertices[(j - 1) * around + i], b = vertices[(j - 1) * around + next];
      const auto c = vertices[j * around + i], d = vertices[j * around + next];
      mesh.add_face(a, c, b);
      mesh.add_face(b, c, d);
    }
  }
}

// A sphere with a small hole: the disk that is hardest to flatten for its size.
template <typename Mesh>
void make_ball(Mesh& mesh, int around)
{
  const double last = 2.9;
  make_revolution(
    mesh, around, around / 2, [=](double t) { return std::sin(last * t); }, [=](double t) { return std::cos(last * t); });
}

// A tube six times as long as wide with a round end: a Tutte embedding shrinks its end beyond recognition.
template <typename Mesh>
void make_tube(Mesh& mesh, int around)
{
  const double pi = 3.14159265358979323846, cap = pi / 2, length = cap + 12;
  make_revolution(
    mesh, around, static_cast<int>(around * length / (2 * pi)), [=](double t) { return length * t < cap ? std::sin(length * t) : 1.; },
    [=](double t) { return length * t < cap ? std::cos(length * t) : cap - length * t; });
}

// About so many triangles of one surface, a square sheet with hills and dents that flattens with energy 1.05 or so, however many
// they are. Vertices are scattered, and each cell of four is cut along its shorter diagonal,
// so that the connectivity is irregular.
template <typename Mesh>
void make_bumpy_sheet(Mesh& mesh, double faces)
{
  using Point = typename Mesh::Point;
  constexpr double PI = 3.14159265358979323846;
  const int cells = (std::max)(2, static_cast<int>(std::lround(std::sqrt(faces / 2))));
  const std::size_t n = cells;
  mesh.reserve((n + 1) * (n + 1), 3 * n * n + 2 * n, 2 * n * n);
  std::mt19937_64 generator(1);
  const auto random = [&] { return 0.25 * (static_cast<double>(generator() >> 11) / 4503599627370496. - 1); };
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i) {
      const double dx = random(), dy = random();
      const double x = (i + (i > 0 && i < cells ? dx : 0)) / cells, y = (j + (j > 0 && j < cells ? dy : 0)) / cells;
      const double z = 0.23 * std::sin(3 * PI * x) * std::sin(2 * PI * y + 1) + 0.055 * std::sin(7 * PI * x + 2 * y) * std::cos(5 * PI * y);
      mesh.add_vertex(Point(x, y, z));
    }
  const auto at = [cells](int i, int j) { return typename Mesh::Vertex_index(static_cast<typename Mesh::size_type>(j) * (cells + 1) + i); };
  for(int j = 0; j < cells; ++j)
    for(int i = 0; i < cells; ++i) {
      const auto a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if((mesh.point(a) - mesh.point(c)).squared_length() < (mesh.point(b) - mesh.point(d)).squared_length()) {
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      } else {
        mesh.add_face(a, b, d);
        mesh.add_face(b, c, d);
      }
    }
}

// Names and makers of the meshes that programs run on when they are given none.
template <typename Mesh>
std::vector<std::pair<std::string, std::function<void(Mesh&)>>> generated_meshes()
{
  return {{"generated_bumpy_5k", [](Mesh& mesh) { make_bumpy_surface(mesh, 50); }},
          {"generated_bumpy_20k", [](Mesh& mesh) { make_bumpy_surface(mesh, 100); }},
          {"generated_roll_6k", [](Mesh& mesh) { make_roll(mesh, 20); }},
          {"generated_ball_5k", [](Mesh& mesh) { make_ball(mesh, 72); }},
          {"generated_tube_4k", [](Mesh& mesh) { make_tube(mesh, 32); }}};
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_MESHES_H
