// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_ELEMENT_QUALITY_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_ELEMENT_QUALITY_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// The shapes of the tetrahedra of a mesh by their scaled Jacobians: sqrt(2) times the determinant of three edges at a corner, over
/// the largest product of the lengths of the three edges at a corner. A regular tetrahedron has 1, a flat one 0, an inverted one less.
struct Element_quality
{
  double min_scaled_jacobian = 0;             ///< of the worst tetrahedron
  double mean_scaled_jacobian = 0;            ///< mean over the tetrahedra
  std::array<std::int64_t, 10> histogram{{}}; ///< how many have less than 0.1, 0.1 to 0.2, ..., 0.9 and more

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    visit("min_scaled_jacobian", min_scaled_jacobian);
    visit("mean_scaled_jacobian", mean_scaled_jacobian);
    visit("histogram", histogram);
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// The scaled Jacobian of a tetrahedron; see `Element_quality`.
inline double scaled_jacobian(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r, const Eigen::Vector3d& s)
{
  Eigen::Matrix3d edges;
  edges << q - p, r - p, s - p;
  const double pq = (q - p).norm(), pr = (r - p).norm(), ps = (s - p).norm(), qr = (r - q).norm(), qs = (s - q).norm(), rs = (s - r).norm();
  const double largest = (std::max)({pq * pr * ps, pq * qr * qs, pr * qr * rs, ps * qs * rs});
  return largest > 0 ? std::sqrt(2.) * edges.determinant() / largest : 0;
}

/// \ingroup PkgFlipFreeMapsRef
/// The shapes of the tetrahedra in a map.
inline Element_quality element_quality(const Simplicial_domain<3>& domain, const Positions<3>& x)
{
  Element_quality result;
  result.min_scaled_jacobian = domain.elements.empty() ? 0 : 1;
  for(const auto& v : domain.elements) {
    const double value = scaled_jacobian(x.col(v[0]), x.col(v[1]), x.col(v[2]), x.col(v[3]));
    result.min_scaled_jacobian = (std::min)(result.min_scaled_jacobian, value);
    result.mean_scaled_jacobian += value / static_cast<double>(domain.elements.size());
    ++result.histogram[static_cast<std::size_t>((std::max)(0., (std::min)(9., std::floor(10 * value))))];
  }
  return result;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_ELEMENT_QUALITY_H
