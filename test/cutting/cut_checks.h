// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SEAMS_CUT_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SEAMS_CUT_CHECKS_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace test_support {

// Without support/mesh_checks.h, which instantiates a minimizer.
struct Soup
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<int, 3>> triangles;
};

// Adds a soup to a mesh; returns its vertices in the order of the points.
template <typename Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> add_soup(const Soup& soup, Mesh& mesh)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  std::vector<Vertex> vertices;
  for(const auto& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(CGAL::vertex_point, mesh, vertices.back(), p);
  }
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(std::array<Vertex, 3>{{vertices[t[0]], vertices[t[1]], vertices[t[2]]}}, mesh);
  return vertices;
}

// The boundary of a solid of unit cubes, those (x, y, z) for which the predicate holds.
inline Soup voxel_soup(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_solid)
{
  Soup soup;
  std::map<std::array<int, 3>, int> numbers;
  const auto corner = [&](std::array<int, 3> p) {
    const auto entry = numbers.emplace(p, static_cast<int>(soup.points.size()));
    if(entry.second)
      soup.points.emplace_back(p[0], p[1], p[2]);
    return entry.first->second;
  };
  const auto solid = [&](int x, int y, int z) { return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && is_solid(x, y, z); };
  for(int x = 0; x < nx; ++x)
    for(int y = 0; y < ny; ++y)
      for(int z = 0; z < nz; ++z)
        for(int axis = 0; axis < 3; ++axis)
          for(int side = 0; side < 2; ++side) {
            std::array<int, 3> c{x, y, z}, neighbor = c;
            neighbor[axis] += side == 0 ? -1 : 1;
            if(!solid(x, y, z) || solid(neighbor[0], neighbor[1], neighbor[2]))
              continue;
            c[axis] += side;
            std::array<std::array<int, 3>, 4> q{c, c, c, c};
            q[1][(axis + 1) % 3] += 1;
            q[2][(axis + 1) % 3] += 1;
            q[2][(axis + 2) % 3] += 1;
            q[3][(axis + 2) % 3] += 1;
            if(side == 0)
              std::swap(q[1], q[3]);
            soup.triangles.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
            soup.triangles.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
          }
  return soup;
}

inline Soup block_soup(int nx = 4, int ny = 4, int nz = 8)
{
  return voxel_soup(nx, ny, nz, [](int, int, int) { return true; });
}

// A plate with a row of tunnels through it.
inline Soup plate_soup(int genus)
{
  return voxel_soup(3 * genus + 2, 5, 2, [](int x, int y, int) { return x % 3 != 2 || y != 2; });
}

// A flat sheet without some of its squares, given by column and row: as many borders more.
inline Soup sheet_soup(int columns, int rows, const std::set<std::array<int, 2>>& holes)
{
  Soup soup;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i)
      soup.points.emplace_back(i, j, 0.4 * std::sin(i + 2. * j));
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
      if(holes.count({i, j}) == 0) {
        const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
  return soup;
}

// What a surface is without its seams: corners that meet across edges that are not cut are one vertex.
struct Count
{
  int pieces = 0;
  std::vector<int> euler, borders;
  int shortest_border = std::numeric_limits<int>::max();

  template <typename M, typename Is_cut>
  Count(const M& mesh, Is_cut&& is_cut)
  {
    using Halfedge = typename boost::graph_traits<M>::halfedge_descriptor;
    const auto null_face = boost::graph_traits<M>::null_face();
    std::map<Halfedge, int> numbers; // of the corners at the targets
    for(const Halfedge h : halfedges(mesh))
      if(face(h, mesh) != null_face)
        numbers.emplace(h, static_cast<int>(numbers.size()));
    std::vector<int> corners(numbers.size()), faces_(numbers.size()), border_edges(numbers.size());
    for(auto* parents : {&corners, &faces_, &border_edges})
      std::iota(parents->begin(), parents->end(), 0);
    const auto root = [](std::vector<int>& parents, int i) {
      while(parents[i] != i)
        i = parents[i] = parents[parents[i]];
      return i;
    };
    const auto join = [&root](std::vector<int>& parents, int i, int j) { parents[root(parents, i)] = root(parents, j); };
    const auto is_inner = [&](Halfedge h) { return face(opposite(h, mesh), mesh) != null_face && !is_cut(edge(h, mesh)); };
    for(const auto& entry : numbers) {
      const Halfedge h = entry.first;
      join(faces_, entry.second, numbers.at(next(h, mesh)));
      if(!is_inner(h))
        continue;
      join(corners, entry.second, numbers.at(prev(opposite(h, mesh), mesh)));
      join(faces_, entry.second, numbers.at(opposite(h, mesh)));
    }
    // Border edges are joined at the vertices that they share.
    std::map<int, int> first_at;
    std::set<int> vertices;
    std::map<int, int> piece_numbers, border_sizes;
    for(const auto& entry : numbers) {
      vertices.insert(root(corners, entry.second));
      if(!is_inner(entry.first))
        for(const Halfedge end : {entry.first, prev(entry.first, mesh)}) {
          const auto found = first_at.emplace(root(corners, numbers.at(end)), entry.second);
          if(!found.second)
            join(border_edges, entry.second, found.first->second);
        }
      piece_numbers.emplace(root(faces_, entry.second), static_cast<int>(piece_numbers.size()));
    }
    pieces = static_cast<int>(piece_numbers.size());
    euler.assign(pieces, 0);
    borders.assign(pieces, 0);
    const auto piece = [&](int i) { return piece_numbers.at(root(faces_, i)); };
    for(int v : vertices)
      euler[piece(v)] += 1;
    std::vector<int> halves(pieces, 0);
    for(const auto& entry : numbers) {
      halves[piece(entry.second)] += is_inner(entry.first) ? 1 : 2;
      if(!is_inner(entry.first) && ++border_sizes[root(border_edges, entry.second)] == 1)
        ++borders[piece(root(border_edges, entry.second))];
    }
    std::vector<int> corners_of(pieces, 0);
    for(const auto& entry : numbers)
      ++corners_of[piece(entry.second)];
    for(int p = 0; p < pieces; ++p)
      euler[p] += corners_of[p] / 3 - halves[p] / 2;
    for(const auto& size : border_sizes)
      shortest_border = (std::min)(shortest_border, size.second);
  }

  bool is_of_disks() const
  {
    return std::all_of(euler.begin(), euler.end(), [](int e) { return e == 1; }) &&
           std::all_of(borders.begin(), borders.end(), [](int b) { return b == 1; }) && shortest_border >= 3;
  }
};

// A mesh with seams.
struct Seamed_surface
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Edge = Mesh::Edge_index;

  Mesh mesh;
  std::vector<Vertex> vertices;
  Mesh::Property_map<Edge, bool> cut;

  explicit Seamed_surface(const Soup& soup) : vertices(add_soup(soup, mesh)), cut(mesh.add_property_map<Edge, bool>("e:cut", false).first)
  {}
  explicit Seamed_surface(const Mesh& other) : mesh(other), cut(mesh.add_property_map<Edge, bool>("e:cut", false).first) {}

  // Cuts the edges for whose end points, in either order, the predicate holds.
  template <typename Predicate>
  void mark(Predicate&& predicate)
  {
    for(const Edge e : mesh.edges()) {
      const Point &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
      cut[e] = cut[e] || predicate(p, q) || predicate(q, p);
    }
  }
  Edge edge_between(int v, int w) const { return mesh.edge(mesh.halfedge(vertices[v], vertices[w])); }
  Count count() const
  {
    return Count(mesh, [this](Edge e) { return cut[e]; });
  }
  std::vector<Edge> seams() const
  {
    std::vector<Edge> result;
    std::copy_if(mesh.edges().begin(), mesh.edges().end(), std::back_inserter(result), [this](Edge e) { return cut[e]; });
    return result;
  }
  double length_of_seams() const
  {
    double length = 0;
    for(const Edge e : seams())
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    return length;
  }
  int seams_at(Vertex v) const
  {
    int seams = 0;
    for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      seams += cut[mesh.edge(h)];
    return seams;
  }
};

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SEAMS_CUT_CHECKS_H
