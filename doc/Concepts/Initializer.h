// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `Initializer` describes functors that lay a disk in the plane without flipped elements, for the minimizer to start
from.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Multilevel_initializer}
\cgalHasModels{CGAL::Flip_free_maps::Tutte_initializer}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::InitializerConcept`
*/
class Initializer
{
public:
  /// Computes a start and certifies it with exact predicates.
  /// \tparam MakeLinearSolver is a functor without arguments that returns a new model of `SymmetricSparseSolver`
  /// \param domain a disk with its `border` and `border_lengths`
  /// \param make_linear_solver makes the solvers that are used
  /// \param x receives the start, a column for each vertex. Its area should be about 1, that of the domain. Undefined after a
  ///   failure.
  /// \param name receives what was used, fallbacks included, for `Summary::start`
  /// \param message receives a sentence after a failure
  /// \returns `CGAL::Flip_free_maps::Status::success` if all elements of `x` are positively oriented, otherwise a failure such as
  ///   `CGAL::Flip_free_maps::Status::start_not_flip_free`
  template <typename MakeLinearSolver>
  CGAL::Flip_free_maps::Status operator()(const CGAL::Flip_free_maps::Simplicial_domain<2>& domain,
                                          MakeLinearSolver&& make_linear_solver, CGAL::Flip_free_maps::Positions<2>& x,
                                          std::string& name, std::string& message) const;
};
