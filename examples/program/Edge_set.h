// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Edges of polygons as pairs of numbers of points.

#ifndef FLIP_FREE_MAPS_PROGRAM_EDGE_SET_H
#define FLIP_FREE_MAPS_PROGRAM_EDGE_SET_H

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

namespace program {

// Whether an edge, given by two numbers of points, is among some.
class Edge_set
{
public:
  using key_type = std::pair<std::size_t, std::size_t>;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  // From pairs, or arrays of two.
  template <typename Pairs>
  explicit Edge_set(const Pairs& edges) : m_edges(std::make_shared<std::set<key_type>>())
  {
    for(const auto& edge : edges)
      m_edges->insert(std::minmax<std::size_t>(std::get<0>(edge), std::get<1>(edge)));
  }

  friend bool get(const Edge_set& set, const key_type& edge) { return set.m_edges->count(edge) != 0; }

private:
  std::shared_ptr<std::set<key_type>> m_edges;
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_EDGE_SET_H
