// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps with flips are repaired in the plane, by both methods and through a mesh;
// what cannot be repaired is left alone and said so.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_repair_map)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef FFM::Flip_free_map_traits<> Traits;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

const Surface patch = bumpy_patch(10, 8);

FFM::Positions<2> with_flips(const FFM::Simplicial_domain<2>& domain)
{
  Random random(31);
  FFM::Positions<2> x = tutte_start(domain);
  for(Eigen::Index v = 0; v < x.cols(); v += 4)
    x.col(v) += Eigen::Vector2d(random(-0.5, 0.5), random(-0.5, 0.5));
  return x;
}

} // namespace

BOOST_AUTO_TEST_CASE(flips_are_removed)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  const FFM::Positions<2> start = with_flips(domain);
  BOOST_TEST_REQUIRE(number_of_flips(domain, start) > 10);
  FFM::Repair_options options;
  FFM::Positions<2> polished = start;
  const FFM::Summary best = FFM::repair_map(domain, polished, {}, options, Traits());
  BOOST_TEST(best.converged());
  BOOST_TEST(number_of_flips(domain, polished) == 0);
  BOOST_TEST(best.start.find("splitting") != std::string::npos);

  options.polish = false;
  FFM::Positions<2> x = start;
  const FFM::Summary first = FFM::repair_map(domain, x, {}, options, Traits());
  BOOST_TEST(first.is_valid());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(symmetric_dirichlet<2>(domain, x) > best.energy);

  // A mirrored map is mirrored first.
  FFM::Positions<2> mirrored = polished;
  mirrored.row(1) *= -1;
  const FFM::Summary again = FFM::repair_map(domain, mirrored, {}, options, Traits());
  BOOST_TEST(again.is_valid());
  BOOST_TEST(again.iterations == 0);
  BOOST_TEST(number_of_flips(domain, mirrored) == 0);
}

BOOST_AUTO_TEST_CASE(second_method)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  const FFM::Positions<2> start = with_flips(domain);
  FFM::Repair_options options;
  options.splitting.max_iterations = 0;
  options.polish = false;
  FFM::Positions<2> x = start;
  const FFM::Summary summary = FFM::repair_map(domain, x, {}, options, Traits());
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(summary.start.find("foldover-free") != std::string::npos);
  BOOST_TEST(summary.iterations > 0);
  BOOST_TEST(number_of_flips(domain, x) == 0);

  // With both methods off nothing is claimed and nothing changed.
  options.use_second_method = false;
  x = start;
  const FFM::Summary failed = FFM::repair_map(domain, x, {}, options, Traits());
  BOOST_TEST((failed.status == FFM::Status::flips_remain));
  BOOST_TEST(failed.flips == number_of_flips(domain, start));
  BOOST_TEST((x.array() == start.array()).all());
}

// Whoever stops the first method does not wait for the second one, nor for the polish.
BOOST_AUTO_TEST_CASE(stopped_by_the_observer)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  const FFM::Positions<2> start = with_flips(domain);
  FFM::Repair_options options;
  options.splitting.observer = [](const FFM::Splitting_report& report) { return report.iteration < 1; };
  FFM::Positions<2> x = start;
  const FFM::Summary early = FFM::repair_map(domain, x, {}, options, Traits());
  BOOST_TEST((early.status == FFM::Status::flips_remain));
  BOOST_TEST(early.iterations == 1);
  BOOST_TEST(early.message.find("observer") != std::string::npos);
  BOOST_TEST((x.array() == start.array()).all());

  options.splitting.observer = [](const FFM::Splitting_report& report) { return report.flips > 0; };
  const FFM::Summary late = FFM::repair_map(domain, x, {}, options, Traits());
  BOOST_TEST((late.status == FFM::Status::stopped_by_observer));
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(late.factorizations > 0);
  FFM::Positions<2> polished = x;
  BOOST_TEST(FFM::repair_map(domain, polished, {}, FFM::Repair_options(), Traits()).energy < symmetric_dirichlet<2>(domain, x));
}

BOOST_AUTO_TEST_CASE(fixed_vertices_and_impossible_ones)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  FFM::Positions<2> start = tutte_start(domain);
  // Vertices inside jump, the border stays.
  start.col(37) += Eigen::Vector2d(0.3, 0.1);
  start.col(60) += Eigen::Vector2d(-0.3, 0.2);
  BOOST_TEST_REQUIRE(number_of_flips(domain, start) > 0);
  FFM::Repair_options options;
  options.fix_border = true;
  options.polish = false;
  FFM::Positions<2> x = start;
  BOOST_TEST(FFM::repair_map(domain, x, {}, options, Traits()).is_valid());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  for(std::int32_t v : domain.border)
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());

  // A triangle whose three vertices are fixed the wrong way round.
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices.assign(domain.elements[50].begin(), domain.elements[50].end());
  start = tutte_start(domain);
  const Eigen::Vector2d first = start.col(constraints.fixed_vertices[0]);
  start.col(constraints.fixed_vertices[0]) = start.col(constraints.fixed_vertices[1]);
  start.col(constraints.fixed_vertices[1]) = first;
  options.fix_border = false;
  options.splitting.max_iterations = 50;
  options.foldover_free.max_levels = 10;
  x = start;
  const FFM::Summary impossible = FFM::repair_map(domain, x, constraints, options, Traits());
  BOOST_TEST((impossible.status == FFM::Status::unreachable_constraints));
  BOOST_TEST(impossible.impossible_elements == std::vector<std::int64_t>(1, 50), boost::test_tools::per_element());
  BOOST_TEST(impossible.iterations == 0);
  BOOST_TEST((x.array() == start.array()).all());
}

// Where no method succeeds the flipped elements of the best map are named, and no stage goes on without progress.
BOOST_AUTO_TEST_CASE(flips_that_remain_are_named)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  FFM::Positions<2> start = tutte_start(domain);
  // All neighbours of a vertex inside are held, and one of them is beyond the others: no place is left for the vertex.
  const std::int32_t center = 60;
  FFM::Position_constraints<2> constraints;
  std::vector<std::int64_t> star;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const auto& element = domain.elements[e];
    if(std::find(element.begin(), element.end(), center) == element.end())
      continue;
    star.push_back(e);
    for(std::int32_t v : element)
      if(v != center)
        constraints.fixed_vertices.push_back(v);
  }
  BOOST_TEST_REQUIRE(star.size() > 3);
  const std::int32_t moved = constraints.fixed_vertices.front();
  start.col(moved) = 3 * start.col(center) - 2 * start.col(moved);
  FFM::Repair_options options;
  FFM::Positions<2> x = start;
  const FFM::Summary summary = FFM::repair_map(domain, x, constraints, options, Traits());
  BOOST_TEST((summary.status == FFM::Status::flips_remain));
  BOOST_TEST_REQUIRE(!summary.flipped_elements.empty());
  BOOST_TEST(summary.flips == static_cast<std::int64_t>(summary.flipped_elements.size()));
  BOOST_TEST((x.array() == start.array()).all());
  bool is_star = false;
  for(std::int64_t e : summary.flipped_elements)
    is_star = is_star || std::find(star.begin(), star.end(), e) != star.end();
  BOOST_TEST(is_star);
}

BOOST_AUTO_TEST_CASE(settings_out_of_range)
{
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  const FFM::Positions<2> start = with_flips(domain);
  FFM::Positions<2> x = start;
  const auto status = [&](const FFM::Repair_options& options, const Traits& traits) {
    return FFM::repair_map(domain, x, {}, options, traits).status;
  };
  FFM::Repair_options options;
  options.splitting.penalty_ratio = 0.5;
  BOOST_TEST((status(options, Traits()) == FFM::Status::invalid_option));
  options = FFM::Repair_options();
  options.foldover_free.measure_weight = -1;
  BOOST_TEST((status(options, Traits()) == FFM::Status::invalid_option));
  // Those of the polish are checked before anything is done.
  options = FFM::Repair_options();
  Traits traits;
  traits.options.armijo = 2;
  BOOST_TEST((status(options, traits) == FFM::Status::invalid_option));
  BOOST_TEST((x.array() == start.array()).all());
}

BOOST_AUTO_TEST_CASE(uv_map_of_a_mesh)
{
  Mesh mesh;
  for(const auto& p : patch.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& t : patch.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  Mesh::Halfedge_index border;
  for(Mesh::Halfedge_index h : halfedges(mesh))
    if(is_border(h, mesh))
      border = h;
  const FFM::Simplicial_domain<2> domain = make_domain(patch);
  const FFM::Positions<2> start = with_flips(domain);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  for(Mesh::Vertex_index v : vertices(mesh))
    uv[v] = Kernel::Point_2(domain.scale * start(0, v.idx()), domain.scale * start(1, v.idx()));
  FFM::Repair_options options;
  const FFM::Summary summary = FFM::repair_map(mesh, border, uv, options, Traits());
  BOOST_TEST(summary.converged());
  FFM::Positions<2> x(2, start.cols());
  for(Mesh::Vertex_index v : vertices(mesh))
    x.col(v.idx()) << uv[v].x() / domain.scale, uv[v].y() / domain.scale;
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(symmetric_dirichlet<2>(domain, x) == summary.energy, boost::test_tools::tolerance(1e-8));
}

// Of a long tube a conformal map leaves next to nothing, and rounding flips most of that.
BOOST_AUTO_TEST_CASE(tube_that_collapsed)
{
  const int around = 12, rings = 18;
  const FFM::Simplicial_domain<2> domain = make_domain(closed_tube(around, rings));
  FFM::Positions<2> start = tutte_start(domain);
  Random random(32);
  for(Eigen::Index v = 0; v < start.cols(); ++v)
    start.col(v) += 2e-3 * Eigen::Vector2d(random(-1, 1), random(-1, 1));
  BOOST_TEST_REQUIRE(number_of_flips(domain, start) > 60);
  FFM::Repair_options options;
  options.use_second_method = false;
  options.polish = false;
  const FFM::Summary summary = FFM::repair_map(domain, start, {}, options, Traits());
  BOOST_TEST(summary.is_valid(), summary.message);
  BOOST_TEST(number_of_flips(domain, start) == 0);
}

BOOST_AUTO_TEST_CASE(conformal_map_that_collapsed, *boost::unit_test::label("needs_data"))
{
  // The antlers of a deer, of which a conformal map leaves next to nothing:
  // the splitting scheme gets by without the second method.
  const std::string folder = std::string(FLIP_FREE_MAPS_SHARED_DATA_DIR) + "/cases/uvrepair/";
  std::ifstream mesh(folder + "deer.obj"), map(folder + "deer_lscm.uv");
  if(!mesh || !map) {
    skip_case("there is no deer in " + folder);
    return;
  }
  Surface deer;
  for(std::string word; mesh >> word;) {
    if(word == "v") {
      Eigen::Vector3d p;
      mesh >> p[0] >> p[1] >> p[2];
      deer.points.push_back(p);
    } else if(word == "f") {
      std::array<std::int32_t, 3> triangle;
      for(std::int32_t& v : triangle) {
        mesh >> word;
        v = std::stoi(word) - 1;
      }
      deer.triangles.push_back(triangle);
    } else
      std::getline(mesh, word);
  }
  const FFM::Simplicial_domain<2> domain = make_domain(deer);
  FFM::Positions<2> start(2, domain.number_of_vertices);
  for(Eigen::Index v = 0; v < start.cols(); ++v)
    map >> start(0, v) >> start(1, v);
  start /= domain.scale;
  BOOST_TEST_REQUIRE(number_of_flips(domain, start) > 600);
  FFM::Repair_options options;
  options.use_second_method = false;
  options.polish = false;
  // Rotations change nothing but rounding, which must not decide.
  for(double angle : {0., 1.}) {
    FFM::Positions<2> x = Eigen::Rotation2Dd(angle).toRotationMatrix() * start;
    const FFM::Summary summary = FFM::repair_map(domain, x, {}, options, Traits());
    BOOST_TEST(summary.is_valid());
    // The authors' program takes 702.
    BOOST_TEST(summary.iterations <= 2 * 702);
    BOOST_TEST(number_of_flips(domain, x) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_repair_map
