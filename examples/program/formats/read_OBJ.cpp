// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "readers.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>

#include <algorithm>
#include <utility>

namespace program {

// Keywords other than v, vt and f are skipped. A face has texture coordinates if all of its corners have.
std::string read_OBJ(std::string_view text, bool with_images, Polygon_file& file)
{
  using Reader = CGAL::Flip_free_maps::internal::OBJ_reader;
  Reader reader(with_images ? Reader::Demand::texture_if_any : Reader::Demand::points_only);
  const std::string error = reader.read(text);
  if(!error.empty())
    return error;
  if(reader.points.empty() && reader.polygons.empty())
    return "there is no vertex and no face, hence this is not an OBJ file";
  file.points = std::move(reader.points);
  file.polygons = std::move(reader.polygons);
  for(const auto& corners : reader.texture_polygons) {
    file.images.emplace_back();
    if(std::find(corners.begin(), corners.end(), Reader::no_texture) == corners.end())
      for(const std::size_t t : corners)
        file.images.back().push_back(reader.texture[t]);
  }
  return "";
}

} // namespace program
