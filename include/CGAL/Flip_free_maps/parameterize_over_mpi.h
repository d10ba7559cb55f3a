// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZE_OVER_MPI_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZE_OVER_MPI_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/deform_volume_over_mpi.h>
#include <CGAL/Flip_free_maps/distribution/Distributed_disk.h>
#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/distribution/internal/Traits_over_mpi.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <mpi.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Flattens a disk in slices. The slice of the result is written if the map is valid.
template <typename Traits>
class Disk_over_mpi
{
public:
  Disk_over_mpi(const Mpi_world& world, const Traits& traits) : m_world(world), m_traits(traits, world), m_disk(world) {}

  // `start` is a slice of planar points in the units of the surface, or has no columns on all ranks.
  template <typename Point>
  Summary run(const Positions<3>& points, const std::vector<Distributed_disk::Triangle>& triangles, const Positions<2>& start,
              std::vector<Point>& result)
  {
    Summary summary;
    Positions<2> x;
    const Deadline deadline(m_traits.options.max_seconds);
    const auto load = [&](std::string& message) { return m_disk.load(points, triangles, message); };
    const auto solve = [&] {
      if(!find_start(start, points.cols(), x, summary))
        return;
      typename Traits::template Minimizer<2, Traits_over_mpi<Traits>> minimizer(m_disk.domain(), m_traits);
      minimizer.minimize(x, summary);
    };
    run_map(
      summary, load, solve, [&] { write(x, points.cols(), result, summary); }, m_world);
    return summary;
  }

private:
  // The linear systems of a start are solved to the end, or elements flip.
  static constexpr double START_TOLERANCE = 1e-13;
  static constexpr int START_ITERATIONS = 10000;

  bool find_start(const Positions<2>& start, Eigen::Index points, Positions<2>& x, Summary& summary)
  {
    const Phase_timer timer(summary.seconds.start);
    const bool is_given = m_world.any(start.cols() != 0);
    if(m_world.any(is_given && start.cols() != points)) {
      summary.status = Status::invalid_option;
      summary.message = "the slice of the start must have a place for each point of the slice of the mesh";
      return false;
    }
    summary.status = Status::success;
    summary.start = "given";
    if(!is_given) {
      using Solver = typename Traits_over_mpi<Traits>::Linear_solver;
      const Tutte_initializer<typename Traits::Kernel, Solver, typename Traits::Concurrency_tag, Mpi_world> tutte(m_traits.start, m_world);
      summary.status = tutte(
        m_disk.domain(), [this] { return Solver(m_world, START_TOLERANCE, START_ITERATIONS); }, x, summary.start, summary.message);
    }
    m_disk.forget_border();
    if(is_given)
      x = m_disk.to_parts(start) / m_disk.domain().scale;
    else
      x.conservativeResize(2, m_disk.domain().number_of_vertices);
    return summary.status == Status::success;
  }

  // Certifies the map in the numbers of the result.
  template <typename Point>
  void write(const Positions<2>& x, Eigen::Index points, std::vector<Point>& result, Summary& summary) const
  {
    Positions<2> written(2, x.cols());
    for(Eigen::Index v = 0; v < x.cols(); ++v) {
      const Point p = make_point_2<Point>(m_disk.domain().scale * x(0, v), m_disk.domain().scale * x(1, v));
      written.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]);
    }
    Element_coloring schedule;
    schedule.build(m_disk.domain().elements, m_disk.domain().number_of_vertices,
                   m_world.counted_elements(m_disk.domain().number_of_elements()));
    const bool is_finite = !m_world.any(!written.allFinite());
    if(!is_finite || m_world.sum(static_cast<double>(
                       count_flips<typename Traits::Kernel, typename Traits::Concurrency_tag>(m_disk.domain(), schedule, written))) > 0) {
      summary.status = Status::result_not_representable;
      summary.message = "elements flip when the map is converted to the number type of the result";
      return;
    }
    Positions<2> slice = Positions<2>::Zero(2, points);
    m_disk.to_slices(written, slice);
    result.clear();
    for(Eigen::Index i = 0; i < points; ++i)
      result.push_back(make_point_2<Point>(slice(0, i), slice(1, i)));
  }

  Mpi_world m_world;
  Traits_over_mpi<Traits> m_traits;
  Distributed_disk m_disk;
};

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Flattens a disk of triangles over the ranks of a communicator of MPI, with a free border, as `parameterize()` does in one process and
/// `deform_volume_over_mpi()` does with solids: what is said there of slices, settings, failures and determinism holds here.
///
/// The start is an embedding of Tutte, by the same linear solver and certified by exact predicates on all ranks, or given. Holes are
/// refused, with `not_a_disk`, and so are mean value weights, which need another solver.
///
/// \param comm the ranks; MPI must have been initialised
/// \param points this rank's slice of the points: the ranks have consecutive ones
/// \param triangles this rank's slice of the triangles, as indices into the points of all ranks
/// \param uv receives the slice of the map, in the units of the surface, if it is valid, and is left untouched otherwise. Points that no
///   triangle uses are 0.
/// \param np optional named parameters: `map_traits` and `map_options`, and `start_map` with a container of this rank's slice of planar points
/// \returns as `parameterize()`, and `interrupted` when a rank has thrown
template <typename PointRange, typename TriangleRange, typename UVRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Summary parameterize_over_mpi(MPI_Comm comm, const PointRange& points, const TriangleRange& triangles, UVRange& uv,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  const Mpi_world world(comm);
  return internal::run_over_mpi(world, [&] {
    Positions<3> point_slice(3, points.size());
    Eigen::Index i = 0;
    for(const auto& p : points)
      point_slice.col(i++) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
    std::vector<Distributed_disk::Triangle> triangle_slice;
    for(const auto& t : triangles)
      triangle_slice.push_back({static_cast<std::int64_t>(t[0]), static_cast<std::int64_t>(t[1]), static_cast<std::int64_t>(t[2])});
    Positions<2> start(2, 0);
    if constexpr(internal::Has_parameter<NamedParameters, internal::Start_map_tag>::value) {
      const auto places = CGAL::parameters::get_parameter(np, internal::start_map_tag);
      start.resize(2, places.size());
      i = 0;
      for(const auto& p : places)
        start.col(i++) << CGAL::to_double(p[0]), CGAL::to_double(p[1]);
    }
    const auto traits = internal::chosen_traits<Map_traits_over_mpi>(np);
    std::vector<typename UVRange::value_type> slice;
    const Summary summary =
      internal::Disk_over_mpi<std::decay_t<decltype(traits)>>(world, traits).run(point_slice, triangle_slice, start, slice);
    if(summary.is_valid())
      uv = UVRange(slice.begin(), slice.end());
    return summary;
  });
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZE_OVER_MPI_H
