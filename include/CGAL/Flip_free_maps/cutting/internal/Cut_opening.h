// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>

#include <cstddef>
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
  Cut_opening(const Cut_surface& surface, const std::vector<char>& is_cut) : m_surface(surface)
  {
    m_is_border.resize(surface.opposite.size());
    for(std::size_t h = 0; h < m_is_border.size(); ++h)
      m_is_border[h] = surface.opposite[h] < 0 || is_cut[surface.edge_of[h]];
    number_copies();
    number_loops();
    number_pieces();
  }

  std::int32_t number_of_copies() const { return static_cast<std::int32_t>(first_corner.size()); }
  std::int32_t number_of_loops() const { return static_cast<std::int32_t>(loop_sizes.size()); }
  std::int32_t number_of_pieces() const { return static_cast<std::int32_t>(loops_of_piece.size()); }

  bool is_border(std::int32_t h) const { return m_is_border[h]; }

  // The corner next to this one around their vertex, -1 at the end of the fan.
  // Between them lies the edge of the halfedge prev(corner).
  std::int32_t next_corner(std::int32_t corner) const
  {
    const std::int32_t h = Cut_surface::prev(corner);
    return m_is_border[h] ? -1 : m_surface.opposite[h];
  }

  // The border halfedge after this one.
  std::int32_t next_border(std::int32_t h) const { return first_corner[copy_of[Cut_surface::next(h)]]; }

private:
  void number_copies()
  {
    copy_of.assign(m_is_border.size(), -1);
    for(std::int32_t start = 0; start < static_cast<std::int32_t>(copy_of.size()); ++start) {
      if(copy_of[start] >= 0)
        continue;
      std::int32_t first = start;
      while(!m_is_border[first]) {
        first = Cut_surface::next(m_surface.opposite[first]);
        if(first == start)
          break;
      }
      std::int32_t corner = first;
      do {
        copy_of[corner] = number_of_copies();
        corner = next_corner(corner);
      } while(corner >= 0 && corner != first);
      first_corner.push_back(first);
    }
  }

  void number_loops()
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

  void number_pieces()
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

  const Cut_surface& m_surface;
  std::vector<char> m_is_border; // by halfedge
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_OPENING_H
