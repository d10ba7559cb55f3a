// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/measure/Distortion_report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Adds up the distortions of triangles.
class Distortion_measure
{
public:
  Distortion_measure();

  // Enters the triangle with the given columns of corners in space and in the plane. Returns its symmetric Dirichlet energy,
  // +infinity when it is not positively oriented; NaN, with the report's status set, when the triangle cannot be measured.
  double add(const Matrix<3>& points, const Eigen::Matrix<double, 2, 3>& image);

  double fail(Status status, const char* text);

  // The means, when no triangle failed.
  Distortion_report report();

private:
  // The stretch below which a part of the area is, when the image is scaled.
  double percentile_of_stretch(double part, double scale) const;

  Distortion_report m_report;
  std::vector<std::array<double, 3>> m_singular_values; // both, and the area; of all triangles
  int m_exponent = 0;                                   // binary logarithm of the unit of length
  double m_squares = 0;
  double m_inverse_squares = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_H
