// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TRAITS_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether an energy has the optional member functions.
template <typename Energy, int D, typename = void>
struct Has_slim_target : std::false_type
{};

template <typename Energy, int D>
struct Has_slim_target<Energy, D,
                       std::void_t<decltype(std::declval<const Energy&>().template slim_target<D>(std::declval<const Vector<D>&>()))>>
  : std::true_type
{};

template <typename Energy, int D, typename = void>
struct Has_convex_hessian : std::false_type
{};

template <typename Energy, int D>
struct Has_convex_hessian<Energy, D,
                          std::void_t<decltype(std::declval<const Energy&>().template convex_hessian<D>(
                            std::declval<const Vector<D>&>(), std::declval<const Matrix<D>&>(), std::declval<Matrix<D>&>()))>>
  : std::true_type
{};

template <typename Energy, int D, typename = void>
struct Has_composite_form : std::false_type
{};

template <typename Energy, int D>
struct Has_composite_form<Energy, D, std::void_t<decltype(Energy::template has_composite_form<D>)>>
  : std::bool_constant<Energy::template has_composite_form<D>>
{};

template <typename Energy, typename = void>
struct Has_holds_barrier : std::false_type
{};

template <typename Energy>
struct Has_holds_barrier<Energy, std::void_t<decltype(std::declval<const Energy&>().holds_barrier())>> : std::true_type
{};

// Whether the energy is infinite on elements that are not positive.
template <typename Energy>
bool has_barrier(const Energy& energy)
{
  if constexpr(Has_holds_barrier<Energy>::value)
    return energy.holds_barrier();
  else
    return Energy::has_barrier;
}

template <int D, typename Energy>
Vector<D> slim_target(const Energy& energy, const Vector<D>& s)
{
  if constexpr(Has_slim_target<Energy, D>::value)
    return energy.template slim_target<D>(s);
  else
    return Vector<D>::Ones();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_INTERNAL_ENERGY_TRAITS_H
