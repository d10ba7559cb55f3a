// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Atlases of surfaces that consist of one or several objects.

#ifndef FLIP_FREE_MAPS_PROGRAM_UNWRAP_SURFACE_H
#define FLIP_FREE_MAPS_PROGRAM_UNWRAP_SURFACE_H

#include "files.h"
#include "number_files.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>

namespace program {

struct Unwrap_request
{
  FFM::Unwrap_options options;
  FFM::Flip_free_map_traits<> traits;
  bool is_single_precision = false; // whether images are certified as floats, and are such
  bool has_atlas_per_object = false;
  std::vector<char> is_pinned; // by polygon, or none
};

// Of polygons that are pinned, images must be given. If each object gets an atlas of its own, the summary is of all of them: numbers of faces are the surface's, the occupancy is the mean
// and the scale the least one.
FFM::Unwrap_summary unwrap_surface(const Unwrap_request& request, const Surface& surface, const Vertex_pairs& seams, Corner_images& images);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_UNWRAP_SURFACE_H
