// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_OPTION_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_OPTION_CHECKS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

inline bool is_tolerance(double value) { return value >= 0 && std::isfinite(value); }

// Checks the limits that all minimizers' options have.
template <typename Options>
bool check_limits(const Options& options, std::string* message)
{
  if(std::isnan(options.target_energy))
    return fail(message, "target_energy must not be NaN");
  if(options.max_iterations < 0)
    return fail(message, "max_iterations must not be negative");
  if(!(options.max_seconds >= 0))
    return fail(message, "max_seconds must not be negative");
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_OPTION_CHECKS_H
