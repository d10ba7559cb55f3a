// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Where the two sides of a seam in a chart lie over each other, as they do beyond a saddle, they are led back to the line midway
// between them, together with what is near: a stretch of a seam at a time.
class Chart_zipper
{
public:
  // What of a chart's map is to change.
  struct Patch
  {
    Simplicial_domain<2> domain;
    Position_constraints<2> constraints;
    std::vector<std::int32_t> vertices; // by number in the domain, that in the chart
    Positions<2> x, targets;            // of the domain
    double unit = 1;                    // the domain's unit of length over the chart's, a power of two
  };

  // One side of a stretch: edges of the border, one after the other.
  using Stretch = std::vector<std::int32_t>;

  // Keeps references. `twins` has by edge of the border the one across the seam, or -1. Sides come to lie `gap` away from the line.
  Chart_zipper(const Linked_triangles& chart, const Border_curves& border, const std::vector<std::int32_t>& twins, double gap);

  // Whether two edges of the border that cross are sides of the same part of a seam.
  bool is_zippable(std::int32_t i, std::int32_t j) const;

  // The stretch that such edges belong to, empty if it is not the sides of the seam there that lie over each other, or if they do so
  // by too much.
  Stretch stretch(const Positions<2>& x, std::int32_t i, std::int32_t j) const;

  // What is to be done about a stretch. False if the domain cannot be made.
  bool make_patch(const Positions<2>& x, const Stretch& stretch, Patch& patch) const;

private:
  // Vertices and where they go.
  using Goals = std::vector<std::pair<std::int32_t, Vector<2>>>;
  // The places on both sides of the line midway between those of a stretch.
  Goals goals(const Positions<2>& x, const Stretch& stretch) const;

  // How far from the other side of an edge, in edges, one that crosses it may be.
  static constexpr int NEAR = 12;
  // The part of the length of a stretch by which its sides may lie over each other.
  static constexpr double MOST_TURN = 0.3;
  // Rings of triangles around a stretch of one edge, and the most.
  static constexpr int RINGS = 4, MOST_RINGS = 40;

  // The direction from one side of a seam to the other at an edge, in the map.
  Vector<2> normal(const Positions<2>& x, std::int32_t i) const;

  // How far the sides are apart at an edge, negative where they lie over each other.
  double distance(const Positions<2>& x, std::int32_t i) const;

  bool is_near(std::int32_t i, std::int32_t j) const;

  // The edge after or before one, if the same seam goes on there, otherwise -1.
  std::int32_t next_of_seam(std::int32_t i) const;
  std::int32_t prev_of_seam(std::int32_t i) const;

  // The triangles around some vertices, in rings.
  std::vector<std::int32_t> rings(const std::vector<std::int32_t>& vertices, int number) const;

  const Linked_triangles& m_chart;
  const Border_curves& m_border;
  const std::vector<std::int32_t>& m_twins;
  const double m_gap;
  std::vector<std::int32_t> m_next, m_prev;                // by edge of the border
  std::vector<std::int32_t> m_first_corner, m_next_corner; // by vertex, and by corner
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ZIPPER_H
