// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ARRAY_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ARRAY_TRAITS_H

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Point, typename = void>
struct Has_y : std::false_type
{};

template <typename Point>
struct Has_y<Point, std::void_t<decltype(std::declval<const Point&>().y())>> : std::true_type
{};

template <typename Point, typename = void>
struct Has_z : std::false_type
{};

template <typename Point>
struct Has_z<Point, std::void_t<decltype(std::declval<const Point&>().z())>> : std::true_type
{};

// Whether a point, of CGAL or a user's own, has two coordinates only.
template <typename Point>
struct Is_planar_point : std::bool_constant<Has_y<Point>::value && !Has_z<Point>::value>
{};

template <typename T, std::size_t N>
struct Is_planar_point<std::array<T, N>> : std::bool_constant<N == 2>
{};

// Whether a type is an array of points or simplices: a random access container whose elements have `[0]`. Meshes are not.
template <typename Range, typename = void>
struct Is_array : std::false_type
{};

template <typename Range>
struct Is_array<Range,
                std::void_t<decltype(std::declval<const Range&>().size()), decltype(*std::declval<const Range&>().begin()),
                            decltype(std::declval<const Range&>()[std::size_t(0)]), decltype((*std::declval<const Range&>().begin())[0])>>
  : std::true_type
{};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ARRAY_TRAITS_H
