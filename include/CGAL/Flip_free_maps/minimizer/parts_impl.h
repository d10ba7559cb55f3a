// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_PARTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_PARTS_IMPL_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/Soft_positions.h>
#include <CGAL/Flip_free_maps/elements/internal/project_to_psd.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Handle_groups.h>
#include <CGAL/Flip_free_maps/minimizer/internal/remove_rigid_motion.h>

// What is the same for all methods of a dimension.

namespace CGAL {
namespace Flip_free_maps {

#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && defined(CGAL_FLIP_FREE_MAPS_USE_PETSC)
template class Conjugate_gradient_solver<Petsc_multigrid>;
template class Automatic_solver<Cholmod_solver, Conjugate_gradient_solver<Petsc_multigrid>>;
#elif defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD)
template class Automatic_solver<Cholmod_solver>;
#endif
template class Conjugate_gradient_solver<Incomplete_cholesky>;
template struct Position_constraints<2>;
template struct Position_constraints<3>;
template class Soft_positions<2>;
template class Soft_positions<3>;

namespace internal {

template void project_to_psd(Eigen::Matrix<double, 2, 2>&, bool);
template void project_to_psd(Eigen::Matrix<double, 3, 3>&, bool);
template void project_to_psd(Eigen::MatrixXd&, bool);
template class Handle_groups<2>;
template class Handle_groups<3>;
template void remove_rigid_motion<2>(const Positions<2>&, Eigen::VectorXd&, const Sequential_world&);
template void remove_rigid_motion<3>(const Positions<3>&, Eigen::VectorXd&, const Sequential_world&);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_PARTS_IMPL_H
