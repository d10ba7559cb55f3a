// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_COMPILED_SPLITTING_H
#define CGAL_FLIP_FREE_MAPS_CORE_COMPILED_SPLITTING_H

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_map_traits.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>

// The compiled library holds the splitting scheme for methods that are chosen at run time.

namespace CGAL {
namespace Flip_free_maps {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Splitting_minimizer<2, Splitting_map_traits<Any_map_traits>>;
extern template class Splitting_minimizer<3, Splitting_map_traits<Any_map_traits>>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_COMPILED_SPLITTING_H
