// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `Preconditioner` describes how directions are found: by a positive semidefinite quadratic form on the increment
\f$dJ\f$ of the Jacobian of each element, written down in the frame of the singular vectors, in which it has the few entries of
a `CGAL::Flip_free_maps::Increment_form`. The package turns it into a matrix on the positions of the vertices, factorizes that,
and solves for the direction. A preconditioner never sees a mesh nor a linear solver.

The full direction is the step that the quadratic form finds best, so the form should approximate the Hessian of the energy,
factor 1/2 not included: the energy itself gives `stretch` \f$= [\psi_{ij}]\f$.

Further members are optional:

- `void begin_iteration(const CGAL::Flip_free_maps::Iteration_state& state)`, called before each iteration, lets the form change in the
  course of a run.
- `bool can_retreat() const` and `void retreat()`, both or none: a form that may be indefinite is tried as long as
  `can_retreat()`. When the matrix turns out not to be positive definite, or gives no direction of descent, `retreat()` is called
  and the forms are written anew; from then on until the next `begin_iteration()` they must be positive semidefinite and
  `can_retreat()` must be `false`.
- `bool is_constant() const` overrides `Category` for preconditioners that are chosen at run time.
- `clamps_element_matrices`, a `bool`: whether the package is to project each element's matrix on the displacements of its
  vertices to the positive semidefinite ones. The form itself may be indefinite then.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Adaptive_preconditioner}
\cgalHasModels{CGAL::Flip_free_maps::Any_preconditioner}
\cgalHasModels{CGAL::Flip_free_maps::Composite_majorization}
\cgalHasModels{CGAL::Flip_free_maps::Hybrid}
\cgalHasModels{CGAL::Flip_free_maps::Killing}
\cgalHasModels{CGAL::Flip_free_maps::Laplacian}
\cgalHasModels{CGAL::Flip_free_maps::Newton}
\cgalHasModels{CGAL::Flip_free_maps::Projected_newton}
\cgalHasModels{CGAL::Flip_free_maps::Slim}
\cgalHasModels{CGAL::Flip_free_maps::Slim_newton}
\cgalHasModels{CGAL::Flip_free_maps::Vertex_space_newton}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::PreconditionerConcept`
\sa `DistortionEnergy`
*/
class Preconditioner
{
public:
  /// `CGAL::Flip_free_maps::Constant_matrix_tag` if the form of every element is the same in all iterations, so that one
  /// factorization serves them all; `CGAL::Flip_free_maps::Varying_matrix_tag` if it depends on the current map.
  typedef unspecified_type Category;

  /// Whether steps of length 1 are natural, as for Newton's method. Steps beyond 1 are tried, and short relative decreases of
  /// the energy count as convergence at once, only if so. A data member serves as well as a constant.
  static constexpr bool is_second_order = unspecified;

  /// The name of the preconditioner in reports, such as "projected_newton": a constant C string.
  static const char* name();

  /// Writes the quadratic form of one element.
  ///
  /// Called from several threads at once.
  /// \tparam D the dimension, 2 or 3; a preconditioner for one dimension only may be defined for that one alone
  /// \tparam Energy is a model of `DistortionEnergy`, or of what else the preconditioner's documentation asks for
  /// \param state singular values and the derivatives of the energy there
  /// \param energy the energy itself, for what the state does not tell
  /// \param form receives the form. On entry all `pairs` are zero and `stretch` is not initialised. The result must be
  ///   symmetric, positive semidefinite (but see above) and finite.
  template <int D, typename Energy>
  void form(const CGAL::Flip_free_maps::Element_state<D>& state, const Energy& energy,
            CGAL::Flip_free_maps::Increment_form<D>& form) const;
};
