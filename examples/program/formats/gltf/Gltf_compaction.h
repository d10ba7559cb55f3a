// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_COMPACTION_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_COMPACTION_H

#include "Gltf_container.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// Removes the accessors that a document has ceased to use, with their data, so that files do not grow when they are written again and
// again. What it never used stays; and if it has an extension that might name accessors or buffer views, everything does.
class Gltf_compaction
{
public:
  // Before the document is edited.
  explicit Gltf_compaction(Gltf_container& container);

  // Afterwards; `path` is where the result goes.
  void finish(const std::string& path);

private:
  Gltf_container& m_container;
  std::vector<char> m_had_accessors, m_had_views; // whether they were in use
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_COMPACTION_H
