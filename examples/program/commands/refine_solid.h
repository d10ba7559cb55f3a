// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Solids that are split where there is no map without flips, with everything that their files have.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMANDS_REFINE_SOLID_H
#define FLIP_FREE_MAPS_PROGRAM_COMMANDS_REFINE_SOLID_H

#include "solid_fields.h"

#include <CGAL/Flip_free_maps/domains/refine_obstructions.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace program {

void add_refine(CLI::App& command, bool& refines);

// Calls `map`, which fills the summary; as long as that ends with obstructions at which the solid can be split, and if that is asked
// for, splits it, calls `split` with the edges, and then `map` again. The message tells what was split.
void map_and_refine(bool refines, Solid_input& input, FFM::Tetrahedral_domain& volume, FFM::Summary& summary,
                    const std::function<void()>& map, const std::function<void(const std::vector<FFM::Edge_split>&)>& split);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMANDS_REFINE_SOLID_H
