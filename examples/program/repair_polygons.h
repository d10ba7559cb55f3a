// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Removes what makes a mesh unfit.

#ifndef FLIP_FREE_MAPS_PROGRAM_REPAIR_POLYGONS_H
#define FLIP_FREE_MAPS_PROGRAM_REPAIR_POLYGONS_H

#include "files.h"

#include <string>

namespace program {

bool is_finite(const Kernel::Point_3& p);

// Leaves a mesh of triangles without text and images, or nothing, and says what was done. Points stay where they are.
std::string repair_polygons(Surface& surface);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_REPAIR_POLYGONS_H
