// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `DistortionEnergy` describes what is minimised: an isotropic function \f$\psi(s_1,\dots,s_D)\f$ of the singular
values of the Jacobian of a map on one element. The package sums it over all elements, weighted by their measures. An energy
never sees a mesh.

The function must be symmetric in its arguments and twice differentiable where all of them are positive. Its value at
\f$s = (1, \dots, 1)\f$ must be finite. Nothing is required of its scale, convexity or minimum; stopping rules are measured
relative to its Hessian at the identity, which therefore must not vanish.

The functions are templates in the dimension `D`, the number of singular values, which is 2 for triangles and 3 for tetrahedra.
An energy that exists in one dimension only may define them for that dimension alone. They are called from several threads at
once and must not change the object.

Further members are optional: `slim_target()`, see `CGAL::Flip_free_maps::Slim`; `has_composite_form` and `composite_form()`, see
`CGAL::Flip_free_maps::Composite_majorization` and `CGAL::Flip_free_maps::Neo_hookean`; `bool holds_barrier() const`, which
overrides `has_barrier` for energies that are chosen at run time; and, for energies with a barrier in the plane, `values()` and
`gradients()`, which compute several triangles at once with the processor's vector registers, and the type `Vectorized_energy`, the energy itself, see
`CGAL::Flip_free_maps::Symmetric_dirichlet`. Without them triangles are computed one by one.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_dirichlet}
\cgalHasModels{CGAL::Flip_free_maps::Exponential_symmetric_dirichlet}
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_gradient}
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_arap}
\cgalHasModels{CGAL::Flip_free_maps::Arap}
\cgalHasModels{CGAL::Flip_free_maps::Hencky}
\cgalHasModels{CGAL::Flip_free_maps::Conformal}
\cgalHasModels{CGAL::Flip_free_maps::Amips}
\cgalHasModels{CGAL::Flip_free_maps::Exponential_amips}
\cgalHasModels{CGAL::Flip_free_maps::Neo_hookean}
\cgalHasModels{CGAL::Flip_free_maps::Aigerman_isometric}
\cgalHasModels{CGAL::Flip_free_maps::Weighted_sum}
\cgalHasModels{CGAL::Flip_free_maps::Any_energy}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::DistortionEnergyConcept`
\sa `CGAL::Flip_free_maps::check_derivatives()`
\sa `Preconditioner`
*/
class DistortionEnergy
{
public:
  /// Whether \f$\psi\f$ grows without bound when an element collapses. The package then takes the energy of an element whose
  /// smallest singular value is not positive for infinite, and never evaluates it there. Without a barrier maps are kept free
  /// of flips all the same, but by the bound on the step length alone, unless
  /// `CGAL::Flip_free_maps::Map_options::allow_flips` is set.
  static constexpr bool has_barrier = unspecified;

  /// The name of the energy in reports, such as "symmetric_dirichlet": a constant C string.
  static const char* name();

  /// The value \f$\psi(s)\f$.
  /// \param s the signed singular values, descending: \f$s_1 \ge \dots \ge s_D\f$. All are positive if `has_barrier`; otherwise
  ///   the last one may be zero or negative. All are finite, unless the map itself overflowed.
  /// \returns a number, or +infinity or NaN where the energy cannot be computed: the step that led there is shortened then
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const;

  /// Writes the first and second derivatives of \f$\psi\f$ in the singular values. Called at maps that were accepted by exact
  /// predicates, hence for positive singular values, up to rounding.
  /// \param s the signed singular values, as in `value()`
  /// \param gradient receives \f$\psi_i = \partial\psi/\partial s_i\f$
  /// \param hessian receives \f$\psi_{ij} = \partial^2\psi/\partial s_i\partial s_j\f$, both triangles. Neither argument is
  ///   initialised on entry.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient,
                   Eigen::Matrix<double, D, D>& hessian) const;
};
