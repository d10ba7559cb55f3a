// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The angle by which a surface turns from one triangle to another.
double turning_angle(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b, const Positions<3>& points);

// Where to cut surfaces that consist of flat and rolled regions between sharp edges, as constructed parts do: an exact unfolding
// exists then, and the Gaussian curvature is at the ends of sharp edges, however small it is at each of them. A connected surface
// is cut along all borders of its regions but hinges: straight borders, long beside the outlines of both regions, that form a
// forest, so that regions unfold about them like the faces of a box.
class Chart_creases
{
public:
  Chart_creases(const Linked_triangles& surface, double sharp_angle);

  // The halfedges of edges to cut, once each; none when the surface is of another kind, or can be unfolded as it is.
  std::vector<std::int32_t> cuts();

private:
  // Collinear edges between two regions.
  struct Border
  {
    std::array<std::int32_t, 2> regions;
    std::vector<std::int32_t> sides; // halfedges
    double length = 0;
  };

  // Of all edges: where nearly all are sharp there are no regions, the mesh is a coarse one of something round.
  static constexpr double SMALLEST_SMOOTH_PART = 0.25;
  // Radians, and sides of a square with the area of the surface: where sharp edges turn by less on the average, weighted by their
  // lengths, and the cuts would be longer, the mesh is such a one as well.
  static constexpr double SMALLEST_MEAN_ANGLE = 1.05, LONGEST_DOUBTFUL_CUT = 5;
  // Total curvature: what need not be unfolded, and what regions may have in themselves beside that between them.
  static constexpr double SMALLEST_CURVATURE = 0.1, LARGEST_SMOOTH_PART_OF_CURVATURE = 0.02;
  // Of the outlines of both regions; of its own for a triangle that would be alone.
  static constexpr double SMALLEST_HINGE = 0.08;
  // Relative.
  static constexpr double COLLINEAR = 1e-4;

  std::int32_t end(std::int32_t h, int i) const { return m_elements[h / 3][(h + i) % 3]; }
  double length(std::int32_t h) const { return (m_points.col(end(h, 1)) - m_points.col(end(h, 0))).norm(); }
  std::int32_t neighbor(std::int32_t h) const { return m_surface.opposite[h] < 0 ? -1 : m_surface.opposite[h] / 3; }

  bool is_constructed() const;

  void find_regions();

  // Adds a side to that of some lines which it is a part of.
  void add(std::int32_t side, std::vector<Border>& lines, const std::array<std::int32_t, 2>& regions) const;

  // The longest borders come first.
  std::vector<char> find_hinges() const;

  const Linked_triangles& m_surface;
  const std::vector<std::array<std::int32_t, 3>>& m_elements;
  const Positions<3>& m_points;
  std::vector<char> m_is_sharp;       // by halfedge
  bool m_is_clearly_sharp;            // whether sharp edges turn by enough on the average
  std::vector<std::int32_t> m_region; // by triangle
  std::vector<double> m_outlines;     // by region, the length of its border
  std::vector<Border> m_borders;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CREASES_H
