// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_MINIMIZER_2_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_MINIMIZER_2_IMPL_H

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

namespace CGAL {
namespace Flip_free_maps {

template class Map_minimizer<2, Flip_free_map_traits<>>;

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_DEFAULT_MINIMIZER_2_IMPL_H
