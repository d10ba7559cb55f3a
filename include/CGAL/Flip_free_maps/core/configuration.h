// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H
#define CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H

// Functions of this folder are no templates. Users of the compiled library (CMake: `Flip_free_maps::core`, which defines
// CGAL_FLIP_FREE_MAPS_USE_CORE) see their declarations only; for all others the same text is inline.
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#define CGAL_FLIP_FREE_MAPS_INLINE
#else
#define CGAL_FLIP_FREE_MAPS_INLINE inline
#endif

#endif // CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H
