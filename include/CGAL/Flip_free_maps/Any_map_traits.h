// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ANY_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_ANY_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/core/configuration.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/chosen_method.h>
#include <CGAL/Flip_free_maps/core/default_traits.h>
#endif

/// \file
/// Methods that are chosen at run time, for the functions of this folder, whether or not the compiled library is used.

#endif // CGAL_FLIP_FREE_MAPS_ANY_MAP_TRAITS_H
