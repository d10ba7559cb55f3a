// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_SPLITTING_2_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_SPLITTING_2_IMPL_H

#include <CGAL/Flip_free_maps/core/compiled_splitting.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>

namespace CGAL {
namespace Flip_free_maps {

template class Splitting_minimizer<2, Splitting_map_traits<Any_map_traits>>;

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_CHOSEN_SPLITTING_2_IMPL_H
