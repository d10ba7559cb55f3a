// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/Radial_profile.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::set_knots(const std::vector<double>& depths, std::size_t number)
{
  m_knots.assign(1, depths.front());
  for(std::size_t k = 1; k <= number; ++k) {
    const double knot = depths[k * (depths.size() - 1) / number];
    if(knot > m_knots.back())
      m_knots.push_back(knot);
  }
  m_intervals.assign(m_knots.size() - 1, Interval());
  m_radii.assign(m_knots.size(), std::numeric_limits<double>::quiet_NaN());
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::add_growth(double from, double to, double rate)
{
  for(std::size_t k = interval(from); k < m_intervals.size() && m_knots[k] < to; ++k)
    m_intervals[k].growth = (std::max)(m_intervals[k].growth, rate);
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::optimize()
{
  begin();
  const std::size_t n = m_radii.size();
  std::vector<double> gradient, diagonal, upper, step(n);
  for(int iteration = 0; iteration < MAX_ITERATIONS; ++iteration) {
    m_energy = differentiate(gradient, diagonal, upper);
    // The first radius stays 0.
    for(std::size_t k = 2; k < n; ++k) {
      const double factor = upper[k - 1] / diagonal[k - 1];
      diagonal[k] -= factor * upper[k - 1];
      gradient[k] -= factor * gradient[k - 1];
    }
    step.assign(n, 0);
    for(std::size_t k = n - 1; k > 0; --k)
      step[k] = (-gradient[k] - (k + 1 < n ? upper[k] * step[k + 1] : 0)) / diagonal[k];
    double length = 1;
    for(std::size_t k = 0; k + 1 < n; ++k)
      if(step[k + 1] < step[k])
        length = (std::min)(length, 0.9 * (m_radii[k + 1] - m_radii[k]) / (step[k] - step[k + 1]));
    const std::vector<double> old = m_radii;
    double energy;
    do {
      for(std::size_t k = 0; k < n; ++k)
        m_radii[k] = old[k] + length * step[k];
      energy = measure();
      length *= 0.5;
    } while(!(energy <= m_energy) && length > 1e-6);
    if(!(energy <= m_energy)) {
      m_radii = old;
      break;
    }
    const bool is_done = m_energy - energy <= 1e-6 * energy;
    m_energy = energy;
    if(is_done)
      break;
  }
  ensure_growth();
}

CGAL_FLIP_FREE_MAPS_INLINE double Radial_profile::radius(double depth) const
{
  const std::size_t k = interval(depth);
  return m_radii[k] + (depth - m_knots[k]) / (m_knots[k + 1] - m_knots[k]) * (m_radii[k + 1] - m_radii[k]);
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::add(Term& term, double weight, double square)
{
  term.direct += weight * square;
  term.inverse += weight / square;
}

CGAL_FLIP_FREE_MAPS_INLINE std::size_t Radial_profile::interval(double depth) const
{
  const std::size_t k = std::upper_bound(m_knots.begin(), m_knots.end(), depth) - m_knots.begin();
  return (std::min)((std::max)(k, std::size_t(1)), m_intervals.size()) - 1;
}

CGAL_FLIP_FREE_MAPS_INLINE double Radial_profile::measure() const
{
  double sum = 0;
  for(std::size_t k = 0; k < m_intervals.size(); ++k)
    sum += m_intervals[k].radial.value(slope(k)) + m_intervals[k].tangential.value(middle(k));
  return sum;
}

CGAL_FLIP_FREE_MAPS_INLINE double Radial_profile::differentiate(std::vector<double>& gradient, std::vector<double>& diagonal,
                                                                std::vector<double>& upper) const
{
  gradient.assign(m_radii.size(), 0);
  diagonal.assign(m_radii.size(), 0);
  upper.assign(m_radii.size(), 0);
  for(std::size_t k = 0; k < m_intervals.size(); ++k) {
    const Interval& i = m_intervals[k];
    const double radial = i.radial.slope(slope(k)) / length(k), tangential = 0.5 * i.tangential.slope(middle(k));
    const double bend = i.radial.curvature(slope(k)) / (length(k) * length(k)), pull = 0.25 * i.tangential.curvature(middle(k));
    gradient[k] += tangential - radial;
    gradient[k + 1] += tangential + radial;
    diagonal[k] += pull + bend;
    diagonal[k + 1] += pull + bend;
    upper[k] = pull - bend;
  }
  return measure();
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::begin()
{
  m_radii[0] = 0;
  for(std::size_t k = 0; k < m_intervals.size(); ++k) {
    const Term& term = m_intervals[k].radial;
    const double stretch = term.direct > 0 ? std::pow(term.inverse / term.direct, 0.25) : 1;
    m_radii[k + 1] = m_radii[k] + stretch * length(k);
  }
  rescale();
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::rescale()
{
  double direct = 0, inverse = 0;
  for(std::size_t k = 0; k < m_intervals.size(); ++k)
    for(const auto& [term, s] : {std::make_pair(m_intervals[k].radial, slope(k)), std::make_pair(m_intervals[k].tangential, middle(k))}) {
      direct += term.direct * s * s;
      inverse += term.inverse / (s * s);
    }
  const double scale = std::pow(inverse / direct, 0.25);
  for(double& radius : m_radii)
    radius *= scale;
}

CGAL_FLIP_FREE_MAPS_INLINE void Radial_profile::ensure_growth()
{
  const std::vector<double> optimum = m_radii;
  for(std::size_t k = 0; k < m_intervals.size(); ++k) {
    const double least = m_radii[k] * std::expm1(SAFETY * m_intervals[k].growth * length(k));
    m_radii[k + 1] = m_radii[k] + (std::max)(optimum[k + 1] - optimum[k], least);
  }
  if(m_radii != optimum)
    rescale();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_IMPL_H
