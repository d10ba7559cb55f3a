// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NESTEROV_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NESTEROV_H

#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// Nesterov's acceleration as in the accelerated quadratic proxy (Kovalsky, Galun and Lipman 2016): each iteration goes on along
/// the last step by theta = (1 - sqrt(1/eta)) / (1 + sqrt(1/eta)) before it computes a gradient. With `Laplacian` and
/// `Every_iteration` this is AQP. The minimizer follows the step only as far as no element flips, and not at all where that would
/// undo the last decrease of the energy.
///
/// \cgalModels{Acceleration}
class Nesterov
{
public:
  /// Takes eta = 100, the value of that paper.
  Nesterov() = default;

  /// Takes another eta, an estimate of the condition number of the preconditioned Hessian, at least 1.
  explicit Nesterov(double eta) : m_theta((1 - std::sqrt(1 / eta)) / (1 + std::sqrt(1 / eta))) {}

  /// "nesterov"
  static const char* name() { return "nesterov"; }

  /// Forgets the last step.
  void reset() { m_x.resize(0); }

  /// The displacement by which to go on before the next gradient; `false` if there is none. Also enters `x`,
  /// the result of the last step.
  bool extrapolate(const Eigen::VectorXd& x, Eigen::VectorXd& displacement)
  {
    const bool has_step = m_x.size() == x.size();
    if(has_step)
      displacement = m_theta * (x - m_x);
    m_x = x;
    return has_step;
  }

  /// The direction at `x`: minus the gradient times the inverse of the preconditioner.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    return No_acceleration().direction(x, gradient, solve, direction);
  }

private:
  double m_theta = 9. / 11;
  Eigen::VectorXd m_x;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_NESTEROV_H
