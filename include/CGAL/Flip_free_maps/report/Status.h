// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_STATUS_H
#define CGAL_FLIP_FREE_MAPS_REPORT_STATUS_H

#include <ostream>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// How a run ended. The first four values leave a valid map (every element positively oriented by exact predicates) in the
/// caller's property map; every other value leaves the caller's property map untouched.
enum class Status
{
  success,                  ///< converged by the stopping rule named in `Summary::message`
  iteration_limit,          ///< valid map, `Map_options::max_iterations` reached
  time_limit,               ///< valid map, `Map_options::max_seconds` or the time of a `Deadline` reached
  stopped_by_observer,      ///< valid map, the observer asked to stop, or a `Deadline` was cancelled
  empty_mesh,               ///< no face to map
  not_triangular,           ///< a face has more than three edges
  no_border,                ///< the surface is closed, or the given halfedge is not on the border
  several_components,       ///< several connected components where one is wanted
  not_a_disk,               ///< the surface has handles: neither a disk nor a disk with holes
  non_manifold,             ///< a vertex or an edge is used by more than one sheet of the surface
  degenerate_rest_element,  ///< an element of the input has zero area or volume
  non_finite_input,         ///< a coordinate of the input is NaN or infinite
  start_not_flip_free,      ///< no start without flipped elements was found
  unreachable_constraints,  ///< the constraints cannot be met by a flip-free map
  linear_solver_failed,     ///< no factorization succeeded, not even with a shifted matrix
  line_search_failed,       ///< no step decreases the energy, although the map is not stationary
  result_not_representable, ///< flip-free in double precision, but not after conversion to the number type of the result
  invalid_option,           ///< an option is out of its range
  file_error,               ///< a file could not be read or written
  out_of_memory,            ///< memory was exhausted
  not_planar,               ///< the rest shape of a planar deformation does not lie in a plane z = const
  flips_remain,             ///< no map without flipped elements was found from the given one
  not_bijective,            ///< the map was to be bijective, and no such map was found
  interrupted               ///< a limit of time or a cancellation ended the run before there was a valid map, see `Deadline`
};

/// \ingroup PkgFlipFreeMapsRef
/// The name of a status, as spelled in the enumeration.
inline const char* status_name(Status status)
{
  switch(status) {
  case Status::success:
    return "success";
  case Status::iteration_limit:
    return "iteration_limit";
  case Status::time_limit:
    return "time_limit";
  case Status::stopped_by_observer:
    return "stopped_by_observer";
  case Status::empty_mesh:
    return "empty_mesh";
  case Status::not_triangular:
    return "not_triangular";
  case Status::no_border:
    return "no_border";
  case Status::several_components:
    return "several_components";
  case Status::not_a_disk:
    return "not_a_disk";
  case Status::non_manifold:
    return "non_manifold";
  case Status::degenerate_rest_element:
    return "degenerate_rest_element";
  case Status::non_finite_input:
    return "non_finite_input";
  case Status::start_not_flip_free:
    return "start_not_flip_free";
  case Status::unreachable_constraints:
    return "unreachable_constraints";
  case Status::linear_solver_failed:
    return "linear_solver_failed";
  case Status::line_search_failed:
    return "line_search_failed";
  case Status::result_not_representable:
    return "result_not_representable";
  case Status::invalid_option:
    return "invalid_option";
  case Status::file_error:
    return "file_error";
  case Status::out_of_memory:
    return "out_of_memory";
  case Status::not_planar:
    return "not_planar";
  case Status::flips_remain:
    return "flips_remain";
  case Status::not_bijective:
    return "not_bijective";
  case Status::interrupted:
    return "interrupted";
  }
  return "unknown";
}

/// \ingroup PkgFlipFreeMapsRef
/// Writes the name of a status.
inline std::ostream& operator<<(std::ostream& os, Status status) { return os << status_name(status); }

/// \ingroup PkgFlipFreeMapsRef
/// `true` for the statuses that leave a valid map in the caller's property map.
inline bool is_valid_map(Status status) { return status <= Status::stopped_by_observer; }

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_STATUS_H
