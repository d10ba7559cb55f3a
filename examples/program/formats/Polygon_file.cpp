// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Polygon_file.h"

#include "readers.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace program {

std::string small_extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

std::string read_polygon_file(const std::string& path, Polygon_file& file, bool with_images, std::string* text)
{
  const std::string extension = small_extension(path);
  const auto read = extension == ".off"   ? &read_OFF
                    : extension == ".obj" ? &read_OBJ
                    : extension == ".ply" ? &read_PLY
                    : extension == ".stl" ? &read_STL
                                          : nullptr;
  if(read == nullptr)
    return path + " is not an OFF, OBJ, PLY, STL, GLB or glTF file: no other extensions are read";
  std::string content, message;
  if(!CGAL::Flip_free_maps::internal::read_whole_file(path, content, &message))
    return message;
  Polygon_file result;
  std::string error = content.empty() ? "the file is empty" : read(content, with_images, result);
  for(std::size_t i = 0; error.empty() && i < result.polygons.size(); ++i)
    for(const std::size_t v : result.polygons[i])
      if(error.empty() && v >= result.points.size())
        error = "face number " + std::to_string(i) + " (from 0) names the vertex " + std::to_string(v) +
                " (from 0), which does not exist: the file has " + std::to_string(result.points.size());
  if(!error.empty())
    return "cannot read " + path + ": " + error;
  if(with_images)
    result.images.resize(result.polygons.size());
  file = std::move(result);
  if(text != nullptr)
    *text = std::move(content);
  return "";
}

} // namespace program
