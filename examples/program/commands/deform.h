// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The sub-command deform, in its two kinds.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H
#define FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H

#include "../layout.h"
#include "../report.h"

#include "../formats/Handles.h"
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <vector>

namespace program {

struct Deform_arguments
{
  Method_arguments method;
  Picture_arguments pictures;
  std::string input, handles, output, start;
  double soft_weight = 0, tikhonov = 0, cell_size = 0.05;
  bool strict = false;
};

// All files that a call writes, the mesh first.
std::vector<File_argument> files_of(const Deform_arguments& arguments);

// Fails if an output of a solid has an extension that is not written.
void check_solid_output(const std::string& path);

// Fills a closed surface with tetrahedra.
FFM::Tetrahedral_mesh tetrahedralized(const Mesh& surface, double cell_size);

// Handles by the numbers of the vertices in the file of the solid, which may have vertices of no tetrahedron.
FFM::Handles<3> read_solid_handles(const std::string& path, const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume);

// Deforms a solid, writes it and draws it.
void deform_solid(const Deform_arguments& arguments, FFM::Tetrahedral_mesh mesh, FFM::Summary& summary);

// Writes and draws a solid whose points went to `result`.
void write_solid(const Deform_arguments& arguments, const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume,
                 const std::vector<Kernel::Point_3>& result, const FFM::Summary& summary);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMANDS_DEFORM_H
