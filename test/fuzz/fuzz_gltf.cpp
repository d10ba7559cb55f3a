// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces in glTF, in the form of the extension FUZZED_EXTENSION. What is read can be written back with other texture coordinates, and
// is read again with them.

#include "fuzz_support.h"

#include "program/formats/gltf/Gltf_document.h"
#include "program/formats/gltf/Gltf_surface.h"

#include <numeric>
#include <utility>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(fuzz::text_of(data, size)), path = fuzz::file("input" FUZZED_EXTENSION);
  try {
    program::Surface surface;
    surface.path = path;
    surface.text = text;
    program::read_gltf(path, text, true, surface);
    program::gltf_scene(surface, surface.images);
    // Writing takes a thousand times as long, since a checkerboard goes into the file.
    if(std::accumulate(data, data + size, 0u) % 16 != 0)
      return 0;

    program::Corner_images images;
    for(std::size_t i = 0; i < surface.polygons.size(); ++i)
      images.push_back({{0, 0.25 * static_cast<double>(i % 1000)}, {0.5, 0}, {0, 1}});
    const std::string output = fuzz::file("written" FUZZED_EXTENSION);
    std::string note;
    const std::string written = program::with_gltf_images({path, text, output, 0, size % 2 == 0}, images, note);
    program::Surface again;
    std::string error;
    try {
      program::read_gltf(output, written, true, again);
    } catch(const program::Failure& failure) {
      error = failure.message;
    }
    fuzz::demand(error.empty(), "what was written is not read: " + error);
    // Images that are read are (t, s).
    for(auto& corners : again.images)
      for(program::Image& image : corners)
        std::swap(image[0], image[1]);
    fuzz::demand(again.images == images, "other texture coordinates");
  } catch(const program::Failure&) {}
  return 0;
}
