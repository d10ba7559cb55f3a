// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A matrix and its factor by MUMPS. All functions, and the destructor, need a Petsc_scope around them.
class Petsc_factor
{
public:
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  bool factorize(const Block_sparse_matrix& matrix);

  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  std::int64_t number_of_entries() const { return m_factor_entries; }

private:
  bool is_positive_definite();

  std::vector<PetscInt> m_rows, m_columns;
  std::vector<double> m_values;
  std::int64_t m_factor_entries = -1;
  bool m_is_factorized = false;
  Petsc_handle<Mat, MatDestroy> m_matrix, m_factor;
  Petsc_handle<Vec, VecDestroy> m_right, m_left;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_factor_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_H
