// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_FLIP_FREE_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_METHOD_FLIP_FREE_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/accelerations/Lbfgs.h>
#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/linear_solver_traits.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/Start_options.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Automatic_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid.h>
#endif
#endif
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/preconditioners/Adaptive_preconditioner.h>
#include <CGAL/Flip_free_maps/references/Fixed_reference.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

template <int D, typename Traits>
class Map_minimizer;

#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && defined(CGAL_FLIP_FREE_MAPS_USE_CORE)
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
extern template class Conjugate_gradient_solver<Petsc_multigrid>;
extern template class Automatic_solver<Cholmod_solver, Conjugate_gradient_solver<Petsc_multigrid>>;
#else
extern template class Automatic_solver<Cholmod_solver>;
#endif
#endif

// The default solver is part of the name: units that see CHOLMOD, or PETSc besides, and units that do not are different programs
// to the linker.
#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && !defined(DOXYGEN_RUNNING)
inline namespace with_cholmod {
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
inline namespace with_petsc {
#endif
#endif

/// \ingroup PkgFlipFreeMapsRef
/// Bundles the choices that make a method: what is minimised, how directions are found, and with which settings.
///
/// \tparam Kernel_ must be a CGAL kernel with exact orientation predicates and number type `double`, which certifies the maps.
///         <b>Default:</b> \code CGAL::Exact_predicates_inexact_constructions_kernel \endcode
/// \tparam Energy_ must be a model of `DistortionEnergy`. <b>Default:</b> \code Symmetric_dirichlet \endcode
/// \tparam Preconditioner_ must be a model of `Preconditioner`. <b>Default:</b> \code Adaptive_preconditioner \endcode
/// \tparam Reference_ must be a model of `Reference`. <b>Default:</b> \code Fixed_reference \endcode
/// \tparam LinearSolver_ must be a model of `SymmetricSparseSolver` and have a default constructor.
///         <b>Default:</b> \code Automatic_solver<Cholmod_solver> \endcode when
///         `CGAL_FLIP_FREE_MAPS_USE_CHOLMOD` is defined, which iterates with `Petsc_multigrid` when `CGAL_FLIP_FREE_MAPS_USE_PETSC`
///         is defined, too; \code Eigen_simplicial_solver \endcode otherwise
/// \tparam Acceleration_ must be a model of `Acceleration`. <b>Default:</b> \code Lbfgs \endcode
/// \tparam RefactorizationRule_ must be a model of `RefactorizationRule`. <b>Default:</b> \code On_demand \endcode
/// \tparam ConcurrencyTag_ whether elements are processed in parallel: `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///         `CGAL::Parallel_if_available_tag`. Results do not depend on it.
///         <b>Default:</b> \code CGAL::Parallel_if_available_tag \endcode
///
/// Any parameter may be `CGAL::Default`. The default method takes SLIM's proxy on badly distorted elements and the projected
/// Hessian elsewhere, and lets L-BFGS reuse a factorization near the optimum; on developable surfaces it takes the Killing
/// operator. The papers' directions are those of
/// `Flip_free_map_traits<CGAL::Default, CGAL::Default, P, CGAL::Default, CGAL::Default, No_acceleration, Every_iteration>` with P
/// one of `Killing`, `Slim`, `Composite_majorization<>` and `Projected_newton`; their line searches and starts are settings, which
/// `Any_map_traits::use_method()` makes.
///
/// \cgalModels{MapTraits}
template <typename Kernel_ = CGAL::Default, typename Energy_ = CGAL::Default, typename Preconditioner_ = CGAL::Default,
          typename Reference_ = CGAL::Default, typename LinearSolver_ = CGAL::Default, typename Acceleration_ = CGAL::Default,
          typename RefactorizationRule_ = CGAL::Default, typename ConcurrencyTag_ = CGAL::Default>
class Flip_free_map_traits
{
#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && defined(CGAL_FLIP_FREE_MAPS_USE_PETSC)
  using Default_linear_solver = Automatic_solver<Cholmod_solver, Conjugate_gradient_solver<Petsc_multigrid>>;
#elif defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD)
  using Default_linear_solver = Automatic_solver<Cholmod_solver>;
#else
  using Default_linear_solver = Eigen_simplicial_solver;
#endif

public:
  /// \name Types
  /// @{

  /// Certifies the maps.
  using Kernel = typename CGAL::Default::Get<Kernel_, CGAL::Exact_predicates_inexact_constructions_kernel>::type;
  /// Model of `DistortionEnergy`.
  using Energy = typename CGAL::Default::Get<Energy_, Symmetric_dirichlet>::type;
  /// Model of `Preconditioner`.
  using Preconditioner = typename CGAL::Default::Get<Preconditioner_, Adaptive_preconditioner>::type;
  /// Model of `Reference`.
  using Reference = typename CGAL::Default::Get<Reference_, Fixed_reference>::type;
  /// Model of `SymmetricSparseSolver`.
  using Linear_solver = typename CGAL::Default::Get<LinearSolver_, Default_linear_solver>::type;
  /// Model of `Acceleration`.
  using Acceleration = typename CGAL::Default::Get<Acceleration_, Lbfgs>::type;
  /// Model of `RefactorizationRule`.
  using Refactorization_rule = typename CGAL::Default::Get<RefactorizationRule_, On_demand>::type;
  /// Whether elements are processed in parallel.
  using Concurrency_tag = typename CGAL::Default::Get<ConcurrencyTag_, CGAL::Parallel_if_available_tag>::type;
  /// Runs the method. `Traits` are these traits, or a class derived from them. It is declared here, and defined in
  /// `minimizer/Map_minimizer.h`.
  template <int D, typename Traits>
  using Minimizer = Map_minimizer<D, Traits>;
  /// @}

  /// \name Choices
  /// The objects may be replaced or changed before they are used.
  /// @{
  Energy energy;                             ///< what is minimised
  Preconditioner preconditioner;             ///< how directions are found
  Reference reference;                       ///< the rest shape to measure against
  Acceleration acceleration;                 ///< what is made of successive directions
  Refactorization_rule refactorization_rule; ///< when the preconditioner is factorized
  Map_options options;                       ///< stopping rules, step lengths, observer
  Start_options start;                       ///< the start of a parameterization
  /// @}

  /// Prepares the default method, and only it, for a surface that can be flattened without distortion. `parameterize()` calls it
  /// when the surface's total curvature, the sum of |2 pi - angles| over all inner vertices, is at most 0.3, and isometries are
  /// strict minima of the energy. The start is then the surface unfolded triangle by triangle, or, where that tears, one from
  /// coarse to fine on meshes of all sizes. From there the Killing operator, factorized in every iteration, needs fewer
  /// iterations than any other method (three or four): it knows the rigid motions of the image,
  /// which are what remains to be found.
  template <typename P = Preconditioner, typename A = Acceleration, typename R = Refactorization_rule>
  std::enable_if_t<std::is_same<P, Adaptive_preconditioner>::value && std::is_same<A, Lbfgs>::value && std::is_same<R, On_demand>::value>
  adapt_to_developable_surface()
  {
    preconditioner.uses_killing = true;
    acceleration = Lbfgs(0);
    refactorization_rule.largest_age = 0;
    if(start.multilevel_size >= 0) {
      start.unfold = true;
      start.multilevel_size = 0;
    }
  }

  /// A new linear solver, within `Map_options::memory_budget` if it takes one.
  Linear_solver make_linear_solver() const { return internal::make_solver<Linear_solver>(options.memory_budget); }
};

#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && !defined(DOXYGEN_RUNNING)
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
} // namespace with_petsc
#endif
} // namespace with_cholmod
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_FLIP_FREE_MAP_TRAITS_H
