// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/default_traits.h>
#endif

/// \file
/// What a program needs that calls `parameterize()` with traits of its own: with the compiled library the functions of this folder
/// know the default method only, and those chosen at run time.

#endif // CGAL_FLIP_FREE_MAPS_FLIP_FREE_MAP_TRAITS_H
