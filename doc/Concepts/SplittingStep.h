// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `SplittingStep` describes what a splitting scheme does with each element of a map of dimension `D` between two solves for
positions. `CGAL::Flip_free_maps::Splitting_minimizer` keeps one `Element` for each simplex and repeats: it finds the positions with the
least \f$\sum_e \frac{\mu_e}{2} |J_e - T_e|^2\f$, where \f$\mu_e\f$ is the penalty of element \f$e\f$ and \f$T_e\f$ the Jacobian that the
element asks for, and then calls `update()` with the new Jacobians. A splitting step never sees a mesh nor a linear solver.

All member functions are called from several threads at once, each with an element of its own.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Admm_splitting_step}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::SplittingStepConcept`
\sa `CGAL::Flip_free_maps::Splitting_minimizer`
*/
class SplittingStep
{
public:
  /// What is kept of an element: default constructible, copyable, with the public data members
  /// `Eigen::Matrix<double, D, D> jacobian`, the Jacobian of the map so far, and `double penalty`, the positive \f$\mu_e\f$.
  /// `CGAL::Flip_free_maps::Split_element` is an example.
  typedef unspecified_type Element;

  /// Keeps copies of an energy, a model of `DistortionEnergy`, and of the settings.
  template <typename Energy>
  SplittingStep(const Energy& energy, const CGAL::Flip_free_maps::Splitting_options& options);

  /// The name of the scheme in reports, such as "admm_splitting": a constant C string.
  static const char* name();

  /// Initialises an element, whose Jacobian may have any determinant.
  /// \param jacobian the Jacobian of the start
  /// \param measure the measure of the element's rest shape
  /// \param inert whether rotations are to be kept close to those of the iteration before
  /// \param element is written; no member is initialised on entry
  void start(const Eigen::Matrix<double, D, D>& jacobian, double measure, bool inert, Element& element) const;

  /// The local step after the positions have been solved for.
  /// \param jacobian the new Jacobian; `element.jacobian` is still that of the iteration before, and this one on return
  /// \param measure the measure of the element's rest shape
  /// \param adapt whether the penalty may change in this iteration; it must not otherwise, since the matrix is kept
  /// \param inert as in `start()`
  /// \param element the element
  /// \param errors to which the element's share is added, in all members of `CGAL::Flip_free_maps::Splitting_errors`
  void update(const Eigen::Matrix<double, D, D>& jacobian, double measure, bool adapt, bool inert, Element& element,
              CGAL::Flip_free_maps::Splitting_errors& errors) const;

  /// The penalty times the difference of the Jacobian that the element asks for and the one that it has,
  /// \f$\mu_e (T_e - J_e)\f$.
  static Eigen::Matrix<double, D, D> pull(const Element& element);
};
