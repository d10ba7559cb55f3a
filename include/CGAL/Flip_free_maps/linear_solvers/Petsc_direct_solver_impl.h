// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_direct_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_factor.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <memory>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Petsc_direct_solver::Petsc_direct_solver() = default;

CGAL_FLIP_FREE_MAPS_INLINE Petsc_direct_solver::~Petsc_direct_solver()
{
  const internal::Petsc_scope scope;
  m_factor.reset();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_direct_solver::analyze_pattern(const Block_sparse_matrix& matrix)
{
  const internal::Petsc_scope scope;
  m_factor = std::make_unique<internal::Petsc_factor>();
  return scope.is_ready() && m_factor->analyze_pattern(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_direct_solver::factorize(const Block_sparse_matrix& matrix)
{
  const internal::Petsc_scope scope;
  return scope.is_ready() && m_factor != nullptr && m_factor->factorize(matrix);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_direct_solver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  const internal::Petsc_scope scope;
  return scope.is_ready() && m_factor != nullptr && m_factor->solve(b, x) && x.allFinite();
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t Petsc_direct_solver::factor_entries() const
{
  return m_factor != nullptr ? m_factor->number_of_entries() : -1;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_PETSC_DIRECT_SOLVER_IMPL_H
