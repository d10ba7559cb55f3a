// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `Reference` describes the shape that distortion is measured against in an iteration. It is the rest shape in the
end, but may be another one on the way there.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Fixed_reference}
\cgalHasModels{CGAL::Flip_free_maps::Progressive_reference}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::ReferenceConcept`
*/
class Reference
{
public:
  /// The name of the reference in reports, such as "fixed": a constant C string.
  static const char* name();

  /// Forgets earlier runs. Called at the beginning of a run, before the first `update()`.
  void restart();

  /// Chooses the reference of the next iteration. Called with the start, and after every accepted step until the reference is the
  /// rest shape, which it then is for the rest of the run.
  /// \param domain the rest shape
  /// \param x the map so far, without flipped elements unless `CGAL::Flip_free_maps::Map_options::allow_flips` let them pass
  /// \returns whether the new reference is the rest shape. Convergence is declared on the rest shape only.
  template <int D>
  bool update(const CGAL::Flip_free_maps::Simplicial_domain<D>& domain, const CGAL::Flip_free_maps::Positions<D>& x);

  /// The relative decrease, by the last iteration, of a measure of distortion of the reference's own choice; infinite before there
  /// is one. It is what preconditioners are told while the reference is not the rest shape.
  double relative_decrease() const;

  /// The inverse of the edge matrix of element `e` in this reference, with positive determinant, by value or as a reference that
  /// is valid until the next `update()`. Called from several threads at once.
  template <int D>
  const Eigen::Matrix<double, D, D>& rest_inverse(const CGAL::Flip_free_maps::Simplicial_domain<D>& domain, std::int64_t e) const;

  /// The weight of element `e` in the mean energy: positive, with sum 1 over all elements. Called from several threads at once.
  template <int D>
  double weight(const CGAL::Flip_free_maps::Simplicial_domain<D>& domain, std::int64_t e) const;
};
