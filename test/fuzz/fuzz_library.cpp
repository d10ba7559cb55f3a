// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The readers of the library: FUZZED_READER into a FUZZED_MESH, and FUZZED_WRITER.

#include "fuzz_support.h"

#include <CGAL/Flip_free_maps/IO/Medit.h>
#include <CGAL/Flip_free_maps/IO/OBJ.h>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  namespace FFM = CGAL::Flip_free_maps;
  FFM::FUZZED_MESH mesh, again;
  std::string message;
  if(!FFM::FUZZED_READER(fuzz::write("input", fuzz::text_of(data, size)), mesh, &message))
    return 0;
  const std::string path = fuzz::file("written.obj");
  fuzz::demand(FFM::FUZZED_WRITER(path, mesh, &message), "not written: " + message);
  fuzz::demand(FFM::FUZZED_READER(path, again, &message), "what was written is not read: " + message);
  fuzz::demand(again.points == mesh.points && again.triangles == mesh.triangles, "another mesh");
  return 0;
}
