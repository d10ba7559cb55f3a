// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The formats of solids. Each reader takes the content of a file and returns the empty string, or what is wrong with it; `file` has
// any content then. A reader does not look at the indices of corners, which read_volume_file() checks for all. Each writer returns
// the content of a file.
//
// VTK and Gmsh have libraries for their formats, which are not used: VTK's readers allocate what a header claims (48 GB for 80 bytes),
// both drop what is to be written back (comments, sections and sets that they do not know), and they come with hundreds of megabytes.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FORMATS_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FORMATS_H

#include "Volume_file.h"

#include <string>
#include <string_view>

namespace program {

// Unstructured grids of VTK in XML, of all encodings and byte orders, with any numbers at points and cells.
std::string read_VTU(std::string_view text, Volume_file& file);
std::string VTU_text(const Volume_file& file, Volume_encoding encoding);

// Those in the old format of VTK, up to version 5.1.
std::string read_VTK(std::string_view text, Volume_file& file);
std::string VTK_text(const Volume_file& file, bool is_binary);

// Meshes of Gmsh, versions 2 and 4.1; version 2 is written. Physical groups are the regions.
std::string read_Gmsh(std::string_view text, Volume_file& file);
std::string Gmsh_text(const Volume_file& file, bool is_binary);

// Files .mesh and .meshb. References are the regions of cells.
std::string read_Medit_text(std::string_view text, Volume_file& file);
std::string Medit_text(const Volume_file& file);
std::string read_Medit_binary(std::string_view text, Volume_file& file);
std::string Medit_binary(const Volume_file& file);

// Input of Abaqus: nodes, elements and sets. Element sets are the regions.
std::string read_Abaqus(std::string_view text, Volume_file& file);
std::string Abaqus_text(const Volume_file& file);

// The files .node and .ele of TetGen. `first` is the number of the first point, 0 or 1; the last attribute of elements is the region.
std::string read_Tetgen_nodes(std::string_view text, Volume_file& file, long long& first);
std::string read_Tetgen_elements(std::string_view text, Volume_file& file, long long first);
std::string Tetgen_nodes(const Volume_file& file);
std::string Tetgen_elements(const Volume_file& file);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FORMATS_H
