// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/Map_options.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/initializers/Start_options.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#endif
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/references/Fixed_reference.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Bundles the choices that make a method: what is minimised, how directions are found, and with which settings.
///
/// \tparam Kernel must be a CGAL kernel with exact orientation predicates and number type `double`, which certifies the maps.
///         <b>Default:</b> \code CGAL::Exact_predicates_inexact_constructions_kernel \endcode
/// \tparam Energy must be a model of `DistortionEnergy`. <b>Default:</b> \code Symmetric_dirichlet \endcode
/// \tparam Preconditioner must be a model of `Preconditioner`. <b>Default:</b> \code Projected_newton \endcode
/// \tparam Reference must be a model of `Reference`. <b>Default:</b> \code Fixed_reference \endcode
/// \tparam LinearSolver must be a model of `SymmetricSparseSolver`. <b>Default:</b> \code Cholmod_solver \endcode when
///         `CGAL_FLIP_FREE_MAPS_USE_CHOLMOD` is defined, \code Eigen_simplicial_solver \endcode otherwise
/// \tparam Acceleration must be a model of `Acceleration`. <b>Default:</b> \code No_acceleration \endcode
/// \tparam RefactorizationRule must be a model of `RefactorizationRule`. <b>Default:</b> \code Every_iteration \endcode
/// \tparam ConcurrencyTag whether elements are processed in parallel: `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///         `CGAL::Parallel_if_available_tag`. Results do not depend on it.
///         <b>Default:</b> \code CGAL::Parallel_if_available_tag \endcode
///
/// Any parameter may be `CGAL::Default`.
///
/// \cgalModels{MapTraits}
template <typename Kernel_ = CGAL::Default, typename Energy_ = CGAL::Default, typename Preconditioner_ = CGAL::Default,
          typename Reference_ = CGAL::Default, typename LinearSolver_ = CGAL::Default, typename Acceleration_ = CGAL::Default,
          typename RefactorizationRule_ = CGAL::Default, typename ConcurrencyTag_ = CGAL::Default>
class Flip_free_map_traits
{
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  using Default_linear_solver = Cholmod_solver;
#else
  using Default_linear_solver = Eigen_simplicial_solver;
#endif

public:
  /// \name Types
  /// @{
  using Kernel = typename CGAL::Default::Get<Kernel_, CGAL::Exact_predicates_inexact_constructions_kernel>::type;
  using Energy = typename CGAL::Default::Get<Energy_, Symmetric_dirichlet>::type;
  using Preconditioner = typename CGAL::Default::Get<Preconditioner_, Projected_newton>::type;
  using Reference = typename CGAL::Default::Get<Reference_, Fixed_reference>::type;
  using Linear_solver = typename CGAL::Default::Get<LinearSolver_, Default_linear_solver>::type;
  using Acceleration = typename CGAL::Default::Get<Acceleration_, No_acceleration>::type;
  using Refactorization_rule = typename CGAL::Default::Get<RefactorizationRule_, Every_iteration>::type;
  using Concurrency_tag = typename CGAL::Default::Get<ConcurrencyTag_, CGAL::Parallel_if_available_tag>::type;
  /// @}

  /// \name Choices
  /// The objects may be replaced or changed before they are used.
  /// @{
  Energy energy;                            ///< what is minimised
  Preconditioner preconditioner;            ///< how directions are found
  Reference reference;                      ///< the rest shape to measure against
  Acceleration acceleration;                ///< what is made of successive directions
  Refactorization_rule refactorization_rule;///< when the preconditioner is factorized
  Map_options options;                      ///< stopping rules, step lengths, observer
  Start_options start;                      ///< the start of a parameterization
  /// @}

  /// A new linear solver.
  Linear_solver make_linear_solver() const { return Linear_solver(); }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H
