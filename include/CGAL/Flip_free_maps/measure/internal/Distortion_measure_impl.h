// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Distortion_measure::Distortion_measure()
{
  m_report.min_singular_value = std::numeric_limits<double>::infinity();
  m_report.max_singular_value = -std::numeric_limits<double>::infinity();
}

CGAL_FLIP_FREE_MAPS_INLINE double Distortion_measure::add(const Matrix<3>& points, const Eigen::Matrix<double, 2, 3>& image)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const double infinity = std::numeric_limits<double>::infinity();
  if(!points.allFinite() || !image.allFinite())
    return fail(Status::non_finite_input, "a coordinate is NaN or infinite in face number ");
  // The unit of length has the magnitude of the first triangle, so that areas neither overflow nor vanish. It is a power of
  // two, which rounds nothing.
  Matrix<3> scaled_points = points;
  scaled_points.colwise() -= points.col(0).eval();
  if(m_report.elements == 0) {
    const double extent = scaled_points.cwiseAbs().maxCoeff();
    m_exponent = extent > 0 && std::isfinite(extent) ? std::ilogb(extent) : 0;
  }
  const auto in_units = [this](double x) { return std::ldexp(x, -m_exponent); };
  scaled_points = scaled_points.unaryExpr(in_units).eval();
  Matrix<2> rest_inverse;
  double area;
  if(!planar_rest_shape(scaled_points.col(0), scaled_points.col(1), scaled_points.col(2), rest_inverse, area))
    return fail(Status::degenerate_rest_element, "zero area, or none within double precision, has face number ");
  Matrix<2> edges;
  edges << image.col(1) - image.col(0), image.col(2) - image.col(0);
  edges = edges.unaryExpr(in_units).eval();
  const Vector<2> s = signed_singular_values(Matrix<2>(edges * rest_inverse));
  const bool is_positive = Kernel::Orientation_2()(Kernel::Point_2(image(0, 0), image(1, 0)), Kernel::Point_2(image(0, 1), image(1, 1)),
                                                   Kernel::Point_2(image(0, 2), image(1, 2))) == CGAL::POSITIVE;
  // A triangle may be positive, but too thin for its singular values to be so.
  const bool is_valid = is_positive && s[1] > 0;
  const double energy = is_valid ? Symmetric_dirichlet().value<2>(s) : infinity;
  ++m_report.elements;
  m_report.flips += is_positive ? 0 : 1;
  m_report.rest_area += area;
  m_report.image_area += area * s.prod();
  m_report.energy += area * energy;
  m_report.max_energy = (std::max)(m_report.max_energy, energy);
  m_report.mean_angle_distortion += area * (is_valid ? 0.5 * (s[0] / s[1] + s[1] / s[0]) : infinity);
  m_report.mean_area_distortion += area * (is_valid ? 0.5 * (s.prod() + 1 / s.prod()) : infinity);
  m_report.min_singular_value = (std::min)(m_report.min_singular_value, s[1]);
  m_report.max_singular_value = (std::max)(m_report.max_singular_value, s[0]);
  m_singular_values.push_back({{s[0], is_valid ? s[1] : 0., area}});
  m_squares += area * s.squaredNorm();
  m_inverse_squares += area * (is_valid ? s.array().square().inverse().sum() : infinity);
  return energy;
}

CGAL_FLIP_FREE_MAPS_INLINE double Distortion_measure::fail(Status status, const char* text)
{
  m_report.status = status;
  m_report.message = text + std::to_string(m_report.elements);
  return std::numeric_limits<double>::quiet_NaN();
}

CGAL_FLIP_FREE_MAPS_INLINE double Distortion_measure::percentile_of_stretch(double part, double scale) const
{
  std::vector<std::pair<double, double>> stretches;
  double area = 0;
  for(const auto& s : m_singular_values) {
    stretches.emplace_back(s[1] > 0 ? (std::max)(scale * s[0], 1 / (scale * s[1])) : std::numeric_limits<double>::infinity(), s[2]);
    area += s[2];
  }
  std::sort(stretches.begin(), stretches.end());
  double below = 0;
  for(const auto& stretch : stretches) {
    below += stretch.second;
    if(below >= part * area)
      return stretch.first;
  }
  return stretches.back().first;
}

CGAL_FLIP_FREE_MAPS_INLINE Distortion_report Distortion_measure::report()
{
  if(!m_report.message.empty())
    return m_report;
  if(m_report.elements == 0) {
    m_report.message = "there are no faces";
    return m_report;
  }
  m_report.status = Status::success;
  m_report.energy /= m_report.rest_area;
  m_report.mean_angle_distortion /= m_report.rest_area;
  m_report.mean_area_distortion /= m_report.rest_area;
  // Scaling the image by t makes it (t^2 a + b / t^2) / 4, smallest for t^4 = b / a.
  m_report.energy_of_similarity = 0.5 * std::sqrt(m_squares / m_report.rest_area) * std::sqrt(m_inverse_squares / m_report.rest_area);
  const double best_scale = std::isfinite(m_inverse_squares) ? std::pow(m_inverse_squares / m_squares, 0.25) : 1;
  m_report.stretch_95 = percentile_of_stretch(0.95, best_scale);
  m_report.rest_area = std::ldexp(m_report.rest_area, 2 * m_exponent);
  m_report.image_area = std::ldexp(m_report.image_area, 2 * m_exponent);
  return m_report;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_DISTORTION_MEASURE_IMPL_H
