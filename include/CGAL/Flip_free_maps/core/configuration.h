// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H
#define CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H

// Functions of this folder take no types. Users of the compiled library (CMake: `Flip_free_maps::core`, which defines
// CGAL_FLIP_FREE_MAPS_USE_CORE) see their declarations only. For all others the same text is a template, though of nothing, so that
// only those who call a function wait for what it instantiates.
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#define CGAL_FLIP_FREE_MAPS_CORE_DECLARATION
#define CGAL_FLIP_FREE_MAPS_CORE_DEFINITION
#else
#define CGAL_FLIP_FREE_MAPS_CORE_DECLARATION template <int = 0>
#define CGAL_FLIP_FREE_MAPS_CORE_DEFINITION template <int>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CORE_CONFIGURATION_H
