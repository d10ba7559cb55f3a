// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H

#include <cstddef>
#include <limits>
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
  void set_knots(const std::vector<double>& depths, std::size_t number);

  // Enters a triangle at the given depth. `square`: that of the norm of the gradient of the depth, or of the angle.
  void add_radial(double depth, double weight, double square) { add(m_intervals[interval(depth)].radial, weight, square); }
  void add_tangential(double depth, double weight, double square) { add(m_intervals[interval(depth)].tangential, weight, square); }

  // Asks that the logarithm of the radius grows by at least `rate` per depth between two depths.
  void add_growth(double from, double to, double rate);

  // Finds the radii by Newton's method, and then increases them where they grow too little.
  void optimize();

  // The least energy, without regard to growth.
  double energy() const { return m_energy; }

  double radius(double depth) const;

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

  static void add(Term& term, double weight, double square);

  std::size_t interval(double depth) const;

  double length(std::size_t k) const { return m_knots[k + 1] - m_knots[k]; }
  double slope(std::size_t k) const { return (m_radii[k + 1] - m_radii[k]) / length(k); }
  double middle(std::size_t k) const { return 0.5 * (m_radii[k] + m_radii[k + 1]); }

  double measure() const;

  double differentiate(std::vector<double>& gradient, std::vector<double>& diagonal, std::vector<double>& upper) const;

  // Radii in proportion to the distance from the pole, at the scale where the energy is least.
  void begin();

  void rescale();

  void ensure_growth();

  static constexpr int MAX_ITERATIONS = 100;
  static constexpr double SAFETY = 1.3; // of the least growth, since it is derived for small angles

  std::vector<double> m_knots, m_radii;
  std::vector<Interval> m_intervals; // between knots k and k + 1
  double m_energy = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/Radial_profile_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_RADIAL_PROFILE_H
