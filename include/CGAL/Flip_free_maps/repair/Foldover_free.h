// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_FOLDOVER_FREE_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_FOLDOVER_FREE_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The cofactor matrix: the derivative of the determinant.
inline Matrix<2> cofactors(const Matrix<2>& J)
{
  Matrix<2> result;
  result << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
  return result;
}

inline Matrix<3> cofactors(const Matrix<3>& J)
{
  Matrix<3> result;
  for(int k = 0; k < 3; ++k)
    result.col(k) = J.col((k + 1) % 3).cross(J.col((k + 2) % 3));
  return result;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsSplitting
/// Settings of `Foldover_free`.
struct Foldover_free_options
{
  /// The weight of the preservation of measures against that of angles, not negative.
  double measure_weight = 1;
  /// Newton steps for one value of the regularization.
  int max_steps_per_level = 10;
  /// Values of the regularization.
  int max_levels = 100;
  /// Stop when the fewest flips so far have not become fewer for this many values of the regularization in a row: then some
  /// elements shrink along with it, and would do so forever.
  int max_stalled_levels = 10;
  /// Stop after this many seconds of wall-clock time.
  double max_seconds = std::numeric_limits<double>::infinity();

  /// Checks the ranges of all fields; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const
  {
    if(!(measure_weight >= 0) || !std::isfinite(measure_weight))
      return internal::fail(message, "measure_weight must be finite and not negative");
    if(max_steps_per_level < 1 || max_levels < 1 || max_stalled_levels < 1)
      return internal::fail(message, "max_steps_per_level, max_levels and max_stalled_levels must be at least 1");
    if(!(max_seconds >= 0))
      return internal::fail(message, "max_seconds must not be negative");
    return true;
  }
};

/// \ingroup PkgFlipFreeMapsSplitting
/// Removes flips by the regularised energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov 2021 (Foldover-free maps
/// in 50 lines of code): sum_e A_e (tr(J^T J) / chi(det J)^(2/D) + w (det J^2 + 1) / chi(det J)), chi(d) = (d + sqrt(e^2 + d^2))
/// / 2, which is finite on flipped elements and becomes a barrier as e decreases to zero. Each value of e takes some steps of
/// Newton's method with the positive definite part of the Hessian that their paper gives: chi is replaced by its tangent.
///
/// Independent of the splitting: another start, another energy, another way.
///
/// \tparam D dimension, 2 or 3
/// \tparam Traits must be a model of `MapTraits`, of which the linear solver, the kernel and the concurrency tag are used
template <int D, typename Traits = Flip_free_map_traits<>>
class Foldover_free
{
  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Matrix = internal::Matrix<D>;
  using Corners = Eigen::Matrix<double, D + 1, D>;

public:
  /// Keeps references to `domain` and `constraints`, which must outlive this object. Soft positions are not heeded.
  Foldover_free(const Simplicial_domain<D>& domain, const Traits& traits, const Position_constraints<D>& constraints,
                const Foldover_free_options& options = Foldover_free_options())
    : m_domain(domain), m_traits(traits), m_options(options)
  {
    m_schedule.build(domain.elements, domain.number_of_vertices);
    m_row.assign(domain.number_of_vertices, constraints.fixed_vertices);
    m_has_fixed = !constraints.fixed_vertices.empty();
  }

  /// Removes the flips of `x`, in the domain's units. The work is added to `summary`; its status is `success`, `flips_remain` or
  /// `invalid_option`, and `Summary::flips` tells how many flipped elements are left. Returns whether no element is flipped by
  /// exact predicates; `x` is changed only then.
  bool remove_flips(Positions<D>& x, Summary& summary);

  /// The same, but where flips remain `x` becomes the map with the fewest that was met.
  void reduce_flips(Positions<D>& x, Summary& summary);

private:
  // Minimises for smaller and smaller values of the regularization, until no element is flipped or none helps. `x` becomes the map
  // with the fewest flips, whose number the summary has.
  template <typename Solver>
  void descend(Solver& solver, Positions<D>& x, Summary& summary)
  {
    m_matrix.build_pattern(m_row.size(), D, m_row.of(m_domain.elements));
    if(m_row.size() == 0 || !solver.analyze_pattern(m_matrix))
      return;
    Positions<D> result = x;
    double epsilon = 1;
    int stalled = 0;
    for(int level = 0; level < m_options.max_levels && summary.flips > 0 && stalled < m_options.max_stalled_levels; ++level) {
      const double least = least_determinant(result);
      // The paper's rule: wide enough for the worst element, and never wider than before.
      epsilon = (std::min)(epsilon, std::sqrt(1e-12 + 4e-2 * (std::min)(least, 0.) * (std::min)(least, 0.)));
      double energy = this->energy(result, epsilon);
      const double before = energy;
      for(int i = 0; i < m_options.max_steps_per_level; ++i) {
        internal::ask_deadline();
        const double previous = energy;
        if(!step(solver, epsilon, energy, result))
          break;
        ++summary.iterations;
        if(previous - energy <= 1e-4 * energy)
          break;
      }
      const std::int64_t flips = this->flips(result);
      ++stalled;
      if(flips < summary.flips) {
        summary.flips = flips;
        x = result;
        stalled = 0;
      }
      // Without progress a smaller epsilon is the only thing left to change.
      if(before - energy <= 1e-3 * energy)
        epsilon *= 0.5;
      if(epsilon < 1e-9)
        break;
    }
  }

  static double chi(double d, double epsilon)
  {
    const double root = std::sqrt(epsilon * epsilon + d * d);
    return d > 0 ? 0.5 * (d + root) : 0.5 * epsilon * epsilon / (root - d);
  }

  static double chi_slope(double d, double epsilon) { return 0.5 + 0.5 * d / std::sqrt(epsilon * epsilon + d * d); }

  double element_energy(const Matrix& J, double epsilon) const
  {
    const double d = J.determinant(), c = chi(d, epsilon);
    return J.squaredNorm() / std::pow(c, 2. / D) + m_options.measure_weight * (d * d + 1) / c;
  }

  double energy(const Positions<D>& x, double epsilon) const
  {
    return m_schedule.template sum<Tag>(
      [&](std::int64_t e) { return m_domain.measures[e] * element_energy(m_domain.jacobian(e, x), epsilon); });
  }

  double least_determinant(const Positions<D>& x) const
  {
    return m_schedule.template minimum<Tag>([&](std::int64_t e) { return m_domain.jacobian(e, x).determinant(); });
  }

  std::int64_t flips(const Positions<D>& x) const
  {
    return x.allFinite() ? internal::count_flips<Kernel, Tag>(m_domain, m_schedule, x) : m_domain.number_of_elements();
  }

  // Gradient and positive definite model of the energy as a function of (J, d = det J): d^2 psi / d(J, d)^2 with chi replaced by
  // its tangent, where psi is jointly convex, and no curvature of det itself.
  void derivatives(const Matrix& J, double epsilon, Matrix& gradient, Eigen::Matrix<double, D * D, D * D>& hessian) const
  {
    constexpr double a = 2. / D;
    const double w = m_options.measure_weight;
    const double d = J.determinant(), c = chi(d, epsilon), s = chi_slope(d, epsilon);
    const double power = std::pow(c, -a), n = J.squaredNorm();
    const Matrix cof = internal::cofactors(J);
    const double f_d = -a * n * power / c * s;
    const double g_d = w * (2 * d * c - (d * d + 1) * s) / (c * c);
    gradient = 2 * power * J + (f_d + g_d) * cof;
    // psi(J, d) = n c^-a + w (d^2 + 1) / c with dc/dd = s constant
    const double psi_dd = a * (a + 1) * n * power * s * s / (c * c) + w * 2 * ((c - d * s) * (c - d * s) + s * s) / (c * c * c);
    const double psi_jd = -2 * a * power * s / c;
    using Flat = Eigen::Matrix<double, D * D, 1>;
    const Flat j = Eigen::Map<const Flat>(J.data()), k = Eigen::Map<const Flat>(cof.data());
    hessian = psi_jd * (j * k.transpose() + k * j.transpose()) + psi_dd * (k * k.transpose());
    hessian.diagonal().array() += 2 * power;
  }

  template <typename Solver>
  bool step(Solver& solver, double epsilon, double& energy, Positions<D>& x)
  {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(Eigen::Index(D) * m_row.size()), direction;
    m_matrix.set_zero();
    m_schedule.template scatter<Tag>([&](std::int64_t e) { assemble(e, epsilon, x, gradient); });
    // Translations are in the null space; stiffness on one vertex removes them without changing the direction.
    if(!m_has_fixed)
      for(int i = 0; i < D; ++i)
        m_matrix.diagonal(i) *= 2;
    if(!solver.factorize(m_matrix, 1e-9) || !solver.solve(gradient, direction))
      return false;
    const double slope = -gradient.dot(direction);
    if(!(slope < 0))
      return false;
    Positions<D> trial = x;
    for(double length = 1; length > 1e-12; length *= 0.5) {
      internal::ask_deadline();
      m_row.for_each(
        [&](std::int32_t v, std::int32_t row) { trial.col(v) = x.col(v) - length * direction.template segment<D>(Eigen::Index(D) * row); });
      const double value = this->energy(trial, epsilon);
      if(value <= energy + 1e-4 * length * slope) {
        energy = value;
        x.swap(trial);
        return true;
      }
    }
    return false;
  }

  void assemble(std::int64_t e, double epsilon, const Positions<D>& x, Eigen::VectorXd& gradient)
  {
    Matrix first;
    Eigen::Matrix<double, D * D, D * D> second;
    derivatives(m_domain.jacobian(e, x), epsilon, first, second);
    const auto& v = m_domain.elements[e];
    Corners hats;
    hats.template bottomRows<D>() = m_domain.rest_inverses[e];
    hats.row(0) = -m_domain.rest_inverses[e].colwise().sum();
    const double weight = m_domain.measures[e];
    for(int i = 0; i <= D; ++i) {
      if(m_row[v[i]] < 0)
        continue;
      gradient.template segment<D>(Eigen::Index(D) * m_row[v[i]]) += weight * first * hats.row(i).transpose();
      for(int j = 0; j <= i; ++j) {
        if(m_row[v[j]] < 0)
          continue;
        // Entry (r, c): sum over a and b of hats(i, a) second(r + D a, c + D b) hats(j, b)
        Matrix block = Matrix::Zero();
        for(int a = 0; a < D; ++a)
          for(int b = 0; b < D; ++b)
            block += (weight * hats(i, a) * hats(j, b)) * second.template block<D, D>(D * a, D * b);
        const std::int32_t r = m_row[v[i]], c = m_row[v[j]];
        m_matrix.add_block(r, c, i == j ? 0 : m_matrix.slot(r, c), block);
      }
    }
  }

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  Foldover_free_options m_options;
  internal::Element_coloring m_schedule;
  internal::Unknowns m_row;
  bool m_has_fixed = false;
  Block_sparse_matrix m_matrix;
};

template <int D, typename Traits>
bool Foldover_free<D, Traits>::remove_flips(Positions<D>& x, Summary& summary)
{
  Positions<D> result = x;
  reduce_flips(result, summary);
  if(summary.status != Status::success)
    return false;
  x.swap(result);
  return true;
}

template <int D, typename Traits>
void Foldover_free<D, Traits>::reduce_flips(Positions<D>& x, Summary& summary)
{
  summary.status = Status::flips_remain;
  if(!m_options.is_valid(&summary.message)) {
    summary.status = Status::invalid_option;
    return;
  }
  const Deadline deadline(m_options.max_seconds);
  const internal::Improving_work work;
  typename Traits::Linear_solver linear_solver = m_traits.make_linear_solver();
  internal::Robust_solver<typename Traits::Linear_solver> solver(linear_solver);
  const auto reporting = solver.report_to(summary);
  std::string limit;
  summary.flips = flips(x);
  try {
    descend(solver, x, summary);
  } catch(const Interruption& interruption) {
    limit = std::string(interruption.what()) + ", and ";
  }
  if(summary.flips != 0) {
    summary.message = limit + std::to_string(summary.flips) + " elements are still flipped";
    return;
  }
  summary.status = Status::success;
  summary.message = "no element is flipped";
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Foldover_free<2>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_FOLDOVER_FREE_H
