// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_COMPOSITE_MAJORIZER_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_COMPOSITE_MAJORIZER_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// One inner function g of a composite energy h(g(J)), isotropic, at one Jacobian, in the frame of its singular vectors.
template <int D>
struct Inner_function
{
  internal::Vector<D> gradient; ///< dg / ds_i
  Increment_form<D> convex;     ///< Hessian of the convex part of g
  Increment_form<D> concave;    ///< minus the Hessian of the concave part of g
};

/// \ingroup PkgFlipFreeMapsPreconditioners
/// The Hessian of the convex majorizer of a composite energy h(g(J)) (Shtengel et al. 2017, equation 9):
/// sum_ij h+_ij grad g_i grad g_j^T, plus (dh/dg_i)_+ times the Hessian of the convex part of each g_i, plus (dh/dg_i)_- times
/// that of its concave part.
///
/// \param h_gradient first derivatives of h in the N inner functions
/// \param h_convex_hessian Hessian of the convex part of h
/// \param inner the inner functions
/// \param form the result
template <int D, int N>
void composite_majorizer(const Eigen::Matrix<double, N, 1>& h_gradient, const Eigen::Matrix<double, N, N>& h_convex_hessian,
                         const std::array<Inner_function<D>, N>& inner, Increment_form<D>& form)
{
  Eigen::Matrix<double, N, D> gradients;
  for(int i = 0; i < N; ++i)
    gradients.row(i) = inner[i].gradient.transpose();
  form.stretch = gradients.transpose() * h_convex_hessian * gradients;
  form.pairs = {};
  for(int i = 0; i < N; ++i) {
    const Increment_form<D>& part = h_gradient[i] > 0 ? inner[i].convex : inner[i].concave;
    const double factor = std::abs(h_gradient[i]);
    form.stretch += factor * part.stretch;
    for(std::size_t p = 0; p < form.pairs.size(); ++p) {
      form.pairs[p].ij_ij += factor * part.pairs[p].ij_ij;
      form.pairs[p].ji_ji += factor * part.pairs[p].ji_ji;
      form.pairs[p].ij_ji += factor * part.pairs[p].ij_ji;
    }
  }
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_COMPOSITE_MAJORIZER_H
