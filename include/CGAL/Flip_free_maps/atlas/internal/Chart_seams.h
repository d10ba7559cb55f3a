// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_progress.h>
#include <CGAL/Flip_free_maps/cutting/Cut_options.h>
#include <CGAL/Flip_free_maps/cutting/Cut_summary.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Where the pieces of an atlas are cut: along creases, for the topology, and where their maps are not good enough. Plans for different
// pieces can be made at the same time; they do not change the surface.
class Chart_seams : public Chart_progress
{
public:
  using Chart_progress::Chart_progress;

protected:
  // The seams of a piece, as halfedges of the surface, and what is said of them.
  using Seams = std::vector<std::int32_t>;
  struct Piece_cuts
  {
    Seams seams;
    Cut_summary summary;
    double area = 0;
  };

  // A piece and its map, if it has one, how good that is, and what becomes of it: seams, along which it is cut, or a failure; else a
  // chart.
  struct Flat_piece
  {
    Open_piece open;
    Positions<2> x;
    Chart_summary chart;
    bool is_mapped = false, is_inherited = false, is_overlapping = false;
    bool is_ahead = false;   // a chart, as it seems, that waits for its turn
    std::int32_t worst = -1; // the triangle that is distorted most
    Seams seams;
    int Unwrap_summary::*reason = nullptr; // for a split
    bool is_cut = false;
    Status failure = Status::success; // any other one is
    std::string failure_message;
  };

  // Cuts the surface along the edges that are to be seams because of their angle.
  void cut_sharp_edges();

  // The creases along which a piece of flat and rolled regions is to be cut.
  Seams creases(const Piece& piece);

  // Plans seams of a piece.
  Piece_cuts cut(const Piece& piece, const Linked_triangles& open, const Cut_options& options);

  // Decides what becomes of a piece: a chart, parts, or a failure.
  void decide(Piece& piece, Flat_piece& flat);

  // Whether a map overlaps itself elsewhere than at the sides of a seam.
  bool has_far_crossing(const Piece& piece, const Open_piece& open, const Positions<2>& x) const;

  // The energy that is expected when the surface is cut for the first time. Maps turn out better than that, since their borders
  // are free; those that do not are cut again.
  double first_target() const { return (std::min)(m_options.cut.target_energy, 1 + HOPE * (m_options.max_distortion - 1)); }

  // New maps of pieces with at most so many triangles take no time, and a good map overlaps itself less than a rough one.
  static constexpr std::size_t FEW_FACES = 20000;
  // The excess of distortion below which what is left of a piece begins with its map: what is distorted a little too much as a whole
  // may be good enough in parts.
  static constexpr double WORST_EXCESS = 2;

private:
  // Whether the surface turns by at least an angle across the edge of a halfedge, which has two triangles.
  bool turns_by(std::int32_t h, double angle) const;

  // Cuts a piece whose map is valid where it is too distorted or too long.
  void improve(Piece& piece, Flat_piece& flat);

  static void give_up(Flat_piece& flat, Status status, const std::string& message);

  // Cuts a piece by more seams where less distortion is expected of them, and tells whether it found any, or failed.
  bool cut_for_less_distortion(Piece& piece, Flat_piece& flat);

  // Cuts a piece by more seams if there are any: the parts of a split surface need not be disks, and the distortion that was expected
  // is not the true one.
  void cut_again(const Piece& piece, Flat_piece& flat, const Cut_options& options);

  // Pairs of triangles that lie over each other where the border crosses itself, but only those that are no sides of a seam there, if
  // there are any; the same one twice if it crosses itself nowhere.
  std::vector<std::pair<std::int32_t, std::int32_t>> overlaps(const Piece& piece, const Open_piece& open, const Positions<2>& x) const;

  // Splits between pairs of triangles; the second is far from the first if there is none, and both from each other if they are the
  // same. Parts that will have new maps may not need more than the first split.
  void split(const Piece& piece, Flat_piece& flat, std::vector<std::pair<std::int32_t, std::int32_t>> seeds, int Unwrap_summary::*reason);

  static constexpr int MOST_RECUTS = 3;
  // Splits of a piece before its parts are looked at.
  static constexpr int MOST_SPLITS = 64;
  // The excess of distortion below which a piece is cut little by little: where it is small, more is expected than comes out.
  static constexpr double SMALL_EXCESS = 1.25;
  // What is expected over what comes out, of energies above 1; and the part of what is wanted that is asked for the second time.
  static constexpr double HOPE = 3, CAUTION = 0.8;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_seams_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SEAMS_H
