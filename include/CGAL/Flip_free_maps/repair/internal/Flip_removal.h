// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REMOVAL_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REMOVAL_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/repair/Foldover_free.h>
#include <CGAL/Flip_free_maps/repair/Repair_options.h>
#include <CGAL/Flip_free_maps/repair/internal/Flip_region.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#endif

#include <CGAL/Default.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What is used of a method where only its kernel, its linear solver and its concurrency count: one type for all energies and
// preconditioners. The energy is the symmetric gradient.
template <typename Kernel, typename LinearSolver, typename ConcurrencyTag>
class Repair_traits
  : public Flip_free_map_traits<Kernel, Symmetric_gradient, CGAL::Default, CGAL::Default, LinearSolver, CGAL::Default, CGAL::Default,
                                ConcurrencyTag>
{
public:
  template <typename Traits>
  explicit Repair_traits(const Traits& traits) : m_make_linear_solver([traits] { return traits.make_linear_solver(); })
  {}

  LinearSolver make_linear_solver() const { return m_make_linear_solver(); }

private:
  std::function<LinearSolver()> m_make_linear_solver;
};

template <typename Traits>
using Repair_traits_of = Repair_traits<typename Traits::Kernel, typename Traits::Linear_solver, typename Traits::Concurrency_tag>;

// Lets both methods take turns until no element is flipped, each as long as it makes progress.
template <int D, typename Traits>
class Flip_removal
{
  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;

public:
  // Keeps references to the domain, the constraints and the options.
  Flip_removal(const Simplicial_domain<D>& domain, const Traits& traits, const Position_constraints<D>& constraints,
               const Repair_options& options)
    : m_domain(domain), m_traits(traits), m_constraints(constraints), m_options(options)
  {
    m_schedule.build(domain.elements, domain.number_of_vertices);
  }

  // Whether the observer asked to stop.
  bool is_stopped() const { return m_is_stopped; }

  // Begins with the map `given`. Returns whether `x` and the summary have a valid map; otherwise the summary says why not.
  bool run(const Positions<D>& given, Positions<D>& x, Summary& summary);

private:
  std::vector<std::int64_t> flipped(const Positions<D>& x) const
  {
    return m_schedule.template collect<Tag>([&](std::int64_t e) { return !is_positively_oriented<Kernel>(m_domain.elements[e], x); });
  }

  bool has_flips(const Positions<D>& x) const { return !flipped(x).empty(); }

  void enter(const std::string& stage, Summary& summary) const { summary.start += summary.start.empty() ? stage : ", then " + stage; }

  // The splitting scheme. `start` becomes its best map where flips remain.
  bool split(const Positions<D>& given, Positions<D>& start, Positions<D>& x, Summary& summary)
  {
    Splitting_options splitting = m_options.splitting;
    // In the plane iterations cost little, and the scheme succeeds after long plateaus.
    if(!m_options.use_second_method || D == 2)
      splitting.max_stalled_iterations = 0;
    if(m_options.splitting.observer)
      splitting.observer = [&](const Splitting_report& report) {
        m_is_stopped = !m_options.splitting.observer(report);
        return !m_is_stopped;
      };
    x = start = given;
    const int iterations = summary.iterations;
    Splitting_minimizer<D, Traits> splitter(m_domain, m_traits, m_constraints, splitting);
    splitter.split(x, given, summary, &start);
    enter("splitting, " + std::to_string(summary.iterations - iterations) + " iterations", summary);
    if(summary.status == Status::flips_remain)
      keep(start);
    return summary.is_valid();
  }

  // The regularised energy, all calls of which share the limit of time.
  void descend(const Simplicial_domain<D>& domain, const Position_constraints<D>& constraints, Positions<D>& x, Summary& summary)
  {
    Foldover_free_options options = m_options.foldover_free;
    options.max_seconds = (std::max)(0., options.max_seconds - m_seconds);
    const Phase_timer timer(m_seconds);
    Foldover_free<D, Traits>(domain, m_traits, constraints, options).reduce_flips(x, summary);
  }

  // The regularised energy near the flips of a map, and farther from them where that does not suffice.
  bool move_near_flips(const Positions<D>& given, Positions<D>& x, Summary& summary)
  {
    x = given;
    const int iterations = summary.iterations;
    std::vector<std::int64_t> flips = flipped(x);
    for(int rings = 2; rings <= MOST_RINGS && !flips.empty(); ++rings) {
      Flip_region<D> region(m_domain, flips, m_constraints.fixed_vertices, rings);
      Positions<D> part = region.positions(x), trial = x;
      descend(region.domain, region.constraints, part, summary);
      region.write(part, trial);
      std::vector<std::int64_t> left = flipped(trial);
      if(left.size() < flips.size()) {
        x.swap(trial);
        flips.swap(left);
      } else if(rings > 2)
        break;
    }
    enter("foldover-free energy near the flips, " + std::to_string(summary.iterations - iterations) + " steps", summary);
    return conclude(flips, x, summary);
  }

  // The regularised energy everywhere, and once more near the flips that it leaves.
  bool move_all(const Positions<D>& given, Positions<D>& x, Summary& summary)
  {
    x = given;
    const int iterations = summary.iterations;
    descend(m_domain, m_constraints, x, summary);
    enter("foldover-free energy, " + std::to_string(summary.iterations - iterations) + " steps", summary);
    if(conclude(flipped(x), x, summary))
      return true;
    const Positions<D> start = x;
    return move_near_flips(start, x, summary);
  }

  bool conclude(const std::vector<std::int64_t>& flips, const Positions<D>& x, Summary& summary)
  {
    summary.flips = static_cast<std::int64_t>(flips.size());
    summary.status = flips.empty() ? Status::success : Status::flips_remain;
    summary.message = "no element is flipped";
    keep(x);
    return flips.empty();
  }

  // Remembers the flipped elements of the best map.
  void keep(const Positions<D>& x)
  {
    std::vector<std::int64_t> flips = flipped(x);
    if(static_cast<std::int64_t>(flips.size()) >= m_fewest)
      return;
    m_fewest = static_cast<std::int64_t>(flips.size());
    m_flipped.swap(flips);
  }

  void fail(const Summary& after_splitting, Summary& summary)
  {
    summary.status = Status::flips_remain;
    summary.flips = m_fewest;
    summary.message = after_splitting.message + "; with the foldover-free energy " + std::to_string(m_fewest) + " are, as " +
                      (D == 2 ? "triangle" : "tetrahedron") + " number " + std::to_string(m_flipped.front()) +
                      ": the mesh may be too coarse there";
    summary.flipped_elements = m_flipped;
  }

  static constexpr int MOST_RINGS = 4;

  const Simplicial_domain<D>& m_domain;
  Traits m_traits;
  const Position_constraints<D>& m_constraints;
  const Repair_options& m_options;
  Element_coloring m_schedule;
  std::vector<std::int64_t> m_flipped;
  std::int64_t m_fewest = 0;
  double m_seconds = 0; // spent by the regularised energy
  bool m_is_stopped = false;
};

template <int D, typename Traits>
bool Flip_removal<D, Traits>::run(const Positions<D>& given, Positions<D>& x, Summary& summary)
{
  summary.vertices = m_domain.number_of_vertices;
  summary.elements = m_domain.number_of_elements();
  summary.dimension = D;
  m_fewest = std::numeric_limits<std::int64_t>::max();
  const bool is_usable = m_options.use_second_method && given.cols() == m_domain.number_of_vertices && given.allFinite();
  if(D == 3 && is_usable && has_flips(given) && move_near_flips(given, x, summary))
    return true;
  Positions<D> start;
  if(split(given, start, x, summary))
    return true;
  if(summary.status == Status::flips_remain)
    summary.flipped_elements = m_flipped;
  if(!is_usable || m_is_stopped || summary.status != Status::flips_remain)
    return false;
  const Summary after_splitting = summary;
  // In space what is near the flips of the given map has moved already.
  const bool is_new = D == 2 || (start.array() != given.array()).any();
  if((is_new && move_near_flips(start, x, summary)) || move_all(given, x, summary)) {
    summary.flipped_elements.clear();
    return true;
  }
  fail(after_splitting, summary);
  return false;
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Flip_removal<2, Repair_traits_of<Flip_free_map_traits<>>>;
extern template class Flip_removal<3, Repair_traits_of<Flip_free_map_traits<>>>;
extern template class Flip_removal<3, Repair_traits_of<Any_map_traits>>;
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REMOVAL_H
