// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_grid.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Images of polygons that stay where they are, and that charts are packed around. They may be mirrored, lie upon each other, and lie
// outside of the unit square.
class Packing_obstacles
{
public:
  // The polygon's corners in turn, all of them finite.
  void add(const Positions<2>& polygon);

  bool empty() const { return m_polygons.empty(); }

  // The sum of their areas within the unit square.
  double area() const;

  // Takes the cells of a grid that they touch, and those nearer than so many cells.
  void take(Cell_grid& grid, const Vector<2>& lower_left, double cells_per_unit, double distance) const;

  struct Square
  {
    Vector<2> lower_left;
    double side;
  };

  // About the largest square in the unit square within which charts keep a distance from them that keep half of it from its sides. Its
  // side is 0 if there is none.
  Square largest_square(double distance) const;

  // Whether some triangle touches one of them, by exact predicates.
  bool are_touched(const std::vector<std::array<std::int32_t, 3>>& triangles, const Positions<2>& x) const;

private:
  // The part of a polygon within a square, whose sides are parts of what is left.
  static Positions<2> clipped(const Positions<2>& polygon, double low, double high);

  std::vector<Positions<2>> m_polygons;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Packing_obstacles_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACKING_OBSTACLES_H
