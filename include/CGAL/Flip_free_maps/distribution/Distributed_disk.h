// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/distribution/internal/Mesh_division.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsWorlds
/// A disk of triangles that is given in slices, of which each rank gets a part, as of a `Distributed_volume_domain`. Its border, which is
/// small beside it, is known to all ranks.
class Distributed_disk
{
public:
  /// A triangle by its vertices, counterclockwise as seen from outside.
  using Triangle = std::array<std::int64_t, 3>;

  /// On the ranks of `world`, each with a part of this disk only.
  explicit Distributed_disk(const Mpi_world& world) : m_world(world), m_division(world) {}

  /// Divides the surface. Called by all ranks.
  ///
  /// \param points this rank's slice of the points, in columns; those that no triangle uses may have any value
  /// \param triangles this rank's slice of the triangles
  /// \param message receives a sentence on failure
  /// \returns on all ranks the same: `success`, `empty_mesh`, `invalid_option` for an index out of range, `non_manifold`, `no_border`,
  ///   `several_components`, `not_a_disk`, also where there are holes, `non_finite_input`, `degenerate_rest_element`, or
  ///   `linear_solver_failed` if PETSc does not divide the mesh
  ///
  /// Complexity: linear in what a rank has and in the length of the border, but for PT-Scotch.
  Status load(const Positions<3>& points, const std::vector<Triangle>& triangles, std::string& message);

  /// The flat arrays of this rank's part, with the border of the disk: its vertices that are elsewhere follow the ghosts, and belong to no
  /// element.
  const Simplicial_domain<2>& domain() const { return m_domain; }

  /// Removes the border, and the vertices that are elsewhere.
  void forget_border();

  /// Of columns for the slice of points, those of the local vertices. Called by all ranks.
  Positions<2> to_parts(const Positions<2>& slice) const { return m_division.to_parts(slice).leftCols(m_domain.number_of_vertices); }

  /// Sets the columns of the slice of points whose vertices belong to a triangle to those of the local vertices. Called by all ranks.
  void to_slices(const Positions<2>& part, Positions<2>& slice) const { m_division.to_slices(part, slice); }

private:
  using Division = internal::Mesh_division<3>;

  Status find_border(const std::vector<Division::Numbered>& triangles, const internal::Slices& slices, std::string& message);
  Status join_border(const std::vector<std::array<std::int64_t, 2>>& edges, std::string& message);
  Status measure(Positions<3> points, std::string& message);
  void scale(double total);

  Mpi_world m_world;
  Division m_division;
  Simplicial_domain<2> m_domain;
  std::vector<std::int64_t> m_border;
  double m_euler_characteristic = 0;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/Distributed_disk_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_DISK_H
