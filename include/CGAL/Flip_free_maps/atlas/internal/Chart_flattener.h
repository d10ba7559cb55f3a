// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_seams.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <atomic>
#include <cstddef>
#include <functional>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What is asked of the map of a piece.
struct Map_request
{
  bool is_convex = false;                               // whether the start will do, which has a convex border
  bool has_start = false;                               // whether to begin with the given map
  std::function<bool(const Positions<2>&)> is_hopeless; // whether a rough map is enough; see `Planar_request`
};

// Makes maps of pieces by a method that a derived class knows.
class Chart_flattener : public Chart_seams
{
public:
  using Chart_seams::Chart_seams;

  virtual ~Chart_flattener() = default;

protected:
  // Computes a map of a piece; any that is good enough, at once, if `is_hasty`.
  virtual Summary solve(const Open_piece& open, Positions<2>& x, const Map_request& request, bool is_hasty) = 0;

  // Whether the method can lead vertices along, and does it: moves a part of a map to its targets.
  virtual bool can_relax() const = 0;
  virtual bool relax(Chart_zipper::Patch& patch) const = 0;

  // Gives a piece a map if it can have one, without overlaps if they are easily removed.
  void flatten(const Piece& piece, Flat_piece& flat);

  // The same for two charts of which one was laid beside the other. If it has to bend for that and lies upon the other, they hardly
  // have a map without overlaps, and none is looked for.
  void flatten_union(const Piece& piece, Flat_piece& flat);

  // The same, and decides what becomes of the piece. When the time is up what was a chart before is one again.
  void flatten_and_decide(Piece& piece, Flat_piece& flat);

  // Flattens a piece with its holes where joining the borders by seams gains nothing: where it is nearly flat. It has no map else.
  void keep_holes(const Piece& piece, Flat_piece& flat);

  // Flattens a chart anew after its vertices were moved in space by at most a length, to and fro:
  // hardly any triangle is much thinner than that then.
  bool thicken(std::size_t number, double length);

  // Whether charts were made when the time was up.
  bool has_made_haste() const { return m_late_since != 0; }

private:
  // A piece that has no map when the time is up gets one that is good enough, or none if that takes long.
  Summary flatten_piece(const Open_piece& open, Positions<2>& x, const Map_request& request = Map_request());

  // Measures a map, and removes overlaps where the map need not become much worse for that.
  void settle(const Piece& piece, Flat_piece& flat);

  // Leads the sides of seams that lie over each other back to where they do not. Returns whether the map was changed.
  bool zip(const Piece& piece, const Open_piece& open, Positions<2>& x) const;

  // Puts a part of a map into the whole if nothing flips.
  static bool put(const Chart_zipper::Patch& patch, Positions<2>& x);

  // Rounds in which the sides of seams are led apart, and half their distance then, over the least one.
  static constexpr int MOST_ROUNDS = 3;
  static constexpr double ZIPPED_GAPS = 5;
  // Seconds for charts that have no map when the time is up.
  static constexpr double GRACE = 0.8;

  std::atomic<double> m_late_since{0};
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_flattener_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_FLATTENER_H
