// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_REST_SHAPE_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_REST_SHAPE_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Geometry>

#include <limits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Lays a triangle in space isometrically in the plane, its first edge along the x axis: the inverse of the edge matrix and the
// area. False when the area has no correct digit or the inverse leaves the range of double.
inline bool planar_rest_shape(const Vector<3>& p_0, const Vector<3>& p_1, const Vector<3>& p_2, Matrix<2>& rest_inverse, double& area)
{
  const Vector<3> a = p_1 - p_0, b = p_2 - p_0;
  const double a_norm = a.norm(), doubled = a.cross(b).norm();
  // Below this the area is rounding of the cross product.
  if(!(doubled > 4 * std::numeric_limits<double>::epsilon() * a_norm * b.norm()))
    return false;
  area = 0.5 * doubled;
  rest_inverse << 1 / a_norm, -a.dot(b) / (a_norm * doubled), 0, a_norm / doubled;
  return rest_inverse.allFinite();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_REST_SHAPE_H
