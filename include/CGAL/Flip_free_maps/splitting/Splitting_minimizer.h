// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MINIMIZER_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MINIMIZER_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Robust_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/method/concepts.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/minimizer/polish_map.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/splitting/Admm_splitting_step.h>
#include <CGAL/Flip_free_maps/splitting/Linear_constraints.h>
#include <CGAL/Flip_free_maps/splitting/Proximal_map.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_errors.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>
#include <CGAL/Flip_free_maps/splitting/internal/Position_solver.h>

#include <CGAL/Default.h>

#include <boost/concept_check.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The traits of a polish: the base of traits that have one, which knows nothing of the splitting.
template <typename Traits, typename = void>
struct Polish_traits
{
  using type = Traits;
};

template <typename Traits>
struct Polish_traits<Traits, std::void_t<typename Traits::Base_traits>>
{
  using type = typename Traits::Base_traits;
};

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Minimises the mean distortion energy of a map by the splitting scheme of Stein, Li and Solomon 2022. The start and the
/// iterates may have flipped elements: each Jacobian is split into a rotation and a stretch without flips, and the map is drawn
/// towards them. The result is accepted only when exact predicates find every element positively oriented.
///
/// The energy has many local minima once flipped elements are let in. From a start with many of them the result may be one in
/// which the map turns twice around some vertices: all elements are positively oriented, but those around such a vertex overlap.
///
/// \tparam D dimension, 2 or 3
/// \tparam Traits must be a model of `MapTraits`; its energy, linear solver, kernel and concurrency tag are used,
///         and all of it for the polish. The energy must be convex in the singular values,
///         such as `Symmetric_gradient` and `Symmetric_dirichlet`.
/// \tparam Step must be a model of `SplittingStep`
///
/// Complexity: an iteration is linear in the number of elements, with one pair of sparse triangular solves of |V| unknowns per
/// coordinate. The matrix is factorized anew when penalties change, about 5 + log2(n / 5) times in n iterations without flips;
/// its pattern is analysed once.
template <int D, typename Traits = Flip_free_map_traits<CGAL::Default, Symmetric_gradient>,
          typename Step = Admm_splitting_step<D, typename Traits::Energy>>
class Splitting_minimizer
{
  BOOST_CONCEPT_ASSERT((MapTraitsConcept<Traits, D>));
  BOOST_CONCEPT_ASSERT((SplittingStepConcept<Step, typename Traits::Energy, D>));

  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Energy = typename Traits::Energy;
  using Position_solver = internal::Position_solver<D, Traits>;

public:
  /// Keeps a reference to `domain`, which must outlive this object, and copies of everything else.
  explicit Splitting_minimizer(const Simplicial_domain<D>& domain, const Traits& traits = Traits(),
                               const Position_constraints<D>& constraints = Position_constraints<D>(),
                               const Splitting_options& options = Splitting_options(),
                               const Linear_constraints<D>& linear_constraints = Linear_constraints<D>());

  Splitting_minimizer(const Splitting_minimizer&) = delete;
  Splitting_minimizer& operator=(const Splitting_minimizer&) = delete;

  /// The settings; they may be changed between runs, but for those of penalties.
  Splitting_options& options() { return m_options; }

  /// Minimises, beginning at the positions `x`, in the domain's units of length.
  ///
  /// \param x the start, with a column for each vertex; on return the result when the summary `is_valid()`, otherwise unchanged.
  ///   Fixed vertices keep their positions exactly.
  /// \returns what happened. When the run ends early, the last iterate without flipped elements is the result, and the status is
  ///   `iteration_limit`, `time_limit` or `stopped_by_observer`; when there was none, it is `flips_remain`, and `Summary::flips`
  ///   tells how many flipped elements the last iterate had. Other failures are `invalid_option`, `non_finite_input`,
  ///   `unreachable_constraints` (all vertices are fixed, and elements flipped), `linear_solver_failed` and `out_of_memory`. No
  ///   exception is thrown but those of the observer.
  Summary minimize(Positions<D>& x)
  {
    Summary summary;
    minimize(x, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void minimize(Positions<D>& x, Summary& summary) { minimize(x, x, summary); }

  /// The same, where the rotations and stretches in the beginning are those of another map, `model`. The first iterate is the map
  /// whose Jacobians are the closest to the model's and which has the fixed vertices where `x` has them. So handles may be moved
  /// far: `model` is the map before, in which nothing is flipped, and `x` the same with the handles at their new places. The
  /// positions that `x` gives to other vertices do not matter then.
  void minimize(Positions<D>& x, const Positions<D>& model, Summary& summary);

  /// Moves the fixed vertices of a map to other positions and minimises there.
  ///
  /// \param x a map without flips; on return the result when the summary `is_valid()`, otherwise unchanged
  /// \param targets its columns of fixed vertices are where these go; others are not read
  /// \param summary counts and times are added to it
  void move_fixed_vertices(Positions<D>& x, const Positions<D>& targets, Summary& summary)
  {
    Positions<D> moved = x;
    if(targets.cols() == x.cols() && x.cols() == m_domain.number_of_vertices)
      for(std::int32_t v : m_constraints.fixed_vertices)
        if(v >= 0 && v < m_domain.number_of_vertices)
          moved.col(v) = targets.col(v);
    minimize(moved, targets.cols() == x.cols() ? x : targets, summary);
    if(summary.is_valid())
      x.swap(moved);
  }

  /// As `minimize()` without a polish, whatever the options say: a program that calls no other function is spared the compilation
  /// of `Map_minimizer`.
  ///
  /// \param x the start; the result, if the summary is valid
  /// \param model the map near which the first iterate is to be
  /// \param summary counts and times are added to it
  /// \param fewest_flips if not null, receives the iterate with the fewest flipped elements when none was without
  void split(Positions<D>& x, const Positions<D>& model, Summary& summary, Positions<D>* fewest_flips = nullptr);

private:
  static void finish(Summary& summary, Status status, const std::string& message)
  {
    summary.status = status;
    summary.message = message;
  }

  Status check(const Positions<D>& x, const Positions<D>& model, std::string& message) const
  {
    if(!m_options.is_valid(&message) || !m_traits.options.is_valid(&message) ||
       !m_constraints.is_valid(m_domain.number_of_vertices, &message) || !internal::has_no_sliding_vertices(m_constraints, &message) ||
       !m_linear_constraints.is_valid(m_domain.number_of_vertices, &message))
      return Status::invalid_option;
    if(x.cols() != m_domain.number_of_vertices || model.cols() != x.cols()) {
      message = "the start must have a column for each vertex";
      return Status::invalid_option;
    }
    if(m_options.polish && !m_linear_constraints.empty()) {
      message = "a map under linear constraints cannot be polished";
      return Status::invalid_option;
    }
    if(!x.allFinite() || !model.allFinite()) {
      message = "the start has positions that are not finite";
      return Status::non_finite_input;
    }
    return Status::success;
  }

  // The variables of one run.
  struct Run
  {
    Run(Positions<D>& positions, Summary& s) : x(positions), summary(s) {}

    Positions<D>& x;
    Summary& summary;
    Splitting_report report;
    Positions<D> flip_free; // the last iterate without flips
    std::int64_t flips = 0;
    int first_iteration = 0;
    double time_begin = 0;
    bool is_warm = false;
    bool is_factorized = false;
    bool wants_energy = false;
    int adaptations = 0, interval = 0, next_adaptation = 0;         // of penalties
    std::int64_t fewest = std::numeric_limits<std::int64_t>::max(); // flips, and the iteration that had them first
    int fewest_iteration = 0;
    Positions<D>* fewest_flips = nullptr;
  };

  void run(Positions<D>& x, const Positions<D>& model, Summary& summary, Positions<D>* fewest_flips)
  {
    const auto reporting = m_solver.report_to(summary);
    Run run(x, summary);
    run.fewest_flips = fewest_flips;
    const Deadline deadline(m_options.max_seconds);
    try {
      const internal::Improving_work work;
      if(!begin(run, model))
        return;
      while(!has_ended(run) && move_positions(run)) {
        update_elements(run);
        schedule_adaptation(run);
        keep_if_flip_free(run);
        note_progress(run);
      }
    } catch(const Interruption& interruption) {
      finish(summary, interruption.status(), interruption.what());
      // What was being made is unfinished.
      run.is_factorized = false;
      m_positions.reset();
    }
    const internal::Unbound_work certificate;
    conclude(run.flip_free, x, summary);
    m_is_warm = summary.is_valid();
    m_is_factorized = run.is_factorized;
  }

  // Measures the start and splits its Jacobians.
  bool begin(Run& run, const Positions<D>& model)
  {
    Summary& summary = run.summary;
    const bool is_new = m_positions == nullptr;
    if(is_new)
      m_positions = std::make_unique<Position_solver>(m_domain, m_schedule, m_constraints, m_linear_constraints);
    run.first_iteration = summary.iterations;
    run.time_begin = internal::wall_seconds();
    run.wants_energy = m_options.observer || std::isfinite(m_options.target_energy);
    run.flips = flips(run.x, summary);
    summary.energy = run.flips == 0 ? energy(run.x) : std::numeric_limits<double>::infinity();
    summary.energy_initial = run.flips == 0 ? summary.energy : -1;
    run.is_warm = m_options.keep_factorization && m_is_warm;
    m_is_warm = false;
    if(!run.is_warm)
      m_is_inert = m_options.proximal_rotation == Proximal_rotation::on ||
                   (m_options.proximal_rotation == Proximal_rotation::automatic && run.flips <= MANY_FLIPS * m_domain.number_of_elements());
    // With a model of its own, the first iterate is to come near it;
    // the Jacobians of x are entered so that its increment is right.
    {
      const internal::Phase_timer timer(summary.seconds.assemble);
      m_elements.resize(m_domain.elements.size());
      m_schedule.template for_each<Tag>([&](std::int64_t e) {
        if(!run.is_warm)
          m_step.start(m_domain.jacobian(e, model), m_domain.measures[e], m_is_inert, m_elements[e]);
        m_elements[e].jacobian = m_domain.jacobian(e, run.x);
      });
    }
    if(run.flips == 0)
      run.flip_free = run.x;
    if(is_new && m_positions->has_unknowns() && !m_positions->analyze_pattern(m_solver)) {
      m_positions.reset();
      finish(summary, Status::linear_solver_failed, "the linear solver could not analyse the pattern of the matrix");
      return false;
    }
    run.is_factorized = run.is_warm && m_is_factorized;
    // Penalties of the run before are about right.
    run.adaptations = run.is_warm ? m_options.first_adaptations : 0;
    run.interval = m_options.adaptation_interval;
    run.next_adaptation = run.first_iteration + (run.is_warm ? run.interval : 1);
    run.fewest_iteration = run.first_iteration;
    note_progress(run);
    return true;
  }

  // Asks the observer, the stopping rules and the limits, in this order.
  bool has_ended(Run& run)
  {
    Summary& summary = run.summary;
    const auto end = [&summary](Status status, const char* message) {
      finish(summary, status, message);
      return true;
    };
    if(run.wants_energy)
      summary.energy = run.flips == 0 ? energy(run.x) : std::numeric_limits<double>::infinity();
    if(m_options.observer && !m_options.observer(report(run)))
      return end(Status::stopped_by_observer, "the observer asked to stop");
    const bool has_moved = summary.iterations > run.first_iteration;
    if(run.flips == 0) {
      if(m_options.stop_when_flip_free)
        return end(Status::success, "no element is flipped");
      if(run.wants_energy && summary.energy <= m_options.target_energy)
        return end(Status::success, "the target energy is reached");
      if(has_moved && is_within_tolerances(run))
        return end(Status::success, "both errors are within their tolerances");
    }
    if(!m_positions->has_unknowns() && has_moved)
      return end(run.flips == 0 ? Status::success : Status::unreachable_constraints, "all vertices are fixed");
    if(summary.iterations - run.first_iteration >= m_options.max_iterations)
      return end(Status::iteration_limit, "the limit of iterations is reached");
    if(has_stalled(run))
      return end(Status::iteration_limit, "flipped elements become no fewer");
    const Status late = internal::deadline_status();
    return late != Status::success && end(late, Interruption(late).what());
  }

  void note_progress(Run& run) const
  {
    if(run.flips >= run.fewest)
      return;
    run.fewest = run.flips;
    run.fewest_iteration = run.summary.iterations;
    if(run.fewest_flips != nullptr)
      *run.fewest_flips = run.x;
  }

  bool has_stalled(const Run& run) const
  {
    return m_options.max_stalled_iterations > 0 && run.fewest > 0 &&
           run.summary.iterations - run.fewest_iteration >= m_options.max_stalled_iterations;
  }

  const Splitting_report& report(Run& run) const
  {
    run.report.iteration = run.summary.iterations;
    run.report.seconds = internal::wall_seconds() - run.time_begin;
    run.report.energy = run.summary.energy;
    run.report.factorizations = run.summary.factorizations;
    run.report.flips = run.flips;
    return run.report;
  }

  bool is_within_tolerances(const Run& run) const
  {
    return run.report.primal_error <= m_primal_tolerance && run.report.dual_error <= m_dual_tolerance;
  }

  // The global step: draws the map to the rotations and stretches.
  bool move_positions(Run& run)
  {
    if(!m_positions->has_unknowns())
      return true;
    if(!run.is_factorized && !m_positions->factorize(m_solver, [this](std::int64_t e) { return m_elements[e].penalty; })) {
      finish(run.summary, Status::linear_solver_failed, "no factorization succeeded, not even of a strongly shifted matrix");
      return false;
    }
    run.is_factorized = true;
    if(!m_positions->move(
         m_solver, [this](std::int64_t e) { return Step::pull(m_elements[e]); }, run.x)) {
      finish(run.summary, Status::linear_solver_failed, "the linear solver found no positions");
      return false;
    }
    return true;
  }

  // The local step: draws rotations and stretches to the map.
  void update_elements(Run& run)
  {
    ++run.summary.iterations;
    const bool adapts = run.summary.iterations == run.next_adaptation;
    const internal::Phase_timer timer(run.summary.seconds.assemble);
    const auto update = [&](std::int64_t e, Splitting_errors& sums) {
      m_step.update(m_domain.jacobian(e, run.x), m_domain.measures[e], adapts, m_is_inert, m_elements[e], sums);
    };
    const Splitting_errors errors = m_schedule.template accumulate<Tag, Splitting_errors>(update);
    run.report.primal_error = std::sqrt(errors.primal);
    run.report.dual_error = std::sqrt(errors.dual);
    // Measures sum to 1.
    const double size = m_options.weights == Splitting_weights::measure ? 1 : static_cast<double>(D * D * m_domain.number_of_elements());
    const double absolute = m_options.absolute_tolerance * std::sqrt(size);
    m_primal_tolerance = absolute + m_options.relative_tolerance * std::sqrt(errors.primal_scale);
    m_dual_tolerance = absolute + m_options.relative_tolerance * std::sqrt(errors.dual_scale);
    run.flips = errors.flips;
    run.is_factorized = run.is_factorized && errors.adapted == 0;
  }

  // After an adaptation of the penalties: when the next one is due.
  void schedule_adaptation(Run& run) const
  {
    if(run.summary.iterations != run.next_adaptation)
      return;
    ++run.adaptations;
    if(run.adaptations < m_options.first_adaptations) {
      run.next_adaptation = run.summary.iterations + 1;
      return;
    }
    run.next_adaptation = run.summary.iterations + run.interval;
    // Where flips remain penalties must go on rising.
    if(run.flips == 0 || 2 * run.interval <= m_options.largest_interval_with_flips)
      run.interval *= 2;
  }

  void keep_if_flip_free(Run& run) const
  {
    if(run.flips != 0)
      return;
    // Determinants in floating point may be wrong where exact predicates are not.
    run.flips = flips(run.x, run.summary);
    if(run.flips == 0)
      run.flip_free = run.x;
  }

  // Certifies the last iterate, or the last one without flips, and measures it.
  void conclude(const Positions<D>& flip_free, Positions<D>& x, Summary& summary) const
  {
    summary.flips = flips(x, summary);
    if(summary.flips != 0 && flip_free.cols() == x.cols() && flips(flip_free, summary) == 0) {
      x = flip_free;
      summary.flips = 0;
    }
    if(!summary.is_valid())
      return;
    if(summary.flips != 0) {
      summary.energy = -1;
      finish(summary, Status::flips_remain, summary.message + ", and " + std::to_string(summary.flips) + " elements are still flipped");
      return;
    }
    summary.energy = energy(x);
    const internal::Phase_timer timer(summary.seconds.certify);
    std::tie(summary.min_singular_value, summary.max_singular_value) = internal::singular_value_range<Tag>(m_domain, m_schedule, x);
  }

  void polish(Positions<D>& x, Summary& summary) const
  {
    const std::string splitting = "splitting, " + std::to_string(summary.iterations) + " iterations: " + summary.message;
    summary.start += summary.start.empty() ? splitting : ", then " + splitting;
    const double energy_initial = summary.energy_initial;
    using Polish = typename internal::Polish_traits<Traits>::type;
    polish_map<Map_minimizer<D, Polish>>(m_domain, static_cast<const Polish&>(m_traits), m_constraints, x, summary);
    summary.energy_initial = energy_initial;
  }

  // The mean energy of a map without flips.
  double energy(const Positions<D>& x) const
  {
    double soft = 0;
    for(const Soft_position<D>& position : m_constraints.soft_positions)
      soft += position.weight * (x.col(position.vertex) - position.target).squaredNorm();
    return internal::mean_energy<Tag>(m_domain, m_schedule, m_traits.energy, x) + soft;
  }

  std::int64_t flips(const Positions<D>& x, Summary& summary) const
  {
    const internal::Phase_timer timer(summary.seconds.certify);
    return x.allFinite() ? internal::count_flips<Kernel, Tag>(m_domain, m_schedule, x) : m_domain.number_of_elements();
  }

  // Beyond this share of flipped elements the start says little about the rotations.
  static constexpr double MANY_FLIPS = 0.01;

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  Position_constraints<D> m_constraints;
  Splitting_options m_options;
  Linear_constraints<D> m_linear_constraints;
  Step m_step;
  internal::Element_coloring m_schedule;
  std::vector<typename Step::Element> m_elements;
  typename Traits::Linear_solver m_linear_solver;
  internal::Robust_solver<typename Traits::Linear_solver> m_solver;
  std::unique_ptr<Position_solver> m_positions; // made in the first run, when constraints have been checked
  bool m_is_warm = false;                       // elements are as a run with a valid map left them
  bool m_is_factorized = false;                 // with their penalties
  bool m_is_inert = false;
  double m_primal_tolerance = 0;
  double m_dual_tolerance = 0;
};

template <int D, typename Traits, typename Step>
Splitting_minimizer<D, Traits, Step>::Splitting_minimizer(const Simplicial_domain<D>& domain, const Traits& traits,
                                                          const Position_constraints<D>& constraints, const Splitting_options& options,
                                                          const Linear_constraints<D>& linear_constraints)
  : m_domain(domain),
    m_traits(traits),
    m_constraints(constraints),
    m_options(options),
    m_linear_constraints(linear_constraints),
    m_step(traits.energy, options),
    m_linear_solver(m_traits.make_linear_solver()),
    m_solver(m_linear_solver)
{
  m_schedule.build(domain.elements, domain.number_of_vertices);
}

template <int D, typename Traits, typename Step>
void Splitting_minimizer<D, Traits, Step>::minimize(Positions<D>& x, const Positions<D>& model, Summary& summary)
{
  try {
    Positions<D> result = x;
    split(result, model, summary);
    if(summary.is_valid() && m_options.polish)
      polish(result, summary);
    if(summary.is_valid())
      x = std::move(result);
  } catch(const std::bad_alloc&) {
    finish(summary, Status::out_of_memory, "memory was exhausted while minimizing");
  }
  summary.peak_memory_mb = internal::peak_memory_mb();
}

template <int D, typename Traits, typename Step>
void Splitting_minimizer<D, Traits, Step>::split(Positions<D>& x, const Positions<D>& model, Summary& summary, Positions<D>* fewest_flips)
{
  summary.vertices = m_domain.number_of_vertices;
  summary.elements = m_domain.number_of_elements();
  summary.dimension = D;
  if constexpr(internal::Holds_energy<Energy>::value)
    summary.energy_name = m_traits.energy.energy_name();
  else
    summary.energy_name = Energy::name();
  summary.preconditioner = Step::name();
  const Status bad = check(x, model, summary.message);
  if(bad != Status::success) {
    summary.status = bad;
    return;
  }
  try {
    Positions<D> result = x;
    run(result, model, summary, fewest_flips);
    if(summary.is_valid())
      x = std::move(result);
  } catch(const std::bad_alloc&) {
    finish(summary, Status::out_of_memory, "memory was exhausted while minimizing");
  }
  summary.peak_memory_mb = internal::peak_memory_mb();
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MINIMIZER_H
