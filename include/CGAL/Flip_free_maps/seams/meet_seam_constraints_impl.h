// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/seams/meet_seam_constraints.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool Seam_options::is_valid(std::string* message) const
{
  const bool valid = tolerance > 0 && first_weight > 0 && first_quarter_turn_weight > 0 && factor > 1 && std::isfinite(factor) &&
                     std::isfinite(largest_weight) && first_weight <= largest_weight;
  return valid ||
         internal::fail(message, "seams need a positive tolerance, positive weights up to a finite largest one, and a factor above 1");
}

} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Vector<2> nearest_quarter_turn(const Vector<2>& p)
{
  if(std::abs(p[0]) >= std::abs(p[1]))
    return {p[0] >= 0 ? 1. : -1., 0.};
  return {0., p[1] >= 0 ? 1. : -1.};
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_IMPL_H
