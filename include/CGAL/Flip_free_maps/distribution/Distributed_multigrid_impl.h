// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Distributed_multigrid.h>
#include <CGAL/Flip_free_maps/distribution/internal/Distributed_hierarchy.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <memory>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Distributed_multigrid::Distributed_multigrid(const Mpi_world& world) : m_world(world) {}

CGAL_FLIP_FREE_MAPS_INLINE Distributed_multigrid::~Distributed_multigrid() { release(); }

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_multigrid::release()
{
  const internal::Petsc_scope scope;
  if(m_hierarchy != nullptr)
    m_hierarchy->release();
  m_hierarchy.reset();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_multigrid::analyze_pattern(const Block_sparse_matrix& matrix)
{
  release();
  m_hierarchy = std::make_unique<internal::Distributed_hierarchy>(m_world);
  return m_hierarchy->analyze_pattern(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE void Distributed_multigrid::set_positions(const Eigen::VectorXd& positions)
{
  if(m_hierarchy != nullptr)
    m_hierarchy->set_positions(positions);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_multigrid::factorize(const Block_sparse_matrix& matrix)
{
  return m_hierarchy != nullptr && m_hierarchy->build(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Distributed_multigrid::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  return m_hierarchy != nullptr && m_hierarchy->solve(b, x);
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t Distributed_multigrid::factor_entries() const
{
  return m_hierarchy != nullptr ? m_hierarchy->number_of_entries() : -1;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_MULTIGRID_IMPL_H
