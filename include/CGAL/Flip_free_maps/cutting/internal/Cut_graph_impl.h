// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_IMPL_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_IMPL_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_graph.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cut_graph::Cut_graph(const Cut_surface& surface, const Cut_opening& opening, const std::vector<double>& costs)
  : m_surface(surface), m_opening(opening), m_costs(costs), m_is_cut(surface.edge_halfedge.size(), 0)
{
  number_nodes();
  build_neighbors();
  m_degrees.assign(number_of_nodes(), 0);
  m_is_kept.assign(number_of_nodes(), 0);
  m_distances.assign(number_of_nodes(), infinity());
  m_predecessors.assign(number_of_nodes(), -1);
  m_marks.assign(number_of_nodes(), 0);
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::connect(const std::vector<std::int32_t>& ends)
{
  std::fill(m_distances.begin(), m_distances.end(), infinity());
  std::fill(m_predecessors.begin(), m_predecessors.end(), -1);
  std::vector<char> is_source_in(m_opening.number_of_pieces(), 0);
  std::vector<char> is_waiting(number_of_nodes(), 0);
  std::int32_t waiting = 0;
  for(std::int32_t n : ends)
    if(m_degrees[n] == 0 && !is_waiting[n] && !m_is_kept[n]) {
      is_waiting[n] = 1;
      ++waiting;
    }
  Cut_queue queue;
  const auto add_source = [&](std::int32_t n) {
    m_distances[n] = 0;
    m_predecessors[n] = -1;
    queue.emplace(0., n);
    is_source_in[m_piece_of_node[n]] = 1;
  };
  for(std::int32_t n = 0; n < number_of_nodes(); ++n)
    if(!is_waiting[n] && (m_degrees[n] > 0 || m_is_kept[n] || is_loop(n)))
      add_source(n);
  for(std::int32_t n : ends) {
    m_is_kept[n] = 1;
    if(is_waiting[n] && !is_source_in[m_piece_of_node[n]]) {
      is_waiting[n] = 0;
      --waiting;
      add_source(n);
    }
  }
  while(!queue.empty() && waiting > 0) {
    const auto [distance, n] = queue.top();
    queue.pop();
    if(distance > m_distances[n])
      continue;
    if(is_waiting[n]) {
      is_waiting[n] = 0;
      --waiting;
      std::int32_t v = n;
      while(m_predecessors[v] >= 0) {
        const std::int32_t e = m_predecessors[v], w = other_end(e, v);
        set_cut(e, true);
        add_source(v);
        v = w;
      }
      continue;
    }
    relax(n, distance, queue, infinity());
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::prune()
{
  for(std::int32_t n = 0; n < number_of_nodes(); ++n) {
    std::int32_t v = n;
    while(m_degrees[v] == 1 && !m_is_kept[v] && !is_loop(v)) {
      const std::int32_t e = first_cut_edge(v);
      set_cut(e, false);
      v = other_end(e, v);
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::extend_single_edges()
{
  for(std::int32_t n = 0; n < m_opening.number_of_loops(); ++n)
    if(m_opening.loop_sizes[n] == 2 && m_degrees[n] == 0)
      extend(n, -1);
  for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e)
    if(m_is_cut[e]) {
      const auto [a, b] = ends_of(e);
      if(a != b && !is_loop(a) && !is_loop(b) && m_degrees[a] == 1 && m_degrees[b] == 1)
        extend(a, e);
    }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::cut_slit(std::int32_t node)
{
  const std::int32_t e = m_neighbors[m_first_neighbors[node]].edge;
  set_cut(e, true);
  m_is_kept[node] = m_is_kept[other_end(e, node)] = 1;
}

CGAL_FLIP_FREE_MAPS_INLINE const std::vector<double>& Cut_graph::find_distances(const std::vector<std::int32_t>& sources)
{
  std::fill(m_distances.begin(), m_distances.end(), infinity());
  std::fill(m_predecessors.begin(), m_predecessors.end(), -1);
  Cut_queue queue;
  for(std::int32_t n : sources) {
    m_distances[n] = 0;
    queue.emplace(0., n);
  }
  while(!queue.empty()) {
    const auto [distance, n] = queue.top();
    queue.pop();
    if(distance <= m_distances[n])
      relax(n, distance, queue, infinity());
  }
  return m_distances;
}

CGAL_FLIP_FREE_MAPS_INLINE std::pair<std::int32_t, std::int32_t> Cut_graph::ends_of(std::int32_t e) const
{
  const std::int32_t h = m_surface.edge_halfedge[e];
  return {node_of(h), node_of(Cut_surface::next(h))};
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_graph::other_end(std::int32_t e, std::int32_t node) const
{
  const auto [a, b] = ends_of(e);
  return a == node ? b : a;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::set_cut(std::int32_t e, bool is_cut)
{
  if(static_cast<bool>(m_is_cut[e]) == is_cut)
    return;
  m_is_cut[e] = is_cut;
  const auto [a, b] = ends_of(e);
  m_degrees[a] += is_cut ? 1 : -1;
  m_degrees[b] += is_cut ? 1 : -1;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::number_nodes()
{
  m_node_of_copy = m_opening.loop_of;
  for(std::int32_t h : m_opening.loop_halfedges)
    m_piece_of_node.push_back(m_opening.piece_of[h / 3]);
  for(std::size_t copy = 0; copy < m_node_of_copy.size(); ++copy)
    if(m_node_of_copy[copy] < 0) {
      m_node_of_copy[copy] = number_of_nodes();
      m_piece_of_node.push_back(m_opening.piece_of[m_opening.first_corner[copy] / 3]);
    }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::build_neighbors()
{
  m_first_neighbors.assign(number_of_nodes() + 1, 0);
  const auto for_each_edge = [this](auto&& f) {
    for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e)
      if(!m_opening.is_border(m_surface.edge_halfedge[e]) && !m_surface.is_rigid[e]) {
        const auto [a, b] = ends_of(e);
        f(e, a, b);
      }
  };
  for_each_edge([this](std::int32_t, std::int32_t a, std::int32_t b) {
    ++m_first_neighbors[a + 1];
    ++m_first_neighbors[b + 1];
  });
  std::partial_sum(m_first_neighbors.begin(), m_first_neighbors.end(), m_first_neighbors.begin());
  m_neighbors.resize(m_first_neighbors.back());
  std::vector<std::int32_t> place(m_first_neighbors.begin(), m_first_neighbors.end() - 1);
  for_each_edge([&](std::int32_t e, std::int32_t a, std::int32_t b) {
    m_neighbors[place[a]++] = {e, b};
    m_neighbors[place[b]++] = {e, a};
  });
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::relax(std::int32_t n, double distance, Cut_queue& queue, double bound)
{
  ask_deadline_sometimes(++m_steps);
  for(std::int32_t i = m_first_neighbors[n]; i < m_first_neighbors[n + 1]; ++i) {
    const Neighbor& neighbor = m_neighbors[i];
    const double d = distance + m_costs[neighbor.edge];
    if(d < m_distances[neighbor.node] && d < bound) {
      m_distances[neighbor.node] = d;
      m_predecessors[neighbor.node] = neighbor.edge;
      queue.emplace(d, neighbor.node);
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_graph::first_cut_edge(std::int32_t n) const
{
  std::int32_t i = m_first_neighbors[n];
  while(!m_is_cut[m_neighbors[i].edge])
    ++i;
  return m_neighbors[i].edge;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Cut_graph::Chain> Cut_graph::chains() const
{
  std::vector<Chain> result;
  std::vector<char> is_done(m_is_cut.size(), 0);
  for(std::int32_t n = 0; n < number_of_nodes(); ++n) {
    if(m_degrees[n] == 0 || !is_end_of_chains(n))
      continue;
    for(std::int32_t i = m_first_neighbors[n]; i < m_first_neighbors[n + 1]; ++i) {
      std::int32_t e = m_neighbors[i].edge, v = m_neighbors[i].node;
      if(!m_is_cut[e] || is_done[e])
        continue;
      Chain chain{{e}, n, v, m_costs[e]};
      is_done[e] = 1;
      while(!is_end_of_chains(v)) {
        e = cut_edge_after(e, v);
        v = other_end(e, v);
        is_done[e] = 1;
        chain.edges.push_back(e);
        chain.cost += m_costs[e];
      }
      chain.end = v;
      result.push_back(std::move(chain));
    }
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_graph::cut_edge_after(std::int32_t e, std::int32_t n) const
{
  std::int32_t i = m_first_neighbors[n];
  while(!m_is_cut[m_neighbors[i].edge] || m_neighbors[i].edge == e)
    ++i;
  return m_neighbors[i].edge;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cut_graph::is_still(const Chain& chain) const
{
  std::int32_t v = chain.begin;
  for(std::size_t i = 0; i < chain.edges.size(); ++i) {
    if(!m_is_cut[chain.edges[i]] || (i > 0 && is_end_of_chains(v)))
      return false;
    v = other_end(chain.edges[i], v);
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE double Cut_graph::shorten(const Chain& chain)
{
  if(chain.edges.size() < 2 || !is_still(chain))
    return 0;
  for(std::int32_t e : chain.edges)
    set_cut(e, false);
  const std::vector<std::int32_t> begin_side = connected_to(chain.begin, 1);
  std::vector<std::int32_t> path;
  if(m_marks[chain.end] != 1) {
    const std::vector<std::int32_t> end_side = connected_to(chain.end, 2);
    // What is nearer than the cost of the chain is much less around a small side than around a large one.
    path =
      begin_side.size() <= end_side.size() ? path_between_sides(begin_side, 2, chain.cost) : path_between_sides(end_side, 1, chain.cost);
    clear_marks(end_side);
  } else {
    path = path_across_annulus(chain);
  }
  clear_marks(begin_side);
  double cost = 0;
  for(std::int32_t e : path)
    cost += m_costs[e];
  const bool is_better = !path.empty() && cost < chain.cost * (1 - 1e-9);
  for(std::int32_t e : is_better ? path : chain.edges)
    set_cut(e, true);
  return is_better ? chain.cost - cost : 0;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Cut_graph::connected_to(std::int32_t node, char mark)
{
  std::vector<std::int32_t> nodes{node};
  m_marks[node] = mark;
  for(std::size_t q = 0; q < nodes.size(); ++q)
    for(std::int32_t i = m_first_neighbors[nodes[q]]; i < m_first_neighbors[nodes[q] + 1]; ++i)
      if(m_is_cut[m_neighbors[i].edge] && m_marks[m_neighbors[i].node] == 0) {
        m_marks[m_neighbors[i].node] = mark;
        nodes.push_back(m_neighbors[i].node);
      }
  return nodes;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::clear_marks(const std::vector<std::int32_t>& nodes)
{
  for(std::int32_t n : nodes)
    m_marks[n] = 0;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Cut_graph::path_between_sides(const std::vector<std::int32_t>& begin_side, char goal,
                                                                                   double bound)
{
  std::vector<std::int32_t> path, reached = begin_side;
  Cut_queue queue;
  for(std::int32_t n : begin_side) {
    m_distances[n] = 0;
    m_predecessors[n] = -1;
    queue.emplace(0., n);
  }
  while(!queue.empty()) {
    const auto [distance, n] = queue.top();
    queue.pop();
    if(distance > m_distances[n])
      continue;
    ask_deadline_sometimes(++m_steps);
    if(m_marks[n] == goal) {
      for(std::int32_t v = n; m_predecessors[v] >= 0;) {
        path.push_back(m_predecessors[v]);
        v = other_end(path.back(), v);
      }
      break;
    }
    for(std::int32_t i = m_first_neighbors[n]; i < m_first_neighbors[n + 1]; ++i) {
      const auto [e, w] = m_neighbors[i];
      const double d = distance + m_costs[e];
      if(!(d < bound && d < m_distances[w]) || (m_marks[w] == 0 && is_on_cut(w)))
        continue;
      if(m_distances[w] == infinity())
        reached.push_back(w);
      m_distances[w] = d;
      m_predecessors[w] = e;
      queue.emplace(d, w);
    }
  }
  for(std::int32_t n : reached)
    m_distances[n] = infinity();
  return path;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_graph::first_of_fan(std::int32_t corner) const
{
  std::int32_t first = corner;
  while(!is_on_border(first)) {
    first = Cut_surface::next(m_surface.opposite[first]);
    if(first == corner)
      return -1;
  }
  return first;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Cut_graph::fans_along_border(std::int32_t first) const
{
  std::vector<std::int32_t> fans;
  std::int32_t h = first;
  do {
    fans.push_back(h);
    h = first_of_fan(Cut_surface::next(h));
  } while(h != first);
  return fans;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Cut_graph::place_of(std::int32_t corner) const
{
  // Most vertices are on no seam.
  const std::int32_t fan = is_on_cut(node_of(corner)) ? first_of_fan(corner) : -1;
  return fan >= 0 ? fan : -1 - m_surface.source(corner);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Cut_graph::path_across_annulus(const Chain& chain)
{
  const auto fan_at = [this](std::int32_t e, std::int32_t node) {
    const std::int32_t h = m_surface.edge_halfedge[e];
    return first_of_fan(node_of(h) == node ? h : m_surface.opposite[h]);
  };
  const std::int32_t from = fan_at(chain.edges.front(), chain.begin), to = fan_at(chain.edges.back(), chain.end);
  std::vector<std::int32_t> path;
  if(from < 0 || to < 0)
    return path;
  std::vector<std::int32_t> begins = fans_along_border(from);
  if(std::find(begins.begin(), begins.end(), to) != begins.end())
    return path;
  std::vector<std::int32_t> ends = fans_along_border(to);
  if(ends.size() < begins.size())
    begins.swap(ends);
  const std::unordered_set<std::int32_t> goal(ends.begin(), ends.end());
  if(m_arrivals.empty())
    m_arrivals.assign(m_surface.number_of_vertices() + m_surface.opposite.size(), {infinity(), -1, -1});
  std::vector<std::int32_t> reached;
  Cut_queue queue;
  const auto arrive = [&](std::int32_t place, const Arrival& by) {
    Arrival& known = arrival(place);
    if(!(by.distance < known.distance))
      return;
    if(known.distance == infinity())
      reached.push_back(place);
    known = by;
    queue.emplace(by.distance, place);
  };
  for(std::int32_t fan : begins)
    arrive(fan, {0., fan, -1});
  while(!queue.empty()) {
    const auto [distance, place] = queue.top();
    queue.pop();
    ask_deadline_sometimes(reached.size());
    const Arrival known = arrival(place);
    if(distance > known.distance)
      continue;
    if(place >= 0 && goal.count(place) != 0) {
      for(std::int32_t h = known.back; h >= 0; h = arrival(place_of(Cut_surface::next(h))).back)
        path.push_back(m_surface.edge_of[h]);
      break;
    }
    // From the first corner of a fan all of it is met.
    const std::int32_t begin = place >= 0 ? place : known.corner;
    std::int32_t corner = begin;
    do {
      const std::int32_t h = Cut_surface::prev(corner);
      if(is_on_border(h))
        break;
      const double d = distance + m_costs[m_surface.edge_of[h]];
      const std::int32_t neighbor = d < chain.cost && !m_surface.is_rigid[m_surface.edge_of[h]] ? place_of(h) : place;
      if(neighbor != place && (neighbor < 0 || goal.count(neighbor) != 0))
        arrive(neighbor, {d, h, h});
      corner = m_surface.opposite[h];
    } while(corner != begin);
  }
  for(const std::int32_t place : reached)
    arrival(place).distance = infinity();
  return path;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cut_graph::extend(std::int32_t node, std::int32_t besides)
{
  // Away from other seams if possible.
  std::int32_t best = -1;
  double best_cost = infinity();
  for(std::int32_t i = m_first_neighbors[node]; i < m_first_neighbors[node + 1]; ++i) {
    const auto [e, w] = m_neighbors[i];
    const double cost = m_costs[e] + (is_on_cut(w) ? 1e3 : 0.);
    if(e != besides && w != node && cost < best_cost) {
      best = e;
      best_cost = cost;
    }
  }
  if(best >= 0)
    set_cut(best, true);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_IMPL_H
