// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces in the files of the extension FUZZED_EXTENSION. What is read can be written back with other texture coordinates and with the
// same points, and is read again with them.

#include "fuzz_support.h"

#include "program/formats/Polygon_document.h"
#include "program/formats/Polygon_file.h"

#include <algorithm>
#include <cmath>

namespace {

program::Polygon_file read_again(const std::string& text)
{
  program::Polygon_file file;
  const std::string error = program::read_polygon_file(fuzz::write("written" FUZZED_EXTENSION, text), file, true);
  fuzz::demand(error.empty(), "what was written is not read: " + error);
  return file;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::write("input" FUZZED_EXTENSION, fuzz::text_of(data, size));
  program::Polygon_file file;
  program::read_polygon_file(path, file);
  std::string text;
  if(!program::read_polygon_file(path, file, true, &text).empty())
    return 0;
  fuzz::demand(file.images.size() == file.polygons.size(), "not as many lists of images as polygons");
  const auto document = program::make_document(FUZZED_EXTENSION, text);
  if(document == nullptr)
    return 0;

  program::Corner_images images;
  for(const auto& polygon : file.polygons) {
    images.emplace_back();
    for(std::size_t k = 0; k < polygon.size(); ++k)
      images.back().push_back({0.1 * static_cast<double>(images.size()), static_cast<double>(k)});
  }
  const program::Polygon_file textured = read_again(document->with_images(images, ""));
  fuzz::demand(textured.polygons == file.polygons, "other polygons");
  fuzz::demand(textured.images == images, "other texture coordinates");

  const bool is_finite = std::all_of(file.points.begin(), file.points.end(), [](const std::array<double, 3>& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  });
  if(is_finite)
    fuzz::demand(read_again(document->with_points(file.points)).points == file.points, "other points");
  return 0;
}
