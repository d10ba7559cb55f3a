// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TETGEN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TETGEN_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

// Without this macro TetGen's inline functions end the program on bad input; with it they throw a number. Whoever includes
// tetgen.h before must have defined it too.
#ifndef TETLIBRARY
#ifdef tetgenH
#error "define TETLIBRARY before tetgen.h is included"
#endif
#define TETLIBRARY
#endif
#include <tetgen.h>

#endif // CGAL_FLIP_FREE_MAPS_USE_TETGEN

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_TETGEN_H
