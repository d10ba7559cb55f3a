// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Texture coordinates of polygons as triangles, which can be measured, drawn and packed.

#ifndef FLIP_FREE_MAPS_PROGRAM_ATLAS_H
#define FLIP_FREE_MAPS_PROGRAM_ATLAS_H

#include "files.h"

#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace program {

struct Atlas
{
  FFM::Textured_mesh mesh;                          // corners of the same place and image share both
  std::vector<std::int32_t> first;                  // of the points at the same place, by point
  std::vector<std::size_t> polygons;                // of which polygon each triangle is
  std::vector<std::array<std::size_t, 3>> corners;  // of which of its corners
  std::vector<char> has_area;                       // whether each triangle has an area in space
  std::size_t without_images = 0, without_area = 0; // polygons

  // A corner of a polygon that no triangle has, and its texture coordinates.
  struct Corner
  {
    std::size_t polygon, corner;
    std::int32_t texture;
  };
  std::vector<Corner> other_corners;
};

// Triangulates polygons so that all of their images are positive, where that is possible. Faces without texture coordinates are left
// out, and triangles without area in space, unless they are asked for; even then those whose corners are not at three places, or have
// less than three images.
Atlas make_atlas(const Surface& surface, const Corner_images& images, bool with_flat_triangles = false);

// Triangles of a polygon that suit its image, as numbers of corners.
std::vector<std::array<std::size_t, 3>> triangulation(const std::vector<Image>& images);

// Whether the triangles of an atlas that are positive are so with other images of the polygons, too.
bool stay_positive(const Atlas& atlas, const Corner_images& images);

// Enters the atlas' texture coordinates.
void copy_images(const Atlas& atlas, Corner_images& images);

// The parts that are connected by shared texture coordinates, as numbers of triangles.
std::vector<std::vector<std::size_t>> islands(const Atlas& atlas);

// Whether the image of a triangle is positive, negative, or has no area, exactly.
CGAL::Orientation image_orientation(const FFM::Textured_mesh& mesh, std::size_t triangle);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_ATLAS_H
