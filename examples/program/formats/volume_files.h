// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of solids of all formats: the extension of a name tells the format.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H

#include "Volume_file.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace program {

// The extensions, for texts.
constexpr const char* VOLUME_EXTENSIONS = ".mesh, .meshb, .vtu, .vtk, .msh, .inp, .node or .ele";

// Whether the name has one of them.
bool is_volume_file(const std::string& path);

// Reads a file. Returns the empty string, or the reason of a failure with the line or byte of the file where there is one; `file` is
// unchanged then.
std::string read_volume_file(const std::string& path, Volume_file& file);

// The names of encodings that an option takes.
std::vector<std::string> volume_encoding_names();
Volume_encoding volume_encoding(const std::string& name);

// Why no solid, or not this one, can be written under this name and in this encoding; empty if it can. Nothing is read or written.
std::string why_volume_not_written(const std::string& path, std::optional<Volume_encoding> encoding = std::nullopt);
std::string why_volume_not_written(const std::string& path, const Volume_file& file);

// Writes a file. What `file` was read from is written back with its points, if that was a file of the same format and encoding: in
// Medit, TetGen, Gmsh and Abaqus files nothing else changes, those of VTK keep all arrays. Otherwise a new file has what its format
// holds of points, cells, regions and groups, and of arrays if it is one of VTK. Returns the empty string, or the reason of a failure.
std::string write_volume_file(const std::string& path, const Volume_file& file, std::optional<Volume_encoding> encoding = std::nullopt);

// The values at the points of a file that have this name. Returns the empty string, or the reason of a failure, which lists the names
// that there are; `array` is null then.
std::string find_point_array(const Volume_file& file, const std::string& name, const Data_array*& array);

} // namespace program

namespace CGAL {
namespace Flip_free_maps {

/*!
  reads the tetrahedra and triangles of a file, whose extension tells the format, and nothing else.

  \param path name of the file
  \param mesh receives the mesh; it is not changed if the file cannot be read
  \param message if not null, receives the reason of a failure, and the empty string on success
*/
bool read_volume(const std::string& path, Tetrahedral_mesh& mesh, std::string* message = nullptr);

/*!
  writes a tetrahedral mesh to a file whose extension tells the format.

  \param path name of the file; an existing file is replaced
  \param mesh the mesh; its coordinates must be finite and its indices valid
  \param message if not null, receives the reason of a failure, and the empty string on success
*/
bool write_volume(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message = nullptr);

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H
