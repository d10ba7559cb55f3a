// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of surfaces, written back: what is replaced is replaced in the text that was read, and everything else stays byte for byte.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_DOCUMENT_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_DOCUMENT_H

#include "Polygon_file.h"

#include <memory>
#include <string>
#include <vector>

namespace program {

// The text of a file that read_polygon_file() has read: polygons and points are numbered as there.
class Polygon_document
{
public:
  virtual ~Polygon_document() = default;

  // Whether the file says what its faces look like.
  virtual bool has_material() const = 0;

  // The text with these texture coordinates instead of what it had. If `material_file` is not empty, all faces have the material
  // `checkerboard` of that file.
  virtual std::string with_images(const Corner_images& images, const std::string& material_file) const = 0;

  // The text with other points.
  virtual std::string with_points(const std::vector<std::array<double, 3>>& points) const = 0;
};

std::unique_ptr<Polygon_document> make_OBJ_document(std::string text);
std::unique_ptr<Polygon_document> make_PLY_document(std::string text);

// The document of a file with this extension; null for formats that have none: they cannot hold texture coordinates.
std::unique_ptr<Polygon_document> make_document(const std::string& extension, std::string text);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_POLYGON_DOCUMENT_H
