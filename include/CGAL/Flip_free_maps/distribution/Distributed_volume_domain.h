// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/distribution/internal/Mesh_division.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsWorlds
/// A tetrahedral mesh that is given in slices, of which each rank gets a part: consecutive points and tetrahedra on each rank, as they
/// are read from a file, go to the ranks that work on them. A vertex is named by its index among the points of all ranks.
///
/// The vertices are divided by PT-Scotch, weighted by their tetrahedra, since a rank works on all tetrahedra of its vertices. No rank
/// ever has the whole mesh.
class Distributed_volume_domain : public Volume_domain<std::int64_t, Mpi_world>
{
public:
  /// A tetrahedron by its vertices.
  using Tetrahedron = std::array<std::int64_t, 4>;

  /// On the ranks of `world`, each with a part of this mesh only.
  explicit Distributed_volume_domain(const Mpi_world& world) : Volume_domain<std::int64_t, Mpi_world>(world), m_division(world) {}

  /// Divides the mesh. Called by all ranks.
  ///
  /// \param points this rank's slice of the points, in columns; those that no tetrahedron uses may have any value
  /// \param tetrahedra this rank's slice of the tetrahedra
  /// \param handles vertices that each rank has to know, in whatever part they are; the same on all ranks
  /// \param message receives a sentence on failure
  /// \returns as `Tetrahedral_domain::load()`, on all ranks the same; `linear_solver_failed` if PETSc does not divide the mesh
  ///
  /// Complexity: linear in what a rank has, but for PT-Scotch.
  Status load(const Positions<3>& points, const std::vector<Tetrahedron>& tetrahedra, const std::vector<std::int64_t>& handles,
              std::string& message);

  /// Of columns for the slice of points, those of the local vertices, in the order of the flat arrays. Called by all ranks.
  Positions<3> to_parts(const Positions<3>& slice) const { return m_division.to_parts(slice); }

  /// Sets the columns of the slice of points whose vertices belong to a tetrahedron to those of the local vertices. Called by all ranks.
  void to_slices(const Positions<3>& part, Positions<3>& slice) const { m_division.to_slices(part, slice); }

private:
  internal::Mesh_division<4> m_division;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/Distributed_volume_domain_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_H
