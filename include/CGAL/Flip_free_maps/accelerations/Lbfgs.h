// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_LBFGS_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_LBFGS_H

#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>

#include <Eigen/Core>

#include <deque>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsAccelerations
/// Limited-memory BFGS (Nocedal and Wright 2006, algorithm 7.4) whose initial inverse Hessian is the preconditioner's last
/// factorization. With `On_demand` one factorization serves several iterations, each of which then costs one solve.
///
/// \cgalModels{Acceleration}
class Lbfgs
{
public:
  /// Keeps the last 8 pairs of steps and changes of the gradient.
  Lbfgs() = default;

  /// Keeps the last `memory` pairs.
  explicit Lbfgs(int memory) : m_memory(memory) {}

  /// "lbfgs"
  static const char* name() { return "lbfgs"; }

  /// Forgets all pairs.
  void reset()
  {
    m_pairs.clear();
    m_x.resize(0);
  }

  /// The quasi-Newton direction at `x`; also enters the step that led here. Pairs of nonpositive curvature are left out.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    if(m_x.size() == x.size()) {
      Pair pair{x - m_x, gradient - m_gradient, 0};
      const double curvature = internal::dot(solve, pair.step, pair.change);
      if(curvature > 1e-12 * internal::norm(solve, pair.step) * internal::norm(solve, pair.change)) {
        pair.rho = 1 / curvature;
        m_pairs.push_back(std::move(pair));
        if(static_cast<int>(m_pairs.size()) > m_memory)
          m_pairs.pop_front();
      }
    }
    m_x = x;
    m_gradient = gradient;

    Eigen::VectorXd q = gradient;
    Eigen::VectorXd alpha(m_pairs.size());
    for(int i = static_cast<int>(m_pairs.size()) - 1; i >= 0; --i) {
      alpha[i] = m_pairs[i].rho * internal::dot(solve, m_pairs[i].step, q);
      q -= alpha[i] * m_pairs[i].change;
    }
    if(!solve(q, direction))
      return false;
    for(int i = 0; i < static_cast<int>(m_pairs.size()); ++i) {
      const double beta = m_pairs[i].rho * internal::dot(solve, m_pairs[i].change, direction);
      direction += (alpha[i] - beta) * m_pairs[i].step;
    }
    direction = -direction;
    return true;
  }

private:
  struct Pair
  {
    Eigen::VectorXd step;
    Eigen::VectorXd change;
    double rho;
  };

  int m_memory = 8;
  std::deque<Pair> m_pairs;
  Eigen::VectorXd m_x;
  Eigen::VectorXd m_gradient;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_LBFGS_H
