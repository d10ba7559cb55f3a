// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces with holes: flat ones keep all distances, tubes become the rings that a computation with one unknown per circle finds,
// and the start does not matter.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/initializers/internal/fill_holes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_holes)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

namespace {

// A sheet without the triangles that `is_removed(i, j, k)` says, k = 0 or 1 in cell (i, j); with heights or flat.
Soup sheet(int columns, int rows, bool is_flat, const std::function<bool(int, int, int)>& is_removed)
{
  Soup soup = bumpy_soup(columns, rows);
  std::vector<std::array<int, 3>> kept;
  for(int t = 0; t < int(soup.triangles.size()); ++t)
    if(!is_removed(t / 2 % columns, t / 2 / columns, t % 2))
      kept.push_back(soup.triangles[t]);
  soup.triangles = kept;
  if(is_flat)
    for(auto& p : soup.points)
      p = {0.8 * p[0] + 0.6 * p[1], 0.6 * p[0] - 0.8 * p[1], 0.5 * p[0]};
  return soup;
}

// Circles of triangles, every other one turned by half a step; `radius(j)` and `height(j)` for the circle j.
template <typename Radius, typename Height>
Soup tube(int around, int circles, Radius radius, Height height)
{
  Soup soup;
  for(int j = 0; j < circles; ++j)
    for(int i = 0; i < around; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.5 * (j % 2)) / around;
      soup.points.push_back({radius(j) * std::cos(angle), radius(j) * std::sin(angle), height(j)});
    }
  for(int j = 0; j + 1 < circles; ++j)
    for(int i = 0; i < around; ++i) {
      const int a = around * j + i, b = around * j + (i + 1) % around, c = a + around, d = b + around;
      if(j % 2 == 0) {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({b, d, c});
      } else {
        soup.triangles.push_back({a, b, d});
        soup.triangles.push_back({a, d, c});
      }
    }
  return soup;
}

struct Example
{
  explicit Example(const Soup& soup)
  {
    for(const Vertex v : add_soup(soup, mesh))
      if(mesh.is_isolated(v))
        mesh.remove_vertex(v);
    uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
  }

  // The longest border, or the shortest one.
  Halfedge border(bool longest = true) const
  {
    std::pair<double, Halfedge> best(longest ? -1 : 1e9, Halfedge());
    for(const Halfedge h : mesh.halfedges()) {
      if(!mesh.is_border(h))
        continue;
      double length = 0;
      for(const Halfedge g : CGAL::halfedges_around_face(h, mesh))
        length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(g)), mesh.point(mesh.target(g))));
      if(longest ? length > 1.0001 * best.first : length < 0.9999 * best.first)
        best = {length, h};
    }
    return best.second;
  }

  FFM::Summary map(long multilevel_size = FFM::Start_options().multilevel_size)
  {
    auto traits = tight_traits();
    traits.start.multilevel_size = multilevel_size;
    const FFM::Summary summary = FFM::parameterize(mesh, border(), uv, traits);
    check_map(mesh, uv, summary, summary.energy);
    return summary;
  }

  // The largest change of a distance between vertices, over the largest distance.
  double largest_change() const
  {
    double change = 0, length = 0;
    for(const Vertex v : mesh.vertices())
      for(const Vertex w : mesh.vertices()) {
        const double before = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
        change = (std::max)(change, std::abs(std::sqrt(CGAL::squared_distance(uv[v], uv[w])) - before));
        length = (std::max)(length, before);
      }
    return change / length;
  }

  FFM::Simplicial_domain<2> domain() const
  {
    FFM::Face_graph_domain<Mesh> graph;
    std::string message;
    BOOST_TEST_REQUIRE(FFM::status_name(graph.load(mesh, border(), get(CGAL::vertex_point, mesh), message)) == std::string("success"));
    return graph.domain();
  }

  Mesh mesh;
  Mesh::Property_map<Vertex, Plain_point_2> uv;
};

// Six holes of three, four and more edges.
bool has_many_holes(int i, int j, int k)
{
  return (i == 1 && j == 1 && k == 0) || (i == 4 && j == 2 && k == 1) || (i == 1 && j == 4) || (i == 2 && j == 6) ||
         (j == 8 && i > 1 && i < 8) || (i > 4 && i < 10 && j > 3 && j < 7);
}

bool has_one_hole(int i, int j, int) { return i > 2 && i < 6 && j > 2 && j < 5; }

// Mean symmetric Dirichlet energy of a tube whose circles become circles of the given radii, one cell of each.
double ring_energy(const Soup& soup, int around, const std::vector<double>& radii)
{
  double energy = 0, area = 0;
  for(std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if(t / 2 % around != 0)
      continue;
    Eigen::Vector3d p[3];
    Eigen::Vector2d q[3];
    for(int k = 0; k < 3; ++k) {
      const int v = soup.triangles[t][k];
      p[k] << soup.points[v][0], soup.points[v][1], soup.points[v][2];
      q[k] = radii[v / around] * p[k].head<2>().normalized();
    }
    const Eigen::Vector3d a = p[1] - p[0], b = p[2] - p[0];
    Eigen::Matrix2d rest, image;
    rest << a.norm(), a.dot(b) / a.norm(), 0, a.cross(b).norm() / a.norm();
    image << q[1] - q[0], q[2] - q[0];
    const Eigen::Matrix2d jacobian = image * rest.inverse();
    const double square = jacobian.squaredNorm(), determinant = std::abs(jacobian.determinant());
    energy += rest.determinant() * 0.25 * (square + square / (determinant * determinant));
    area += rest.determinant();
  }
  return energy / area;
}

// The least such energy: Newton's method in finite differences, one radius after the other.
double least_ring_energy(const Soup& soup, int around, std::vector<double> radii)
{
  double energy = ring_energy(soup, around, radii);
  for(int sweep = 0; sweep < 4000; ++sweep) {
    const double before = energy;
    for(double& r : radii) {
      const double middle = r, step = 1e-5 * middle;
      r = middle + step;
      const double above = ring_energy(soup, around, radii);
      r = middle - step;
      const double below = ring_energy(soup, around, radii);
      r = middle - 0.5 * step * (above - below) / (above - 2 * energy + below);
      const double found = ring_energy(soup, around, radii);
      if(found < energy)
        energy = found;
      else
        r = middle;
    }
    if(before - energy < 1e-15)
      break;
  }
  return energy;
}

} // namespace

BOOST_AUTO_TEST_CASE(flat_sheets_keep_all_distances)
{
  for(const long multilevel_size : {-1l, 0l}) {
    Example example(sheet(12, 10, true, has_many_holes));
    BOOST_TEST(example.domain().holes.size() == 6u);
    const FFM::Summary summary = example.map(multilevel_size);
    BOOST_TEST(std::abs(summary.energy - 1) <= 1e-12);
    BOOST_TEST(example.largest_change() <= 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(hole_with_thousands_of_edges)
{
  // A narrow flat ring; the hole is nearly all of it.
  Example example(tube(
    2500, 3, [](int j) { return 1 - 0.002 * j; }, [](int) { return 0.25; }));
  auto traits = tight_traits();
  traits.start.multilevel_size = -1;
  const FFM::Summary summary = FFM::parameterize(example.mesh, example.border(), example.uv, traits);
  BOOST_TEST(FFM::status_name(summary.status) == std::string("success"));
  BOOST_TEST(summary.start.find("tutte") == 0u);
  BOOST_TEST(FFM::number_of_flipped_elements(example.mesh, example.uv) == 0);
  // Long waves of a thread cost nearly nothing.
  BOOST_TEST(std::abs(summary.energy - 1) <= 1e-9);
}

BOOST_AUTO_TEST_CASE(slit)
{
  // The hole has no area: the vertices of a row are doubled.
  Soup soup = sheet(10, 8, true, [](int, int, int) { return false; });
  const auto below = soup.triangles;
  for(int i = 3; i < 8; ++i) {
    const int v = 4 * 11 + i, twin = static_cast<int>(soup.points.size());
    soup.points.push_back(soup.points[v]);
    for(std::size_t t = below.size() / 2; t < below.size(); ++t)
      std::replace(soup.triangles[t].begin(), soup.triangles[t].end(), v, twin);
  }
  for(const long multilevel_size : {-1l, 0l}) {
    Example example(soup);
    BOOST_TEST_REQUIRE(example.domain().holes.size() == 1u);
    BOOST_TEST(example.domain().holes[0].size() == 12u);
    BOOST_TEST(std::abs(example.map(multilevel_size).energy - 1) <= 1e-12);
    BOOST_TEST(example.largest_change() <= 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(start_does_not_matter)
{
  Example example(sheet(30, 24, false, [](int i, int j, int) { return has_many_holes(i / 2, j / 2, 0); }));
  BOOST_TEST_REQUIRE(example.domain().holes.size() == 5u);
  const FFM::Summary tutte = example.map(-1);
  BOOST_TEST(tutte.start.find("tutte") == 0u);
  auto traits = tight_traits();
  traits.start.multilevel_size = 0;
  traits.start.coarsest_size = 150;
  const FFM::Summary multilevel = FFM::parameterize(example.mesh, example.border(), example.uv, traits);
  check_map(example.mesh, example.uv, multilevel, tutte.energy);
  BOOST_TEST(multilevel.start.find("multilevel") == 0u);
  // The holes are no part of what the levels optimise, so the start is near the optimum.
  BOOST_TEST(multilevel.energy_initial - tutte.energy < 0.5 * (tutte.energy_initial - tutte.energy));
}

BOOST_AUTO_TEST_CASE(tubes_become_rings)
{
  const int around = 24, circles = 6;
  const Soup cylinder = tube(
    around, circles, [](int) { return 1.; }, [](int j) { return 0.2 * j; });
  Example example(cylinder);
  const FFM::Summary summary = example.map();
  std::vector<double> radii;
  Plain_point_2 centre(0, 0);
  for(const Vertex v : example.mesh.vertices())
    centre = centre + (example.uv[v] - CGAL::ORIGIN) / (around * circles);
  double spread = 0;
  for(int j = 0; j < circles; ++j) {
    double low = 1e9, high = 0;
    for(int i = 0; i < around; ++i) {
      const double r = std::sqrt(CGAL::squared_distance(centre, example.uv[Vertex(around * j + i)]));
      low = (std::min)(low, r);
      high = (std::max)(high, r);
    }
    spread = (std::max)(spread, high / low - 1);
    radii.push_back(0.5 * (low + high));
  }
  BOOST_TEST(spread <= 1e-5);
  BOOST_TEST(std::abs(ring_energy(cylinder, around, radii) - summary.energy) <= 1e-9);
  // From other radii, which the map did not find.
  for(int j = 0; j < circles; ++j)
    radii[j] = radii[0] < radii[circles - 1] ? 0.8 + 0.15 * j : 0.8 + 0.15 * (circles - 1 - j);
  BOOST_TEST(std::abs(least_ring_energy(cylinder, around, radii) - summary.energy) <= 1e-8);
}

BOOST_AUTO_TEST_CASE(any_border_may_be_the_outer_one)
{
  Example example(sheet(9, 8, false, has_one_hole));
  const double energy = example.map().energy;
  const FFM::Summary turned = FFM::parameterize(example.mesh, example.border(false), example.uv, tight_traits());
  check_map(example.mesh, example.uv, turned, turned.energy);
  // The sheet is inside out, which is no good, but another valid map.
  BOOST_TEST(turned.energy > energy + 0.1);
}

BOOST_AUTO_TEST_CASE(curvature_of_holes)
{
  using FFM::internal::total_curvature;
  BOOST_TEST(total_curvature(Example(sheet(12, 10, true, has_many_holes)).domain()) <= 1e-9);
  const auto one = [](int) { return 1.; };
  BOOST_TEST(std::abs(total_curvature(Example(tube(16, 5, one, [](int j) { return 0.3 * j; })).domain()) - 2 * CGAL_PI) <= 1e-9);
  BOOST_TEST(total_curvature(Example(tube(
                                       16, 5, [](int j) { return 1 + 0.3 * j; }, one))
                               .domain()) <= 1e-9);
  // A cone of slope 45 degrees whose circles lie on planes:
  // the angle at its missing tip is the perimeter over the length of a side.
  const int around = 16;
  const auto linear = [](int j) { return 1 + 0.5 * j; };
  const Soup pyramid = tube(around, 2, linear, linear);
  const double curvature = total_curvature(Example(pyramid).domain());
  BOOST_TEST(std::abs(curvature - 2 * CGAL_PI * (1 - std::sqrt(0.5))) <= 0.03);
}

BOOST_AUTO_TEST_CASE(fixed_borders)
{
  Example example(sheet(9, 8, false, has_one_hole));
  // Sheared, so that the map is not at rest anywhere.
  std::map<Vertex, Plain_point_2> start;
  for(const Vertex v : example.mesh.vertices())
    start[v] = Plain_point_2(1.2 * example.mesh.point(v)[0] + 0.4 * example.mesh.point(v)[1], example.mesh.point(v)[1]);
  const boost::associative_property_map<std::map<Vertex, Plain_point_2>> start_map(start);
  const FFM::Summary summary = FFM::parameterize(example.mesh, example.border(), example.uv,
                                                 FFM::parameters::border_is_fixed(true, FFM::parameters::start_map(start_map)));
  BOOST_TEST(FFM::status_name(summary.status) == std::string("success"));
  BOOST_TEST(summary.energy < summary.energy_initial);
  BOOST_TEST(FFM::number_of_flipped_elements(example.mesh, example.uv) == 0);
  int fixed = 0, moved = 0;
  for(const Vertex v : example.mesh.vertices()) {
    const bool is_same = example.uv[v] == start[v];
    if(example.mesh.is_border(v)) {
      ++fixed;
      BOOST_TEST(is_same);
    } else {
      moved += !is_same;
    }
  }
  BOOST_TEST(fixed == 2 * (9 + 8) + 2 * (3 + 2));
  BOOST_TEST(moved > 0);
}

BOOST_AUTO_TEST_CASE(filled_holes_are_disks)
{
  for(int n = 3; n <= 40; n = n < 20 ? n + 1 : n + 7) {
    const FFM::Simplicial_domain<2> ring = Example(tube(
                                                     n, 2, [](int j) { return 1 + 0.3 * j; }, [](int) { return 0.; }))
                                             .domain();
    const FFM::Simplicial_domain<2> disk = FFM::internal::fill_holes(ring);
    BOOST_TEST(disk.holes.empty());
    std::map<std::pair<int, int>, int> halfedges;
    std::set<int> vertices;
    for(std::int64_t e = 0; e < disk.number_of_elements(); ++e) {
      if(e >= ring.number_of_elements()) {
        // No needles: twice the area over the squared longest edge.
        const Eigen::Matrix2d edges = disk.rest_inverses[e].inverse();
        const double longest = (std::max)({edges.col(0).norm(), edges.col(1).norm(), (edges.col(1) - edges.col(0)).norm()});
        BOOST_TEST(edges.determinant() / (longest * longest) > 0.1);
      }
      for(int k = 0; k < 3; ++k) {
        vertices.insert(disk.elements[e][k]);
        ++halfedges[{disk.elements[e][k], disk.elements[e][(k + 1) % 3]}];
      }
    }
    BOOST_TEST(static_cast<int>(vertices.size()) == disk.number_of_vertices);
    int border = 0;
    for(const auto& h : halfedges) {
      BOOST_TEST(h.second == 1);
      border += halfedges.count({h.first.second, h.first.first}) == 0;
    }
    BOOST_TEST(border == n);
    const int edges = (static_cast<int>(halfedges.size()) + border) / 2;
    BOOST_TEST(disk.number_of_vertices - edges + disk.number_of_elements() == 1);
  }
}

BOOST_AUTO_TEST_CASE(files, *boost::unit_test::label("needs_data"))
{
  const std::string folder = FLIP_FREE_MAPS_SHARED_DATA_DIR;
  for(const char* name : {"holes_cat2", "holes_sheet5", "holes_sheet12", "holes_spot3"}) {
    Example example{Soup()};
    std::ifstream in(folder + "/" + name + ".off");
    if(!in || !CGAL::IO::read_OFF(in, example.mesh)) {
      skip_case("there is no " + std::string(name) + " in " + folder);
      continue;
    }
    const FFM::Summary summary = FFM::parameterize(example.mesh, example.border(), example.uv);
    BOOST_TEST(FFM::status_name(summary.status) == std::string("success"));
    BOOST_TEST(FFM::number_of_flipped_elements(example.mesh, example.uv) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_holes
