// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_REPAIR_OPTIONS_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_REPAIR_OPTIONS_H

#include <CGAL/Flip_free_maps/repair/Foldover_free.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// Settings of `repair_map()`.
struct Repair_options
{
  Repair_options()
  {
    splitting.stop_when_flip_free = true;
    splitting.max_iterations = 3000;
    splitting.max_stalled_iterations = 50;
  }

  /// Settings of the first method, the splitting scheme with the symmetric gradient energy. Its `polish` is not used. When its
  /// observer returns `false`, neither the second method nor the polish follows. `max_stalled_iterations` counts only in
  /// space, and where the second method may follow.
  Splitting_options splitting;
  /// Settings of the second method.
  Foldover_free_options foldover_free;
  /// Whether the second method may be used.
  bool use_second_method = true;
  /// Whether the repaired map is handed to `Map_minimizer`: the first flip-free map still has elements that are almost collapsed.
  bool polish = true;
  /// Whether the vertices on the border keep their positions, for domains that know their border.
  bool fix_border = false;

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const { return splitting.is_valid(message) && foldover_free.is_valid(message); }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_REPAIR_OPTIONS_H
