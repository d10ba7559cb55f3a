// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The options of sub-commands that pack charts.

#ifndef FLIP_FREE_MAPS_PROGRAM_PACKING_ARGUMENTS_H
#define FLIP_FREE_MAPS_PROGRAM_PACKING_ARGUMENTS_H

#include "types.h"

#include <CGAL/Flip_free_maps/atlas/Packing_options.h>

#include <CLI/CLI.hpp>

namespace program {

struct Packing_arguments
{
  FFM::Packing_options options;
  bool no_rotation = false;

  FFM::Packing_options chosen() const;
};

void add_packing_options(CLI::App& command, Packing_arguments& arguments);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_PACKING_ARGUMENTS_H
