// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Cuts to disks, counted by other means than those of the package.

#include "support/unit_test.h"

#include "cutting/cut_checks.h"

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_graph.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cut_to_disk)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Seamed_surface::Mesh;
using Vertex = Seamed_surface::Vertex;
using Edge = Seamed_surface::Edge;
using Point = Seamed_surface::Point;
using Branches = FFM::Cut_options::Branches;

namespace {

const std::vector<Branches> ALL_BRANCHES = {Branches::none, Branches::extremities, Branches::curvature_peaks, Branches::farthest_points};

FFM::Cut_options with(Branches branches)
{
  FFM::Cut_options options;
  options.branches = branches;
  options.number_of_points = branches == Branches::farthest_points ? 5 : 0;
  return options;
}

// Cuts, checks disks and the account, and returns the latter.
FFM::Cut_summary check_disks(Seamed_surface& surface, int components, int borders, int genus,
                             const FFM::Cut_options& options = FFM::Cut_options())
{
  const FFM::Cut_summary summary = FFM::cut_to_disk(surface.mesh, surface.cut, options);
  BOOST_TEST_CONTEXT(summary.message)
  {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::success));
    const Count count = surface.count();
    BOOST_TEST(count.is_of_disks());
    BOOST_TEST(summary.components == components);
    BOOST_TEST(summary.borders == borders);
    BOOST_TEST(summary.genus == genus);
    BOOST_TEST(summary.pieces == count.pieces);
    BOOST_TEST(summary.borders_of_pieces == count.pieces);
    BOOST_TEST(summary.seam_edges == static_cast<std::int64_t>(surface.seams().size()));
    BOOST_TEST(std::abs(summary.seam_length / surface.length_of_seams() - 1) <= 1e-12);
  }
  return summary;
}

void check_failure(Mesh mesh, FFM::Status status, const FFM::Cut_options& options = FFM::Cut_options())
{
  Seamed_surface surface(mesh);
  const FFM::Cut_summary summary = FFM::cut_to_disk(surface.mesh, surface.cut, options);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
  BOOST_TEST(!summary.message.empty());
  BOOST_TEST(surface.seams().empty());
}

// The graph in which seams are looked for, without those who use it.
struct Graph
{
  Seamed_surface surface;
  std::vector<Edge> edges;
  FFM::internal::Cut_surface flat;
  FFM::internal::Cut_opening opening;
  std::vector<double> costs;
  FFM::internal::Cut_graph graph;

  explicit Graph(const Soup& soup)
    : surface(soup), flat(load()), opening(flat, flat.is_seam), costs(flat.lengths), graph(flat, opening, costs)
  {}

  FFM::internal::Cut_surface load()
  {
    FFM::internal::Cut_surface result;
    std::string message;
    const auto nothing = [](Edge) { return false; };
    const FFM::Status status =
      FFM::internal::load_cut_surface(surface.mesh, get(CGAL::vertex_point, surface.mesh), nothing, nothing, result, edges, message);
    BOOST_TEST_REQUIRE((status == FFM::Status::success), message);
    return result;
  }

  std::pair<std::int32_t, std::int32_t> ends(std::int32_t edge) const
  {
    const std::int32_t h = flat.edge_halfedge[edge];
    return {graph.node_of(h), graph.node_of(FFM::internal::Cut_surface::next(h))};
  }

  double cost() const
  {
    double sum = 0;
    for(std::int32_t e = 0; e < flat.number_of_edges(); ++e)
      sum += graph.is_cut()[e] ? costs[e] : 0;
    return sum;
  }

  // By Bellman's and Ford's algorithm.
  std::vector<double> distances_from(std::int32_t source) const
  {
    std::vector<double> result(graph.number_of_nodes(), std::numeric_limits<double>::infinity());
    result[source] = 0;
    for(bool changes = true; changes;) {
      changes = false;
      for(std::int32_t e = 0; e < flat.number_of_edges(); ++e) {
        const auto [a, b] = ends(e);
        for(const auto& [from, to] : {std::make_pair(a, b), std::make_pair(b, a)})
          if(!flat.is_border(e) && result[from] + costs[e] < result[to] - 1e-13) {
            result[to] = result[from] + costs[e];
            changes = true;
          }
      }
    }
    return result;
  }

  // Writes the seams to the mesh, where they are counted.
  Count count()
  {
    for(std::int32_t e = 0; e < flat.number_of_edges(); ++e)
      surface.cut[edges[e]] = graph.is_cut()[e];
    return surface.count();
  }
};

const auto never = [] { return false; };

} // namespace

BOOST_AUTO_TEST_CASE(the_count_itself)
{
  Seamed_surface torus(plate_soup(1));
  BOOST_TEST((torus.count().euler.front() == 0 && torus.count().borders.front() == 0));
  BOOST_TEST(!torus.count().is_of_disks());
  const Count sheet = Seamed_surface(sheet_soup(7, 7, {{2, 2}, {4, 4}})).count();
  BOOST_TEST((sheet.euler.front() == -1 && sheet.borders.front() == 3));
  BOOST_TEST(Seamed_surface(sheet_soup(7, 7, {})).count().is_of_disks());
}

BOOST_AUTO_TEST_CASE(closed_surfaces)
{
  for(const Branches branches : ALL_BRANCHES)
    for(int genus : {0, 1, 2, 5}) {
      BOOST_TEST_CONTEXT("genus " << genus << ", branches " << static_cast<int>(branches))
      {
        Seamed_surface surface(genus == 0 ? block_soup() : plate_soup(genus));
        const FFM::Cut_summary summary = check_disks(surface, 1, 0, genus, with(branches));
        if(branches == Branches::none && genus == 0)
          BOOST_TEST(summary.seam_edges == 2);
        // A loop has four edges at least, and the loops share a vertex or are joined.
        if(branches == Branches::none && genus > 0)
          BOOST_TEST((summary.seam_length >= 8 * genus && summary.seam_length <= 24 * genus));
        if(branches == Branches::extremities)
          BOOST_TEST((summary.expected_energy >= 1 && summary.expected_energy <= 1.2));
      }
    }
}

BOOST_AUTO_TEST_CASE(smallest_surfaces)
{
  Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  for(const Branches branches : {Branches::none, Branches::extremities, Branches::curvature_peaks}) {
    Seamed_surface surface(tetrahedron);
    check_disks(surface, 1, 0, 0, with(branches));
  }
  Seamed_surface surface(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  BOOST_TEST(FFM::cut_to_disk(surface.mesh, surface.cut).is_valid());
  BOOST_TEST(surface.seams().empty());
}

// Limbs stand out of a cube: their ends are reached, however few seams the topology needs.
BOOST_AUTO_TEST_CASE(extremities_are_reached)
{
  const auto is_solid = [](int x, int y, int z) {
    return (x < 4 && y < 4 && z < 4) || (x >= 4 && y == 1 && z == 1) || (y >= 4 && x == 2 && z == 2);
  };
  Seamed_surface surface(voxel_soup(12, 12, 4, is_solid));
  FFM::Cut_options options;
  const FFM::Cut_summary summary = check_disks(surface, 1, 0, 0, options);
  BOOST_TEST(summary.points >= 2);
  double ends[2] = {0, 0};
  for(const Edge e : surface.seams())
    for(int k = 0; k < 2; ++k) {
      const auto& p = surface.mesh.point(surface.mesh.vertex(e, k));
      ends[0] = (std::max)(ends[0], p.x());
      ends[1] = (std::max)(ends[1], p.y());
    }
  BOOST_TEST((ends[0] == 12 && ends[1] == 12));

  // The lower the energy that is wanted, the more seams.
  Seamed_surface finer(surface.mesh), coarser(surface.mesh);
  for(const Edge e : surface.mesh.edges())
    finer.cut[e] = coarser.cut[e] = false;
  options.target_energy = 1.01;
  const FFM::Cut_summary fine = check_disks(finer, 1, 0, 0, options);
  options.number_of_points = 2;
  const FFM::Cut_summary coarse = check_disks(coarser, 1, 0, 0, options);
  BOOST_TEST(fine.expected_energy <= 1.01);
  BOOST_TEST(fine.seam_length > coarse.seam_length);
  BOOST_TEST(coarse.points == 2);
  BOOST_TEST(coarse.expected_energy > fine.expected_energy);
}

// One round after the other reaches more places, and all rounds together those of no limit.
BOOST_AUTO_TEST_CASE(rounds_are_limited)
{
  const int n = 40;
  Soup soup = sheet_soup(n, n, {});
  for(auto& p : soup.points) {
    const double x = p.x() / n, y = p.y() / n;
    p = {x, y, 0.2 * std::sin(9 * x) * std::cos(7 * y)};
  }
  FFM::Cut_options options;
  options.cut_disks = true;
  options.target_energy = 1.002;
  Seamed_surface unlimited(soup);
  const FFM::Cut_summary all = check_disks(unlimited, 1, 1, 0, options);
  int points = 0;
  for(const int rounds : {1, 2, 1000}) {
    Seamed_surface limited(soup);
    options.max_rounds = rounds;
    const FFM::Cut_summary some = check_disks(limited, 1, 1, 0, options);
    BOOST_TEST(some.points > points);
    points = some.points;
    if(rounds < 1000)
      BOOST_TEST(some.seam_length < all.seam_length);
    else
      BOOST_TEST((limited.seams() == unlimited.seams()));
  }
  BOOST_TEST(points == all.points);
}

BOOST_AUTO_TEST_CASE(farthest_points_of_the_paper)
{
  // Moved a little, so that no two points are equally far.
  Soup soup = block_soup(3, 4, 9);
  Point corner(1, 1, 1);
  for(std::size_t i = 0; i < soup.points.size(); ++i) {
    Point& p = soup.points[i];
    p = Point(p.x() + 0.1 * std::sin(1. * i), p.y() + 0.1 * std::sin(2. * i), p.z() + 0.1 * std::sin(3. * i));
    corner = Point((std::min)(corner.x(), p.x()), (std::min)(corner.y(), p.y()), (std::min)(corner.z(), p.z()));
  }
  Seamed_surface surface(soup);
  FFM::Cut_options options = with(Branches::farthest_points);
  options.number_of_points = 7;
  BOOST_TEST(check_disks(surface, 1, 0, 0, options).points == 7);
  const auto distance = [](const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); };
  std::set<Vertex> chosen;
  while(chosen.size() < 7) {
    const auto score = [&](Vertex v) {
      double sum = chosen.empty() ? -distance(surface.mesh.point(v), corner) : 0.;
      for(const Vertex w : chosen)
        sum += distance(surface.mesh.point(v), surface.mesh.point(w));
      return chosen.count(v) != 0 ? -1e9 : sum;
    };
    chosen.insert(
      *std::max_element(surface.vertices.begin(), surface.vertices.end(), [&](Vertex v, Vertex w) { return score(v) < score(w); }));
  }
  // All are reached, and seams end nowhere else.
  for(const Vertex v : surface.vertices)
    BOOST_TEST((chosen.count(v) == 0 ? surface.seams_at(v) != 1 : surface.seams_at(v) > 0));
}

BOOST_AUTO_TEST_CASE(holes)
{
  const Soup soup = sheet_soup(15, 15, {{2, 2}, {12, 2}, {2, 12}, {12, 12}, {7, 7}, {7, 2}});
  Seamed_surface joined(soup), open(soup);
  check_disks(joined, 1, 7, 0);
  FFM::Cut_options options;
  options.join_borders = false;
  BOOST_TEST(FFM::cut_to_disk(open.mesh, open.cut, options).is_valid());
  BOOST_TEST(open.seams().empty());

  // A plate with two tunnels and two holes in its skin.
  Soup plate = plate_soup(2);
  plate.triangles.erase(plate.triangles.begin() + 40);
  plate.triangles.erase(plate.triangles.begin());
  Seamed_surface plate_joined(plate);
  check_disks(plate_joined, 1, 2, 2);
  for(const Branches branches : ALL_BRANCHES) {
    options.branches = branches;
    options.number_of_points = 4;
    Seamed_surface plate_open(plate);
    BOOST_TEST(FFM::cut_to_disk(plate_open.mesh, plate_open.cut, options).is_valid());
    const Count count = plate_open.count();
    BOOST_TEST(count.pieces == 1);
    // Genus 0: chi = 2 - borders.
    BOOST_TEST(count.euler.front() == 2 - count.borders.front());
    BOOST_TEST(count.borders.front() >= 1);
  }
}

BOOST_AUTO_TEST_CASE(several_components)
{
  Soup all;
  for(const Soup& soup : {block_soup(), plate_soup(2), sheet_soup(8, 8, {}), sheet_soup(9, 9, {{2, 2}, {6, 6}})}) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
    for(const auto& t : soup.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for(const Branches branches : ALL_BRANCHES) {
    Seamed_surface surface(all);
    surface.mesh.add_vertex(Point(0, 0, 0)); // isolated
    check_disks(surface, 4, 4, 2, with(branches));
    BOOST_TEST(surface.count().pieces == 4);
    // The sheet that is a disk already is left alone.
    const int first = static_cast<int>(block_soup().points.size() + plate_soup(2).points.size());
    for(int v = first; v < first + 81; ++v)
      BOOST_TEST(surface.seams_at(surface.vertices[v]) == 0);
  }
  Seamed_surface sheet(sheet_soup(8, 8, {}));
  FFM::Cut_options options;
  options.cut_disks = true;
  options.target_energy = 1.001;
  BOOST_TEST(check_disks(sheet, 1, 1, 0, options).seam_edges > 0);
}

BOOST_AUTO_TEST_CASE(seams_of_the_user)
{
  // The edges around a block at a height; 16 there are.
  const auto ring = [](Seamed_surface& surface, double z) {
    surface.mark([z](const Point& p, const Point& q) { return p.z() == z && q.z() == z; });
  };
  for(const Branches branches : ALL_BRANCHES) {
    // One leaves two disks; nothing is to be added.
    Seamed_surface equator(block_soup());
    ring(equator, 4);
    FFM::Cut_summary summary = check_disks(equator, 1, 0, 0, with(branches));
    BOOST_TEST(summary.pieces == 2);
    BOOST_TEST((summary.user_seam_edges == 16 && summary.seam_edges == 16));
    // Two leave an annulus between them, which is opened; all are kept.
    Seamed_surface circles(block_soup());
    ring(circles, 2);
    ring(circles, 6);
    const std::vector<Edge> before = circles.seams();
    summary = check_disks(circles, 1, 0, 0, with(branches));
    BOOST_TEST(summary.pieces == 3);
    BOOST_TEST(summary.seam_edges >= 2 * 16 + 4);
    for(const Edge e : before)
      BOOST_TEST(circles.cut[e]);
    // A single edge would leave a border of two edges.
    Seamed_surface edge(block_soup());
    edge.mark([](const Point& p, const Point& q) { return p == Point(0, 2, 2) && q == Point(0, 2, 3); });
    BOOST_TEST(check_disks(edge, 1, 0, 0, with(branches)).user_seam_edges == 1);
    // A slit inside a sheet is joined to its border.
    Seamed_surface slit(sheet_soup(9, 9, {}));
    slit.cut[slit.edge_between(44, 45)] = slit.cut[slit.edge_between(45, 46)] = true;
    summary = check_disks(slit, 1, 1, 0, with(branches));
    BOOST_TEST(summary.seam_edges > 2);
    BOOST_TEST((slit.cut[slit.edge_between(44, 45)] && slit.cut[slit.edge_between(45, 46)]));
  }
  // Without joined borders a slit is a hole, but no hole has two edges only.
  FFM::Cut_options options;
  options.join_borders = false;
  Seamed_surface sheet(sheet_soup(9, 9, {}));
  sheet.cut[sheet.edge_between(44, 45)] = true;
  BOOST_TEST(FFM::cut_to_disk(sheet.mesh, sheet.cut, options).is_valid());
  BOOST_TEST(sheet.seams().size() == 2);
  BOOST_TEST(sheet.count().shortest_border == 4);
}

BOOST_AUTO_TEST_CASE(features_are_preferred)
{
  // The two borders of a tube; all ways along it are equally long.
  Soup tube = block_soup(4, 4, 6);
  tube.triangles.erase(std::remove_if(tube.triangles.begin(), tube.triangles.end(),
                                      [&tube](const auto& t) {
                                        const double a = tube.points[t[0]].z(), b = tube.points[t[1]].z(), c = tube.points[t[2]].z();
                                        return a == b && b == c;
                                      }),
                       tube.triangles.end());
  for(int column : {1, 2, 3}) {
    Seamed_surface surface(tube);
    auto feature = surface.mesh.add_property_map<Edge, bool>("e:feature", false).first;
    for(const Edge e : surface.mesh.edges()) {
      const auto &p = surface.mesh.point(surface.mesh.vertex(e, 0)), &q = surface.mesh.point(surface.mesh.vertex(e, 1));
      feature[e] = p.x() == column && q.x() == column && p.y() == 4 && q.y() == 4;
    }
    FFM::Cut_options options = with(Branches::none);
    const auto summary = FFM::cut_to_disk(surface.mesh, surface.cut, options, FFM::parameters::edge_is_feature_map(feature));
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(surface.count().is_of_disks());
    BOOST_TEST(surface.seams().size() == 6u);
    for(const Edge e : surface.seams())
      BOOST_TEST(feature[e]);
  }
}

BOOST_AUTO_TEST_CASE(the_same_again)
{
  const Soup soup = plate_soup(3);
  std::vector<Edge> first;
  for(int run = 0; run < 2; ++run) {
    Seamed_surface surface(soup);
    check_disks(surface, 1, 0, 3);
    if(run == 0)
      first = surface.seams();
    BOOST_TEST((surface.seams() == first));
  }
  // Neither do units matter, nor where the surface is.
  Soup moved = soup;
  for(auto& p : moved.points)
    p = Point(1024 * p.x() + 4096, 1024 * p.y() + 4096, 1024 * p.z() + 4096);
  Seamed_surface surface(moved);
  check_disks(surface, 1, 0, 3);
  BOOST_TEST((surface.seams() == first));
}

BOOST_AUTO_TEST_CASE(other_mesh_types_and_maps)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  using Polyhedron_edge = boost::graph_traits<Polyhedron>::edge_descriptor;
  Polyhedron mesh;
  add_soup(plate_soup(2), mesh);
  std::map<Polyhedron_edge, bool> cut;
  const auto summary = FFM::cut_to_disk(mesh, boost::make_assoc_property_map(cut), FFM::Cut_options(),
                                        CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, mesh)));
  BOOST_TEST((summary.is_valid() && summary.genus == 2));
  BOOST_TEST(Count(mesh, [&cut](Polyhedron_edge e) { return cut.count(e) != 0 && cut.at(e); }).is_of_disks());
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  const auto mesh_of = [](const Soup& soup) { return Seamed_surface(soup).mesh; };
  check_failure(Mesh(), FFM::Status::empty_mesh);
  Mesh quad;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), quad);
  check_failure(quad, FFM::Status::not_triangular);
  Soup soup = block_soup();
  soup.points[17] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  check_failure(mesh_of(soup), FFM::Status::non_finite_input);
  soup = block_soup();
  soup.points[soup.triangles[5][0]] = soup.points[soup.triangles[5][1]];
  check_failure(mesh_of(soup), FFM::Status::degenerate_rest_element);
  // Two sheets that meet in one vertex.
  const Soup fans{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  check_failure(mesh_of(fans), FFM::Status::non_manifold);

  const Mesh sphere = mesh_of(block_soup());
  const auto check_option = [&sphere](auto&& change) {
    FFM::Cut_options options;
    change(options);
    BOOST_TEST(!options.is_valid());
    check_failure(sphere, FFM::Status::invalid_option, options);
  };
  BOOST_TEST(FFM::Cut_options().is_valid());
  check_option([](auto& o) { o.target_energy = 1; });
  check_option([](auto& o) { o.target_energy = std::numeric_limits<double>::quiet_NaN(); });
  check_option([](auto& o) { o.number_of_points = -1; });
  check_option([](auto& o) { o.branches = Branches::farthest_points; });
  check_option([](auto& o) { o.feature_cost = 0; });
  check_option([](auto& o) { o.crease_preference = -1; });
  check_option([](auto& o) { o.max_rounds = -1; });
}

BOOST_AUTO_TEST_CASE(distances_in_the_graph)
{
  for(const Soup& soup : {block_soup(), sheet_soup(8, 6, {{2, 2}, {5, 3}}), plate_soup(1)}) {
    Graph g(soup);
    for(const std::int32_t source : {0, g.graph.number_of_nodes() / 2}) {
      const std::vector<double> expected = g.distances_from(source), found = g.graph.find_distances({source});
      double error = 0;
      for(std::size_t n = 0; n < expected.size(); ++n)
        error = (std::max)(error, std::abs(found[n] - expected[n]));
      BOOST_TEST(error <= 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(ends_are_joined_by_a_tree)
{
  Graph g(block_soup());
  const std::int32_t n = g.graph.number_of_nodes();
  const std::vector<std::int32_t> ends{0, n / 3, n / 2, n - 1};
  g.graph.connect(ends);
  std::map<std::int32_t, int> degrees;
  std::vector<std::int32_t> parents(n);
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](std::int32_t v) {
    while(parents[v] != v)
      v = parents[v];
    return v;
  };
  int edges = 0;
  for(std::int32_t e = 0; e < g.flat.number_of_edges(); ++e)
    if(g.graph.is_cut()[e]) {
      const auto [a, b] = g.ends(e);
      ++edges;
      ++degrees[a];
      ++degrees[b];
      BOOST_TEST(root(a) != root(b));
      parents[root(a)] = root(b);
    }
  BOOST_TEST(static_cast<int>(degrees.size()) == edges + 1);
  for(const std::int32_t end : ends)
    BOOST_TEST(degrees.count(end) == 1u);
  for(const auto& [node, degree] : degrees)
    BOOST_TEST((degree > 1 || std::count(ends.begin(), ends.end(), node) == 1));
  BOOST_TEST(g.cost() < g.distances_from(0)[n / 3] + g.distances_from(0)[n / 2] + g.distances_from(0)[n - 1] + 1e-12);
  const double cost = g.cost();
  g.graph.prune();
  BOOST_TEST(g.cost() == cost);
}

// A path that was the shortest for other costs becomes the shortest one.
BOOST_AUTO_TEST_CASE(chains_become_shortest_paths)
{
  Graph g(block_soup());
  const std::int32_t a = 0, b = g.graph.number_of_nodes() - 1;
  for(std::size_t e = 0; e < g.costs.size(); ++e)
    g.costs[e] = 1 + 7 * e % 11;
  g.graph.connect({a, b});
  g.costs = g.flat.lengths;
  const double shortest = g.distances_from(a)[b];
  BOOST_TEST_REQUIRE(g.cost() > 1.05 * shortest);
  g.graph.shorten(20, never);
  BOOST_TEST(g.cost() == shortest, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(handles_are_opened)
{
  for(const int genus : {1, 3}) {
    Graph g(plate_soup(genus));
    g.graph.open_handles(false, never);
    const Count count = g.count();
    BOOST_TEST(count.is_of_disks());
    BOOST_TEST(count.pieces == 1);
    const double cost = g.cost();
    g.graph.shorten(20, never);
    BOOST_TEST(g.count().is_of_disks());
    BOOST_TEST(g.cost() <= cost);
  }
}

// What the collection has, made up: many handles and holes, and nothing that is flat, straight or of one size.
BOOST_AUTO_TEST_CASE(uneven_surfaces)
{
  for(const Soup& even : {plate_soup(12), sheet_soup(16, 12, {{2, 2}, {2, 7}, {6, 4}, {10, 9}, {12, 3}}), block_soup(9, 7, 5)}) {
    Soup soup = even;
    double phase = 0;
    for(Point& p : soup.points) {
      phase += 2.4;
      p = Point(p.x() + 0.3 * std::sin(phase), 1.5 * p.y() + 0.3 * std::cos(1.7 * phase),
                p.z() * (1 + 0.1 * p.x()) + 0.3 * std::sin(2.9 * phase));
    }
    Seamed_surface surface(soup);
    const Count before = surface.count();
    const int genus = (2 - before.euler.front() - before.borders.front()) / 2;
    check_disks(surface, 1, before.borders.front(), genus);
  }
}

BOOST_AUTO_TEST_CASE(scanned_and_modelled_surfaces, *boost::unit_test::label("needs_data"))
{
  const std::filesystem::path folder = FLIP_FREE_MAPS_SHARED_DATA_DIR;
  std::set<std::filesystem::path> files;
  if(!std::filesystem::exists(folder)) {
    skip_case("there is no folder " + folder.string());
    return;
  }
  for(const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if(entry.path().extension() == ".off" && (name.rfind("closed_", 0) == 0 || name.rfind("holes_", 0) == 0))
      files.insert(entry.path());
  }
  if(files.empty())
    skip_case("there are no meshes in " + folder.string());
  for(const auto& file : files)
    BOOST_TEST_CONTEXT(file)
    {
      Mesh mesh;
      BOOST_TEST_REQUIRE(CGAL::IO::read_OFF(file.string(), mesh));
      Seamed_surface surface(mesh);
      const Count before = surface.count();
      const int genus = (2 - before.euler.front() - before.borders.front()) / 2;
      check_disks(surface, 1, before.borders.front(), genus);
    }
}

BOOST_AUTO_TEST_SUITE_END() // test_cut_to_disk
