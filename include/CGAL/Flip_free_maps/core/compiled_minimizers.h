// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_COMPILED_MINIMIZERS_H
#define CGAL_FLIP_FREE_MAPS_CORE_COMPILED_MINIMIZERS_H

#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#endif

// Beside the minimizers of the default methods the compiled library holds those of methods that are chosen at run time.

namespace CGAL {
namespace Flip_free_maps {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Map_minimizer<2, Any_map_traits>;
extern template class Map_minimizer<3, Any_map_traits>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CORE_COMPILED_MINIMIZERS_H
