// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Atlases of generated surfaces, checked triangle by triangle: orientations, overlaps by exact intersections of all that come
// near each other, seams by comparing corners, distortion from lengths.

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SEAMS_ATLAS_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SEAMS_ATLAS_CHECKS_H

#include "cutting/cut_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
using Halfedge = Mesh::Halfedge_index;
using Corner_map = Mesh::Property_map<Halfedge, Point_2>;

inline const Point_2 sentinel(12345, -54321);

struct Atlas_surface
{
  Mesh mesh;
  Corner_map uv;
  Mesh::Property_map<Mesh::Face_index, int> chart;
  Mesh::Property_map<Mesh::Edge_index, bool> seam, user;

  explicit Atlas_surface(const Soup& soup)
  {
    add_soup(soup, mesh);
    uv = mesh.add_property_map<Halfedge, Point_2>("h:uv", sentinel).first;
    chart = mesh.add_property_map<Mesh::Face_index, int>("f:chart", -1).first;
    seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    user = mesh.add_property_map<Mesh::Edge_index, bool>("e:user", false).first;
  }

  FFM::Unwrap_summary unwrap(const FFM::Unwrap_options& options = FFM::Unwrap_options(),
                             const FFM::Flip_free_map_traits<>& traits = FFM::Flip_free_map_traits<>())
  {
    return FFM::unwrap(
      mesh, uv, options, traits,
      FFM::parameters::face_chart_map(chart, FFM::parameters::edge_is_seam_map(seam, CGAL::parameters::edge_is_constrained_map(user))));
  }

  bool is_untouched() const
  {
    for(const auto h : mesh.halfedges())
      if(uv[h] != sentinel)
        return false;
    for(const auto f : mesh.faces())
      if(chart[f] != -1)
        return false;
    return true;
  }
};

inline Soup ball_soup()
{
  return voxel_soup(5, 5, 5, [](int x, int y, int z) { return (x - 2) * (x - 2) + (y - 2) * (y - 2) + (z - 2) * (z - 2) <= 5; });
}

inline Soup together(const Soup& a, const Soup& b)
{
  Soup soup = a;
  const int n = static_cast<int>(a.points.size());
  for(const auto& p : b.points)
    soup.points.emplace_back(p.x() + 100, p.y(), p.z());
  for(const auto& t : b.triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return soup;
}

// Whether triangles of different charts have a point in common, or two of one chart that are not glued together more than their
// corners do. Pairs with the same corner on the surface and in the plane are those that may touch.
template <typename UV>
bool has_overlap(const Mesh& mesh, UV uv)
{
  struct Corner
  {
    Mesh::Vertex_index v;
    Exact::Point_2 p;
  };
  std::vector<std::array<Corner, 3>> triangles;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  std::vector<Box> boxes;
  for(const auto f : mesh.faces()) {
    std::array<Corner, 3> t;
    int k = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      t[k++] = {mesh.target(h), Exact::Point_2(uv[h].x(), uv[h].y())};
    boxes.emplace_back(t[0].p.bbox() + t[1].p.bbox() + t[2].p.bbox(), triangles.size());
    triangles.push_back(t);
  }
  bool result = false;
  const auto shape = [](const std::array<Corner, 3>& t) { return Exact::Triangle_2(t[0].p, t[1].p, t[2].p); };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto& s = triangles[a.info()];
    const auto& t = triangles[b.info()];
    std::vector<std::pair<int, int>> common;
    for(int k = 0; k < 3; ++k)
      for(int l = 0; l < 3; ++l)
        if(s[k].v == t[l].v && s[k].p == t[l].p)
          common.emplace_back(k, l);
    if(common.empty())
      result = result || CGAL::do_intersect(shape(s), shape(t));
    else if(common.size() == 1) {
      const int k = common[0].first, l = common[0].second;
      result = result || CGAL::do_intersect(Exact::Segment_2(s[(k + 1) % 3].p, s[(k + 2) % 3].p), shape(t)) ||
               CGAL::do_intersect(Exact::Segment_2(t[(l + 1) % 3].p, t[(l + 2) % 3].p), shape(s));
    } else if(common.size() == 3)
      result = true;
  });
  return result;
}

// Everything that an atlas must be.
inline void check_atlas(const Atlas_surface& surface, const FFM::Unwrap_summary& summary)
{
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  const Mesh& mesh = surface.mesh;
  const int charts = static_cast<int>(summary.charts.size());
  double energy = 0, area = 0, covered = 0;
  bool is_inside = true, is_positive = true, are_seams_right = true;
  std::vector<std::int64_t> sizes(charts, 0);
  for(const auto f : mesh.faces()) {
    std::array<Point_2, 3> q;
    std::array<Mesh::Point, 3> p;
    int k = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      q[k] = surface.uv[h];
      p[k++] = mesh.point(mesh.target(h));
      is_inside = is_inside && surface.uv[h].x() >= 0 && surface.uv[h].x() <= 1 && surface.uv[h].y() >= 0 && surface.uv[h].y() <= 1;
    }
    const double image = CGAL::area(q[0], q[1], q[2]);
    is_positive = is_positive && CGAL::orientation(Exact::Point_2(q[0].x(), q[0].y()), Exact::Point_2(q[1].x(), q[1].y()),
                                                   Exact::Point_2(q[2].x(), q[2].y())) == CGAL::LEFT_TURN;
    covered += image;
    // For the map to the plane sum cot / 2 |edge|^2 is twice the Dirichlet energy times the area; for its inverse likewise.
    const double rest = std::sqrt(CGAL::squared_area(p[0], p[1], p[2])), scaled = image / (summary.scale * summary.scale);
    double stretch = 0, shrink = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      const double on_surface = CGAL::squared_distance(p[j], p[l]);
      const double in_plane = CGAL::squared_distance(q[j], q[l]) / (summary.scale * summary.scale);
      stretch += (p[j] - p[i]) * (p[l] - p[i]) / (2 * rest) * in_plane;
      shrink += (q[j] - q[i]) * (q[l] - q[i]) / (2 * image) * on_surface;
    }
    energy += 0.25 * rest * (0.5 * stretch / rest + 0.5 * shrink / scaled);
    area += rest;
    BOOST_TEST_REQUIRE((surface.chart[f] >= 0 && surface.chart[f] < charts));
    ++sizes[surface.chart[f]];
  }
  BOOST_TEST(is_inside);
  BOOST_TEST(is_positive);
  BOOST_TEST(!has_overlap(mesh, surface.uv));
  BOOST_TEST(FFM::is_atlas_bijective(mesh, surface.uv));
  BOOST_TEST(std::abs(summary.energy - energy / area) <= 1e-9 * summary.energy);
  BOOST_TEST(std::abs(summary.occupancy - covered) <= 1e-9);
  BOOST_TEST(summary.flips == 0);
  for(int c = 0; c < charts; ++c)
    BOOST_TEST(summary.charts[c].faces == sizes[c]);
  std::int64_t seams = 0;
  for(const auto e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e, 0), g = mesh.halfedge(e, 1);
    const bool is_inner = !mesh.is_border(h) && !mesh.is_border(g);
    const bool is_seam = is_inner && (surface.uv[h] != surface.uv[mesh.prev(g)] || surface.uv[g] != surface.uv[mesh.prev(h)]);
    seams += is_seam;
    are_seams_right =
      are_seams_right && surface.seam[e] == is_seam && (!is_inner || is_seam || surface.chart[mesh.face(h)] == surface.chart[mesh.face(g)]);
  }
  BOOST_TEST(are_seams_right);
  BOOST_TEST(summary.seam_edges == seams);
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SEAMS_ATLAS_CHECKS_H
