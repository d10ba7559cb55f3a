// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A surface opened along some edges: each vertex has a copy for each of the fans of corners between the cut edges around it.
// Borders are numbered, and so are the connected pieces.
class Cut_opening
{
public:
  std::vector<std::int32_t> copy_of;        // by corner
  std::vector<std::int32_t> first_corner;   // by copy; turning by `next_corner()` from it meets all corners of the copy
  std::vector<std::int32_t> loop_of;        // by copy, the border that it lies on, -1 inside
  std::vector<std::int32_t> loop_halfedges; // by border, one of its halfedges
  std::vector<std::int32_t> loop_sizes;     // by border, the number of its edges
  std::vector<std::int32_t> piece_of;       // by face
  std::vector<std::int32_t> loops_of_piece, genus_of_piece;

  // `is_cut` by edge; edges on the border of the surface do not matter.
  Cut_opening(const Cut_surface& surface, const std::vector<char>& is_cut);

  std::int32_t number_of_copies() const { return static_cast<std::int32_t>(first_corner.size()); }
  std::int32_t number_of_loops() const { return static_cast<std::int32_t>(loop_sizes.size()); }
  std::int32_t number_of_pieces() const { return static_cast<std::int32_t>(loops_of_piece.size()); }

  bool is_border(std::int32_t h) const { return m_is_border[h]; }

  // The corner next to this one around their vertex, -1 at the end of the fan.
  // Between them lies the edge of the halfedge prev(corner).
  std::int32_t next_corner(std::int32_t corner) const;

  // The border halfedge after this one.
  std::int32_t next_border(std::int32_t h) const { return first_corner[copy_of[Cut_surface::next(h)]]; }

private:
  void number_loops();

  void number_pieces();

  const Cut_surface& m_surface;
  std::vector<char> m_is_border; // by halfedge
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/cutting/internal/Cut_opening_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H
