// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H

#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/accelerations/internal/acceleration_traits.h>
#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/concepts.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Convergence_test.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Current_factorization.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Handle_path.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Step_finder.h>
#include <CGAL/Flip_free_maps/minimizer/internal/characteristic_gradient.h>
#include <CGAL/Flip_free_maps/minimizer/internal/remove_rigid_motion.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/references/Fixed_reference.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/worlds/internal/world_traits.h>

#include <CGAL/Default.h>

#include <boost/concept_check.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <tuple>
#include <type_traits>
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
  /// \param constraints vertices that are fixed, pulled to places, or slide
  explicit Map_minimizer(const Simplicial_domain<D>& domain, const Traits& traits = Traits(),
                         const Position_constraints<D>& constraints = Position_constraints<D>());

  Map_minimizer(const Map_minimizer&) = delete;
  Map_minimizer& operator=(const Map_minimizer&) = delete;

  /// Minimises `term` along with the energy, from the next run on, which analyses the pattern of the matrix anew. The term may
  /// change between runs, except for its stencils.
  void add_term(std::shared_ptr<const Objective_term<D>> term)
  {
    if(term == nullptr)
      return;
    m_objective.add_term(std::move(term));
    m_factorization.forget_pattern();
  }

  /// The settings; they may be changed between runs.
  Map_options& options() { return m_traits.options; }

  /// Analyses the pattern of the matrix, which the first run does otherwise. It needs no map, so it can be done at the same time
  /// as a start is made.
  ///
  /// \param summary times are added to it
  /// \returns whether the linear solver succeeded, in time
  bool analyze(Summary& summary);

  /// Minimises, beginning at the positions `x`, in the domain's units of length.
  ///
  /// \param x the start, with a column for each vertex; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \returns what happened. The status is one of `success`, `iteration_limit`, `time_limit` and `stopped_by_observer`, or a
  ///   failure: `invalid_option` (also of a term whose matrix has blocks outside its stencils), `start_not_flip_free`,
  ///   `linear_solver_failed`, `line_search_failed`, `out_of_memory`, or `flips_remain` if predicates contradict themselves. No
  ///   exception is thrown but those of the observer.
  Summary minimize(Positions<D>& x)
  {
    Summary summary;
    minimize(x, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void minimize(Positions<D>& x, Summary& summary);

  /// Moves the fixed vertices of a map to other positions and minimises there. Where the other vertices cannot follow at once
  /// without a flip, the fixed vertices take as many steps as are needed, and the map is optimised a little after each.
  ///
  /// \param x a map without flips; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \param targets its columns of fixed vertices are where these go; others are not read
  /// \returns what happened: as `minimize()`, or `unreachable_constraints` when no path without flips was found. When time or the
  ///   observer ends the run on the way, the fixed vertices are where they have got to, and the message says so.
  Summary move_fixed_vertices(Positions<D>& x, const Positions<D>& targets)
  {
    Summary summary;
    move_fixed_vertices(x, targets, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void move_fixed_vertices(Positions<D>& x, const Positions<D>& targets, Summary& summary);

private:
  using Run = internal::Minimizer_run<D>;
  using World = typename internal::World_of<Traits>::type;

  const World& world() const { return m_objective.world(); }

  // What the minimiser cannot do with a part of the mesh, null if nothing of it is asked for.
  const char* refusal_by_world() const
  {
    if constexpr(!World::is_sequential) {
      if(!std::is_same<typename Traits::Reference, Fixed_reference>::value)
        return "references other than the rest shape are for one process";
      if(m_objective.has_terms())
        return "terms beside the energy of the elements are for one process";
      if(m_objective.has_sliding_vertices())
        return "sliding vertices are for one process";
      if(m_traits.options.free_blocked_vertices)
        return "vertices are moved one by one in one process only: Map_options::free_blocked_vertices has to be false";
      if(m_traits.options.renew_factorization)
        return "factorizations are renewed in one process only: Map_options::renew_factorization has to be false";
    }
    return nullptr;
  }

  // Whatever happens inside, `x` changes only if the map is valid.
  template <typename Body>
  void guarded(Positions<D>& x, Summary& summary, Body&& body)
  {
    summary.dimension = D;
    summary.energy_name = Traits::Energy::name();
    summary.preconditioner = Preconditioner::name();
    summary.reference = Traits::Reference::name();
    summary.acceleration = Traits::Acceleration::name();
    try {
      world().together([&] { run_guarded(x, summary, body); });
    } catch(const std::bad_alloc&) {
      summary.status = Status::out_of_memory;
      summary.message = "memory was exhausted while minimizing";
    }
    summary.peak_memory_mb = internal::peak_memory_mb();
  }

  template <typename Body>
  void run_guarded(Positions<D>& x, Summary& summary, Body&& body)
  {
    summary.vertices = static_cast<std::int64_t>(world().sum(world().owned_vertices(m_domain.number_of_vertices)));
    summary.elements = static_cast<std::int64_t>(m_objective.number_of_elements());
    Positions<D> result = x;
    Run run(result, summary);
    std::string message = m_constraint_error;
    if(!message.empty() || !m_traits.options.is_valid(&message)) {
      run.finish(Status::invalid_option, message);
      return;
    }
    if(const char* refusal = refusal_by_world(); refusal != nullptr) {
      run.finish(Status::invalid_option, refusal);
      return;
    }
    if(D != 2 && internal::is_planar(m_traits.preconditioner)) {
      run.finish(Status::invalid_option, "the preconditioner is one of the plane only");
      return;
    }
    if(x.cols() != m_domain.number_of_vertices) {
      run.finish(Status::invalid_option, "the start must have a column for each vertex");
      return;
    }
    const Deadline deadline(m_traits.options.max_seconds);
    const auto reporting = m_factorization.report_to(summary);
    try {
      world().together([&] { body(run); });
    } catch(const Interruption& interruption) {
      interrupt(run, interruption);
    }
    if(summary.is_valid())
      x = std::move(result);
  }

  // Checks the start and prepares what all iterations share.
  bool begin(Run& run)
  {
    Summary& summary = run.summary;
    run.options = m_traits.options;
    run.time_begin = internal::wall_seconds();
    run.first_iteration = summary.iterations;
    const bool is_finite = !world().any(!run.x.allFinite());
    {
      const internal::Phase_timer timer(summary.seconds.certify);
      summary.flips = is_finite ? m_steps.flips(run.x) : summary.elements;
    }
    const bool is_usable = summary.flips == 0 || (m_steps.allows_flips() && is_finite);
    m_traits.reference.restart();
    run.is_rest_reference = !is_usable || m_traits.reference.update(m_domain, run.x);
    if(is_usable)
      run.measure(m_objective, m_traits.reference);
    if(!is_usable || !std::isfinite(run.progress.energy))
      return run.finish(Status::start_not_flip_free, "the start has flipped or collapsed elements");
    summary.energy_initial = summary.energy = run.progress.rest_energy;
    summary.energy_of_terms = m_objective.energy_of_terms(run.x);
    run.characteristic_gradient = internal::characteristic_gradient(m_domain, m_traits.energy, world());
    run.energy_of_isometry = m_traits.energy.template value<D>(internal::Vector<D>::Ones());
    if(!run.options.keep_factorization)
      m_factorization.discard();
    if(m_factorization.exists()) {
      // To the refactorization rule a kept matrix is one that has served well so far.
      run.progress.step = 1;
      run.progress.relative_decrease = 0;
    }
    m_traits.acceleration.reset();
    return true;
  }

  // Keeps the last map that was accepted. What was being made of it is unfinished.
  void interrupt(Run& run, const Interruption& interruption)
  {
    m_factorization.discard();
    run.measure(m_objective, m_traits.reference);
    run.summary.energy = run.progress.rest_energy;
    run.finish(interruption.status(), interruption.what());
    conclude(run);
  }

  bool analyze_or_fail(Run& run)
  {
    return m_factorization.analyze(run.summary) ||
           run.finish(Status::linear_solver_failed, "the linear solver could not analyse the pattern of the matrix");
  }

  // Iterates until a rule ends the run, and says which in the summary.
  void iterate(Run& run)
  {
    while(iterate_once(run)) {}
    conclude(run);
  }

  // Measures the result, if there is one.
  void conclude(Run& run)
  {
    Summary& summary = run.summary;
    if(!summary.is_valid())
      return;
    const internal::Unbound_work work;
    {
      const internal::Phase_timer timer(summary.seconds.certify);
      summary.flips = m_steps.flips(run.x);
    }
    if(summary.flips > 0 && !m_steps.allows_flips()) {
      run.finish(Status::flips_remain, "the predicates contradict themselves: elements of a certified map are flipped");
      return;
    }
    summary.energy_of_terms = m_objective.energy_of_terms(run.x);
    std::tie(summary.min_singular_value, summary.max_singular_value) = m_objective.singular_value_range(run.x);
  }

  // One iteration, or an attempt at one that failed and left a more careful matrix for the next. Returns whether to go on.
  bool iterate_once(Run& run)
  {
    if(run.retries == 0)
      tell_preconditioner(run);
    const Refactorization refactorization = m_factorization.next(run.progress);
    if(!prepare_matrix(run, refactorization))
      return false;

    double slope = std::numeric_limits<double>::quiet_NaN();
    const bool solved = find_direction(run, slope);
    Line_search_result found;
    if(slope < 0)
      found = m_steps(run, slope);
    if(!found.success)
      return recover(run, solved, slope);
    accept(run, found, slope);
    extrapolate(run);
    return true;
  }

  void tell_preconditioner(const Run& run)
  {
    Iteration_state state;
    state.iteration = run.iterations();
    state.relative_decrease = run.is_rest_reference ? run.progress.relative_decrease : m_traits.reference.relative_decrease();
    state.model_ratio = run.progress.model_ratio;
    state.distorted_fraction = [&](double bound) { return m_objective.distorted_fraction(run.x, bound); };
    internal::begin_iteration(m_traits.preconditioner, state);
  }

  // The gradient and what is needed to solve with the matrix. `false` if the run has ended, be it well.
  bool prepare_matrix(Run& run, Refactorization refactorization)
  {
    const bool factorizes = refactorization != Refactorization::none;
    const bool assembles = factorizes || m_factorization.multiplies_by_current_matrix();
    // A start may be the solution already; then no pattern is needed.
    run.differentiate(m_objective, m_traits.reference, assembles && m_factorization.is_analyzed());
    if(run.retries == 0 && m_convergence.has_ended(run, factorizes))
      return false;
    if(!m_factorization.is_analyzed()) {
      if(!analyze_or_fail(run))
        return false;
      run.differentiate(m_objective, m_traits.reference, assembles);
    }
    if(!m_objective.terms_keep_to_stencils())
      return run.finish(Status::invalid_option, m_objective.FOREIGN_BLOCK);

    if(factorizes && !m_factorization.factorize(run))
      return run.finish(Status::linear_solver_failed, "no factorization succeeded, not even of a strongly shifted matrix");
    if(refactorization == Refactorization::restart)
      m_traits.acceleration.reset();
    if(assembles && !factorizes)
      m_factorization.finish_matrix(run);
    m_factorization.renew(run);
    return true;
  }

  // What accelerations are given.
  struct Linear_algebra
  {
    bool operator()(const Eigen::VectorXd& b, Eigen::VectorXd& y) const { return minimizer.m_factorization.solve(b, y); }

    void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& product) const
    {
      internal::ask_deadline();
      const World& world = minimizer.world();
      product.noalias() = minimizer.m_objective.matrix().lower().template selfadjointView<Eigen::Lower>() * world.with_ghosts(p);
      world.keep_owned(product);
    }

    double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return minimizer.world().dot(a, b); }
    double norm(const Eigen::VectorXd& a) const { return minimizer.world().norm(a); }

    Map_minimizer& minimizer;
  };

  // Leaves the displacement of all vertices in the run. `false` if the linear solver fails.
  bool find_direction(Run& run, double& slope)
  {
    m_objective.gather(run.x, run.unknowns);
    if(!m_traits.acceleration.direction(run.unknowns, run.gradient, Linear_algebra{*this}, run.direction))
      return false;
    if(m_objective.is_rigid_motion_invariant())
      internal::remove_rigid_motion<D>(run.x, run.direction, world());
    slope = world().dot(run.gradient, run.direction);
    m_objective.spread(run.direction, run.displacement);
    return true;
  }

  // After an attempt that led nowhere: ends the run, or asks for a fresh matrix,
  // then for one that is shifted towards its diagonal.
  bool recover(Run& run, bool solved, double slope)
  {
    // A stationary map has no direction of descent beyond rounding.
    if(std::abs(slope) <= 1e-12 * std::abs(run.progress.energy) && run.is_rest_reference && m_convergence.is_nearly_stationary(run))
      return run.finish(Status::success, "the predicted decrease of the energy is below rounding");
    if(m_factorization.age() == 0 && m_factorization.retreat(run)) {
      ++run.retries;
      m_factorization.discard();
      return true;
    }
    if(run.retries >= MAX_RETRIES && !solved)
      return run.finish(Status::linear_solver_failed, "the linear solver found no direction");
    if(run.retries >= MAX_RETRIES && !m_steps.has_barrier() && !m_steps.allows_flips())
      return run.finish(Status::iteration_limit,
                        "elements are about to collapse, which this energy does not prevent, and hold up all steps");
    if(run.retries >= MAX_RETRIES)
      return run.finish(Status::line_search_failed, "no step decreases the energy, although the gradient does not vanish");
    if(run.retries > 0 || m_factorization.age() == 0)
      run.shift = (std::max)(1e-6, 100 * run.shift);
    ++run.retries;
    m_factorization.discard();
    return true;
  }

  // Takes the trial positions.
  void accept(Run& run, Line_search_result found, double slope)
  {
    internal::Minimizer_progress& progress = run.progress;
    m_steps.free_blocked_vertices(run, found);
    progress.fresh = m_factorization.age() == 0 && m_traits.preconditioner.is_second_order;
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
    m_factorization.grow_older();
    run.retries = 0;
    run.shift = Run::BASE_SHIFT;
    if(run.is_rest_reference) {
      progress.energy = progress.rest_energy = found.energy;
    } else {
      run.is_rest_reference = m_traits.reference.update(m_domain, run.x);
      run.measure(m_objective, m_traits.reference);
      m_factorization.discard();
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
      run.trial = run.x + (std::min)(1., run.options.step_fraction * m_steps.largest_step(run)) * run.displacement;
      const double energy = m_objective.energy(m_traits.reference, run.trial);
      ++run.summary.energy_evaluations;
      const double before = run.progress.energy * (1 + (std::max)(0., run.progress.relative_decrease));
      if(!(energy <= before) || !m_steps.is_certified(run, run.trial)) {
        m_traits.acceleration.reset();
        return;
      }
      run.x.swap(run.trial);
      run.progress.energy = run.progress.rest_energy = energy;
    }
  }

  static constexpr int MAX_RETRIES = 5;

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  internal::Map_objective<D, Traits> m_objective;
  internal::Current_factorization<D, Traits> m_factorization;
  internal::Step_finder<D, Traits> m_steps;
  internal::Convergence_test<D, Traits> m_convergence;
  std::string m_constraint_error;
};

template <int D, typename Traits>
Map_minimizer<D, Traits>::Map_minimizer(const Simplicial_domain<D>& domain, const Traits& traits,
                                        const Position_constraints<D>& constraints)
  : m_domain(domain),
    m_traits(traits),
    m_objective(domain, m_traits.energy, m_traits.preconditioner, internal::World_of<Traits>::get(m_traits)),
    m_factorization(m_traits, m_objective),
    m_steps(domain, m_traits, m_objective),
    m_convergence(m_factorization, m_steps)
{
  if(!constraints.is_valid(domain.number_of_vertices, &m_constraint_error))
    return;
  m_objective.fix(constraints.fixed_vertices);
  m_objective.slide(constraints.sliding_vertices);
  if(!constraints.soft_positions.empty())
    m_objective.add_term(std::make_shared<Soft_positions<D>>(constraints.soft_positions));
}

template <int D, typename Traits>
void Map_minimizer<D, Traits>::minimize(Positions<D>& x, Summary& summary)
{
  guarded(x, summary, [&](Run& run) {
    if(!begin(run))
      return;
    const internal::Improving_work work;
    iterate(run);
  });
}

template <int D, typename Traits>
void Map_minimizer<D, Traits>::move_fixed_vertices(Positions<D>& x, const Positions<D>& targets, Summary& summary)
{
  guarded(x, summary, [&](Run& run) {
    if(targets.cols() != m_domain.number_of_vertices) {
      run.finish(Status::invalid_option, "the targets must have a column for each vertex");
      return;
    }
    if(!begin(run))
      return;
    const internal::Improving_work work;
    run.remark = " before the fixed vertices reached their positions";
    if(!analyze_or_fail(run))
      return;
    internal::Handle_path<D, Traits> path(m_domain, m_traits, m_objective, m_factorization, m_steps);
    const auto optimize = [this](Run& r) {
      while(iterate_once(r)) {}
    };
    if(!path.follow(run, targets, optimize)) {
      conclude(run);
      return;
    }
    run.remark.clear();
    iterate(run);
  });
}

template <int D, typename Traits>
bool Map_minimizer<D, Traits>::analyze(Summary& summary)
{
  const internal::Improving_work work;
  try {
    return m_factorization.analyze(summary);
  } catch(const Interruption&) {
    return false;
  }
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
// The compiled library holds the default methods for surfaces and for volumes.
extern template class Map_minimizer<2, Flip_free_map_traits<>>;
extern template class Map_minimizer<3, Flip_free_map_traits<>>;
extern template class Map_minimizer<3, Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_MAP_MINIMIZER_H
