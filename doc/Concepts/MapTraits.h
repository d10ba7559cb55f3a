// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `MapTraits` bundles the choices that make a method: types for each role, and the objects that carry their settings.
The algorithms copy the traits and change only their copy.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Any_map_traits}
\cgalHasModels{CGAL::Flip_free_maps::Flip_free_map_traits}
\cgalHasModels{CGAL::Flip_free_maps::Splitting_map_traits}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::MapTraitsConcept`
\sa `CGAL::Flip_free_maps::parameterize()`
\sa `CGAL::Flip_free_maps::Map_minimizer`
*/
class MapTraits
{
public:
  /// \name Types
  /// @{

  /// The kernel that certifies the maps. In the plane it provides `Point_2`, constructible from two numbers of type `double`,
  /// and `Orientation_2`, default constructible, whose `operator()` takes three such points; in space `Point_3` and
  /// `Orientation_3` with one coordinate and one point more. The orientations must be exact for the given numbers, as those of
  /// `CGAL::Exact_predicates_inexact_constructions_kernel` are.
  typedef unspecified_type Kernel;

  /// A model of `DistortionEnergy`.
  typedef unspecified_type Energy;

  /// A model of `Preconditioner` for `Energy`.
  typedef unspecified_type Preconditioner;

  /// A model of `Reference`.
  typedef unspecified_type Reference;

  /// A model of `SymmetricSparseSolver`.
  typedef unspecified_type Linear_solver;

  /// A model of `Acceleration`.
  typedef unspecified_type Acceleration;

  /// A model of `RefactorizationRule`.
  typedef unspecified_type Refactorization_rule;

  /// `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`.
  typedef unspecified_type Concurrency_tag;

  /// Optional, with a member `world` of this type: a model of `World`. Without it, the minimiser works alone.
  typedef unspecified_type World;

  /// The class that runs the method on maps of dimension `D`, where `Traits` are these traits, or a class derived from them, so
  /// that derived traits inherit it: `CGAL::Flip_free_maps::Map_minimizer<D, Traits>`, or another class that is constructed from
  /// the same arguments and has `options()`, `analyze()`, `minimize()` and `move_fixed_vertices()` like it. What takes terms of
  /// one's own, or asks for bijective maps, needs the former.
  template <int D, typename Traits>
  using Minimizer = unspecified_type;

  /// @}

  /// \name Choices
  /// @{

  Energy energy;                             ///< what is minimised
  Preconditioner preconditioner;             ///< how directions are found
  Reference reference;                       ///< the rest shape to measure against
  Acceleration acceleration;                 ///< what is made of successive directions
  Refactorization_rule refactorization_rule; ///< when the preconditioner is factorized
  CGAL::Flip_free_maps::Map_options options; ///< stopping rules, step lengths, observer
  CGAL::Flip_free_maps::Start_options start; ///< the start of a parameterization; the minimizer does not use it

  /// @}

  /// A new linear solver, returned by value.
  Linear_solver make_linear_solver() const;
};
