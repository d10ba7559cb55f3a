// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INEXACT_NEWTON_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INEXACT_NEWTON_H

#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// The direction of the preconditioner's matrix at the current map, by conjugate gradients which are themselves preconditioned by
/// its last factorization (Nocedal and Wright 2006, algorithm 7.1). With `On_demand` one factorization then serves many
/// iterations that converge like those with a factorization each. It is made for high accuracy: far from the optimum `Lbfgs`
/// gains more by a step than conjugate gradients by one of theirs, at the same cost.
///
/// It suits direct linear solvers: an iterative one would as soon solve with the current matrix itself.
///
/// Complexity: the assembly of the matrix, and one solve and one product with it for each step of conjugate gradients.
///
/// \cgalModels{Acceleration}
class Inexact_newton
{
public:
  /// "inexact_newton"
  static const char* name() { return "inexact_newton"; }

  /// `true`: the minimizer assembles the matrix in each iteration.
  bool needs_current_matrix() const { return true; }

  /// Norm of the residual at which conjugate gradients end, relative to that of the gradient, at most; near the optimum it is the
  /// ratio of the gradient to the first one, so that convergence is superlinear.
  double largest_residual = 0.1;
  /// The least such residual.
  double smallest_residual = 1e-6;
  /// Most steps of conjugate gradients for one direction.
  int max_steps = 30;

  /// Forgets the first gradient.
  void reset() { m_first_gradient = 0; }

  /// The direction at a map with this gradient. Conjugate gradients end early where the matrix is not positive.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& /* x */, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    const double norm = internal::norm(solve, gradient);
    if(m_first_gradient == 0)
      m_first_gradient = norm;
    const double bound =
      norm * (std::max)(smallest_residual, (std::min)(largest_residual, m_first_gradient > 0 ? norm / m_first_gradient : 0));

    Eigen::VectorXd residual = -gradient, preconditioned, product;
    if(!solve(residual, preconditioned))
      return false;
    direction.setZero(gradient.size());
    Eigen::VectorXd search = preconditioned;
    double decrease = internal::dot(solve, residual, preconditioned);
    int step = 0;
    for(; step < max_steps && internal::norm(solve, residual) > bound; ++step) {
      solve.multiply(search, product);
      const double curvature = internal::dot(solve, search, product);
      if(!(curvature > 0 && decrease > 0))
        break;
      const double length = decrease / curvature;
      direction += length * search;
      residual -= length * product;
      if(!solve(residual, preconditioned))
        return false;
      const double next = internal::dot(solve, residual, preconditioned);
      search = preconditioned + next / decrease * search;
      decrease = next;
    }
    // Without a first step the preconditioner alone leads on.
    if(step == 0)
      direction = search;
    return true;
  }

private:
  double m_first_gradient = 0;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INEXACT_NEWTON_H
