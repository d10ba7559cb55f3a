// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Solids in the files of the extension FUZZED_EXTENSION. What can be mapped is written in the same format and in another one, and read
// again with the same points.

#include "fuzz_support.h"

#include "program/formats/volume_files.h"

#include <algorithm>

namespace {

void check_written(const program::Volume_file& file, const std::string& name)
{
  const std::string path = fuzz::file(name);
  if(!program::why_volume_not_written(path, file).empty())
    return;
  const std::string error = program::write_volume_file(path, file);
  fuzz::demand(error.empty(), "not written: " + error);
  program::Volume_file again;
  const std::string error_again = program::read_volume_file(path, again);
  fuzz::demand(error_again.empty(), "what was written is not read: " + error_again);
  fuzz::demand(again.points == file.points, "other points in " + name);
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::string_view text = fuzz::text_of(data, size);
  // Solids of TetGen are in two files.
  if(std::string(FUZZED_EXTENSION) == ".node") {
    const std::size_t end = std::min(text.find('%'), text.size());
    fuzz::write("input.ele", text.substr(std::min(end + 1, text.size())));
    text = text.substr(0, end);
  }
  const std::string path = fuzz::write("input" FUZZED_EXTENSION, text);
  program::Volume_file file;
  if(!program::read_volume_file(path, file).empty())
    return 0;
  program::Solid solid;
  // Nothing else is written, and some formats have no way to say that there is nothing.
  if(!program::take_solid(file, true, solid).empty() || file.points.empty())
    return 0;
  fuzz::demand(solid.mesh.tetrahedra.size() == solid.cells.size(), "not as many cells as tetrahedra");
  check_written(file, "written" FUZZED_EXTENSION);
  const char* extensions[] = {".vtu", ".vtk", ".msh", ".mesh", ".meshb", ".inp", ".node"};
  check_written(file, std::string("other") + extensions[size % 7]);
  return 0;
}
