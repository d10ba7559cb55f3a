// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `ConvexConcaveEnergy` describes energies that come with a decomposition \f$\psi = h^+ + h^-\f$ into a convex and a
concave function of the singular values, which composite majorization needs.

\cgalRefines{DistortionEnergy}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_dirichlet}
\cgalHasModels{CGAL::Flip_free_maps::Exponential_symmetric_dirichlet}
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_gradient}
\cgalHasModels{CGAL::Flip_free_maps::Symmetric_arap}
\cgalHasModels{CGAL::Flip_free_maps::Arap}
\cgalHasModels{CGAL::Flip_free_maps::Hencky}
\cgalHasModels{CGAL::Flip_free_maps::Aigerman_isometric}
\cgalHasModels{CGAL::Flip_free_maps::Weighted_sum}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::ConvexConcaveEnergyConcept`
\sa `CGAL::Flip_free_maps::Composite_majorization`
*/
class ConvexConcaveEnergy
  : public DistortionEnergy
{
public:
  /// Writes the Hessian of the convex part \f$h^+\f$ in the singular values.
  /// \param s the signed singular values, as in `DistortionEnergy::derivatives()`
  /// \param hessian what `DistortionEnergy::derivatives()` wrote for the same `s`
  /// \param convex receives a symmetric positive semidefinite matrix; not initialised on entry
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& s, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const;
};
