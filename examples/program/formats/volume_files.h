// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H

#include "Tetgen_files.h"
#include "VTU.h"
#include <CGAL/Flip_free_maps/IO/Medit.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <filesystem>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

inline std::string lower_case_extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for(char& c : extension)
    if(c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

inline bool fail_by_extension(const std::string& path, std::string* message)
{
  return fail(message, path + ": no format of tetrahedral meshes has this extension; known are .mesh (Medit), .vtu (VTK), .node and "
                              ".ele (TetGen)");
}

} // namespace internal

/*!
  reads a tetrahedral mesh from a file whose extension tells the format: `.mesh` (`read_Medit()`), `.vtu` (`read_VTU()`), `.node`
  or `.ele` (`read_Tetgen_files()`).

  \param path name of the file
  \param mesh receives the mesh; it is not changed if the file cannot be read
  \param message if not null, receives the reason of a failure, and the empty string on success
*/
inline bool read_volume(const std::string& path, Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  const std::string extension = internal::lower_case_extension(path);
  if(extension == ".mesh")
    return read_Medit(path, mesh, message);
  if(extension == ".vtu")
    return read_VTU(path, mesh, message);
  if(extension == ".node" || extension == ".ele")
    return read_Tetgen_files(path, mesh, message);
  return internal::fail_by_extension(path, message);
}

/*!
  writes a tetrahedral mesh to a file whose extension tells the format, as in `read_volume()`. `write_VTU()` can add values.

  \param path name of the file; an existing file is replaced
  \param mesh the mesh
  \param message if not null, receives the reason of a failure, and the empty string on success
*/
inline bool write_volume(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  const std::string extension = internal::lower_case_extension(path);
  if(extension == ".mesh")
    return write_Medit(path, mesh, message);
  if(extension == ".vtu")
    return write_VTU(path, mesh, {}, {}, message);
  if(extension == ".node" || extension == ".ele")
    return write_Tetgen_files(path, mesh, message);
  return internal::fail_by_extension(path, message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VOLUME_FILES_H
