// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_ANY_ACCELERATION_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_ANY_ACCELERATION_H

#include <CGAL/Flip_free_maps/accelerations/Inexact_newton.h>
#include <CGAL/Flip_free_maps/accelerations/Lbfgs.h>
#include <CGAL/Flip_free_maps/accelerations/Nesterov.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>

#include <string>
#include <utility>
#include <variant>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// An acceleration of this package that is chosen at run time.
///
/// \cgalModels{Acceleration}
class Any_acceleration
{
public:
  /// Holds a `Lbfgs`.
  Any_acceleration() = default;
  /// Holds a `Lbfgs`.
  explicit Any_acceleration(const Lbfgs& acceleration) : m_acceleration(acceleration) {}
  /// Holds an `Inexact_newton`.
  explicit Any_acceleration(const Inexact_newton& acceleration) : m_acceleration(acceleration) {}
  /// Holds a `Nesterov`.
  explicit Any_acceleration(const Nesterov& acceleration) : m_acceleration(acceleration) {}
  /// Holds a `No_acceleration`.
  explicit Any_acceleration(const No_acceleration& acceleration) : m_acceleration(acceleration) {}

  /// "any"; see `acceleration_name()`.
  static const char* name() { return "any"; }

  /// The name of the acceleration that is held.
  std::string acceleration_name() const
  {
    return std::visit([](const auto& acceleration) { return std::string(acceleration.name()); }, m_acceleration);
  }

  /// Whether the acceleration that is held multiplies by the matrix of the current map.
  bool needs_current_matrix() const
  {
    return std::visit([](const auto& acceleration) { return internal::needs_current_matrix(acceleration); }, m_acceleration);
  }

  /// Passed on.
  void reset()
  {
    std::visit([](auto& acceleration) { acceleration.reset(); }, m_acceleration);
  }

  /// Passed on to `Nesterov`; `false` for others.
  bool extrapolate(const Eigen::VectorXd& x, Eigen::VectorXd& displacement)
  {
    Nesterov* nesterov = std::get_if<Nesterov>(&m_acceleration);
    return nesterov != nullptr && nesterov->extrapolate(x, displacement);
  }

  /// Passed on.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    return std::visit([&](auto& acceleration) { return acceleration.direction(x, gradient, solve, direction); }, m_acceleration);
  }

private:
  std::variant<Lbfgs, Inexact_newton, Nesterov, No_acceleration> m_acceleration;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_ANY_ACCELERATION_H
