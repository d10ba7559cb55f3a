// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REGION_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REGION_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The part of a map around some elements, as a domain of its own in which only vertices near them can move.
template <int D>
struct Flip_region
{
  // Vertices that are less than `rings` edges away from the given elements can move, unless they are fixed.
  Flip_region(const Simplicial_domain<D>& whole, const std::vector<std::int64_t>& given, const std::vector<std::int32_t>& fixed_vertices,
              int rings)
  {
    std::vector<char> moves(whole.number_of_vertices, 0);
    for(std::int64_t e : given)
      for(std::int32_t v : whole.elements[e])
        moves[v] = 1;
    for(int i = 1; i < rings; ++i)
      grow(whole, moves);
    for(std::int32_t v : fixed_vertices)
      moves[v] = 0;

    std::vector<std::int32_t> number(whole.number_of_vertices, -1);
    double measure = 0;
    for(std::int64_t e = 0; e < whole.number_of_elements(); ++e) {
      auto element = whole.elements[e];
      if(std::none_of(element.begin(), element.end(), [&moves](std::int32_t v) { return moves[v]; }))
        continue;
      for(std::int32_t& v : element) {
        if(number[v] < 0)
          number[v] = add(v, moves[v]);
        v = number[v];
      }
      domain.elements.push_back(element);
      domain.rest_inverses.push_back(whole.rest_inverses[e]);
      domain.measures.push_back(whole.measures[e]);
      measure += whole.measures[e];
    }
    for(double& part : domain.measures)
      part /= measure;
    domain.number_of_vertices = static_cast<std::int32_t>(vertices.size());
  }

  // The places of the region's vertices in a map of the whole.
  Positions<D> positions(const Positions<D>& x) const
  {
    Positions<D> part(D, vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
      part.col(i) = x.col(vertices[i]);
    return part;
  }

  // The way back.
  void write(const Positions<D>& part, Positions<D>& x) const
  {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      x.col(vertices[i]) = part.col(i);
  }

  Simplicial_domain<D> domain;
  Position_constraints<D> constraints;
  std::vector<std::int32_t> vertices; // their numbers in the whole

private:
  static void grow(const Simplicial_domain<D>& whole, std::vector<char>& moves)
  {
    const std::vector<char> before = moves;
    for(const auto& element : whole.elements)
      if(std::any_of(element.begin(), element.end(), [&before](std::int32_t v) { return before[v]; }))
        for(std::int32_t v : element)
          moves[v] = 1;
  }

  std::int32_t add(std::int32_t v, bool moves)
  {
    const std::int32_t number = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(v);
    if(!moves)
      constraints.fixed_vertices.push_back(number);
    return number;
  }
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_INTERNAL_FLIP_REGION_H
