// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_INLINE_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_INLINE_H

// What is no template is defined in files *_impl.h, as in CGAL: X.h includes X_impl.h, unless the program links to the compiled
// library, which is made of these files. A body that is seen costs its time in every program, used or not.
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#define CGAL_FLIP_FREE_MAPS_INLINE
#else
#define CGAL_FLIP_FREE_MAPS_INLINE inline
#endif

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_INLINE_H
