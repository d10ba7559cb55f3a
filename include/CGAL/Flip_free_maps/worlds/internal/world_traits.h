// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_WORLDS_INTERNAL_WORLD_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_WORLDS_INTERNAL_WORLD_TRAITS_H

#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The world of traits that name one; the others work alone.
template <typename Traits, typename = void>
struct World_of
{
  using type = Sequential_world;

  static type get(const Traits&) { return type(); }
};

template <typename Traits>
struct World_of<Traits, std::void_t<typename Traits::World>>
{
  using type = typename Traits::World;

  static type get(const Traits& traits) { return traits.world; }
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_WORLDS_INTERNAL_WORLD_TRAITS_H
