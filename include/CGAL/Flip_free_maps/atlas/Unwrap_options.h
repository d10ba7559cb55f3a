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

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// What an observer of `unwrap()` is told at the beginning of each chart and in each iteration on it.
struct Unwrap_progress
{
  int charts_done = 0;         ///< charts that are finished
  int charts = 0;              ///< charts that are known of, those to be flattened included; it grows when charts are split
  std::int64_t faces_done = 0; ///< faces of the charts that are finished
  std::int64_t faces = 0;      ///< faces of the mesh
  double seconds = 0;          ///< wall-clock seconds since the beginning
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
  /// Whether charts are packed. Otherwise each stays where it was flattened, in the units of the surface;
  /// charts lie upon each other then.
  bool pack = true;
  /// Charts whose mean symmetric Dirichlet energy exceeds this are split; above 1, where 1 is an isometry. If it is finite, it
  /// lowers `Cut_options::target_energy` to itself, and disks are cut, too:
  /// seams to the places that are distorted most come before splits.
  double max_distortion = std::numeric_limits<double>::infinity();
  /// After this many seconds of wall-clock time no chart is improved any more. The result is as valid as any other,
  /// but more distorted.
  double max_seconds = std::numeric_limits<double>::infinity();
  /// Called at the beginning of each chart and in each iteration. When it returns `false`,
  /// the rest is done as if the time were up.
  std::function<bool(const Unwrap_progress&)> observer;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!cut.is_valid(message) || !packing.is_valid(message))
      return false;
    if(!(max_distortion > 1))
      return internal::fail(message, "max_distortion must be above 1");
    if(!(max_seconds >= 0))
      return internal::fail(message, "max_seconds must not be negative");
    return true;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_UNWRAP_OPTIONS_H
