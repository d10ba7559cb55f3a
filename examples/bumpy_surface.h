// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_EXAMPLES_BUMPY_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_EXAMPLES_BUMPY_SURFACE_H

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>

// A sheet over the unit square: a high hill, a dent beside it, and waves.
inline double bumpy_height(double x, double y)
{
  const auto hill = [x, y](double center_x, double center_y, double width) {
    return std::exp(-((x - center_x) * (x - center_x) + (y - center_y) * (y - center_y)) / (width * width));
  };
  return 0.5 * hill(0.35, 0.4, 0.15) - 0.3 * hill(0.7, 0.65, 0.12) + 0.02 * std::sin(20 * x) * std::cos(17 * y);
}

// Adds the sheet with 2 cells^2 triangles to an empty mesh, a model of MutableFaceGraph, and returns a halfedge on its border.
template <typename Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor make_bumpy_surface(Mesh& mesh, int cells = 50)
{
  using Point = typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  const auto point = [cells](double i, double j) { return Point(i / cells, j / cells, bumpy_height(i / cells, j / cells)); };
  const auto h = CGAL::make_grid(cells, cells, mesh, point, true);
  return CGAL::is_border(h, mesh) ? h : opposite(h, mesh);
}

#endif // CGAL_FLIP_FREE_MAPS_EXAMPLES_BUMPY_SURFACE_H
