// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_MULTILEVEL_INITIALIZER_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_MULTILEVEL_INITIALIZER_H

#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/initializers/internal/Polar_map.h>
#include <CGAL/Flip_free_maps/initializers/internal/Progressive_disk.h>
#include <CGAL/Flip_free_maps/initializers/internal/Vertex_placement.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsInitializers
/// A start that is close to the optimum already: the surface is simplified by edge collapses, its simplest form embedded and
/// optimised, and the vertices are put back in the reverse order, each in the kernel of its neighbours' ring where its own
/// triangles' energy is least. The map is optimised again each time the number of triangles has grown by a factor. Large
/// deformations are thus found on few triangles, and every vertex is placed at a size that double precision handles, so that long
/// thin tubes, on which Tutte embeddings collapse, are no obstacle.
///
/// On a very long closed tube with one open end each ring lies around the next. Simplified to rings of three vertices it becomes
/// a pile of triangles, which hundreds of rings of more vertices do not leave any more. Where a map in polar coordinates promises
/// a lower energy than a simplified surface has, it is the start.
///
/// \tparam Traits must be a model of `MapTraits`, whose minimizer optimises the levels
///
/// \cgalModels{Initializer}
template <typename Traits>
class Multilevel_initializer
{
  using Kernel = typename Traits::Kernel;
  using Tag = typename Traits::Concurrency_tag;
  using Placement = internal::Vertex_placement<Kernel, typename Traits::Energy>;
  using Tutte = Tutte_initializer<Kernel, typename Traits::Linear_solver, Tag>;

public:
  /// Settings are copied; those of the levels are in `Traits::start`.
  explicit Multilevel_initializer(const Traits& traits) : m_traits(traits)
  {
    m_traits.options.observer = nullptr;
    m_traits.options.characteristic_gradient_tolerance = 0;
    m_traits.options.gradient_tolerance = 0;
    m_traits.options.stagnation_iterations = 5;
  }

  /// Computes the start.
  ///
  /// \param domain a disk with its border and its rest points in space, which may have holes
  /// \param x the start, positively oriented; undefined after a failure
  /// \param name what was done
  /// \param message why it failed
  /// \returns `success`, `invalid_option`, `start_not_flip_free`, or a failure of `Map_minimizer`
  ///
  /// Complexity: about n log n for the simplification, and the factorizations of all levels, whose sizes form a geometric series.
  Status operator()(const Simplicial_domain<2>& domain, Positions<2>& x, std::string& name, std::string& message)
  {
    x.setZero(2, domain.number_of_vertices);
    Run run(domain, m_traits.energy, x);
    Status status = embed_coarsest(run, message);
    if(status != Status::success)
      return status;
    name = "multilevel (" + std::to_string(run.disk.number_of_triangles()) + " faces by " + run.start_name;
    const std::size_t passes = run.disk.number_of_passes();
    status = refine(run, message);
    if(status != Status::success)
      return status;
    if(run.is_polar) {
      name = "polar coordinates; instead of " + name + "; " + std::to_string(run.levels) + " levels)";
      return status;
    }
    name += "; " + std::to_string(passes) + " passes, " + std::to_string(run.levels) + " levels)";
    const std::int64_t flips = Measure(domain).number_of_flips(x);
    if(flips != 0) {
      message = "the multilevel start has " + std::to_string(flips) + " flipped elements";
      return Status::start_not_flip_free;
    }
    return Status::success;
  }

private:
  using Measure = Map_measure<2, Kernel, Tag>;

  // What one call works on.
  struct Run
  {
    Run(const Simplicial_domain<2>& surface, const typename Traits::Energy& energy, Positions<2>& positions)
      : domain(surface), x(positions), disk(domain), placement(disk, energy, x), polar_map(domain)
    {}

    const Simplicial_domain<2>& domain;
    Positions<2>& x;
    internal::Progressive_disk disk;
    Placement placement;
    internal::Polar_map polar_map;
    bool has_polar_map = false; // and has not taken or refused it yet
    bool is_polar = false;      // x is the polar map
    bool is_thin = false;
    int levels = 1;
    std::string start_name;
  };

  // Simplifies the surface, embeds and optimises it. Where even the simplified surface has no flip-free embedding in double
  // precision, simpler ones are tried.
  Status embed_coarsest(Run& run, std::string& message)
  {
    const auto make_solver = [this] { return m_traits.make_linear_solver(); };
    for(std::int64_t wanted = m_traits.start.coarsest_size;; wanted /= 4) {
      run.disk.template coarsen<Tag>(wanted);
      std::vector<std::int32_t> vertices;
      const Simplicial_domain<2> coarse = run.disk.domain(vertices);
      Positions<2> y;
      const Status status = Tutte(m_traits.start)(coarse, make_solver, y, run.start_name, message);
      if(status == Status::invalid_option)
        return status;
      if(status == Status::success)
        return optimize(coarse, vertices, y, run.x, message);
      if(wanted < 12)
        return Status::start_not_flip_free;
      if(!run.is_thin)
        run.has_polar_map = run.polar_map.build(make_solver);
      run.is_thin = true;
    }
  }

  // Puts all vertices back, and optimises in between.
  Status refine(Run& run, std::string& message)
  {
    const std::int64_t coarsest = run.disk.number_of_triangles();
    // On long thin tubes the sizes of triangles differ by many orders of magnitude until distances along the tube are right; the
    // vertices are moved into place one by one before all together, and more often.
    const double level_ratio = run.is_thin ? (std::min)(m_traits.start.level_ratio, 2.) : m_traits.start.level_ratio;
    // Levels are spread evenly up to the surface itself: the last ones cost most, and a gap behind them costs more.
    const double growth = std::log(static_cast<double>(run.domain.number_of_elements()) / coarsest);
    const int sizes = (std::max)(1, static_cast<int>(std::round(growth / std::log((std::max)(level_ratio, 1.1)))));
    while(run.disk.number_of_passes() > 0) {
      if(!put_back(run.disk, run.x, message))
        return Status::start_not_flip_free;
      if(run.is_thin)
        for(int sweep = 0; sweep < SWEEPS; ++sweep)
          for(std::int32_t v = 0; v < run.domain.number_of_vertices; ++v) {
            internal::ask_deadline_sometimes(v);
            if(run.disk.is_awake(v))
              run.placement.relax(v, 1);
          }
      if(run.disk.number_of_passes() > 0 && run.levels < sizes &&
         run.disk.number_of_triangles() >= NEAR_LEVEL * coarsest * std::exp(growth * run.levels / sizes)) {
        const Status status = optimize_level(run, message);
        if(status != Status::success || run.is_polar)
          return status;
      }
    }
    run.placement.relax_distorted(LARGEST_DISTORTION, DISTORTED_SWEEPS);
    return Status::success;
  }

  // Optimises the surface as far as it is, and takes the polar map instead if that is better.
  Status optimize_level(Run& run, std::string& message)
  {
    run.placement.relax_distorted(LARGEST_DISTORTION, DISTORTED_SWEEPS);
    std::vector<std::int32_t> vertices;
    const Simplicial_domain<2> level = run.disk.domain(vertices);
    Positions<2> y(2, vertices.size());
    for(std::size_t v = 0; v < vertices.size(); ++v)
      y.col(v) = run.x.col(vertices[v]) / level.scale;
    const Status status = optimize(level, vertices, y, run.x, message);
    if(status != Status::success)
      return status;
    ++run.levels;
    // The symmetric Dirichlet energy tells, whatever energy the level was optimised for.
    if(run.has_polar_map && run.polar_map.energy() < POLAR_ADVANTAGE * Measure(level).mean_energy(Symmetric_dirichlet(), y)) {
      run.has_polar_map = false;
      Positions<2> polar;
      run.polar_map.place(polar);
      run.is_polar = Measure(run.domain).number_of_flips(polar) == 0;
      if(run.is_polar)
        run.x = std::move(polar);
    }
    return Status::success;
  }

  Status optimize(const Simplicial_domain<2>& level, const std::vector<std::int32_t>& vertices, Positions<2>& y, Positions<2>& x,
                  std::string& message)
  {
    // Errors of coarse levels are expensive to repair on finer ones, where they are errors of long waves.
    m_traits.options.relative_energy_tolerance = m_traits.start.level_tolerance * (std::min)(1., level.number_of_elements() / 2e4);
    const Summary summary = typename Traits::template Minimizer<2, Traits>(level, m_traits).minimize(y);
    if(!summary.is_valid()) {
      message = "a simplified surface could not be optimised: " + summary.message;
      return summary.status;
    }
    for(std::size_t v = 0; v < vertices.size(); ++v)
      x.col(vertices[v]) = y.col(v) * level.scale;
    return Status::success;
  }

  // Puts the vertices of one pass back. They are not adjacent, so each is placed by itself. Those whose ring has no kernel in
  // double precision wait until their neighbours have moved.
  bool put_back(internal::Progressive_disk& disk, Positions<2>& x, std::string& message) const
  {
    std::vector<std::int32_t> pass = disk.take_pass(), targets, waiting;
    std::vector<char> is_placed;
    for(int round = 0; round < ROUNDS; ++round) {
      internal::ask_deadline();
      targets.clear();
      for(std::int32_t v : pass)
        targets.push_back(disk.restore(v));
      is_placed.assign(pass.size(), 0);
      internal::for_each_index<Tag>((pass.size() + CHUNK_SIZE - 1) / CHUNK_SIZE, [&](std::size_t c) {
        Placement placement(disk, m_traits.energy, x);
        for(std::size_t i = c * CHUNK_SIZE; i < (std::min)(pass.size(), (c + 1) * CHUNK_SIZE); ++i)
          is_placed[i] = placement.place(pass[i], NEWTON_STEPS);
      });
      waiting.clear();
      for(std::size_t i = 0; i < pass.size(); ++i)
        if(!is_placed[i]) {
          disk.remove(pass[i], targets[i]);
          waiting.push_back(pass[i]);
        }
      if(waiting.empty())
        return true;
      Placement placement(disk, m_traits.energy, x);
      for(std::int32_t v : waiting)
        for(std::int32_t u : disk.neighbors_while_removed(v))
          placement.relax(u, 2);
      pass.swap(waiting);
    }
    message = std::to_string(pass.size()) + " vertices of a simplified surface found no place";
    return false;
  }

  // A polar map is taken when its energy is below this times that of a simplified surface, which is still far from smooth.
  static constexpr double POLAR_ADVANTAGE = 0.8;
  static constexpr int ROUNDS = 6;               // of trying to place a vertex
  static constexpr std::size_t CHUNK_SIZE = 256; // vertices that are placed by one thread
  static constexpr int NEWTON_STEPS = 4;         // for a vertex that is put back; most need one
  static constexpr double NEAR_LEVEL = 0.88;     // since passes multiply the number of triangles by about 1.3
  static constexpr int SWEEPS = 2;               // over all vertices of a thin surface, after each pass
  // Before a level is optimised, and at the end, the vertices of distorted triangles are relaxed one by one. That costs little
  // and spares the optimisation the triangles that would hold it up.
  static constexpr double LARGEST_DISTORTION = 1.5;
  static constexpr int DISTORTED_SWEEPS = 2;

  Traits m_traits;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_MULTILEVEL_INITIALIZER_H
