// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `RefactorizationRule` describes when a preconditioner whose matrix varies is assembled and factorized anew.
Preconditioners with a constant matrix do not ask it.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Every_iteration}
\cgalHasModels{CGAL::Flip_free_maps::On_demand}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::RefactorizationRuleConcept`
*/
class RefactorizationRule
{
public:
  /// What to do now: keep the factorization, refresh it, or refresh it and let the acceleration forget what it knows. Not
  /// called where there is no choice: at the beginning, after a factorization that no step has followed yet, and after a
  /// direction that led nowhere.
  /// \param age accepted steps since the last factorization, at least 1
  /// \param last_step length of the last step in units of its direction, positive
  /// \param relative_decrease by how much it decreased the energy, relative to the energy after the step; not negative
  CGAL::Flip_free_maps::Refactorization operator()(int age, double last_step, double relative_decrease);
};
