// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The radius as a function of the depth, 0 at depth 0, for which a map in polar coordinates has the least symmetric Dirichlet
// energy. It is linear between knots. With the gradients of depth and angle perpendicular to each other, the singular values of
// the map are radius' |grad depth| and radius |grad angle|; so the energy is convex in the radii of the knots,
// with a tridiagonal Hessian.
class Radial_profile
{
public:
  // Begins with `number` intervals between quantiles of sorted depths.
  void set_knots(const std::vector<double>& depths, std::size_t number)
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

  // Enters a triangle at the given depth. `square`: that of the norm of the gradient of the depth, or of the angle.
  void add_radial(double depth, double weight, double square) { add(m_intervals[interval(depth)].radial, weight, square); }
  void add_tangential(double depth, double weight, double square) { add(m_intervals[interval(depth)].tangential, weight, square); }

  // Asks that the logarithm of the radius grows by at least `rate` per depth between two depths.
  void add_growth(double from, double to, double rate)
  {
    for(std::size_t k = interval(from); k < m_intervals.size() && m_knots[k] < to; ++k)
      m_intervals[k].growth = (std::max)(m_intervals[k].growth, rate);
  }

  // Finds the radii by Newton's method, and then increases them where they grow too little.
  void optimize()
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

  // The least energy, without regard to growth.
  double energy() const { return m_energy; }

  double radius(double depth) const
  {
    const std::size_t k = interval(depth);
    return m_radii[k] + (depth - m_knots[k]) / (m_knots[k + 1] - m_knots[k]) * (m_radii[k + 1] - m_radii[k]);
  }

private:
  // The sum of weights w times (s^2 q + 1 / (s^2 q)) / 4 over triangles, as a function of s.
  struct Term
  {
    double direct = 0, inverse = 0; // sums of w q, w / q

    double value(double s) const { return 0.25 * (direct * s * s + (inverse > 0 ? inverse / (s * s) : 0)); }
    double slope(double s) const { return 0.5 * (direct * s - inverse / (s * s * s)); }
    double curvature(double s) const { return 0.5 * (direct + 3 * inverse / (s * s * s * s)); }
  };

  struct Interval
  {
    Term radial, tangential; // of the slope of the radius, and of the radius in the middle
    double growth = 0;
  };

  static void add(Term& term, double weight, double square)
  {
    term.direct += weight * square;
    term.inverse += weight / square;
  }

  std::size_t interval(double depth) const
  {
    const std::size_t k = std::upper_bound(m_knots.begin(), m_knots.end(), depth) - m_knots.begin();
    return (std::min)((std::max)(k, std::size_t(1)), m_intervals.size()) - 1;
  }

  double length(std::size_t k) const { return m_knots[k + 1] - m_knots[k]; }
  double slope(std::size_t k) const { return (m_radii[k + 1] - m_radii[k]) / length(k); }
  double middle(std::size_t k) const { return 0.5 * (m_radii[k] + m_radii[k + 1]); }

  double measure() const
  {
    double sum = 0;
    for(std::size_t k = 0; k < m_intervals.size(); ++k)
      sum += m_intervals[k].radial.value(slope(k)) + m_intervals[k].tangential.value(middle(k));
    return sum;
  }

  double differentiate(std::vector<double>& gradient, std::vector<double>& diagonal, std::vector<double>& upper) const
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

  // Radii in proportion to the distance from the pole, at the scale where the energy is least.
  void begin()
  {
    m_radii[0] = 0;
    for(std::size_t k = 0; k < m_intervals.size(); ++k) {
      const Term& term = m_intervals[k].radial;
      const double stretch = term.direct > 0 ? std::pow(term.inverse / term.direct, 0.25) : 1;
      m_radii[k + 1] = m_radii[k] + stretch * length(k);
    }
    rescale();
  }

  void rescale()
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

  void ensure_growth()
  {
    const std::vector<double> optimum = m_radii;
    for(std::size_t k = 0; k < m_intervals.size(); ++k) {
      const double least = m_radii[k] * std::expm1(SAFETY * m_intervals[k].growth * length(k));
      m_radii[k + 1] = m_radii[k] + (std::max)(optimum[k + 1] - optimum[k], least);
    }
    if(m_radii != optimum)
      rescale();
  }

  static constexpr int MAX_ITERATIONS = 100;
  static constexpr double SAFETY = 1.3; // of the least growth, since it is derived for small angles

  std::vector<double> m_knots, m_radii;
  std::vector<Interval> m_intervals; // between knots k and k + 1
  double m_energy = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H
