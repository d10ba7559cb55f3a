// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MAP_MINIMIZER_H
#define CGAL_FLIP_FREE_MAPS_MAP_MINIMIZER_H

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/Map_options.h>
#include <CGAL/Flip_free_maps/Summary.h>
#include <CGAL/Flip_free_maps/concepts.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/characteristic_gradient.h>
#include <CGAL/Flip_free_maps/internal/count_flips.h>
#include <CGAL/Flip_free_maps/internal/remove_rigid_motion.h>
#include <CGAL/Flip_free_maps/line_search/Line_search.h>

#include <boost/concept_check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Minimises the mean distortion energy of a map without ever flipping an element. Each iteration finds a direction by
/// solving with the preconditioner's matrix, follows it no further than 0.95 of the way to the first collapse of an element,
/// with sufficient decrease, and accepts the result only when exact predicates find every element positively oriented.
///
/// \tparam D dimension, 2 or 3
/// \tparam Traits must be a model of `MapTraits`
///
/// Complexity: per iteration one sparse factorization and solve of D |V| unknowns, everything else linear in the number of elements.
/// The pattern of the matrix is analysed once per object.
template <int D, typename Traits = Flip_free_map_traits<>>
class Map_minimizer
{
  BOOST_CONCEPT_ASSERT((MapTraitsConcept<Traits, D>));

  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Preconditioner = typename Traits::Preconditioner;

  static constexpr bool IS_CONSTANT = std::is_same<typename Preconditioner::Category, Constant_matrix_tag>::value;

public:
  /// Keeps a reference to `domain`, which must outlive this object, and a copy of `traits`.
  explicit Map_minimizer(const Simplicial_domain<D>& domain, const Traits& traits = Traits())
    : m_domain(domain), m_traits(traits), m_objective(domain, m_traits.energy, m_traits.preconditioner)
  {}

  Map_minimizer(const Map_minimizer&) = delete;
  Map_minimizer& operator=(const Map_minimizer&) = delete;

  /// Minimises, beginning at the positions `x`, in the domain's units of length.
  ///
  /// \param x the start, with a column for each vertex; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \returns what happened. The status is one of `success`, `iteration_limit`, `time_limit` and `stopped_by_observer`, or a failure:
  ///   `invalid_option`, `start_not_flip_free`, `linear_solver_failed`, `line_search_failed` or `out_of_memory`. No exception
  ///   is thrown but those of the observer.
  Summary minimize(Positions<D>& x)
  {
    Summary summary;
    minimize(x, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void minimize(Positions<D>& x, Summary& summary)
  {
    summary.vertices = m_domain.number_of_vertices;
    summary.elements = m_domain.number_of_elements();
    summary.energy_name = Traits::Energy::name();
    summary.preconditioner = Preconditioner::name();
    std::string message;
    if(!m_traits.options.is_valid(&message)) {
      finish(summary, Status::invalid_option, message);
      return;
    }
    if(x.cols() != m_domain.number_of_vertices) {
      finish(summary, Status::invalid_option, "the start must have a column for each vertex");
      return;
    }
    try {
      Positions<D> result = x;
      run(result, summary);
      if(summary.is_valid())
        x = std::move(result);
    } catch(const std::bad_alloc&) {
      finish(summary, Status::out_of_memory, "memory was exhausted while minimizing");
    }
    summary.peak_memory_mb = internal::peak_memory_mb();
  }

private:
  static void finish(Summary& summary, Status status, const std::string& message)
  {
    summary.status = status;
    summary.message = message;
  }

  // What the stopping rules look at.
  struct Progress
  {
    double energy = 0;
    double relative_decrease = std::numeric_limits<double>::infinity();
    double gradient_norm = 0;
    double characteristic_gradient_norm = 0;
    double step = 0;
    double largest_step = 0;
    int small_decreases = 0;
    bool fresh = false; // the last direction was of second order with a matrix of its own
  };

  bool is_converged(const Progress& progress, bool first, Summary& summary) const
  {
    const Map_options& options = m_traits.options;
    const auto stop = [&summary](const char* rule) {
      finish(summary, Status::success, rule);
      return true;
    };
    if(progress.energy <= options.target_energy)
      return stop("the target energy is reached");
    if(options.gradient_tolerance > 0 && progress.gradient_norm <= options.gradient_tolerance)
      return stop("the norm of the gradient is within its tolerance");
    if(progress.characteristic_gradient_norm <= options.characteristic_gradient_tolerance)
      return stop("the characteristic norm of the gradient is within its tolerance");
    if(!first && options.relative_energy_tolerance > 0 && progress.relative_decrease <= options.relative_energy_tolerance &&
       (progress.small_decreases >= options.stagnation_iterations || (progress.fresh && progress.step >= 0.5)))
      return stop("the relative decrease of the energy is within its tolerance");
    return false;
  }

  void run(Positions<D>& x, Summary& summary)
  {
    const Map_options& options = m_traits.options;
    typename Traits::Linear_solver linear_solver = m_traits.make_linear_solver();
    internal::Robust_solver<typename Traits::Linear_solver> solver(linear_solver, summary);
    const double time_begin = internal::wall_seconds();

    Progress progress;
    bool is_rest_reference = m_traits.reference.update(m_domain, x);
    {
      const internal::Phase_timer timer(summary.seconds.certify);
      summary.flips = x.allFinite() ? flips(x) : m_domain.number_of_elements();
    }
    progress.energy = summary.flips == 0 ? m_objective.energy(m_traits.reference, x) : 0;
    if(summary.flips != 0 || !std::isfinite(progress.energy)) {
      finish(summary, Status::start_not_flip_free, "the start has flipped or collapsed elements");
      return;
    }
    summary.energy_initial = summary.energy = progress.energy;
    {
      const internal::Phase_timer timer(summary.seconds.assemble);
      m_objective.build_pattern();
    }
    if(!solver.analyze_pattern(m_objective.matrix())) {
      finish(summary, Status::linear_solver_failed, "the linear solver could not analyse the pattern of the matrix");
      return;
    }
    const double characteristic_gradient = internal::characteristic_gradient(m_domain, m_traits.energy);

    Eigen::VectorXd gradient, direction;
    Positions<D> trial(D, x.cols());
    int age = 0; // accepted steps since the last factorization
    bool is_factorized = false;
    double shift = BASE_SHIFT;
    int retries = 0;
    for(;;) {
      Refactorization refactorization = is_factorized ? Refactorization::none : Refactorization::restart;
      if(is_factorized && !IS_CONSTANT && age > 0)
        refactorization = m_traits.refactorization_rule(age, progress.step, progress.relative_decrease);
      const bool with_matrix = refactorization != Refactorization::none;
      {
        const internal::Phase_timer timer(summary.seconds.assemble);
        m_objective.derivatives(m_traits.reference, x, with_matrix, gradient);
      }
      progress.gradient_norm = gradient.norm();
      progress.characteristic_gradient_norm = progress.gradient_norm / characteristic_gradient;
      summary.energy = progress.energy;
      summary.gradient_norm = progress.gradient_norm;
      summary.characteristic_gradient_norm = progress.characteristic_gradient_norm;

      if(retries == 0) {
        if(options.observer && !options.observer(report(progress, summary, internal::wall_seconds() - time_begin))) {
          finish(summary, Status::stopped_by_observer, "the observer asked to stop");
          break;
        }
        if(is_rest_reference && is_converged(progress, summary.iterations == 0, summary))
          break;
        if(summary.iterations >= options.max_iterations) {
          finish(summary, Status::iteration_limit, "the limit of iterations is reached");
          break;
        }
        if(internal::wall_seconds() - time_begin >= options.max_seconds) {
          finish(summary, Status::time_limit, "the limit of time is reached");
          break;
        }
      }

      if(with_matrix) {
        anchor(m_objective.matrix());
        if(!solver.factorize(m_objective.matrix(), shift)) {
          finish(summary, Status::linear_solver_failed, "no factorization succeeded, not even of a strongly shifted matrix");
          break;
        }
        is_factorized = true;
        age = 0;
        if(refactorization == Refactorization::restart)
          m_traits.acceleration.reset();
      }

      const Eigen::Map<const Eigen::VectorXd> flat_x(x.data(), x.size());
      const bool solved = m_traits.acceleration.direction(
        flat_x, gradient, [&solver](const Eigen::VectorXd& b, Eigen::VectorXd& y) { return solver.solve(b, y); }, direction);
      double slope = std::numeric_limits<double>::quiet_NaN();
      Line_search_result found;
      if(solved) {
        internal::remove_rigid_motion<D>(x, direction);
        slope = gradient.dot(direction);
      }
      if(slope < 0) {
        const internal::Phase_timer timer(summary.seconds.line_search);
        const Eigen::Map<const Positions<D>> d(direction.data(), D, x.cols());
        progress.largest_step = m_objective.largest_step(x, d);
        double largest = progress.largest_step;
        // Rounding may leave an element of the accepted candidate collapsed or flipped although its energy was finite; then a
        // shorter step is searched.
        for(int i = 0; i < 10; ++i) {
          found = line_search(
            [&](double step) {
              trial = x + step * d;
              return m_objective.energy(m_traits.reference, trial);
            },
            progress.energy, slope, largest, options.extend_steps && Preconditioner::is_second_order, options);
          summary.energy_evaluations += found.evaluations;
          if(!found.success)
            break;
          trial = x + found.step * d;
          const internal::Phase_timer certify_timer(summary.seconds.certify);
          if(flips(trial) == 0)
            break;
          largest = found.step;
          found.success = false;
        }
      }

      if(!found.success) {
        // A stationary map has no direction of descent beyond rounding.
        if(std::abs(slope) <= 1e-12 * std::abs(progress.energy) && is_rest_reference) {
          finish(summary, Status::success, "the predicted decrease of the energy is below rounding");
          break;
        }
        if(retries >= MAX_RETRIES && !solved) {
          finish(summary, Status::linear_solver_failed, "the linear solver found no direction");
          break;
        }
        if(retries >= MAX_RETRIES) {
          finish(summary, Status::line_search_failed, "no step decreases the energy, although the gradient does not vanish");
          break;
        }
        // An old matrix is replaced by a fresh one first; then the matrix is shifted towards its diagonal.
        if(retries > 0 || age == 0)
          shift = (std::max)(1e-6, 100 * shift);
        ++retries;
        is_factorized = false;
        continue;
      }

      if(options.free_blocked_vertices && found.step < THROTTLED && found.step >= 0.5 * progress.largest_step) {
        const internal::Phase_timer timer(summary.seconds.line_search);
        const Eigen::Map<const Positions<D>> d(direction.data(), D, x.cols());
        m_objective.free_blocked_vertices(
          m_traits.reference, d, BLOCKED * progress.largest_step,
          [this](std::int64_t e, const Positions<D>& y) { return internal::is_positively_oriented<Kernel>(m_domain.elements[e], y); },
          trial);
        found.energy = m_objective.energy(m_traits.reference, trial);
      }

      progress.fresh = age == 0 && Preconditioner::is_second_order;
      progress.step = found.step;
      progress.relative_decrease = (progress.energy - found.energy) / std::abs(found.energy);
      progress.small_decreases = progress.relative_decrease <= options.relative_energy_tolerance ? progress.small_decreases + 1 : 0;
      progress.energy = found.energy;
      x.swap(trial);
      ++summary.iterations;
      ++age;
      retries = 0;
      shift = BASE_SHIFT;
      is_rest_reference = m_traits.reference.update(m_domain, x);
    }

    summary.flips = 0;
    const std::pair<double, double> range = m_objective.singular_value_range(x);
    summary.min_singular_value = range.first;
    summary.max_singular_value = range.second;
  }

  Iteration_report report(const Progress& progress, const Summary& summary, double seconds) const
  {
    Iteration_report report;
    report.iteration = summary.iterations;
    report.seconds = seconds;
    report.energy = progress.energy;
    report.gradient_norm = progress.gradient_norm;
    report.characteristic_gradient_norm = progress.characteristic_gradient_norm;
    report.step = progress.step;
    report.largest_step = progress.largest_step;
    report.factorizations = summary.factorizations;
    return report;
  }

  std::int64_t flips(const Positions<D>& x) const
  {
    return internal::count_flips<Kernel, Tag>(m_domain, m_objective.schedule(), x);
  }

  // Translations are in the null space of every preconditioner. Stiffness on one vertex removes them without changing the solution,
  // since the gradient is orthogonal to them.
  static void anchor(Block_sparse_matrix& matrix)
  {
    for(int i = 0; i < D; ++i)
      matrix.diagonal(i) *= 2;
  }

  // Relative stiffness on the diagonal for the rotations, which are in the null space of some preconditioners.
  static constexpr double BASE_SHIFT = 1e-9;
  static constexpr int MAX_RETRIES = 5;
  // A step below THROTTLED that ends at a collapsing element frees the elements that collapse within BLOCKED times its bound.
  static constexpr double THROTTLED = 0.3;
  static constexpr double BLOCKED = 4;

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  internal::Map_objective<D, Traits> m_objective;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MAP_MINIMIZER_H
