// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The method splitting, for the sub-commands that have it.

#ifndef FLIP_FREE_MAPS_PROGRAM_SPLITTING_H
#define FLIP_FREE_MAPS_PROGRAM_SPLITTING_H

#include "method_arguments.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/core/compiled_splitting.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_map_traits.h>

namespace program {

// Limits and the observer are those of `traits.options`.
inline FFM::Splitting_map_traits<FFM::Any_map_traits> splitting_traits(const Method_arguments& arguments, const FFM::Any_map_traits& traits)
{
  FFM::Splitting_options options;
  set_splitting(arguments, options);
  options.polish = arguments.polish;
  return FFM::Splitting_map_traits<FFM::Any_map_traits>(traits, options);
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_SPLITTING_H
