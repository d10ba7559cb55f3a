// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_OVER_MPI_H
#define CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_OVER_MPI_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/distribution/Distributed_volume_domain.h>
#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/distribution/internal/Traits_over_mpi.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// The default method with the settings that a mesh in parts needs: one thread in each process, and nothing that looks at the whole
/// mesh: blocked vertices are not freed, and factorizations not renewed.
struct Map_traits_over_mpi
  : Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default,
                         CGAL::Sequential_tag>
{
  Map_traits_over_mpi()
  {
    options.free_blocked_vertices = false;
    options.renew_factorization = false;
  }
};

namespace internal {

// What `run()` returns on all ranks; whatever one of them throws ends all with a status.
template <typename Run>
Summary run_over_mpi(const Mpi_world& world, Run&& run)
{
  Summary summary;
  const auto fail = [&summary](Status status, const char* message) {
    summary.status = status;
    summary.message = message;
  };
  try {
    world.together([&] { summary = run(); });
  } catch(const std::bad_alloc&) {
    fail(Status::out_of_memory, "memory was exhausted on one of the ranks");
  } catch(const Interruption& interruption) {
    fail(Status::interrupted, interruption.what());
  } catch(const Common_failure& failure) {
    fail(Status::interrupted, failure.what());
  }
  return summary;
}

// Writes to the positions of a part of a mesh.
template <typename Point>
struct Part_map
{
  using key_type = std::int64_t;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::writable_property_map_tag;

  const Distributed_volume_domain* volume;
  Positions<3>* positions;

  friend void put(const Part_map& map, std::int64_t vertex, const Point& p)
  {
    map.positions->col(map.volume->number(vertex)) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
  }
};

// The slices of a mesh and the handles of all ranks, in the form in which they are sent.
struct Sliced_solid
{
  Positions<3> points;
  std::vector<Distributed_volume_domain::Tetrahedron> tetrahedra;
  std::vector<std::pair<std::int64_t, std::array<double, 3>>> handles;

  template <typename PointRange, typename TetrahedronRange, typename Handles>
  Sliced_solid(const Mpi_world& world, const PointRange& point_slice, const TetrahedronRange& tetrahedron_slice,
               const Handles& handle_slice)
    : points(3, point_slice.size())
  {
    Eigen::Index i = 0;
    for(const auto& p : point_slice)
      points.col(i++) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
    for(const auto& t : tetrahedron_slice)
      tetrahedra.push_back({static_cast<std::int64_t>(t[0]), static_cast<std::int64_t>(t[1]), static_cast<std::int64_t>(t[2]),
                            static_cast<std::int64_t>(t[3])});
    for(const auto& [v, p] : handle_slice)
      handles.push_back({static_cast<std::int64_t>(v), {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])}});
    handles = world.gather(handles);
  }

  std::vector<std::int64_t> handle_vertices() const
  {
    std::vector<std::int64_t> vertices;
    for(const auto& handle : handles)
      vertices.push_back(handle.first);
    return vertices;
  }
};

// Deforms a solid in slices. The slice of the result is written if the map is valid.
template <typename Point, typename Traits>
Summary deform_slices(const Mpi_world& world, const Sliced_solid& solid, std::vector<Point>& result, const Traits& traits,
                      Deform_volume_options options)
{
  Distributed_volume_domain volume(world);
  Positions<3> part;
  const auto load = [&](std::string& message) {
    Status status = volume.load(solid.points, solid.tetrahedra, solid.handle_vertices(), message);
    if(status != Status::success || !world.any(options.start.cols() != 0))
      return status;
    if(world.any(options.start.cols() != solid.points.cols())) {
      message = "the slice of the start must have a column for each point of the slice of the mesh";
      return Status::invalid_option;
    }
    options.start = volume.to_parts(options.start);
    return status;
  };
  const auto make_room = [&](std::string& message) {
    const Status status = load(message);
    part.resize(3, volume.domain().number_of_vertices);
    return status;
  };
  const Summary summary = deform_loaded_volume<std::int64_t, Mpi_world>(make_room, volume, solid.handles, Part_map<Point>{&volume, &part},
                                                                        Traits_over_mpi<Traits>(traits, world), options);
  if(!summary.is_valid())
    return summary;
  Positions<3> slice = solid.points;
  volume.to_slices(part, slice);
  result.clear();
  for(Eigen::Index i = 0; i < slice.cols(); ++i)
    result.push_back(make_point_3<Point>(slice(0, i), slice(1, i), slice(2, i)));
  return summary;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// `deform_volume()` over the ranks of a communicator of MPI, for solids that one process is too slow or too small for. The mesh is
/// given in slices, as it is read from a file; it is divided among the ranks, and the map comes back in the same slices. The minimiser
/// is that of one process, and finds the same map up to the tolerances and to rounding; the same number of ranks gives the same bits.
///
/// All ranks call this function, with the same settings, and all get the same status. When one of them throws, in an observer for
/// example, or runs out of memory, all end with a status. The limits of time of all ranks hold for all.
///
/// What needs the whole mesh is refused, with `invalid_option`: soft handles, freeing blocked vertices, renewed factorizations, and
/// references other than the rest shape. Handles may travel, as in one process. Targets that alone exclude a map without flips are not looked for: the
/// status is `unreachable_constraints` in the end.
///
/// \tparam PointRange,TetrahedronRange,Handles,ResultRange as of `deform_volume()` for arrays
///
/// \param comm the ranks; MPI must have been initialised
/// \param points this rank's slice of the points: the ranks have consecutive ones
/// \param tetrahedra this rank's slice of the tetrahedra, as indices into the points of all ranks
/// \param handles this rank's part of the handles: pairs of an index into the points of all ranks and a place
/// \param result receives this rank's slice of the result if the map is valid, and is left untouched otherwise
/// \param np optional named parameters: `map_traits`, of which the linear solver is not used and the energy, the preconditioner, the
///   acceleration and the refactorization rule are; `map_options`; and `volume_options`, with a slice of the start. <b>Default:</b>
///   `Map_traits_over_mpi`
/// \returns as `deform_volume()`, and `interrupted` when a rank has thrown. Counts are of the whole mesh, times, memory and
///   `factor_entries` of this rank.
///
/// Complexity: work and memory of a rank are those of `deform_volume()` on its part and a layer of tetrahedra around it, and of all
/// handles. Directions are found by conjugate gradients with `Distributed_multigrid`.
template <typename PointRange, typename TetrahedronRange, typename Handles, typename ResultRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Summary deform_volume_over_mpi(MPI_Comm comm, const PointRange& points, const TetrahedronRange& tetrahedra, const Handles& handles,
                               ResultRange& result, const NamedParameters& np = CGAL::parameters::default_values())
{
  const Mpi_world world(comm);
  return internal::run_over_mpi(world, [&] {
    const internal::Sliced_solid solid(world, points, tetrahedra, handles);
    std::vector<typename ResultRange::value_type> slice;
    const Summary summary = internal::deform_slices(world, solid, slice, internal::chosen_traits<Map_traits_over_mpi>(np),
                                                    internal::parameter_or(np, internal::volume_options_tag, Deform_volume_options()));
    if(summary.is_valid())
      result = ResultRange(slice.begin(), slice.end());
    return summary;
  });
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_OVER_MPI_H
