// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_GENERATED_DOMAINS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_GENERATED_DOMAINS_H

// Shapes that tests make themselves, turned into domains without any mesh class, and random numbers that are the same on
// every machine.

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

constexpr double pi = 3.14159265358979323846;

// Uniform numbers. The distributions of the standard library differ between implementations, the generator does not.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_generator(seed) {}

  double operator()(double low, double high) { return low + (high - low) * (static_cast<double>(m_generator() >> 11) / 9007199254740992.); }

  template <int D>
  Eigen::Matrix<double, D, D> matrix(double low = -1, double high = 1)
  {
    Eigen::Matrix<double, D, D> result;
    for(int i = 0; i < D; ++i)
      for(int j = 0; j < D; ++j)
        result(i, j) = (*this)(low, high);
    return result;
  }

  template <int D>
  Eigen::Matrix<double, D, D> rotation();

  Eigen::VectorXd vector(Eigen::Index size, double low = -1, double high = 1);

private:
  std::mt19937_64 m_generator;
};

struct Surface
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

struct Volume
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::int32_t, 4>> tetrahedra;
};

// (columns + 1) x (rows + 1) vertices at shape(u, v), u and v from 0 to 1, two triangles per cell. With alternating diagonals
// every corner of the patch belongs to two triangles or to one (a flap), depending on the numbers.
template <typename Shape>
Surface grid(int columns, int rows, Shape&& shape, bool alternate = false)
{
  Surface surface;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i)
      surface.points.push_back(shape(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const std::int32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 2, d = a + columns + 1;
      if(alternate && (i + j) % 2 != 0) {
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({b, c, d});
      } else {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
      }
    }
  return surface;
}

// A sheet with hills, which no map flattens without distortion.
Surface bumpy_patch(int columns, int rows, double height = 0.25);

// Three developable shapes. Their rulings are edges, so the triangulated surfaces are developable as well.
Surface cylinder_patch(int columns, int rows);

Surface cone_patch(int columns, int rows);

Surface bent_sheet(int columns, int rows);

// A tube of `rings` rings of unit edges, open at one end and closed by a fan at the other: a disk.
Surface closed_tube(int around, int rings);

// A bar of cubes, each cut into six tetrahedra around its diagonal; vertices go through `shape`.
template <typename Shape>
Volume bar(int nx, int ny, int nz, Shape&& shape)
{
  Volume volume;
  for(int k = 0; k <= nz; ++k)
    for(int j = 0; j <= ny; ++j)
      for(int i = 0; i <= nx; ++i)
        volume.points.push_back(shape(Eigen::Vector3d(i, j, k)));
  const auto index = [=](int i, int j, int k) { return static_cast<std::int32_t>((k * (ny + 1) + j) * (nx + 1) + i); };
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for(int k = 0; k < nz; ++k)
    for(int j = 0; j < ny; ++j)
      for(int i = 0; i < nx; ++i)
        for(int o = 0; o < 6; ++o) {
          int p[3] = {i, j, k};
          std::array<std::int32_t, 4> tetrahedron;
          tetrahedron[0] = index(p[0], p[1], p[2]);
          for(int step = 0; step < 3; ++step) {
            ++p[orders[o][step]];
            tetrahedron[step + 1] = index(p[0], p[1], p[2]);
          }
          if(o >= 3)
            std::swap(tetrahedron[1], tetrahedron[2]);
          volume.tetrahedra.push_back(tetrahedron);
        }
  return volume;
}

template <int D, typename Elements>
FFM::Simplicial_domain<D> scaled_domain(std::int32_t number_of_vertices, const Elements& elements,
                                        const std::vector<Eigen::Matrix<double, D, D>>& rest_edges)
{
  FFM::Simplicial_domain<D> domain;
  domain.number_of_vertices = number_of_vertices;
  domain.elements.assign(elements.begin(), elements.end());
  double total = 0;
  for(const auto& edges : rest_edges) {
    domain.measures.push_back(edges.determinant() / (D == 2 ? 2 : 6));
    total += domain.measures.back();
  }
  domain.scale = std::pow(total, 1. / D);
  for(std::size_t e = 0; e < rest_edges.size(); ++e) {
    domain.measures[e] /= total;
    domain.rest_inverses.push_back(domain.scale * rest_edges[e].inverse());
  }
  return domain;
}

FFM::Simplicial_domain<2> make_domain(const Surface& surface);

FFM::Simplicial_domain<3> make_domain(const Volume& volume);

// The points of a shape in the unit of length of its domain, first D coordinates.
template <int D, typename Shape>
FFM::Positions<D> positions_of(const Shape& shape, double scale)
{
  FFM::Positions<D> x(D, shape.points.size());
  for(std::size_t v = 0; v < shape.points.size(); ++v)
    x.col(v) = shape.points[v].template head<D>() / scale;
  return x;
}

// Small domains with a flip-free, distorted image each, for tests that need one in the plane and one in space.
template <int D>
struct Distorted_example;

template <>
struct Distorted_example<2>
{
  explicit Distorted_example(int columns = 4, int rows = 3);

  FFM::Simplicial_domain<2> domain;
  FFM::Positions<2> x;
};

template <>
struct Distorted_example<3>
{
  explicit Distorted_example(int nx = 2, int ny = 1, int nz = 1);

  FFM::Simplicial_domain<3> domain;
  FFM::Positions<3> x;
};

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_GENERATED_DOMAINS_H
