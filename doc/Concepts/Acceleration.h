// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `Acceleration` describes what is made of successive gradients and the factorized preconditioner: the direction in
which the next step is taken.

Two further member functions are optional.
- `bool extrapolate(const Eigen::VectorXd& x, Eigen::VectorXd& displacement)` is called after every accepted step on the rest shape with
  its result. If it returns `true`, the minimizer goes on by `displacement`, or as far along it as no element flips, before the next
  gradient is computed, unless that undoes the last decrease of the energy; then `reset()` is called.
- `bool needs_current_matrix() const`: if it returns `true`, always, the minimizer assembles the preconditioner's matrix in every
  iteration, factorized or not, for the function `multiply()` below.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Any_acceleration}
\cgalHasModels{CGAL::Flip_free_maps::Inexact_newton}
\cgalHasModels{CGAL::Flip_free_maps::Lbfgs}
\cgalHasModels{CGAL::Flip_free_maps::Nesterov}
\cgalHasModels{CGAL::Flip_free_maps::No_acceleration}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::AccelerationConcept`
*/
class Acceleration
{
public:
  /// The name of the acceleration in reports, such as "none": a constant C string.
  static const char* name();

  /// Forgets what is known of earlier iterations. Called at the beginning of a run, and whenever a direction has led nowhere.
  void reset();

  /// Computes a direction.
  /// \tparam Solve is a functor `bool operator()(const Eigen::VectorXd& b, Eigen::VectorXd& y)`, which sets y to the inverse of
  ///   the last factorized matrix times b. It returns `false` if that failed. b and y must be different objects. It has a member
  ///   function `void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& product) const`, the product of p with the matrix of the
  ///   current map, which is meaningful where `needs_current_matrix()` returns `true`, and `double dot(const Eigen::VectorXd& a,
  ///   const Eigen::VectorXd& b) const` and `double norm(const Eigen::VectorXd& a) const`, which are to be used in place of
  ///   Eigen's: in a `World` of several processes vectors hold a part of the unknowns.
  /// \param x the current positions of the vertices that are not fixed, coordinates of one vertex side by side
  /// \param gradient the gradient of the energy there, in the same layout
  /// \param solve applies the inverse of the preconditioner
  /// \param direction receives the direction, to be added to the positions (not to be subtracted). It is resized by this
  ///   function.
  /// \returns whether `direction` was computed. One along which the energy does not decrease is discarded, after which the
  ///   preconditioner is factorized anew and this function is called again.
  template <typename Solve>
  bool direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction);
};
