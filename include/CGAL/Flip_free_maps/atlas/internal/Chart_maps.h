// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_surface.h>
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The maps of the pieces of a surface, however they were made.
class Chart_maps : public Chart_surface
{
public:
  Chart_maps(const Linked_triangles& surface, double begin, const Unwrap_options& options, Unwrap_summary& summary);

  const std::vector<Flat_chart>& charts() const { return m_charts; }

protected:
  using Image = Eigen::Matrix<double, 2, 3>;

  // Whether nothing is improved any more: the observer said so, or a deadline.
  bool is_late() const { return m_is_stopped || deadline_status() != Status::success; }

  // The map that the piece has as a part of a larger one.
  bool inherit(const Piece& piece, const Open_piece& open, Positions<2>& x) const;

  // Whether a map is without overlaps. Where it touches itself, as parts with right angles do when they are unfolded, its border
  // is moved inwards by a millionth of the atlas: what is apart by rounding only would overlap once it is turned and moved.
  bool draw_apart(const Open_piece& open, Positions<2>& x) const;

  // Half the least distance between parts of the border of a chart.
  double gap() const { return 1e-6 * std::sqrt(m_area); }

  // By edge of the border of a piece, the one that a seam joins it to, -1 if that is not one of the piece.
  std::vector<std::int32_t> twins(const Piece& piece, const Open_piece& open) const;

  // Seams go between polygons only.
  bool can_be_split(const Piece& piece) const;

  // How many times the distortion of a chart, the energy or the stretch beyond an isometry, is the bound.
  double excess(const Chart_summary& chart) const
  {
    return (std::max)((chart.energy - 1) / (m_options.max_distortion - 1), (chart.stretch_95 - 1) / (m_options.max_stretch - 1));
  }

  bool is_too_distorted(const Chart_summary& chart) const
  {
    return chart.energy > m_options.max_distortion || chart.stretch_95 > m_options.max_stretch;
  }

  // Whether a chart alone would leave half of the square empty, since it is longer than the side of a square with the area of all.
  bool is_too_long(const Piece& piece, const Positions<2>& x) const;

  // Enters the distortion of a map into the account of a chart, and remembers the map.
  // Returns the triangle that is distorted most.
  std::int32_t measure(const Piece& piece, const Open_piece& open, const Positions<2>& x, Chart_summary& chart);

  // Remembers the map of a piece that is a chart already, and is cut again only to be a better one.
  void remember(const Piece& piece, const Open_piece& open, const Positions<2>& x);

  // Whether a piece is a part of such a chart.
  bool was_chart(const Piece& piece) const;

  // The map of the piece in that chart, with the seams closed again that it did not have there. It has no overlaps.
  Positions<2> chart_again(const Piece& piece, Open_piece& open);

  // Moves the map of some faces, as it is, to that of their neighbors across these sides of them; what these have in common goes where
  // the neighbors have it.
  void lay_beside(const std::vector<std::int32_t>& faces, const std::vector<std::int32_t>& sides);

  void keep(Piece& piece, const Open_piece& open, Positions<2>& x, const Chart_summary& chart);

  // The halfedge of the surface that one of a piece was.
  static std::int32_t original_halfedge(const Piece& piece, std::int32_t h) { return 3 * piece.faces[h / 3] + h % 3; }

  // Splits charts in two, one after the other, while much of the square would stay empty and the parts fill it better, if the seams
  // are short. Parts keep the map of the whole.
  void split_for_packing(const std::function<bool()>& must_stop);

  // Sorts by areas in the units of `m_surface`, since in the user's they may exceed the range of double precision.
  void sort_charts();

  // Seams are the edges with two images: an edge that was cut alone, at both ends of which the surface is not, has one.
  void count();

  // Halves of a rectangle that is twice as long as wide cover as much of a square as the whole.
  static constexpr double LONG = 2.2;

  const Unwrap_options& m_options;
  Packing_obstacles m_obstacles;
  std::vector<Image> m_image;       // of each face in the last map of it
  std::vector<Image> m_chart_image; // in the last one that was a chart's and was cut again
  std::vector<Flat_chart> m_charts;
  std::vector<double> m_areas;   // of the charts on the surface, in the units of m_surface
  double m_area = 0;             // of the surface, likewise
  std::int64_t m_faces_done = 0; // polygons of the user's
  std::atomic<bool> m_is_stopped{false};

private:
  // Radians between faces that are one plane; and the part of a seam that may run across such.
  static constexpr double FLAT = 1e-4, MOST_ACROSS_PLANES = 0.1;
  // Polygons of a half: crumbs are worse than empty places.
  static constexpr std::int64_t LEAST_HALF = 8;

  // Replaces a chart by two, the second at the end, and tells whether that went well and how long the seam is.
  bool halve(std::size_t c, double& seam_length);

  // How much of a chart's smallest box is empty, in the units of the surface.
  double empty_area(const Flat_chart& chart) const;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_maps_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_MAPS_H
