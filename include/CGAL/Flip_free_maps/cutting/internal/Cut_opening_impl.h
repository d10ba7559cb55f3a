// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_IMPL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_opening.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cut_opening::Cut_opening(const Cut_surface& surface, const std::vector<char>& is_cut) : m_surface(surface)
{
  m_is_border.resize(surface.opposite.size());
  for(std::size_t h = 0; h < m_is_border.size(); ++h)
    m_is_border[h] = surface.opposite[h] < 0 || is_cut[surface.edge_of[h]];
  number_fans(
    surface.opposite, [this](std::int32_t h) { return m_is_border[h]; }, copy_of, first_corner);
  number_loops();
  number_pieces();
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_opening::next_corner(std::int32_t corner) const
{
  const std::int32_t h = Cut_surface::prev(corner);
  return m_is_border[h] ? -1 : m_surface.opposite[h];
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_opening::number_loops()
{
  loop_of.assign(first_corner.size(), -1);
  for(std::int32_t copy = 0; copy < number_of_copies(); ++copy) {
    if(loop_of[copy] >= 0 || !m_is_border[first_corner[copy]])
      continue;
    std::int32_t h = first_corner[copy], size = 0;
    do {
      loop_of[copy_of[h]] = number_of_loops();
      h = next_border(h);
      ++size;
    } while(h != first_corner[copy]);
    loop_halfedges.push_back(h);
    loop_sizes.push_back(size);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_opening::number_pieces()
{
  piece_of.assign(m_surface.faces.size(), -1);
  std::vector<std::int32_t> euler, stack;
  for(std::int32_t start = 0; start < m_surface.number_of_faces(); ++start) {
    if(piece_of[start] >= 0)
      continue;
    const std::int32_t piece = static_cast<std::int32_t>(euler.size());
    std::int32_t faces = 0, inner = 0, border = 0;
    piece_of[start] = piece;
    stack.assign(1, start);
    while(!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      ++faces;
      for(std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if(m_is_border[h]) {
          ++border;
          continue;
        }
        ++inner;
        const std::int32_t neighbor = m_surface.opposite[h] / 3;
        if(piece_of[neighbor] < 0) {
          piece_of[neighbor] = piece;
          stack.push_back(neighbor);
        }
      }
    }
    euler.push_back(faces - inner / 2 - border);
  }
  for(std::int32_t corner : first_corner)
    ++euler[piece_of[corner / 3]];
  loops_of_piece.assign(euler.size(), 0);
  for(std::int32_t h : loop_halfedges)
    ++loops_of_piece[piece_of[h / 3]];
  for(std::size_t p = 0; p < euler.size(); ++p)
    genus_of_piece.push_back((2 - loops_of_piece[p] - euler[p]) / 2);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_IMPL_H
