// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_H

#include <CGAL/Flip_free_maps/cutting/Cut_options.h>
#include <CGAL/Flip_free_maps/cutting/Cut_summary.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_graph.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_opening.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_potential.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/number_type_config.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The costs of edges by which seams are chosen.
std::vector<double> cut_costs(const Cut_surface& surface, const Cut_options& options);

// Decides which edges are cut, beside those that are seams already.
class Cut_planner
{
public:
  // When `must_stop()` tells so, seams are neither improved nor added any more, but those that the topology asks for.
  Cut_planner(const Cut_surface& surface, const Cut_options& options, const std::function<bool()>& must_stop);

  void plan(Cut_summary& summary);

  // By edge, the seams that were planned.
  const std::vector<char>& is_cut() const { return m_graph.is_cut(); }

private:
  static constexpr int ROUNDS_OF_SHORTENING = 3;
  // Of the excess of the worst place: places above it are reached in the same round.
  static constexpr double PART_OF_WORST = 0.3;
  static constexpr int MOST_ROUNDS = 100;
  // Of the distortion that is wanted: corners with more are reached.
  static constexpr double PART_OF_TARGET = 0.02;
  // Of logarithms of scales.
  static constexpr double SMALLEST_PROMINENCE = 0.1;
  // Of peaks of curvature; a corner of a cube has pi / 2, the tip of a limb 2 pi.
  static constexpr double SMALLEST_CURVATURE = CGAL_PI / 4;
  // Radius of the discs over which curvature is summed, over the square root of the area.
  static constexpr double DISC_RADIUS = 0.05;

  void grow(Cut_summary& summary);

  bool may_grow(std::int32_t piece) const
  {
    return m_is_active[piece] && (m_options.number_of_points == 0 || m_points_of_piece[piece] < m_options.number_of_points);
  }

  std::int32_t piece_of_vertex(std::int32_t v) const { return m_opening.piece_of[m_corner_of[v] / 3]; }

  std::vector<double> areas_of_pieces() const;

  // Counts a vertex as reached; where it is not already, on a border, it becomes an end of seams.
  void add_point(std::int32_t v, std::vector<std::int32_t>& ends);

  void cut_slits();

  // Two places of each sphere without points that are far from each other: the farthest from anywhere,
  // and the farthest from there.
  void add_far_pairs(std::vector<std::int32_t>& ends);

  // Section 4.2 of Liu et al. 2018: the vertex nearest to the lower left front corner of the bounding box, then again and again
  // the vertex with the largest sum of distances to those that were chosen.
  std::vector<std::int32_t> farthest_points();

  void reach_extremities(std::vector<std::int32_t>& ends, Cut_summary& summary);

  // Peaks of the Gaussian curvature of discs, the highest first.
  void add_curvature_peaks(Cut_potential& curvature, std::vector<std::int32_t>& ends);

  // Corners of coarse meshes, the triangles around which are a large part of the surface.
  void add_cones(const Cut_potential& potential, std::vector<std::int32_t>& ends);

  // Round by round the places that would be distorted most.
  void reach_distorted_places(Cut_potential& potential, Cut_summary& summary);

  const Cut_surface& m_surface;
  const Cut_options& m_options;
  std::function<bool()> m_must_stop;
  Cut_opening m_opening;
  std::vector<double> m_costs;
  Cut_graph m_graph;
  std::vector<char> m_is_active, m_is_closed; // by piece
  std::vector<std::int32_t> m_corner_of;      // by vertex, one of its corners
  std::vector<int> m_points_of_piece;
};

// Counts components, borders and handles. The status tells of sheets that meet at a vertex.
void describe_surface(const Cut_surface& surface, Cut_summary& summary);

// Counts seams, the new ones and those that were there before, and the pieces that they leave, which are returned.
Cut_opening describe_seams(const Cut_surface& surface, const std::vector<char>& is_cut, Cut_summary& summary);

// Plans the seams of a surface and checks them. On success `is_cut` tells the new seams.
void plan_cuts(const Cut_surface& surface, const Cut_options& options, std::vector<char>& is_cut, Cut_summary& summary,
               const std::function<bool()>& must_stop = nullptr);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/cutting/internal/Cut_planner_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_PLANNER_H
