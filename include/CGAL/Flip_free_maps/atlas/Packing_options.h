// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `pack_charts()`.
struct Packing_options
{
  /// Least distance between the bounding boxes of two charts, in parts of the unit square's side, in (0, 1/2]. Charts keep half
  /// of it from the sides of the square.
  double margin = 1. / 256;
  /// Whether charts are turned to where their bounding boxes are smallest. Otherwise they are turned by quarters only.
  bool rotate = true;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    return (margin > 0 && margin <= 0.5) || internal::fail(message, "the margin must be positive and at most 1/2");
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of a packing.
struct Packing_summary
{
  Status status = Status::invalid_option; ///< `success`, or why nothing was written
  std::string message = "not run";        ///< a sentence that says why
  int charts = 0;                         ///< number of charts
  double scale = -1;                      ///< the factor from the lengths of the charts to those in the unit square
  double occupancy = -1;                  ///< the part of the unit square that is covered

  /// `true` when the charts were packed.
  bool is_valid() const { return status == Status::success; }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_PACKING_OPTIONS_H
