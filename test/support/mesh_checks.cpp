// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/mesh_checks.h"

#include <cmath>

namespace test_support {

Soup bumpy_soup(int columns, int rows)
{
  Soup soup;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i) {
      const double x = double(i) / columns, y = double(j) / columns;
      const double z = 0.45 * std::exp(-30 * ((x - 0.35) * (x - 0.35) + (y - 0.4) * (y - 0.4))) -
                       0.3 * std::exp(-40 * ((x - 0.75) * (x - 0.75) + (y - 0.5) * (y - 0.5))) + 0.03 * std::sin(9 * x + 7 * y);
      soup.points.push_back({double(float(x)), double(float(y)), double(float(z))});
    }
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      if((i + 2 * j) % 3 == 0) {
        soup.triangles.push_back({a, b, d});
        soup.triangles.push_back({b, c, d});
      } else {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
    }
  return soup;
}

Soup sphere_soup(int around, int rings)
{
  Soup soup;
  for(int j = 1; j <= rings; ++j)
    for(int i = 0; i < around; ++i) {
      const double latitude = CGAL_PI * j / (rings + 1), longitude = 2 * CGAL_PI * (i + 0.5 * (j % 2)) / around;
      soup.points.push_back({std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude)});
    }
  const int north = around * rings, south = north + 1;
  soup.points.push_back({0, 0, 1});
  soup.points.push_back({0, 0, -1});
  for(int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    soup.triangles.push_back({north, i, next});
    for(int j = 0; j + 1 < rings; ++j) {
      const int a = around * j + i, b = around * j + next, c = a + around, d = b + around;
      // Every other circle is turned by half a step.
      if(j % 2 == 0) {
        soup.triangles.push_back({a, d, b});
        soup.triangles.push_back({a, c, d});
      } else {
        soup.triangles.push_back({a, c, b});
        soup.triangles.push_back({b, c, d});
      }
    }
    soup.triangles.push_back({south, around * (rings - 1) + next, around * (rings - 1) + i});
  }
  return soup;
}

CGAL::Flip_free_maps::Flip_free_map_traits<> tight_traits()
{
  CGAL::Flip_free_maps::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-7;
  return traits;
}

Plain_result plain_result(const Soup& soup)
{
  Plain_mesh mesh;
  const auto vertices = add_soup(soup, mesh);
  auto uv = mesh.add_property_map<Plain_mesh::Vertex_index, Plain_point_2>("v:uv").first;
  Plain_result result;
  result.summary = CGAL::Flip_free_maps::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  BOOST_TEST_REQUIRE(result.summary.converged());
  for(const auto v : vertices)
    result.uv.push_back(uv[v]);
  return result;
}

} // namespace test_support
