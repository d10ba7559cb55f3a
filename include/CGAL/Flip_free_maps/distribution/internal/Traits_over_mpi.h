// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_TRAITS_OVER_MPI_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_TRAITS_OVER_MPI_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Distributed_multigrid.h>
#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The method of given traits on the ranks of a world, with a linear solver that has the rows of each rank.
template <typename Base>
class Traits_over_mpi : public Base
{
public:
  using World = Mpi_world;
  using Linear_solver = Conjugate_gradient_solver<Distributed_multigrid, Mpi_world>;

  Traits_over_mpi(const Base& base, const World& w) : Base(base), world(w) {}

  Linear_solver make_linear_solver() const { return Linear_solver(world); }

  World world;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_TRAITS_OVER_MPI_H
