// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REFERENCES_FIXED_REFERENCE_H
#define CGAL_FLIP_FREE_MAPS_REFERENCES_FIXED_REFERENCE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsReferences
/// Measures every iteration against the rest shape itself.
///
/// \cgalModels{Reference}
struct Fixed_reference
{
  /// "fixed"
  static const char* name() { return "fixed"; }

  /// Begins a new run.
  void restart() {}

  /// Moves on to the reference of the next iteration, given the map so far. Returns whether this reference is the rest shape.
  template <int D>
  bool update(const Simplicial_domain<D>& /* domain */, const Positions<D>& /* x */)
  {
    return true;
  }

  /// Relative decrease of the reference's own measure of distortion; of no interest for the rest shape.
  double relative_decrease() const { return 0; }

  /// Inverse of the reference's edge matrix of element `e`.
  template <int D>
  const internal::Matrix<D>& rest_inverse(const Simplicial_domain<D>& domain, std::int64_t e) const
  {
    return domain.rest_inverses[e];
  }

  /// Weight of element `e`; the weights sum to 1.
  template <int D>
  double weight(const Simplicial_domain<D>& domain, std::int64_t e) const
  {
    return domain.measures[e];
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REFERENCES_FIXED_REFERENCE_H
