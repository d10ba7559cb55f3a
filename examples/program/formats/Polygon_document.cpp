// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Polygon_document.h"

#include <utility>

namespace program {

std::unique_ptr<Polygon_document> make_document(const std::string& extension, std::string text)
{
  if(extension == ".obj")
    return make_OBJ_document(std::move(text));
  return extension == ".ply" ? make_PLY_document(std::move(text)) : nullptr;
}

} // namespace program
