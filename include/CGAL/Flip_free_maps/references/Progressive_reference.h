// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REFERENCES_PROGRESSIVE_REFERENCE_H
#define CGAL_FLIP_FREE_MAPS_REFERENCES_PROGRESSIVE_REFERENCE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsReferences
/// How a progressive reference lies between the rest shape and the image: the singular values s(t) of the Jacobian from the
/// reference to the image, t = 0 for the image itself, t = 1 for the rest shape.
enum class Interpolation
{
  exponential, ///< s_i^t (Liu et al. 2018, equation 7)
  linear,      ///< t s_i + 1 - t (equation 13)
  projection   ///< s_i, moved into the interval of x with (x^2 + x^-2) / 2 <= K (equation 15); there is no t
};

/// \ingroup PkgFlipFreeMapsReferences
/// Progressive references (Liu, Ye, Ni and Fu 2018, sections 3.3 to 3.6): while elements are badly distorted, each iteration
/// measures against elements between those at rest and their images, chosen such that no distortion exceeds a bound K, and all
/// elements count alike. The rest shape takes over for the rest of the run as soon as 99 % of the elements have a distortion of at
/// most K, or the mean distortion, over the area (equation 11), changed by less than a hundredth in one iteration (section 3.6).
/// Algorithm 1 asks for all elements, `distorted_fraction` 0: the few others throttle the first steps towards the rest shape
/// otherwise. Distortion is the symmetric Dirichlet energy, whatever energy is minimised.
///
/// \cgalModels{Reference}
class Progressive_reference
{
public:
  /// \name Settings
  /// @{
  Interpolation interpolation = Interpolation::exponential; ///< how references lie between rest shape and image
  bool has_common_parameter = true; ///< whether all elements take the smallest t, or each its own; a projection is individual
  double bound = 60;                ///< K, greater than 1
  double smallest_decrease = 0.01;  ///< relative change of the mean distortion below which the rest shape takes over
  double distorted_fraction = 0.01; ///< fraction of elements beyond K up to which the rest shape takes over
  /// @}

  /// "progressive"
  static const char* name() { return "progressive"; }

  /// Begins a new run.
  void restart()
  {
    m_is_rest_shape = false;
    m_distortion = std::numeric_limits<double>::infinity();
    m_relative_decrease = std::numeric_limits<double>::infinity();
  }

  /// Moves on to the reference of the next iteration, given the map so far. Returns whether this reference is the rest shape.
  ///
  /// Complexity: linear in the number of elements.
  template <int D>
  bool update(const Simplicial_domain<D>& domain, const Positions<D>& x)
  {
    if(m_is_rest_shape)
      return true;
    const std::int64_t n = domain.number_of_elements();
    double sum = 0, total = 0, common = 1;
    std::int64_t distorted = 0;
    for(std::int64_t e = 0; e < n; ++e) {
      const internal::Vector<D> s = internal::signed_singular_values(domain.jacobian(e, x));
      const double distortion = Symmetric_dirichlet().value<D>(s);
      sum += domain.measures[e] * distortion;
      total += domain.measures[e];
      if(distortion <= bound)
        continue;
      ++distorted;
      if(has_common_parameter && interpolation != Interpolation::projection &&
         Symmetric_dirichlet().value<D>(interpolated<D>(s, common)) > bound)
        common = largest_parameter<D>(s, common);
    }
    const double distortion = sum / total;
    m_relative_decrease = (m_distortion - distortion) / distortion;
    m_distortion = distortion;
    // A positive element on which double precision finds no positive singular value has no reference.
    if(static_cast<double>(distorted) <= distorted_fraction * static_cast<double>(n) || std::abs(m_relative_decrease) < smallest_decrease ||
       !std::isfinite(distortion)) {
      m_is_rest_shape = true;
      m_rest_inverses = {};
      return true;
    }

    m_rest_inverses.resize(n * D * D);
    for(std::int64_t e = 0; e < n; ++e) {
      internal::Signed_svd<D> svd;
      internal::signed_svd(domain.jacobian(e, x), svd);
      double t = common;
      if(!has_common_parameter && Symmetric_dirichlet().value<D>(svd.s) > bound && interpolation != Interpolation::projection)
        t = largest_parameter<D>(svd.s, 1);
      const internal::Vector<D> ratio = interpolated<D>(svd.s, t).cwiseQuotient(svd.s);
      entry<D>(e) = domain.rest_inverses[e] * svd.V * ratio.asDiagonal() * svd.V.transpose();
    }
    m_weight = 1. / n;
    return false;
  }

  /// Relative decrease of the mean distortion, weighted by measure, by the last iteration.
  double relative_decrease() const { return m_relative_decrease; }

  /// Inverse of the reference's edge matrix of element `e`.
  template <int D>
  internal::Matrix<D> rest_inverse(const Simplicial_domain<D>& domain, std::int64_t e) const
  {
    if(m_is_rest_shape)
      return domain.rest_inverses[e];
    return Eigen::Map<const internal::Matrix<D>>(m_rest_inverses.data() + e * D * D);
  }

  /// Weight of element `e`: the same for all elements until the rest shape takes over. The weights sum to 1.
  template <int D>
  double weight(const Simplicial_domain<D>& domain, std::int64_t e) const
  {
    return m_is_rest_shape ? domain.measures[e] : m_weight;
  }

private:
  template <int D>
  Eigen::Map<internal::Matrix<D>> entry(std::int64_t e)
  {
    return Eigen::Map<internal::Matrix<D>>(m_rest_inverses.data() + e * D * D);
  }

  template <int D>
  internal::Vector<D> interpolated(const internal::Vector<D>& s, double t) const
  {
    switch(interpolation) {
    case Interpolation::exponential:
      return s.array().pow(t);
    case Interpolation::linear:
      return t * s.array() + (1 - t);
    case Interpolation::projection:
      break;
    }
    const double largest = std::sqrt(bound + std::sqrt(bound * bound - 1));
    return s.cwiseMax(1 / largest).cwiseMin(largest);
  }

  // The largest t below `high` at which the distortion is within the bound; it grows with t.
  template <int D>
  double largest_parameter(const internal::Vector<D>& s, double high) const
  {
    double low = 0;
    for(int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
      const double middle = 0.5 * (low + high);
      (Symmetric_dirichlet().value<D>(interpolated<D>(s, middle)) <= bound ? low : high) = middle;
    }
    return low;
  }

  bool m_is_rest_shape = false;
  double m_distortion = std::numeric_limits<double>::infinity();
  double m_relative_decrease = std::numeric_limits<double>::infinity();
  double m_weight = 0;
  std::vector<double> m_rest_inverses;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REFERENCES_PROGRESSIVE_REFERENCE_H
