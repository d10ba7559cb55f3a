// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Block_graph.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A matrix and its coarser versions. All functions that call PETSc, and the destructor, need a Petsc_scope around them.
class Petsc_hierarchy
{
public:
  bool analyze_pattern(const Block_sparse_matrix& matrix);

  void set_positions(const Eigen::VectorXd& positions) { m_positions = positions; }

  bool build(const Block_sparse_matrix& matrix);

  bool cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  std::int64_t number_of_entries() const { return static_cast<std::int64_t>(m_values.size()); }

private:
  // By which corrections of rigid pieces are lengthened: they are too stiff to bend, and corrections too short.
  static constexpr double OVERCORRECTION = 1.4;
  // Unknowns at which a direct solver takes over.
  static constexpr PetscInt COARSEST = 1000;

  template <int b>
  void fill_columns();

  template <int b>
  bool fill_values(const Block_sparse_matrix& matrix);

  bool make_matrix();
  bool tell_rigid_motions();
  bool make_levels();
  bool choose_smoothers();
  bool smooth_by_sweeps(PetscInt level);

  Block_graph m_graph;
  std::int64_t m_entries = -1;        // of the matrix analysed
  std::vector<std::int32_t> m_before; // blocks on the left of each row's diagonal block
  std::vector<PetscInt> m_rows, m_columns;
  std::vector<double> m_values;
  Eigen::VectorXd m_positions;
  Petsc_handle<Mat, MatDestroy> m_matrix;
  Petsc_handle<Vec, VecDestroy> m_right, m_left;
  Petsc_handle<PC, PCDestroy> m_levels;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_hierarchy_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_PETSC_HIERARCHY_H
