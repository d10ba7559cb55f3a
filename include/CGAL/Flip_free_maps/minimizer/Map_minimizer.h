// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H

#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>
#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/concepts.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Handle_groups.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Renewed_factorization.h>
#include <CGAL/Flip_free_maps/minimizer/internal/characteristic_gradient.h>
#include <CGAL/Flip_free_maps/minimizer/internal/remove_rigid_motion.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/references/Fixed_reference.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <boost/concept_check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>

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
/// Complexity: per iteration one sparse factorization and solve of D times as many unknowns as there are vertices that are not
/// fixed, everything else linear in the number of elements. The pattern of the matrix is analysed once per object.
template <int D, typename Traits = Flip_free_map_traits<>>
class Map_minimizer
{
  BOOST_CONCEPT_ASSERT((MapTraitsConcept<Traits, D>));

  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Preconditioner = typename Traits::Preconditioner;

public:
  /// Keeps a reference to `domain`, which must outlive this object, and copies of the others.
  ///
  /// \param domain the rest shape
  /// \param traits the method and its settings
  /// \param constraints vertices that are fixed or pulled to places
  explicit Map_minimizer(const Simplicial_domain<D>& domain, const Traits& traits = Traits(),
                         const Position_constraints<D>& constraints = Position_constraints<D>())
    : m_domain(domain),
      m_traits(traits),
      m_objective(domain, m_traits.energy, m_traits.preconditioner),
      m_linear_solver(m_traits.make_linear_solver()),
      m_solver(m_linear_solver)
  {
    if(!constraints.is_valid(domain.number_of_vertices, &m_constraint_error))
      return;
    m_objective.fix(constraints.fixed_vertices);
    if(!constraints.soft_positions.empty())
      m_objective.add_term(std::make_shared<Soft_positions<D>>(constraints.soft_positions));
  }

  Map_minimizer(const Map_minimizer&) = delete;
  Map_minimizer& operator=(const Map_minimizer&) = delete;

  /// Minimises `term` along with the energy, from the next run on. The term may change between runs, except for its stencils.
  /// \pre Nothing was minimised yet.
  void add_term(std::shared_ptr<const Objective_term<D>> term) { m_objective.add_term(std::move(term)); }

  /// The settings; they may be changed between runs.
  Map_options& options() { return m_traits.options; }

  /// Analyses the pattern of the matrix, which the first run does otherwise. It needs no map, so it can be done at the same time
  /// as a start is made.
  ///
  /// \param summary times are added to it
  /// \returns whether the linear solver succeeded
  bool analyze(Summary& summary)
  {
    if(m_is_analyzed)
      return true;
    {
      const internal::Phase_timer timer(summary.seconds.assemble);
      m_objective.build_pattern();
    }
    m_solver.set_summary(summary);
    m_is_analyzed = m_objective.number_of_unknowns() == 0 || m_solver.analyze_pattern(m_objective.matrix());
    return m_is_analyzed;
  }

  /// Minimises, beginning at the positions `x`, in the domain's units of length.
  ///
  /// \param x the start, with a column for each vertex; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \returns what happened. The status is one of `success`, `iteration_limit`, `time_limit` and `stopped_by_observer`, or a
  ///   failure: `invalid_option`, `start_not_flip_free`, `linear_solver_failed`, `line_search_failed` or `out_of_memory`. No
  ///   exception is thrown but those of the observer.
  Summary minimize(Positions<D>& x)
  {
    Summary summary;
    minimize(x, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void minimize(Positions<D>& x, Summary& summary)
  {
    guarded(x, summary, [&](Run& run) {
      if(begin(run))
        iterate(run);
    });
  }

  /// Moves the fixed vertices of a map to other positions and minimises there. Where the other vertices cannot follow at once
  /// without a flip, the fixed vertices take as many steps as are needed, and the map is optimised a little after each.
  ///
  /// \param x a map without flips; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \param targets its columns of fixed vertices are where these go; others are not read
  /// \returns what happened: as `minimize()`, or `unreachable_constraints` when no path without flips was found
  Summary move_fixed_vertices(Positions<D>& x, const Positions<D>& targets)
  {
    Summary summary;
    move_fixed_vertices(x, targets, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void move_fixed_vertices(Positions<D>& x, const Positions<D>& targets, Summary& summary)
  {
    guarded(x, summary, [&](Run& run) {
      if(targets.cols() != m_domain.number_of_vertices) {
        finish(summary, Status::invalid_option, "the targets must have a column for each vertex");
        return;
      }
      if(begin(run) && analyze_or_fail(summary) && follow_handles(run, targets))
        iterate(run);
    });
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
    double energy = 0;                                                  // what is minimised in this iteration, measured on the reference
    double rest_energy = 0;                                             // the same, measured on the rest shape
    double relative_decrease = std::numeric_limits<double>::infinity(); // of the rest energy
    double model_ratio = std::numeric_limits<double>::quiet_NaN();
    double predicted_decrease = std::numeric_limits<double>::infinity(); // relative, by the full last step, as the model had it
    double gradient_norm = 0;
    double last_gradient_norm = 0; // before the last step
    double characteristic_gradient_norm = 0;
    double step = 0;
    double largest_step = 0;
    int small_decreases = 0;
    bool fresh = false; // the last direction was of second order with a matrix of its own
  };

  // The variables of one run.
  struct Run
  {
    Run(Positions<D>& positions, Summary& s) : x(positions), summary(s) {}

    Positions<D>& x;
    Summary& summary;
    Map_options options;
    Progress progress;
    double time_begin = 0;
    double characteristic_gradient = 0;
    double energy_of_isometry = 0;
    bool is_rest_reference = true;
    double shift = BASE_SHIFT;
    int retries = 0;
    int first_iteration = 0; // of this run, in the counts of the summary
    Eigen::VectorXd unknowns, gradient, direction;
    Positions<D> displacement, trial;
  };

  // Whatever happens inside, `x` changes only if the map is valid.
  template <typename Body>
  void guarded(Positions<D>& x, Summary& summary, Body&& body)
  {
    summary.vertices = m_domain.number_of_vertices;
    summary.elements = m_domain.number_of_elements();
    summary.energy_name = Traits::Energy::name();
    summary.preconditioner = Preconditioner::name();
    summary.reference = Traits::Reference::name();
    summary.acceleration = Traits::Acceleration::name();
    std::string message = m_constraint_error;
    if(!message.empty() || !m_traits.options.is_valid(&message)) {
      finish(summary, Status::invalid_option, message);
      return;
    }
    if(x.cols() != m_domain.number_of_vertices) {
      finish(summary, Status::invalid_option, "the start must have a column for each vertex");
      return;
    }
    try {
      Positions<D> result = x;
      Run run(result, summary);
      body(run);
      if(summary.is_valid())
        x = std::move(result);
    } catch(const std::bad_alloc&) {
      finish(summary, Status::out_of_memory, "memory was exhausted while minimizing");
    }
    summary.peak_memory_mb = internal::peak_memory_mb();
  }

  bool allows_flips() const { return m_traits.options.allow_flips && !internal::has_barrier(m_traits.energy); }

  // Checks the start and prepares what all iterations share.
  bool begin(Run& run)
  {
    Summary& summary = run.summary;
    run.options = m_traits.options;
    run.time_begin = internal::wall_seconds();
    run.first_iteration = summary.iterations;
    m_solver.set_summary(summary);
    {
      const internal::Phase_timer timer(summary.seconds.certify);
      summary.flips = run.x.allFinite() ? flips(run.x) : m_domain.number_of_elements();
    }
    const bool is_usable = summary.flips == 0 || (allows_flips() && run.x.allFinite());
    m_traits.reference.restart();
    run.is_rest_reference = !is_usable || m_traits.reference.update(m_domain, run.x);
    measure(run, is_usable);
    if(!is_usable || !std::isfinite(run.progress.energy)) {
      finish(summary, Status::start_not_flip_free, "the start has flipped or collapsed elements");
      return false;
    }
    summary.energy_initial = summary.energy = run.progress.rest_energy;
    summary.energy_of_terms = m_objective.energy_of_terms(run.x);
    run.characteristic_gradient = internal::characteristic_gradient(m_domain, m_traits.energy);
    run.energy_of_isometry = m_traits.energy.template value<D>(internal::Vector<D>::Ones());
    m_is_factorized = m_is_factorized && run.options.keep_factorization;
    if(m_is_factorized) {
      // To the refactorization rule a kept matrix is one that has served well so far.
      run.progress.step = 1;
      run.progress.relative_decrease = 0;
    }
    m_traits.acceleration.reset();
    return true;
  }

  bool analyze_or_fail(Summary& summary)
  {
    if(analyze(summary))
      return true;
    finish(summary, Status::linear_solver_failed, "the linear solver could not analyse the pattern of the matrix");
    return false;
  }

  // Energies at x after x or the reference changed.
  void measure(Run& run, bool is_usable = true) const
  {
    Progress& progress = run.progress;
    progress.energy = is_usable ? m_objective.energy(m_traits.reference, run.x) : 0;
    progress.rest_energy = run.is_rest_reference ? progress.energy : m_objective.energy(Fixed_reference(), run.x);
  }

  // Iterates until a rule ends the run, and says which in the summary.
  void iterate(Run& run)
  {
    while(iterate_once(run)) {}
    Summary& summary = run.summary;
    if(!summary.is_valid())
      return;
    summary.flips = allows_flips() ? flips(run.x) : 0;
    summary.energy_of_terms = m_objective.energy_of_terms(run.x);
    const std::pair<double, double> range = m_objective.singular_value_range(run.x);
    summary.min_singular_value = range.first;
    summary.max_singular_value = range.second;
  }

  // One iteration, or an attempt at one that failed and left a more careful matrix for the next. Returns whether to go on.
  bool iterate_once(Run& run)
  {
    Progress& progress = run.progress;
    Summary& summary = run.summary;
    if(run.retries == 0) {
      Iteration_state state;
      state.iteration = summary.iterations - run.first_iteration;
      state.relative_decrease = run.is_rest_reference ? progress.relative_decrease : m_traits.reference.relative_decrease();
      state.model_ratio = progress.model_ratio;
      state.distorted_fraction = [&](double bound) { return m_objective.distorted_fraction(run.x, bound); };
      internal::begin_iteration(m_traits.preconditioner, state);
    }
    Refactorization refactorization = m_is_factorized ? Refactorization::none : Refactorization::restart;
    if(m_is_factorized && !internal::is_constant(m_traits.preconditioner) && m_age > 0)
      refactorization = m_traits.refactorization_rule(m_age, progress.step, progress.relative_decrease);
    const bool with_matrix = refactorization != Refactorization::none;
    const bool assembles = with_matrix || multiplies_by_current_matrix();
    // A start may be the solution already; then no pattern is needed.
    differentiate(run, assembles && m_is_analyzed);
    if(run.retries == 0 && has_ended(run, with_matrix))
      return false;
    if(!m_is_analyzed) {
      if(!analyze_or_fail(summary))
        return false;
      differentiate(run, assembles);
    }

    if(with_matrix && !factorize(run)) {
      finish(summary, Status::linear_solver_failed, "no factorization succeeded, not even of a strongly shifted matrix");
      return false;
    }
    if(refactorization == Refactorization::restart)
      m_traits.acceleration.reset();
    if(assembles && !with_matrix)
      finish_matrix(run);
    renew(run);

    m_objective.gather(run.x, run.unknowns);
    const bool solved = m_traits.acceleration.direction(run.unknowns, run.gradient, Linear_algebra{*this}, run.direction);
    double slope = std::numeric_limits<double>::quiet_NaN();
    Line_search_result found;
    if(solved) {
      if(m_objective.is_rigid_motion_invariant())
        internal::remove_rigid_motion<D>(run.x, run.direction);
      slope = run.gradient.dot(run.direction);
      m_objective.spread(run.direction, run.displacement);
    }
    if(slope < 0)
      found = find_step(run, slope);
    if(!found.success)
      return recover(run, solved, slope);
    accept(run, found, slope);
    extrapolate(run);
    return true;
  }

  // Gradient, and the matrix if asked for.
  void differentiate(Run& run, bool with_matrix)
  {
    Progress& progress = run.progress;
    Summary& summary = run.summary;
    {
      const internal::Phase_timer timer(summary.seconds.assemble);
      m_objective.derivatives(m_traits.reference, run.x, with_matrix, run.gradient);
    }
    progress.gradient_norm = run.gradient.norm();
    progress.characteristic_gradient_norm = progress.gradient_norm / run.characteristic_gradient;
    summary.energy = progress.rest_energy;
    summary.gradient_norm = progress.gradient_norm;
    summary.characteristic_gradient_norm = progress.characteristic_gradient_norm;
  }

  // Asks the observer, the stopping rules and the limits, in this order. `factorizes`: whether to go on takes a factorization.
  bool has_ended(Run& run, bool factorizes)
  {
    Summary& summary = run.summary;
    const double seconds = internal::wall_seconds() - run.time_begin;
    if(run.options.observer && !run.options.observer(report(run, seconds))) {
      finish(summary, Status::stopped_by_observer, "the observer asked to stop");
      return true;
    }
    if(run.is_rest_reference && is_converged(run, factorizes))
      return true;
    if(summary.iterations - run.first_iteration >= run.options.max_iterations) {
      finish(summary, Status::iteration_limit, "the limit of iterations is reached");
      return true;
    }
    if(seconds >= run.options.max_seconds) {
      finish(summary, Status::time_limit, "the limit of time is reached");
      return true;
    }
    return false;
  }

  bool is_converged(Run& run, bool factorizes)
  {
    const Progress& progress = run.progress;
    const Map_options& options = run.options;
    const auto stop = [&run](const char* rule) {
      finish(run.summary, Status::success, rule);
      return true;
    };
    if(progress.energy <= options.target_energy)
      return stop("the target energy is reached");
    if(options.gradient_tolerance > 0 && progress.gradient_norm <= options.gradient_tolerance)
      return stop("the norm of the gradient is within its tolerance");
    if(progress.characteristic_gradient_norm <= options.characteristic_gradient_tolerance)
      return stop("the characteristic norm of the gradient is within its tolerance");
    if(run.summary.iterations == run.first_iteration || !(options.relative_energy_tolerance > 0) || !is_nearly_stationary(run))
      return false;
    const bool is_full_step = progress.fresh && progress.step >= 0.5;
    // A step that goes far beyond the minimum along its direction may decrease the energy by as little as one that ends the run.
    if(progress.relative_decrease <= options.relative_energy_tolerance &&
       (progress.small_decreases >= options.stagnation_iterations ||
        (is_full_step && progress.predicted_decrease <= MODEL_ERROR * options.relative_energy_tolerance)))
      return stop("the relative decrease of the energy is within its tolerance");
    if(is_full_step && factorizes && predicts_small_decrease(run, options.relative_energy_tolerance / MODEL_ERROR))
      return stop("the predicted relative decrease of the energy is within its tolerance");
    return false;
  }

  // Whether the model of the last step, with the gradient of now, predicts a relative decrease of at most `tolerance`: a solve
  // instead of the factorization of an iteration that would only confirm convergence.
  // The norms of the gradients say when it is worth it.
  bool predicts_small_decrease(Run& run, double tolerance)
  {
    const Progress& progress = run.progress;
    const double drop = progress.gradient_norm / progress.last_gradient_norm;
    if(!m_is_factorized || !(progress.predicted_decrease * drop * drop <= tolerance) || !m_solver.solve(run.gradient, run.direction))
      return false;
    return 0.5 * run.gradient.dot(run.direction) <= tolerance * std::abs(progress.energy);
  }

  // Where the energy is astronomical, by few elements that nearly collapse, small changes of it say nothing. Where it is not, a
  // large gradient says nothing: that of a needle is large as soon as it is not a perfect isometry.
  static bool is_nearly_stationary(const Run& run)
  {
    return run.progress.characteristic_gradient_norm <= 1 || run.progress.rest_energy <= run.energy_of_isometry + ASTRONOMICAL;
  }

  // Whether the acceleration needs a matrix that is not the one of the last factorization.
  bool multiplies_by_current_matrix() const
  {
    return internal::needs_current_matrix(m_traits.acceleration) && !internal::is_constant(m_traits.preconditioner);
  }

  // What accelerations are given.
  struct Linear_algebra
  {
    bool operator()(const Eigen::VectorXd& b, Eigen::VectorXd& y) const { return minimizer.solve(b, y); }

    void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& product) const
    {
      product.noalias() = minimizer.m_objective.matrix().lower().template selfadjointView<Eigen::Lower>() * p;
    }

    Map_minimizer& minimizer;
  };

  // Brings a factorization that is kept up to date where the map has changed most. It needs the matrix that was factorized.
  void renew(const Run& run)
  {
    if(m_age == 0 || !run.options.renew_factorization || internal::is_constant(m_traits.preconditioner) ||
       internal::needs_current_matrix(m_traits.acceleration))
      return;
    const internal::Phase_timer timer(run.summary.seconds.assemble);
    m_renewed.renew(m_objective, m_traits.reference, m_factorized_map, run.x);
  }

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& y)
  {
    return m_renewed.solve(
      b, [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) { return m_solver.solve(r, z); }, y);
  }

  bool factorize(Run& run)
  {
    m_is_factorized = true;
    m_age = 0;
    m_factorized_map = run.x;
    m_renewed.clear();
    finish_matrix(run);
    if(internal::can_retreat(m_traits.preconditioner)) {
      if(m_solver.try_to_factorize(m_objective.matrix()))
        return true;
      retreat(run);
      differentiate(run, true);
      finish_matrix(run);
    }
    return m_solver.factorize(m_objective.matrix(), run.shift);
  }

  // Takes the more careful form of a preconditioner that has one. `false` if it is in use already.
  bool retreat(Run& run)
  {
    if(!internal::can_retreat(m_traits.preconditioner))
      return false;
    internal::retreat(m_traits.preconditioner);
    ++run.summary.fallbacks;
    return true;
  }

  void finish_matrix(const Run& run)
  {
    Block_sparse_matrix& matrix = m_objective.matrix();
    if(run.options.tikhonov > 0)
      for(Block_sparse_matrix::Index i = 0; i < matrix.rows(); ++i)
        matrix.diagonal(i) += run.options.tikhonov;
    // Translations are in the null space of every preconditioner. Stiffness on one vertex removes them without changing the
    // solution, since the gradient is orthogonal to them.
    if(m_objective.is_rigid_motion_invariant())
      for(int i = 0; i < D; ++i)
        matrix.diagonal(i) *= 2;
  }

  // A step along the displacement after which no element is flipped. Leaves the new positions in `trial`.
  Line_search_result find_step(Run& run, double slope)
  {
    const internal::Phase_timer timer(run.summary.seconds.line_search);
    Line_search_result found;
    run.progress.largest_step =
      allows_flips() ? std::numeric_limits<double>::infinity() : m_objective.largest_step(run.x, run.displacement);
    double largest = run.progress.largest_step;
    // Long steps make up for a model that overestimates curvature, and do harm where it is right.
    Map_options options = run.options;
    options.begin_with_largest_step = options.begin_with_largest_step && !(run.progress.model_ratio <= TRUSTED_MODEL);
    // Rounding may leave an element of the accepted candidate collapsed or flipped although its energy was finite; then a
    // shorter step is searched.
    for(int i = 0; i < 10; ++i) {
      found = line_search(
        [&](double step) {
          run.trial = run.x + step * run.displacement;
          return m_objective.energy(m_traits.reference, run.trial);
        },
        run.progress.energy, slope, largest, run.options.extend_steps && m_traits.preconditioner.is_second_order, options);
      run.summary.energy_evaluations += found.evaluations;
      if(!found.success)
        break;
      run.trial = run.x + found.step * run.displacement;
      if(is_certified(run, run.trial))
        break;
      largest = found.step;
      found.success = false;
    }
    return found;
  }

  bool is_certified(Run& run, const Positions<D>& x) const
  {
    const internal::Phase_timer timer(run.summary.seconds.certify);
    return allows_flips() || (flips(x) == 0 && keeps_distance(run.x, x));
  }

  bool has_barrier() const { return internal::has_barrier(m_traits.energy); }

  // Energies without a barrier draw elements into their collapse. So close to it that the result would not bear being scaled they
  // come no closer.
  bool keeps_distance(const Positions<D>& before, const Positions<D>& after) const
  {
    if(has_barrier())
      return true;
    const double distance = m_objective.singular_value_range(after).first;
    return distance >= COLLAPSED || distance >= m_objective.singular_value_range(before).first;
  }

  bool is_element_certified(std::int64_t e, const Positions<D>& x) const
  {
    return internal::is_positively_oriented<Kernel>(m_domain.elements[e], x) &&
           (has_barrier() || internal::signed_singular_values(m_domain.jacobian(e, x))[D - 1] >= COLLAPSED);
  }

  // After an attempt that led nowhere: ends the run, or asks for a fresh matrix,
  // then for one that is shifted towards its diagonal.
  bool recover(Run& run, bool solved, double slope)
  {
    // A stationary map has no direction of descent beyond rounding.
    if(std::abs(slope) <= 1e-12 * std::abs(run.progress.energy) && run.is_rest_reference && is_nearly_stationary(run)) {
      finish(run.summary, Status::success, "the predicted decrease of the energy is below rounding");
      return false;
    }
    if(m_age == 0 && retreat(run)) {
      ++run.retries;
      m_is_factorized = false;
      return true;
    }
    if(run.retries >= MAX_RETRIES && !solved) {
      finish(run.summary, Status::linear_solver_failed, "the linear solver found no direction");
      return false;
    }
    if(run.retries >= MAX_RETRIES && !has_barrier() && !allows_flips()) {
      finish(run.summary, Status::iteration_limit,
             "elements are about to collapse, which this energy does not prevent, and hold up all steps");
      return false;
    }
    if(run.retries >= MAX_RETRIES) {
      finish(run.summary, Status::line_search_failed, "no step decreases the energy, although the gradient does not vanish");
      return false;
    }
    if(run.retries > 0 || m_age == 0)
      run.shift = (std::max)(1e-6, 100 * run.shift);
    ++run.retries;
    m_is_factorized = false;
    return true;
  }

  void accept(Run& run, Line_search_result found, double slope)
  {
    Progress& progress = run.progress;
    if(run.options.free_blocked_vertices && found.step < THROTTLED && found.step >= 0.5 * progress.largest_step) {
      const internal::Phase_timer timer(run.summary.seconds.line_search);
      m_objective.free_blocked_vertices(
        m_traits.reference, run.displacement, BLOCKED * progress.largest_step,
        [this](std::int64_t e, const Positions<D>& y) { return is_element_certified(e, y); }, run.trial);
      found.energy = m_objective.energy(m_traits.reference, run.trial);
    }
    progress.fresh = m_age == 0 && m_traits.preconditioner.is_second_order;
    progress.step = found.step;
    // The quadratic model along the direction is slope a + curvature a^2 / 2 with curvature -slope.
    const double predicted = -slope * found.step * (1 - 0.5 * found.step);
    progress.model_ratio =
      progress.fresh && predicted > 0 ? (progress.energy - found.energy) / predicted : std::numeric_limits<double>::quiet_NaN();
    progress.predicted_decrease = -0.5 * slope / std::abs(progress.energy);
    progress.last_gradient_norm = progress.gradient_norm;
    const double previous = progress.rest_energy;
    run.x.swap(run.trial);
    ++run.summary.iterations;
    ++m_age;
    run.retries = 0;
    run.shift = BASE_SHIFT;
    if(run.is_rest_reference) {
      progress.energy = progress.rest_energy = found.energy;
    } else {
      run.is_rest_reference = m_traits.reference.update(m_domain, run.x);
      measure(run);
      m_is_factorized = false;
    }
    progress.relative_decrease = (previous - progress.rest_energy) / std::abs(progress.rest_energy);
    const bool is_small = run.is_rest_reference && progress.relative_decrease <= run.options.relative_energy_tolerance;
    progress.small_decreases = is_small ? progress.small_decreases + 1 : 0;
  }

  // Goes on along the last step if the acceleration wants it.
  void extrapolate(Run& run)
  {
    if constexpr(internal::Has_extrapolate<typename Traits::Acceleration>::value) {
      m_objective.gather(run.x, run.unknowns);
      if(!run.is_rest_reference || !m_traits.acceleration.extrapolate(run.unknowns, run.direction))
        return;
      const internal::Phase_timer timer(run.summary.seconds.line_search);
      m_objective.spread(run.direction, run.displacement);
      const double largest = allows_flips() ? std::numeric_limits<double>::infinity() : m_objective.largest_step(run.x, run.displacement);
      run.trial = run.x + (std::min)(1., run.options.step_fraction * largest) * run.displacement;
      const double energy = m_objective.energy(m_traits.reference, run.trial);
      ++run.summary.energy_evaluations;
      const double before = run.progress.energy * (1 + (std::max)(0., run.progress.relative_decrease));
      if(!(energy <= before) || !is_certified(run, run.trial)) {
        m_traits.acceleration.reset();
        return;
      }
      run.x.swap(run.trial);
      run.progress.energy = run.progress.rest_energy = energy;
    }
  }

  // Leads the fixed vertices to their targets. In each round the quadratic model is minimised with the fixed vertices at their
  // targets, or part of the way to them; the map goes in that direction half as far as it could without a flip,
  // and is then optimised a little.
  bool follow_handles(Run& run, const Positions<D>& targets)
  {
    Summary& summary = run.summary;
    const Map_options options = run.options;
    const internal::Handle_groups<D> groups(m_domain, [this](std::int32_t v) { return m_objective.is_fixed(v); });
    if(groups.carry(run.x, targets, run.trial) && is_certified(run, run.trial)) {
      run.x.swap(run.trial);
      measure(run);
      m_is_factorized = false;
    }
    for(int round = 0; round < MAX_ROUNDS; ++round) {
      bool is_last = false;
      Positions<D> handles = Positions<D>::Zero(D, run.x.cols());
      if(!groups.next_displacement(run.x, targets, handles, is_last)) {
        finish(summary, Status::non_finite_input, "a target is NaN or infinite");
        return false;
      }
      if((handles.array() == 0).all()) {
        run.options = options;
        summary.flips = 0;
        return true;
      }
      const bool reuses = m_is_factorized && round == 0 && options.keep_factorization;
      if(!find_drag(run, handles, reuses)) {
        finish(summary, Status::linear_solver_failed, "no direction was found while the fixed vertices moved");
        return false;
      }
      const double largest = allows_flips() ? std::numeric_limits<double>::infinity() : m_objective.largest_step(run.x, run.displacement);
      double step = 0.5 * largest >= 1 ? 1 : 0.5 * largest;
      for(;; step *= 0.5) {
        run.trial = run.x + step * run.displacement;
        // The vertices arrive exactly.
        if(step == 1 && is_last)
          groups.place(targets, run.trial);
        if(std::isfinite(m_objective.energy(m_traits.reference, run.trial)) && is_certified(run, run.trial))
          break;
        if(step < SHORTEST_ROUND) {
          finish(summary, Status::unreachable_constraints, "no path without flips leads to the positions of the fixed vertices");
          return false;
        }
      }
      run.x.swap(run.trial);
      measure(run);
      // The matrix is one of an earlier map now.
      m_is_factorized = reuses;
      m_age = (std::max)(m_age, 1);
      if(step == 1 && is_last)
        continue;
      run.options = options;
      run.options.max_iterations = summary.iterations - run.first_iteration + STEPS_PER_ROUND;
      run.options.relative_energy_tolerance = 0.01;
      run.progress.relative_decrease = std::numeric_limits<double>::infinity();
      run.progress.small_decreases = 0;
      run.retries = 0;
      m_is_factorized = false;
      while(iterate_once(run)) {}
      if(summary.status == Status::stopped_by_observer || summary.status == Status::time_limit || !summary.is_valid()) {
        if(summary.status != Status::linear_solver_failed)
          finish(summary, Status::unreachable_constraints,
                 "the run ended before the fixed vertices reached their positions: " + std::string(summary.message));
        return false;
      }
    }
    finish(summary, Status::unreachable_constraints,
           "the fixed vertices did not reach their positions in " + std::to_string(MAX_ROUNDS) + " rounds");
    return false;
  }

  // The displacement of all vertices that minimises the quadratic model when the fixed vertices are displaced by `handles`.
  bool find_drag(Run& run, const Positions<D>& handles, bool reuses)
  {
    if(m_objective.number_of_unknowns() == 0) {
      run.displacement = handles;
      return true;
    }
    Eigen::VectorXd product;
    m_objective.multiply(m_traits.reference, run.x, handles, product);
    differentiate(run, !reuses);
    if((!reuses && !factorize(run)) || !m_solver.solve(Eigen::VectorXd(run.gradient + product), run.direction))
      return false;
    m_objective.spread(-run.direction, run.displacement);
    run.displacement += handles;
    return true;
  }

  Iteration_report report(const Run& run, double seconds) const
  {
    Iteration_report report;
    report.iteration = run.summary.iterations;
    report.seconds = seconds;
    report.energy = run.progress.rest_energy;
    report.gradient_norm = run.progress.gradient_norm;
    report.characteristic_gradient_norm = run.progress.characteristic_gradient_norm;
    report.step = run.progress.step;
    report.largest_step = run.progress.largest_step;
    report.factorizations = run.summary.factorizations;
    report.flips = allows_flips() ? flips(run.x) : 0;
    return report;
  }

  std::int64_t flips(const Positions<D>& x) const { return internal::count_flips<Kernel, Tag>(m_domain, m_objective.schedule(), x); }

  // Relative stiffness on the diagonal for the rotations, which are in the null space of some preconditioners.
  static constexpr double BASE_SHIFT = 1e-9;
  static constexpr int MAX_RETRIES = 5;
  // Smallest singular value of elements where no barrier keeps them from collapsing.
  static constexpr double COLLAPSED = 1e-6;
  // A step below THROTTLED that ends at a collapsing element frees the elements that collapse within BLOCKED times its bound.
  static constexpr double THROTTLED = 0.3;
  static constexpr double BLOCKED = 4;
  // Mean energy above that of an isometry from which on a few elements make up most of it.
  static constexpr double ASTRONOMICAL = 10;
  // Decrease of the energy over the predicted one up to which the quadratic model counts as right.
  static constexpr double TRUSTED_MODEL = 1.1;
  // Preconditioners overestimate curvature, and decreases are predicted too small by such a factor.
  static constexpr double MODEL_ERROR = 10;
  // Of the way of fixed vertices to their targets: rounds, iterations between them, and the shortest part of the rest of the way.
  static constexpr int MAX_ROUNDS = 300;
  static constexpr int STEPS_PER_ROUND = 4;
  static constexpr double SHORTEST_ROUND = 1e-8;

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  internal::Map_objective<D, Traits> m_objective;
  typename Traits::Linear_solver m_linear_solver;
  internal::Robust_solver<typename Traits::Linear_solver> m_solver;
  internal::Renewed_factorization<D> m_renewed;
  Positions<D> m_factorized_map;
  std::string m_constraint_error;
  bool m_is_analyzed = false;
  bool m_is_factorized = false;
  int m_age = 0; // accepted steps since the last factorization
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H
