// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_H

#include <CGAL/Flip_free_maps/cutting/internal/Cut_opening.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Nodes in the order of their distances; the smaller number first among equals, so that results do not depend on anything else.
using Cut_queue = std::priority_queue<std::pair<double, std::int32_t>, std::vector<std::pair<double, std::int32_t>>,
                                      std::greater<std::pair<double, std::int32_t>>>;

// The seams that grow on a surface which is opened along the user's seams. Each border of the opened surface is shrunk to one
// node, the other copies of vertices are nodes themselves; so every piece is a closed surface, and seams that form a connected
// graph with a disk as their complement there, and contain the nodes of all borders, cut it to a disk. Edges that must not be cut
// are no edges of the graph: what they join is one face.
class Cut_graph
{
public:
  // `costs` of edges by which seams are kept short.
  Cut_graph(const Cut_surface& surface, const Cut_opening& opening, const std::vector<double>& costs);

  std::int32_t number_of_nodes() const { return static_cast<std::int32_t>(m_piece_of_node.size()); }
  std::int32_t node_of(std::int32_t corner) const { return m_node_of_copy[m_opening.copy_of[corner]]; }
  bool is_loop(std::int32_t node) const { return node < m_opening.number_of_loops(); }
  std::int32_t piece_of(std::int32_t node) const { return m_piece_of_node[node]; }
  // On a border or on a seam.
  bool is_on_cut(std::int32_t node) const { return is_loop(node) || m_degrees[node] > 0; }
  const std::vector<char>& is_cut() const { return m_is_cut; }

  // Cuts open the handles of all pieces, before there are other seams, by loops through a base: the shortest system of loops for
  // the base (Erickson and Whittlesey 2005), for the best of some bases that are far from each other.
  template <typename MustStop>
  void open_handles(bool begin_on_borders, const MustStop& must_stop)
  {
    const std::int32_t pieces = m_opening.number_of_pieces();
    const auto has_handles = [this](std::int32_t piece) { return m_opening.genus_of_piece[piece] > 0; };
    std::vector<std::int32_t> bases(pieces, -1);
    bool is_any = false;
    for(std::int32_t n = 0; n < number_of_nodes(); ++n) {
      const std::int32_t p = m_piece_of_node[n];
      if(!has_handles(p))
        continue;
      is_any = true;
      if(bases[p] < 0 || (is_loop(bases[p]) && !is_loop(n) && !begin_on_borders))
        bases[p] = n;
    }
    if(!is_any)
      return;
    std::vector<std::vector<std::int32_t>> best(pieces);
    std::vector<double> best_costs(pieces, infinity());
    std::vector<double> distance_to_bases(number_of_nodes(), infinity());
    for(int trial = 0; trial == 0 || (trial < NUMBER_OF_BASES && !must_stop()); ++trial) {
      std::vector<std::int32_t> sources;
      std::copy_if(bases.begin(), bases.end(), std::back_inserter(sources), [](std::int32_t b) { return b >= 0; });
      find_distances(sources);
      std::vector<std::vector<std::int32_t>> system(pieces);
      std::vector<double> costs(pieces, 0.);
      find_loops(has_handles);
      prune();
      for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e)
        if(m_is_cut[e]) {
          const std::int32_t p = m_opening.piece_of[m_surface.edge_halfedge[e] / 3];
          system[p].push_back(e);
          costs[p] += m_costs[e];
          set_cut(e, false);
        }
      for(std::int32_t p = 0; p < pieces; ++p)
        if(has_handles(p) && costs[p] < best_costs[p]) {
          best_costs[p] = costs[p];
          best[p].swap(system[p]);
        }
      std::vector<double> farthest(pieces, -1);
      for(std::int32_t n = 0; n < number_of_nodes(); ++n) {
        const std::int32_t p = m_piece_of_node[n];
        distance_to_bases[n] = (std::min)(distance_to_bases[n], m_distances[n]);
        if(has_handles(p) && distance_to_bases[n] > farthest[p] && distance_to_bases[n] < infinity()) {
          farthest[p] = distance_to_bases[n];
          bases[p] = n;
        }
      }
    }
    for(const auto& edges : best)
      for(std::int32_t e : edges)
        set_cut(e, true);
  }

  // Keeps nodes as ends of seams, and joins them to the seams of their pieces by short paths, the nearest first. Where a piece
  // has no seams, the borders serve as such, and the first of the nodes if there are none or the borders are to be joined, too.
  void connect(const std::vector<std::int32_t>& ends);

  // Removes dangling seams that lead to no node that is kept.
  void prune();

  // Replaces chains of seam edges between branchings by shorter ones. Without a chain the complement is an annulus, which any
  // path from one of its borders to the other cuts to a disk again: the shortest is taken, wherever its ends are.
  template <typename MustStop>
  void shorten(int rounds, const MustStop& must_stop)
  {
    std::fill(m_distances.begin(), m_distances.end(), infinity());
    for(int round = 0; round < rounds; ++round) {
      double gain = 0, total = 0;
      for(const Chain& chain : chains()) {
        if(must_stop())
          return;
        total += chain.cost;
        gain += shorten(chain);
      }
      if(!(gain > 1e-3 * total))
        break;
    }
  }

  // Adds an edge to each isolated seam edge: a border of two edges is none of a triangulated disk.
  void extend_single_edges();

  // An edge on its own, which `extend_single_edges()` makes a path of two.
  void cut_slit(std::int32_t node);

  // Distances from some nodes.
  const std::vector<double>& find_distances(const std::vector<std::int32_t>& sources);

private:
  static constexpr int NUMBER_OF_BASES = 6;

  struct Neighbor
  {
    std::int32_t edge, node;
  };

  struct Chain
  {
    std::vector<std::int32_t> edges; // in their order
    std::int32_t begin, end;         // nodes
    double cost;
  };

  static double infinity() { return std::numeric_limits<double>::infinity(); }

  std::pair<std::int32_t, std::int32_t> ends_of(std::int32_t e) const;

  std::int32_t other_end(std::int32_t e, std::int32_t node) const;

  void set_cut(std::int32_t e, bool is_cut);

  void number_nodes();

  void build_neighbors();

  void relax(std::int32_t n, double distance, Cut_queue& queue, double bound);

  std::int32_t first_cut_edge(std::int32_t n) const;

  // From the tree of shortest paths in m_predecessors, and the tree of faces that crosses edges of long loops first: cuts the
  // edges that are in neither, with their paths to the base.
  template <typename HasHandles>
  void find_loops(HasHandles&& has_handles)
  {
    std::vector<char> is_marked(m_surface.edge_halfedge.size(), 0);
    for(std::int32_t n = 0; n < number_of_nodes(); ++n)
      if(m_predecessors[n] >= 0)
        is_marked[m_predecessors[n]] = 1;
    std::vector<std::pair<double, std::int32_t>> candidates;
    for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e) {
      const std::int32_t h = m_surface.edge_halfedge[e];
      if(is_marked[e] || m_opening.is_border(h) || m_surface.is_rigid[e] || !has_handles(m_opening.piece_of[h / 3]))
        continue;
      const auto [a, b] = ends_of(e);
      candidates.emplace_back(-(m_distances[a] + m_distances[b] + m_costs[e]), e);
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::int32_t> parents(m_surface.faces.size());
    std::iota(parents.begin(), parents.end(), 0);
    const auto root = [&parents](std::int32_t f) {
      while(parents[f] != f)
        f = parents[f] = parents[parents[f]];
      return f;
    };
    for(std::int32_t e = 0; e < m_surface.number_of_edges(); ++e)
      if(m_surface.is_rigid[e]) {
        const std::int32_t h = m_surface.edge_halfedge[e], f = root(h / 3), g = root(m_surface.opposite[h] / 3);
        parents[(std::max)(f, g)] = (std::min)(f, g);
      }
    std::vector<char> is_reached(number_of_nodes(), 0);
    for(const auto& candidate : candidates) {
      const std::int32_t e = candidate.second, h = m_surface.edge_halfedge[e];
      const std::int32_t f = root(h / 3), g = root(m_surface.opposite[h] / 3);
      if(f != g) {
        parents[(std::max)(f, g)] = (std::min)(f, g);
        continue;
      }
      set_cut(e, true);
      const auto [a, b] = ends_of(e);
      for(std::int32_t v : {a, b})
        while(!is_reached[v]) {
          is_reached[v] = 1;
          if(m_predecessors[v] < 0)
            break;
          set_cut(m_predecessors[v], true);
          v = other_end(m_predecessors[v], v);
        }
    }
  }

  bool is_end_of_chains(std::int32_t n) const { return m_degrees[n] != 2 || m_is_kept[n] || is_loop(n); }

  std::vector<Chain> chains() const;

  std::int32_t cut_edge_after(std::int32_t e, std::int32_t n) const;

  // The chain may have changed since it was listed: it is left alone then.
  bool is_still(const Chain& chain) const;

  double shorten(const Chain& chain);

  std::vector<std::int32_t> connected_to(std::int32_t node, char mark);

  void clear_marks(const std::vector<std::int32_t>& nodes);

  // The shortest path from some nodes, which are marked, to nodes with the mark `goal` that meets no other seam and no other border;
  // empty if none is shorter than the bound.
  std::vector<std::int32_t> path_between_sides(const std::vector<std::int32_t>& begin_side, char goal, double bound);

  bool is_on_border(std::int32_t h) const { return m_opening.is_border(h) || m_is_cut[m_surface.edge_of[h]]; }

  // The first corner of the fan between seams that a corner belongs to, the one whose halfedge is on a seam or border; -1 where
  // there is none around the vertex.
  std::int32_t first_of_fan(std::int32_t corner) const;

  // Where paths across an annulus lead: fans, known by their first corners, and vertices that are not on seams, known by -1 - vertex.
  std::int32_t place_of(std::int32_t corner) const;

  // How a place was reached.
  struct Arrival
  {
    double distance;
    std::int32_t corner; // of the place
    std::int32_t back;   // the halfedge that leads there from the place before, -1 at the beginning
  };

  Arrival& arrival(std::int32_t place) { return m_arrivals[place >= 0 ? m_surface.number_of_vertices() + place : -1 - place]; }

  // The first corners of the fans along a border of the surface that is opened along all seams.
  std::vector<std::int32_t> fans_along_border(std::int32_t first) const;

  // The same where the seams stay connected without the chain: its two sides are different borders of the surface that is opened
  // along them.
  std::vector<std::int32_t> path_across_annulus(const Chain& chain);

  void extend(std::int32_t node, std::int32_t besides);

  const Cut_surface& m_surface;
  const Cut_opening& m_opening;
  const std::vector<double>& m_costs;
  std::vector<char> m_is_cut;               // by edge
  std::vector<std::int32_t> m_node_of_copy; // nodes of borders come first, by their numbers
  std::vector<std::int32_t> m_piece_of_node;
  std::vector<std::int32_t> m_first_neighbors;
  std::vector<Neighbor> m_neighbors;
  std::vector<std::int32_t> m_degrees; // seam edges at a node
  std::vector<char> m_is_kept, m_marks;
  std::size_t m_steps = 0; // of searches for paths
  std::vector<double> m_distances;
  std::vector<std::int32_t> m_predecessors; // edges
  std::vector<Arrival> m_arrivals;          // by place, at infinite distances between searches
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/cutting/internal/Cut_graph_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_GRAPH_H
