// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_hierarchy.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <memory>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Petsc_multigrid::Petsc_multigrid() = default;

CGAL_FLIP_FREE_MAPS_INLINE Petsc_multigrid::~Petsc_multigrid()
{
  const internal::Petsc_scope scope;
  m_hierarchy.reset();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_multigrid::analyze_pattern(const Block_sparse_matrix& matrix)
{
  const internal::Petsc_scope scope;
  m_hierarchy = std::make_unique<internal::Petsc_hierarchy>();
  return scope.is_ready() && m_hierarchy->analyze_pattern(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE void Petsc_multigrid::set_positions(const Eigen::VectorXd& positions)
{
  if(m_hierarchy != nullptr)
    m_hierarchy->set_positions(positions);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_multigrid::factorize(const Block_sparse_matrix& matrix)
{
  const internal::Petsc_scope scope;
  return scope.is_ready() && m_hierarchy != nullptr && m_hierarchy->build(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_multigrid::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  const internal::Petsc_scope scope;
  return scope.is_ready() && m_hierarchy != nullptr && m_hierarchy->cycle(b, x) && x.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t Petsc_multigrid::factor_entries() const
{
  return m_hierarchy != nullptr ? m_hierarchy->number_of_entries() : -1;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_MULTIGRID_IMPL_H
