// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_VERSION_H
#define CGAL_FLIP_FREE_MAPS_VERSION_H

/// \ingroup PkgFlipFreeMapsRef
/// The version of this package as text, "major.minor.patch".
#define CGAL_FLIP_FREE_MAPS_VERSION "0.1.0"

/// \ingroup PkgFlipFreeMapsRef
/// The version of this package as a number that can be compared: 10000 * major + 100 * minor + patch.
#define CGAL_FLIP_FREE_MAPS_VERSION_NR 100

#endif // CGAL_FLIP_FREE_MAPS_VERSION_H
