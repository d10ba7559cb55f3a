// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The sub-command deform, in its two kinds.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H
#define FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H

#include "solid_fields.h"

#include "../layout.h"
#include "../report.h"

#include "../formats/Handles.h"
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace program {

struct Deform_arguments
{
  Method_arguments method;
  Picture_arguments pictures;
  std::string input, handles, output, start;
  double soft_weight = 0, tikhonov = 0, cell_size = 0.05;
  bool second_order = false; // tetrahedra of 10 nodes are taken
  std::string encoding;      // of the output; empty for the usual one
  bool strict = false;
};

// Options of all sub-commands for solids in files.
void add_solid_options(CLI::App& command, Deform_arguments& arguments);

// All files that a call writes, the mesh first.
std::vector<File_argument> files_of(const Deform_arguments& arguments);

// Fails if the output of a solid has an extension or an encoding that is not written.
void check_solid_output(const Deform_arguments& arguments);
// ... or does not hold the kinds of cells of this file.
void check_solid_output(const Deform_arguments& arguments, const Volume_file& file);

// Reads the solid that a call names, into a domain as well; fails where it or its output cannot be had.
Solid_input read_solid_to_map(const Deform_arguments& arguments, FFM::Tetrahedral_domain& volume);

// Fills a closed surface with tetrahedra.
FFM::Tetrahedral_mesh tetrahedralized(const Mesh& surface, double cell_size);

std::vector<Kernel::Point_3> points_of(const FFM::Tetrahedral_mesh& mesh);

// Handles by the numbers of the vertices in the file of the solid, which may have vertices of no tetrahedron.
FFM::Handles<3> read_solid_handles(const std::string& path, const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume);

// Vertices of a solid and the places that a file has for them: a file .handles, or a surface (OFF, OBJ or PLY) whose vertex k is where
// vertex k of the solid goes; vertices of no tetrahedron are left out.
std::vector<std::pair<std::size_t, Kernel::Point_3>> read_places(const std::string& path, const std::string& input,
                                                                 const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume);

// Deforms a solid, writes it and draws it.
void deform_solid(const Deform_arguments& arguments, Solid_input input, FFM::Summary& summary);

// Writes and draws a solid whose points went to `result`; `handles` are the vertices whose places were given.
void write_solid(const Deform_arguments& arguments, Solid_input input, const FFM::Tetrahedral_domain& volume,
                 const std::vector<Kernel::Point_3>& result, const std::vector<std::size_t>& handles, const FFM::Summary& summary);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H
