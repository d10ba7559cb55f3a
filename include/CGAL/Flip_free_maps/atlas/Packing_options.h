// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `pack_charts()`.
struct Packing_options
{
  /// Least distance between two charts, in parts of the unit square's side, in (0, 1/2]. Charts keep half of it from the sides of
  /// the square. Charts are laid into dents and holes of others.
  double margin = 1. / 512;
  /// The side of the texture in pixels. If it is not 0, `padding` takes the place of `margin`.
  int resolution = 0;
  /// Least distance between two charts in pixels, see `resolution`.
  double padding = 2;
  /// Whether charts are turned to where they fit best. Otherwise they are turned by quarters only.
  bool rotate = true;

  /// The least distance between two charts that holds, in parts of the unit square's side.
  double distance() const { return resolution > 0 ? padding / resolution : margin; }

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(resolution < 0)
      return internal::fail(message, "the resolution must not be negative");
    if(resolution > 0)
      return (distance() > 0 && distance() <= 0.5) ||
             internal::fail(message, "the padding must be positive and at most half the resolution");
    return (margin > 0 && margin <= 0.5) || internal::fail(message, "the margin must be positive and at most 1/2");
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of a packing.
struct Packing_summary : Outcome
{
  int charts = 0;        ///< number of charts
  int pinned_charts = 0; ///< how many of them stayed where they were
  double scale = -1;     ///< the factor from the lengths of the charts that were moved to those in the unit square
  double occupancy = -1; ///< the part of the unit square that is covered

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    Outcome::for_each_field(visit);
    visit("charts", charts);
    visit("pinned_charts", pinned_charts, pinned_charts > 0 ? Field_role::shown : Field_role::detail);
    visit("scale", scale);
    visit("occupancy", occupancy);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H
