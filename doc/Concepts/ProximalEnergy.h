// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `ProximalEnergy` describes energies that know their proximal map in the singular values, the step of the splitting scheme
that involves the energy (Stein, Li and Solomon 2022, section 4.3). It is an option: for other energies
`CGAL::Flip_free_maps::Proximal_map` finds the proximal map by a damped Newton's method, which takes longer.
`CGAL::Flip_free_maps::Symmetric_gradient` and `CGAL::Flip_free_maps::Symmetric_dirichlet` need not be models; the package has closed
forms for them.

\cgalRefines{DistortionEnergy}

\sa `CGAL::Flip_free_maps::ProximalEnergyConcept`
\sa `CGAL::Flip_free_maps::Proximal_map`
*/
class ProximalEnergy
  : public DistortionEnergy
{
public:
  /// The `p` with positive components that has the least \f$c\,\psi(p) + \frac12 |p - q|^2\f$; unique where \f$\psi\f$ is convex.
  ///
  /// Called from several threads at once.
  /// \param q numbers of either sign in descending order: the eigenvalues of a symmetric matrix
  /// \param c a positive number
  /// \returns `p`, component by component in the order of `q`
  template <int D>
  Eigen::Matrix<double, D, 1> proximal(const Eigen::Matrix<double, D, 1>& q, double c) const;
};
