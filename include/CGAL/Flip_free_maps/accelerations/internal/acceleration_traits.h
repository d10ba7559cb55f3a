// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INTERNAL_ACCELERATION_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INTERNAL_ACCELERATION_TRAITS_H

#include <Eigen/Core>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Acceleration, typename = void>
struct Has_extrapolate : std::false_type
{};

template <typename Acceleration>
struct Has_extrapolate<Acceleration, std::void_t<decltype(std::declval<Acceleration&>().extrapolate(
                                       std::declval<const Eigen::VectorXd&>(), std::declval<Eigen::VectorXd&>()))>> : std::true_type
{};

template <typename Acceleration, typename = void>
struct Has_needs_current_matrix : std::false_type
{};

template <typename Acceleration>
struct Has_needs_current_matrix<Acceleration, std::void_t<decltype(std::declval<const Acceleration&>().needs_current_matrix())>>
  : std::true_type
{};

// Whether the acceleration multiplies by the matrix of the current map.
template <typename Acceleration>
bool needs_current_matrix(const Acceleration& acceleration)
{
  if constexpr(Has_needs_current_matrix<Acceleration>::value)
    return acceleration.needs_current_matrix();
  else
    return false;
}

template <typename Solve, typename = void>
struct Has_dot : std::false_type
{};

template <typename Solve>
struct Has_dot<Solve, std::void_t<decltype(std::declval<const Solve&>().dot(std::declval<const Eigen::VectorXd&>(),
                                                                            std::declval<const Eigen::VectorXd&>()))>> : std::true_type
{};

// The inner product of two vectors of unknowns, of which `solve` may hold a part.
template <typename Solve>
double dot(const Solve& solve, const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  static_cast<void>(solve);
  if constexpr(Has_dot<Solve>::value)
    return solve.dot(a, b);
  else
    return a.dot(b);
}

template <typename Solve>
double norm(const Solve& solve, const Eigen::VectorXd& a)
{
  static_cast<void>(solve);
  if constexpr(Has_dot<Solve>::value)
    return solve.norm(a);
  else
    return a.norm();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ACCELERATIONS_INTERNAL_ACCELERATION_TRAITS_H
