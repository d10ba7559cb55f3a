// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_SHAPES_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_SHAPES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/LU>

#include <cmath>
#include <cstdint>
#include <random>

namespace benchmark_support {

namespace FFM = CGAL::Flip_free_maps;

// A planar shape at rest and its vertices' positions, in the domain's units.
struct Planar_shape
{
  FFM::Simplicial_domain<2> domain;
  FFM::Positions<2> x;
};

// A rectangle of columns x rows cells of height 1 and a given width, centered at the origin and cut alternately. Inner vertices
// are moved by up to `disorder` cells, below 1/4, so that no two triangles are alike. Its number of triangles is 2 columns rows.
inline Planar_shape make_rectangle(int columns, int rows, double disorder = 0, double width = 1)
{
  Planar_shape shape;
  FFM::Simplicial_domain<2>& domain = shape.domain;
  domain.number_of_vertices = (columns + 1) * (rows + 1);
  domain.scale = std::sqrt(width * columns * rows);
  shape.x.resize(2, domain.number_of_vertices);
  std::mt19937_64 generator(1);
  const auto random = [&] { return disorder * (static_cast<double>(generator() >> 11) / 4503599627370496. - 1); };
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i) {
      const bool is_inside = i > 0 && i < columns && j > 0 && j < rows;
      const double dx = is_inside ? random() : 0, dy = is_inside ? random() : 0;
      shape.x.col(j * (columns + 1) + i) << width * (i - 0.5 * columns + dx), j - 0.5 * rows + dy;
    }
  shape.x /= domain.scale;
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const std::int32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 2, d = a + columns + 1;
      if((i + j) % 2 != 0) {
        domain.elements.push_back({{a, b, d}});
        domain.elements.push_back({{b, c, d}});
      } else {
        domain.elements.push_back({{a, b, c}});
        domain.elements.push_back({{a, c, d}});
      }
    }
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Matrix2d edges = domain.image_edges(e, shape.x);
    domain.measures.push_back(0.5 * edges.determinant());
    domain.rest_inverses.push_back(edges.inverse());
  }
  return shape;
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_GENERATED_SHAPES_H
