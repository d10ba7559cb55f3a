// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_ARAP_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_ARAP_H

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// The symmetric as-rigid-as-possible energy psi(s) = (s_max - 1)^2 + (1/s_min - 1)^2 (Shtengel et al. 2017, equation 25, where
/// D = 2), for D = 3 with the same formula, in which the middle singular value does not occur. Its minimum is 0, at isometries.
///
/// Where the largest and the smallest singular value coincide and are not 1, psi has a kink, the one of a convex function, and
/// derivatives are those of one side. Minima tend to have elements there, where the gradient does not become small: stop by
/// `Map_options::relative_energy_tolerance`, since otherwise a run may end with `Status::line_search_failed`.
///
/// \cgalModels{ConvexConcaveEnergy}
struct Symmetric_arap
{
  /// Infinite on collapsed elements.
  static constexpr bool has_barrier = true;

  /// "symmetric_arap"
  static const char* name() { return "symmetric_arap"; }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    const double large = s.maxCoeff() - 1, small = 1 / s.minCoeff() - 1;
    return large * large + small * small;
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    const int i = index_of_largest<D>(s), j = index_of_smallest<D>(s);
    const double inverse = 1 / s[j];
    gradient.setZero();
    gradient[i] = 2 * (s[i] - 1);
    gradient[j] = 2 * (1 - inverse) * inverse * inverse;
    hessian.setZero();
    hessian(i, i) = 2;
    hessian(j, j) = (6 * inverse - 4) * inverse * inverse * inverse;
  }

  /// The Hessian of the convex part of psi. (1/s - 1)^2 is convex up to s = 1.5 and concave beyond; its convex part is continued
  /// by the tangent there.
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& s, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    const int i = index_of_largest<D>(s), j = index_of_smallest<D>(s);
    convex.setZero();
    convex(i, i) = hessian(i, i);
    convex(j, j) = (std::max)(hessian(j, j), 0.);
  }

private:
  // Singular values come in descending order; of equal ones the first counts as the largest and the last as the smallest.
  template <int D>
  static int index_of_largest(const Eigen::Matrix<double, D, 1>& s)
  {
    int result = 0;
    for(int i = 1; i < D; ++i)
      if(s[i] > s[result])
        result = i;
    return result;
  }
  template <int D>
  static int index_of_smallest(const Eigen::Matrix<double, D, 1>& s)
  {
    int result = D - 1;
    for(int i = D - 2; i >= 0; --i)
      if(s[i] < s[result])
        result = i;
    return result;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_SYMMETRIC_ARAP_H
