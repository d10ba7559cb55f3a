// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_EIGENMODES_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_EIGENMODES_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>

#include <cmath>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Eigenvalue of the symmetric mode of a pair, with its limit at equal singular values.
template <int D>
double symmetric_mode(const Element_state<D>& state, int i, int j)
{
  const double difference = state.s[i] - state.s[j];
  if(std::abs(difference) > 1e-6 * (std::abs(state.s[i]) + std::abs(state.s[j])))
    return (state.gradient[i] - state.gradient[j]) / difference;
  return 0.5 * (state.hessian(i, i) + state.hessian(j, j)) - state.hessian(i, j);
}

// Eigenvalue of the twist mode of a pair, with its limit at opposite singular values, which only flipped elements have.
template <int D>
double twist_mode(const Element_state<D>& state, int i, int j)
{
  const double sum = state.s[i] + state.s[j];
  if(std::abs(sum) > 1e-6 * (std::abs(state.s[i]) + std::abs(state.s[j])))
    return (state.gradient[i] + state.gradient[j]) / sum;
  return 0.5 * (state.hessian(i, i) + state.hessian(j, j)) + state.hessian(i, j);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INTERNAL_EIGENMODES_H
