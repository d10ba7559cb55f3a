// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_ADMM_SPLITTING_STEP_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_ADMM_SPLITTING_STEP_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/elements/internal/closest_rotation.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/splitting/Proximal_map.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_errors.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// What the splitting keeps of one element.
template <int D>
struct Split_element
{
  internal::Matrix<D> jacobian; ///< J, the Jacobian of the map
  internal::Matrix<D> rotation; ///< R
  internal::Matrix<D> stretch;  ///< P, symmetric and positive definite
  internal::Matrix<D> dual;     ///< L, the scaled dual variable
  double penalty;               ///< mu
  double inertia;               ///< h / mu, how strongly R keeps to the rotation of the iteration before
};

/// \ingroup PkgFlipFreeMapsSplitting
/// The local steps of the splitting scheme of Stein, Li and Solomon 2022 (section 4), an alternating direction method of
/// multipliers that minimises sum_e A_e psi(P_e) subject to J_e = R_e P_e. The augmented Lagrangian is
/// sum_e A_e psi(P_e) + mu_e / 2 (|J_e - R_e P_e + L_e|^2 - |L_e|^2). All steps are exact, up to the Newton iterations of
/// energies whose proximal maps have no closed form. What `Splitting_options` say departs from the paper in how errors are weighted and
/// in what is done about flipped elements; `Splitting_options::published()` does not.
///
/// \tparam D dimension, 2 or 3
/// \tparam Energy must be a model of `DistortionEnergy`, convex in the singular values, see `Proximal_map`
///
/// \cgalModels{SplittingStep}
template <int D, typename Energy = Symmetric_gradient>
class Admm_splitting_step
{
  using Vector = internal::Vector<D>;
  using Matrix = internal::Matrix<D>;

public:
  /// What is kept of an element.
  using Element = Split_element<D>;

  /// Keeps copies of the energy and of the options.
  explicit Admm_splitting_step(const Energy& energy = Energy(), const Splitting_options& options = Splitting_options())
    : m_proximal_map(energy), m_options(options)
  {}

  /// "admm_splitting"
  static const char* name() { return "admm_splitting"; }

  /// Splits the Jacobian of an element of measure `measure`: J = R P by polar decomposition, with the sign of the last singular
  /// value moved to R, L = 0, mu = A. Whether rotations are inert is decided for the whole run.
  void start(const Matrix& jacobian, double measure, bool inert, Element& element) const
  {
    internal::Signed_svd<D> svd;
    internal::signed_svd(jacobian, svd);
    const Vector p = svd.s.cwiseAbs().cwiseMax(m_proximal_map.floor());
    element.jacobian = jacobian;
    element.rotation = svd.U * svd.V.transpose();
    element.stretch = svd.V * p.asDiagonal() * svd.V.transpose();
    element.dual.setZero();
    element.penalty = scaled_measure(measure);
    element.inertia = inert ? inertia(p, measure, element.penalty) : 0;
  }

  /// The rotation with the least augmented Lagrangian plus the proximal term h / 2 |R - previous R|^2.
  void update_rotation(Element& element) const
  {
    const Matrix target = (element.jacobian + element.dual) * element.stretch + element.inertia * element.rotation;
    internal::closest_rotation(target, element.rotation);
  }

  /// The stretch with the least augmented Lagrangian.
  void update_stretch(double measure, Element& element) const
  {
    const Matrix product = element.rotation.transpose() * (element.jacobian + element.dual);
    const Matrix symmetric = 0.5 * (product + product.transpose());
    proximal(symmetric, scaled_measure(measure) / element.penalty, element.stretch);
  }

  /// The dual variable after the step: L plus the residual J - R P.
  static void update_dual(Element& element) { element.dual += element.jacobian - element.rotation * element.stretch; }

  /// All steps of one element after the positions have been solved for: rotation, stretch, dual variable; on request also the
  /// penalty. The errors are added to `errors`.
  void update(const Matrix& jacobian, double measure, bool adapt, bool inert, Element& element, Splitting_errors& errors) const
  {
    const double moved = (jacobian - element.jacobian).squaredNorm();
    element.jacobian = jacobian;
    update_rotation(element);
    update_stretch(measure, element);
    const Matrix residual = jacobian - element.rotation * element.stretch;
    element.dual += residual;

    const bool is_weighted = m_options.weights == Splitting_weights::measure;
    const double weight = is_weighted ? measure : 1, relative = element.penalty / weight;
    const double primal = residual.squaredNorm(), dual = relative * relative * moved;
    errors.primal += weight * primal;
    errors.dual += weight * dual;
    errors.primal_scale += weight * jacobian.squaredNorm();
    errors.dual_scale += weight * relative * relative * element.dual.squaredNorm();
    const bool is_flipped = !(jacobian.determinant() > 0);
    errors.flips += is_flipped;
    if(adapt)
      errors.adapted +=
        adapt_penalty(measure, std::sqrt(primal), is_flipped && m_options.raises_penalties_of_flips ? 0 : std::sqrt(dual), inert, element);
  }

  /// Raises or lowers the penalty so that the two errors become alike, but not below the bound under which the stretch is known
  /// to be stable, and scales L so that mu L, the dual variable itself, stays the same. Returns whether the penalty changed.
  bool adapt_penalty(double measure, double primal, double dual, bool inert, Element& element) const
  {
    double penalty = element.penalty;
    if(primal > m_options.penalty_ratio * dual)
      penalty *= m_options.penalty_factor;
    else if(dual > m_options.penalty_ratio * primal)
      penalty /= m_options.penalty_factor;
    const Vector p = eigenvalues(element.stretch).cwiseMax(std::numeric_limits<double>::min());
    penalty = (std::max)(penalty, least_penalty(p, measure));
    penalty = (std::min)(penalty, m_options.largest_penalty * scaled_measure(measure));
    const bool changed = penalty != element.penalty;
    if(changed) {
      element.dual *= element.penalty / penalty;
      element.penalty = penalty;
    }
    element.inertia = inert ? inertia(p, measure, penalty) : 0;
    return changed;
  }

  /// The least penalty of an element whose stretch has the eigenvalues `p`: A / 4 (sqrt(1 + 16 F^2) - 1) with the Lipschitz
  /// constant F of the energy's gradient, F^2 at most eps^(-1/4).
  double least_penalty(const Vector& p, double measure) const
  {
    const double cap = std::pow(std::numeric_limits<double>::epsilon(), -0.25);
    const double F = m_proximal_map.lipschitz(p, m_proximal_map.squared_gradient(p));
    const double squared = F * F < cap ? F * F : cap;
    return 0.25 * scaled_measure(measure) * (std::sqrt(1 + 16 * squared) - 1);
  }

  /// What the Jacobian should be for the next positions, R P - L, times the penalty, less what the present one contributes.
  static Matrix pull(const Element& element)
  {
    return element.penalty * (element.rotation * element.stretch - element.dual - element.jacobian);
  }

  /// The P with the least c f(P) + 1/2 |P - Q|^2, for a symmetric Q.
  void proximal(const Matrix& Q, double c, Matrix& P) const
  {
    if constexpr(D == 2)
      proximal_in_plane(Q, c, P);
    else if(m_proximal_map.closed_form() != Closed_form::symmetric_gradient || !symmetric_gradient_in_space(Q, c, P))
      proximal_by_eigenvectors(Q, c, P);
  }

private:
  // The measure in units in which f takes the place of psi.
  double scaled_measure(double measure) const { return measure * m_proximal_map.scale(); }

  // h / mu = 4 A^2 b^2 / mu^2, b^2 = 5 (1 + |grad f(P)|^2).
  double inertia(const Vector& p, double measure, double penalty) const
  {
    const double relative = scaled_measure(measure) / penalty;
    return 20 * relative * relative * (1 + m_proximal_map.squared_gradient(p));
  }

  static Vector eigenvalues(const Matrix& P)
  {
    if constexpr(D == 2) {
      const double mean = 0.5 * (P(0, 0) + P(1, 1)), half = 0.5 * (P(0, 0) - P(1, 1));
      const double radius = std::sqrt(half * half + P(1, 0) * P(1, 0));
      return Vector(mean + radius, (P(0, 0) * P(1, 1) - P(1, 0) * P(1, 0)) / (mean + radius));
    } else
      return Eigen::SelfAdjointEigenSolver<Matrix>(P, Eigen::EigenvaluesOnly).eigenvalues().reverse();
  }

  void proximal_in_plane(const Matrix& Q, double c, Matrix& P) const
  {
    const double mean = 0.5 * (Q(0, 0) + Q(1, 1)), half = 0.5 * (Q(0, 0) - Q(1, 1)), off = Q(1, 0);
    const double radius = std::sqrt(half * half + off * off);
    const Vector p = m_proximal_map.proximal(Vector(mean + radius, mean - radius), c);
    const double p_mean = 0.5 * (p[0] + p[1]), slope = radius > 0 ? 0.5 * (p[0] - p[1]) / radius : 0;
    P << p_mean + slope * half, slope * off, slope * off, p_mean - slope * half;
  }

  void proximal_by_eigenvectors(const Matrix& Q, double c, Matrix& P) const
  {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(Q);
    const Vector p = m_proximal_map.proximal(eigen.eigenvalues().reverse(), c).reverse();
    P = eigen.eigenvectors() * p.asDiagonal() * eigen.eigenvectors().transpose();
  }

  // p(q) = (q + g(q)) / (2 (c + 1)) with g(q) = sqrt(q^2 + k) is applied to a matrix as Newton's interpolation polynomial at its
  // eigenvalues, which needs no eigenvectors; the divided differences of g have forms that do not cancel. Not where the
  // eigenvalues differ so much that rounding of the greatest spoils the least.
  static bool symmetric_gradient_in_space(const Matrix& Q, double c, Matrix& P)
  {
    const double mean = Q.trace() / 3;
    const double a = Q(0, 0) - mean, b = Q(1, 1) - mean, d = Q(2, 2) - mean;
    const double off = Q(1, 0) * Q(1, 0) + Q(2, 0) * Q(2, 0) + Q(2, 1) * Q(2, 1);
    const double radius = std::sqrt((a * a + b * b + d * d + 2 * off) / 6);
    const double k = 4 * c * (c + 1), largest = std::abs(mean) + 2 * radius;
    if(!(largest * largest < 1e6 * k))
      return false;
    double q0 = mean, q1 = mean, q2 = mean;
    if(radius > 1e-150) {
      const double determinant =
        a * (b * d - Q(2, 1) * Q(2, 1)) - Q(1, 0) * (Q(1, 0) * d - Q(2, 1) * Q(2, 0)) + Q(2, 0) * (Q(1, 0) * Q(2, 1) - b * Q(2, 0));
      const double r = 0.5 * determinant / (radius * radius * radius);
      const double angle = std::acos((std::max)(-1., (std::min)(1., r))) / 3;
      const double cosine = std::cos(angle), sine = std::sqrt((std::max)(0., 1 - cosine * cosine));
      q0 = mean + 2 * radius * cosine;
      q1 = mean - radius * (cosine - 1.7320508075688772 * sine);
      q2 = mean - radius * (cosine + 1.7320508075688772 * sine);
    }
    const double g0 = std::sqrt(q0 * q0 + k), g1 = std::sqrt(q1 * q1 + k), g2 = std::sqrt(q2 * q2 + k);
    const double first = (q0 + q1) / (g0 + g1);
    const double second = ((g0 * g1 - q0 * q1) + (g1 * g2 - q1 * q2) + (g0 * g2 - q0 * q2) + k) / ((g0 + g1) * (g1 + g2) * (g0 + g2));
    Matrix shifted = Q;
    shifted.diagonal().array() -= q0;
    Matrix other = Q;
    other.diagonal().array() -= q1;
    P = Q + first * shifted + second * (shifted * other);
    P.diagonal().array() += g0;
    const double factor = 0.5 / (c + 1);
    P = (0.5 * factor * (P + P.transpose())).eval();
    return true;
  }

  Proximal_map<Energy, D> m_proximal_map;
  Splitting_options m_options;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_ADMM_SPLITTING_STEP_H
