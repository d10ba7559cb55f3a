// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_IMPL_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_factor.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_factor::analyze_pattern(const Block_sparse_matrix& matrix)
{
  if(matrix.rows() == 0 || matrix.number_of_entries() > PETSC_MAX_INT)
    return false;
  // The lower triangle by columns is the upper one by rows, which is what PETSc's symmetric matrices are made of.
  m_rows.assign(matrix.column_starts().begin(), matrix.column_starts().end());
  m_columns.assign(matrix.row_indices().begin(), matrix.row_indices().end());
  m_values.assign(matrix.values().size(), 1.);
  const PetscInt n = static_cast<PetscInt>(matrix.rows());
  MatFactorInfo info;
  return succeeded(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, nullptr, m_right.receive())) &&
         succeeded(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, nullptr, m_left.receive())) &&
         succeeded(
           MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, m_rows.data(), m_columns.data(), m_values.data(), m_matrix.receive())) &&
         succeeded(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE)) &&
         succeeded(MatGetFactor(m_matrix, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, m_factor.receive())) && m_factor != nullptr &&
         // The root, too, is factorized where pivots are counted.
         succeeded(MatMumpsSetIcntl(m_factor, 13, 1)) && succeeded(MatFactorInfoInitialize(&info)) &&
         succeeded(MatCholeskyFactorSymbolic(m_factor, m_matrix, nullptr, &info));
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_factor::factorize(const Block_sparse_matrix& matrix)
{
  m_is_factorized = false;
  if(m_factor == nullptr || matrix.values().size() != m_values.size())
    return false;
  // MUMPS is not prepared for what is no number.
  if(!std::all_of(matrix.values().begin(), matrix.values().end(), [](double value) { return std::isfinite(value); }))
    return false;
  std::copy(matrix.values().begin(), matrix.values().end(), m_values.begin());
  MatFactorInfo info;
  m_is_factorized = succeeded(MatFactorInfoInitialize(&info)) && succeeded(MatAssemblyBegin(m_matrix, MAT_FINAL_ASSEMBLY)) &&
                    succeeded(MatAssemblyEnd(m_matrix, MAT_FINAL_ASSEMBLY)) &&
                    succeeded(MatCholeskyFactorNumeric(m_factor, m_matrix, &info)) && is_positive_definite();
  return m_is_factorized;
}

// Whether the last factorization was one without negative pivots.
CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_factor::is_positive_definite()
{
  MatFactorError error = MAT_FACTOR_NOERROR;
  PetscInt negative = 0, entries = 0;
  if(!succeeded(MatFactorGetError(m_factor, &error)))
    return false;
  if(error == MAT_FACTOR_OUTMEMORY)
    throw std::bad_alloc();
  if(error != MAT_FACTOR_NOERROR || !succeeded(MatMumpsGetInfog(m_factor, 12, &negative)) || negative != 0)
    return false;
  // Large numbers are told in millions, with a minus sign.
  if(succeeded(MatMumpsGetInfog(m_factor, 29, &entries)))
    m_factor_entries = entries >= 0 ? entries : -1000000 * std::int64_t(entries);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Petsc_factor::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
{
  if(!m_is_factorized || b.size() + 1 != static_cast<Eigen::Index>(m_rows.size()))
    return false;
  x.resize(b.size());
  if(!succeeded(VecPlaceArray(m_right, b.data())) || !succeeded(VecPlaceArray(m_left, x.data())))
    return false;
  const bool solved = succeeded(MatSolve(m_factor, m_right, m_left));
  return succeeded(VecResetArray(m_right)) && succeeded(VecResetArray(m_left)) && solved;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_FACTOR_IMPL_H
