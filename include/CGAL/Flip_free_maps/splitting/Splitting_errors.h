// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_ERRORS_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_ERRORS_H

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// Squares of the errors of elements and of what they are compared with, weighted by w and summed: w is the element's measure A, or 1
/// if all count alike, see `Splitting_weights`.
struct Splitting_errors
{
  double primal = 0;        ///< |J - R P|^2
  double dual = 0;          ///< |mu / w (J - previous J)|^2
  double primal_scale = 0;  ///< |J|^2
  double dual_scale = 0;    ///< |mu / w L|^2
  std::int64_t flips = 0;   ///< elements whose Jacobian has no positive determinant in floating point
  std::int64_t adapted = 0; ///< elements whose penalty changed

  /// Adds the sums over other elements.
  Splitting_errors& operator+=(const Splitting_errors& other)
  {
    primal += other.primal;
    dual += other.dual;
    primal_scale += other.primal_scale;
    dual_scale += other.dual_scale;
    flips += other.flips;
    adapted += other.adapted;
    return *this;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_ERRORS_H
