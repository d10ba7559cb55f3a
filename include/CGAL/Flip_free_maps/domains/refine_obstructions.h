// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_REFINE_OBSTRUCTIONS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_REFINE_OBSTRUCTIONS_H

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// An edge that is split.
struct Edge_split
{
  std::array<int, 2> ends; ///< its vertices
  int vertex;              ///< the new one in its middle
};

/// \ingroup PkgFlipFreeMapsRef
/// Splits edges, triangles or tetrahedra that have the edges, one edge after the other. One half takes the place of the whole, the
/// other is added at the end.
///
/// \param simplices the vertices of each
/// \param splits the edges
/// \returns for each simplex that was added, the number of the one that it is a part of
///
/// Complexity: linear in the number of simplices for few edges.
template <std::size_t N>
std::vector<std::size_t> split_simplices(std::vector<std::array<int, N>>& simplices, const std::vector<Edge_split>& splits)
{
  std::vector<std::size_t> parents;
  std::vector<int> ends;
  for(const Edge_split& split : splits)
    ends.insert(ends.end(), split.ends.begin(), split.ends.end());
  std::sort(ends.begin(), ends.end());
  const std::size_t number = simplices.size();
  for(std::size_t i = 0; i < number; ++i) {
    const auto is_end = [&ends](int v) { return std::binary_search(ends.begin(), ends.end(), v); };
    if(std::count_if(simplices[i].begin(), simplices[i].end(), is_end) < 2)
      continue;
    std::vector<std::array<int, N>> parts(1, simplices[i]);
    for(const Edge_split& split : splits)
      for(std::size_t p = 0, n = parts.size(); p < n; ++p) {
        const auto a = std::find(parts[p].begin(), parts[p].end(), split.ends[0]) - parts[p].begin();
        const auto b = std::find(parts[p].begin(), parts[p].end(), split.ends[1]) - parts[p].begin();
        if(a == static_cast<std::ptrdiff_t>(N) || b == static_cast<std::ptrdiff_t>(N))
          continue;
        parts.push_back(parts[p]);
        parts[p][b] = split.vertex;
        parts.back()[a] = split.vertex;
      }
    simplices[i] = parts.front();
    simplices.insert(simplices.end(), parts.begin() + 1, parts.end());
    parents.insert(parents.end(), parts.size() - 1, i);
  }
  return parents;
}

/// \ingroup PkgFlipFreeMapsRef
/// The edges at whose middles a solid is to be split when there is no map without flips because of where vertices are held: the
/// impossible edges of a summary, and of each tetrahedron that is impossible, or still flipped, the longest edge that is not on the
/// boundary. A vertex in the middle, which nobody holds, leaves the side of the target on which both ends lie. Tetrahedra all of whose
/// edges are on the boundary are of no help.
///
/// \param mesh the solid at rest
/// \param summary of the call, whose elements have the numbers of the mesh's tetrahedra
/// \param impossible_edges those of the summary, by the mesh's numbers of vertices
/// \returns the edges, each with a new vertex: the first has the number of points of the mesh
template <typename Edges>
std::vector<Edge_split> splits_of_obstructions(const Tetrahedral_mesh& mesh, const Summary& summary, const Edges& impossible_edges)
{
  using Edge = std::array<int, 2>;
  const auto edge = [](int v, int w) { return Edge{{(std::min)(v, w), (std::max)(v, w)}}; };
  std::vector<Edge> on_boundary, chosen;
  for(const auto& t : boundary_triangles(mesh))
    for(int k = 0; k < 3; ++k)
      on_boundary.push_back(edge(t[k], t[(k + 1) % 3]));
  std::sort(on_boundary.begin(), on_boundary.end());
  for(const auto& ends : impossible_edges)
    chosen.push_back(edge(static_cast<int>(ends[0]), static_cast<int>(ends[1])));
  std::vector<std::int64_t> elements = summary.impossible_elements;
  elements.insert(elements.end(), summary.flipped_elements.begin(), summary.flipped_elements.end());
  for(const std::int64_t e : elements) {
    const std::array<int, 4>& t = mesh.tetrahedra[static_cast<std::size_t>(e)];
    double longest = 0;
    Edge best{{-1, -1}};
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j) {
        const Edge candidate = edge(t[i], t[j]);
        double length = 0;
        for(int c = 0; c < 3; ++c)
          length += (mesh.points[t[i]][c] - mesh.points[t[j]][c]) * (mesh.points[t[i]][c] - mesh.points[t[j]][c]);
        if(length > longest && !std::binary_search(on_boundary.begin(), on_boundary.end(), candidate)) {
          longest = length;
          best = candidate;
        }
      }
    if(best[0] >= 0)
      chosen.push_back(best);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Edge_split> splits;
  for(const Edge& ends : chosen)
    splits.push_back({ends, static_cast<int>(mesh.points.size() + splits.size())});
  return splits;
}

/// \ingroup PkgFlipFreeMapsRef
/// Splits a solid where held vertices leave no map without flips, see `splits_of_obstructions()`. Vertices and tetrahedra keep their
/// numbers, new ones are last.
///
/// \param mesh the solid at rest, all of whose points are vertices of tetrahedra
/// \param summary of a call that ended with `unreachable_constraints` or `flips_remain`
/// \returns the edges that were split, none if that does not help; it may take several rounds of calls and splits
inline std::vector<Edge_split> refine_obstructions(Tetrahedral_mesh& mesh, const Summary& summary)
{
  std::vector<Edge_split> splits = splits_of_obstructions(mesh, summary, summary.impossible_edges);
  for(const Edge_split& split : splits) {
    std::array<double, 3> middle;
    for(int c = 0; c < 3; ++c)
      middle[c] = 0.5 * (mesh.points[split.ends[0]][c] + mesh.points[split.ends[1]][c]);
    mesh.points.push_back(middle);
  }
  split_simplices(mesh.tetrahedra, splits);
  split_simplices(mesh.triangles, splits);
  return splits;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_REFINE_OBSTRUCTIONS_H
