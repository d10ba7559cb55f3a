// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_OPTIONS_H

#include <CGAL/Flip_free_maps/atlas/Packing_options.h>
#include <CGAL/Flip_free_maps/cutting/Cut_options.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// What `unwrap()` is at. Seams are planned again for charts that are not good enough, within the second phase.
enum class Unwrap_phase
{
  cut,     ///< planning seams
  flatten, ///< flattening charts
  pack     ///< packing them
};

/// \ingroup PkgFlipFreeMapsRef
/// The name of a phase as it appears in reports, e.g. `"flatten"`.
inline const char* phase_name(Unwrap_phase phase)
{
  return phase == Unwrap_phase::cut ? "cut" : phase == Unwrap_phase::flatten ? "flatten" : "pack";
}

/// \ingroup PkgFlipFreeMapsRef
/// What an observer of `unwrap()` is told while seams are planned, while charts are flattened, and while they are packed.
struct Unwrap_progress
{
  Unwrap_phase phase = Unwrap_phase::cut; ///< what is being done
  int charts_done = 0;                    ///< charts that are finished
  int charts = 0;                         ///< charts that are known of, those to be flattened included; it grows when charts are split
  std::int64_t faces_done = 0;            ///< faces of the charts that are finished
  std::int64_t faces = 0;                 ///< faces of the mesh
  double seconds = 0;                     ///< wall-clock seconds since the beginning
};

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `unwrap()`.
struct Unwrap_options
{
  /// Where the surface is cut open. With `Cut_options::join_borders`, the default, holes are joined by seams, so that charts are
  /// disks; but a piece that is nearly flat, with energy at most 1.01, keeps its holes. Without, all charts may have holes.
  Cut_options cut;
  /// How charts are laid into the unit square.
  Packing_options packing;
  /// Whether charts are packed. Otherwise they lie side by side, in the units of the surface.
  bool pack = true;
  /// No chart has a mean symmetric Dirichlet energy above this; above 1, where 1 is an isometry. Charts whose map exceeds it are
  /// cut again, by seams to the places that are distorted most, and split when that does not help. If it is finite, it lowers
  /// `Cut_options::target_energy` to itself, disks are cut, too, and so are surfaces between their creases, see `crease_angle`.
  /// With infinity, only the topology and `cut` ask for seams.
  double max_distortion = 1.025;
  /// At least 95 percent of the area of each chart are stretched or compressed by at most this factor in any direction, where 1 is an
  /// isometry; above 1. Charts that exceed it are treated as those above `max_distortion`.
  double max_stretch = std::numeric_limits<double>::infinity();
  /// Edges across which the surface turns by at least this angle, in radians, are seams. Positive; infinity for none.
  double seam_angle = std::numeric_limits<double>::infinity();
  /// Edges across which the surface turns by at least this angle, in radians, are creases. Flat and rolled regions between creases
  /// become charts of their own, or parts of one that unfolds about straight edges, if the surface consists of nothing else and
  /// `max_distortion` is finite. A coarse mesh of something round, where edges turn by less than 60 degrees on the average and charts
  /// of regions would need long seams, is cut like a smooth one. Positive; infinity for none.
  double crease_angle = 0.5;
  /// Charts that are more than 2.2 times as long as wide, and longer than this times the side of a square with the area of the
  /// surface, are split if charts are packed and distortion is bounded: a single long one would leave most of the square
  /// empty. At least 1; infinity for any length.
  double max_length = 1.2;
  /// While charts would cover less than this part of the square, those that leave most of it empty are split in two where their
  /// parts fill it better, if the seams are short, charts are packed and distortion is bounded. In [0, 1]; 0 for no such splits.
  double min_occupancy = 0.65;
  /// Whether surfaces are refused that are no triangle meshes whose faces have an area and are joined by their indices to a manifold.
  /// Otherwise all are taken, see `unwrap()`.
  bool strict = false;
  /// After this many seconds of wall-clock time no seam and no chart is improved any more. The result is as valid as any other,
  /// but more distorted; if its mean energy were 2 or more, or there are no charts within a second, the status is `interrupted`.
  double max_seconds = std::numeric_limits<double>::infinity();
  /// Called by the thread that called `unwrap()`, and by no other: while seams are planned, before charts are flattened, while charts
  /// are packed, and in each iteration on a chart, or, while several charts are flattened at the same time, every few hundredths of a
  /// second. When it returns `false`, the rest is done as if the time were up. See `Deadline` for what is asked more often.
  std::function<bool(const Unwrap_progress&)> observer;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!cut.is_valid(message) || !packing.is_valid(message))
      return false;
    if(!(max_distortion > 1))
      return internal::fail(message, "max_distortion must be above 1");
    if(!(max_stretch > 1))
      return internal::fail(message, "max_stretch must be above 1");
    if(!(seam_angle > 0))
      return internal::fail(message, "seam_angle must be positive");
    if(!(crease_angle > 0))
      return internal::fail(message, "crease_angle must be positive");
    if(!(max_length >= 1))
      return internal::fail(message, "max_length must be at least 1");
    if(!(min_occupancy >= 0 && min_occupancy <= 1))
      return internal::fail(message, "min_occupancy must be in [0, 1]");
    if(!(max_seconds >= 0))
      return internal::fail(message, "max_seconds must not be negative");
    return true;
  }

  /// Whether there is a bound on the distortion of charts.
  bool is_bounded() const { return std::isfinite(max_distortion) || std::isfinite(max_stretch); }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_OPTIONS_H
