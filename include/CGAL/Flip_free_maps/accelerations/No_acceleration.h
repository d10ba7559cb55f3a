// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NO_ACCELERATION_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NO_ACCELERATION_H

#include <Eigen/Core>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// Takes the preconditioned gradient as it is.
///
/// \cgalModels{Acceleration}
struct No_acceleration
{
  /// "none"
  static const char* name() { return "none"; }

  /// Forgets what it knows of earlier iterations.
  void reset() {}

  /// The direction at `x`: minus the gradient times the inverse of the preconditioner, which `solve(b, result)` applies.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& /* x */, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    if(!solve(gradient, direction))
      return false;
    direction = -direction;
    return true;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NO_ACCELERATION_H
