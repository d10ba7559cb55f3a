// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>
#include <CGAL/Flip_free_maps/domains/internal/tetgen.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Outcome.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/tetrahedralization/internal/Closed_surface.h>
#include <CGAL/Flip_free_maps/tetrahedralization/internal/run_in_subprocess.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstring>
#include <string>
#include <utility>

/// \file

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `tetrahedralize_with_tetgen()`.
struct Tetgen_options
{
  /// Upper bound for the edge length of a regular tetrahedron as large as the largest one, relative to the diagonal of the
  /// bounding box of the surface; from 0.001 to 1, where 1 leaves the size free.
  /// Tetrahedra at a boundary that is coarser remain larger.
  double cell_size = 0.05;
  /// Upper bound for the ratio of circumradius and shortest edge of the tetrahedra in the interior; at least 1.2, or 0 for none:
  /// then only the size demands additional vertices.
  double radius_edge_ratio = 1.6;

  /// Checks the ranges; when a value is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const;
};

namespace internal {

// A power of two, so that a division by it is exact, that brings the surface to size 1: TetGen's switches are decimal fractions.
inline double tetgen_unit(const Closed_surface& surface) { return std::exp2(std::ceil(std::log2(surface.diagonal()))); }

void fill_tetgenio(const Closed_surface& surface, tetgenio& input);

// p: a piecewise linear complex; Y: the boundary stays as it is; q, a: bounds for ratio and volume; Q: no report.
std::string tetgen_switches(const Closed_surface& surface, const Tetgen_options& options);

// Writes the points and the tetrahedra as bytes; returns 0, or the number that TetGen throws.
int run_tetgen(const Closed_surface& surface, const Tetgen_options& options, std::string& bytes);

// False when the bytes are not complete.
bool unpack_tetgen(const Closed_surface& surface, const std::string& bytes, Tetrahedral_mesh& mesh);

// What the numbers mean that TetGen throws.
Status tetgen_failure(int code, std::string& message);

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Fills a closed triangle mesh with tetrahedra by TetGen 1.5. The boundary of the result is the given surface: its triangles are
/// those of the surface, and its vertices come first, in the order of `vertices(surface)`, without those that have no face.
/// TetGen runs in a process of its own where the operating system has `fork()`, since version 1.5 crashes when it cannot mesh a
/// surface. Needs the macro `CGAL_FLIP_FREE_MAPS_USE_TETGEN` and the library `tet`.
///
/// \tparam FaceGraph must be a model of `VertexListGraph` and `FaceListGraph` whose vertex descriptors are `Hashable`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param surface a closed connected triangle mesh without self-intersections; the orientation does not matter
/// \param volume receives the tetrahedra, all of the same orientation, and the triangles of their boundary;
///   not changed on failure
/// \param options sizes
/// \param message receives a sentence on failure
/// \param np optional named parameters: `vertex_point_map`, as in `parameterize()`
///
/// \returns `success`, `invalid_option`, `empty_mesh`, `not_triangular`, `several_components`, `non_manifold` (not closed,
///   several sheets at a vertex, or self-intersecting), `degenerate_rest_element` (also for what is too small or too close for
///   TetGen), `non_finite_input`, `out_of_memory` or `interrupted`, by a `Deadline`
template <typename FaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status tetrahedralize_with_tetgen(const FaceGraph& surface, Tetrahedral_mesh& volume, const Tetgen_options& options, std::string& message,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Closed_surface closed;
  const Status status = internal::load_closed_surface(surface, options, np, closed, message);
  if(status != Status::success)
    return status;
  if(closed.number_of_components() > 1) {
    message = "the surface has " + std::to_string(closed.number_of_components()) + " components";
    return Status::several_components;
  }

  // When TetGen 1.5 throws it has freed its memory, which its destructor then frees again: a failure would end this process.
  std::string bytes;
  int code = 0;
  const internal::Apart_end end =
    internal::run_in_subprocess([&](std::string& result) { return internal::run_tetgen(closed, options, result); }, bytes, code);
  if(end == internal::Apart_end::not_started) {
    message = "no process could be started for TetGen";
    return Status::out_of_memory;
  }
  if(end == internal::Apart_end::interrupted) {
    message = "TetGen was interrupted";
    return Status::interrupted;
  }
  if(end == internal::Apart_end::crashed || code != 0)
    return internal::tetgen_failure(code, message);
  Tetrahedral_mesh result;
  if(!internal::unpack_tetgen(closed, bytes, result))
    return internal::tetgen_failure(0, message);
  result.triangles = boundary_triangles(result);
  volume = std::move(result);
  return Status::success;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the sizes as a named parameter, `tetrahedralization_options` of `Flip_free_maps::parameters`.
template <typename FaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Outcome tetrahedralize_with_tetgen(const FaceGraph& surface, Tetrahedral_mesh& volume,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  Outcome outcome(Status::success, "");
  outcome.status = tetrahedralize_with_tetgen(
    surface, volume, internal::parameter_or(np, internal::tetrahedralization_options_tag, Tetgen_options()), outcome.message, np);
  return outcome;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_TETGEN

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/tetrahedralize_with_tetgen_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_H
