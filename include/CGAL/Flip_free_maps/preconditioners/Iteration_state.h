// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ITERATION_STATE_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ITERATION_STATE_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>

#include <functional>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// What a preconditioner that changes in the course of a run is told before each iteration, by its optional member function
/// `void begin_iteration(const Iteration_state&)`.
struct Iteration_state
{
  /// Accepted steps so far; 0 begins a new run.
  int iteration = 0;
  /// Relative decrease of the energy by the last step, infinite before the first. While the reference is not the rest shape, that
  /// of the reference's own measure.
  double relative_decrease = std::numeric_limits<double>::infinity();
  /// Decrease of the energy by the last step over the decrease that the preconditioner's quadratic model predicted for it; NaN
  /// before the first step, and where the model had another matrix.
  double model_ratio = std::numeric_limits<double>::quiet_NaN();
  /// The fraction of elements whose symmetric Dirichlet energy, measured on the rest shape, exceeds a bound.
  std::function<double(double)> distorted_fraction;
};

namespace internal {

template <typename Preconditioner, typename = void>
struct Has_begin_iteration : std::false_type
{};

template <typename Preconditioner>
struct Has_begin_iteration<Preconditioner,
                           std::void_t<decltype(std::declval<Preconditioner&>().begin_iteration(std::declval<const Iteration_state&>()))>>
  : std::true_type
{};

template <typename Preconditioner>
void begin_iteration(Preconditioner& preconditioner, const Iteration_state& state)
{
  if constexpr(Has_begin_iteration<Preconditioner>::value)
    preconditioner.begin_iteration(state);
}

template <typename Preconditioner, typename = void>
struct Has_retreat : std::false_type
{};

template <typename Preconditioner>
struct Has_retreat<Preconditioner, std::void_t<decltype(std::declval<Preconditioner&>().retreat())>> : std::true_type
{};

// Whether the preconditioner has a more careful form for iterations in which its matrix is indefinite,
// or gives no direction of descent.
template <typename Preconditioner>
bool can_retreat(const Preconditioner& preconditioner)
{
  if constexpr(Has_retreat<Preconditioner>::value)
    return preconditioner.can_retreat();
  else
    return false;
}

template <typename Preconditioner>
void retreat(Preconditioner& preconditioner)
{
  if constexpr(Has_retreat<Preconditioner>::value)
    preconditioner.retreat();
}

template <typename Preconditioner, typename = void>
struct Has_is_constant : std::false_type
{};

template <typename Preconditioner>
struct Has_is_constant<Preconditioner, std::void_t<decltype(std::declval<const Preconditioner&>().is_constant())>> : std::true_type
{};

// Whether the matrix is the same in every iteration.
template <typename Preconditioner>
bool is_constant(const Preconditioner& preconditioner)
{
  if constexpr(Has_is_constant<Preconditioner>::value)
    return preconditioner.is_constant();
  else
    return std::is_same<typename Preconditioner::Category, Constant_matrix_tag>::value;
}

template <typename Preconditioner, typename = void>
struct Clamps_element_matrices : std::false_type
{};

template <typename Preconditioner>
struct Clamps_element_matrices<Preconditioner, std::void_t<decltype(Preconditioner::clamps_element_matrices)>> : std::true_type
{};

// Whether each element's matrix on its vertices' displacements is to be projected to the positive semidefinite ones.
template <typename Preconditioner>
bool clamps_element_matrices(const Preconditioner& preconditioner)
{
  if constexpr(Clamps_element_matrices<Preconditioner>::value)
    return preconditioner.clamps_element_matrices;
  else
    return false;
}

template <typename Preconditioner, typename = void>
struct Is_planar : std::false_type
{};

template <typename Preconditioner>
struct Is_planar<Preconditioner, std::enable_if_t<Preconditioner::is_planar>> : std::true_type
{};

template <typename Preconditioner, typename = void>
struct Has_is_planar : std::false_type
{};

template <typename Preconditioner>
struct Has_is_planar<Preconditioner, std::void_t<decltype(std::declval<const Preconditioner&>().is_planar())>> : std::true_type
{};

// Whether the preconditioner is one of the plane only.
template <typename Preconditioner>
bool is_planar(const Preconditioner& preconditioner)
{
  if constexpr(Has_is_planar<Preconditioner>::value)
    return preconditioner.is_planar();
  else
    return Is_planar<Preconditioner>::value;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ITERATION_STATE_H
