// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Volume correspondence: the boundary of a bar is mapped, the inside follows without flips.

#define BOOST_TEST_MODULE map_volume
#include "support/unit_test.h"

#include "support/splitting_checks.h"

#include <CGAL/Flip_free_maps/map_volume.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

const int n = 4;

std::vector<std::int32_t> boundary_vertices()
{
  std::vector<std::int32_t> result;
  for(int k = 0; k <= n; ++k)
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i)
        if(i % n == 0 || j % n == 0 || k % n == 0)
          result.push_back((k * (n + 1) + j) * (n + 1) + i);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(inside_follows_the_boundary)
{
  const Volume cube = bar(n, n, n, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(cube);
  const std::vector<std::int32_t> boundary = boundary_vertices();
  // Bent and twisted on the boundary, anything inside.
  FFM::Positions<3> target = positions_of<3>(cube, domain.scale);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const Eigen::Vector3d p = target.col(v);
    const double angle = 0.7 * p[2];
    target.col(v) << std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1],
      p[2] + 0.3 * p[0] * p[0];
  }
  FFM::Positions<3> start = target;
  Random random(41);
  std::vector<char> is_boundary(domain.number_of_vertices, 0);
  for(std::int32_t v : boundary)
    is_boundary[v] = 1;
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
    if(!is_boundary[v])
      start.col(v) += 0.4 * Eigen::Vector3d(random(-1, 1), random(-1, 1), random(-1, 1));
  BOOST_TEST_REQUIRE(negative_elements(domain, target) == 0);
  BOOST_TEST_REQUIRE(negative_elements(domain, start) > 10);

  const FFM::Volume_start starts[] = {FFM::Volume_start::extension, FFM::Volume_start::given};
  for(int i = 0; i < 2; ++i) {
    FFM::Positions<3> x = start;
    const FFM::Summary summary = FFM::map_volume(domain, boundary, x, starts[i]);
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(negative_elements(domain, x) == 0);
    BOOST_TEST(summary.start.find(i == 0 ? "uniform extension" : "given") == 0);
    for(std::int32_t v : boundary)
      BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
  }
}

BOOST_AUTO_TEST_CASE(extension_is_the_mean_of_the_neighbours)
{
  const Volume cube = bar(n, n, n, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(cube);
  const std::vector<std::int32_t> boundary = boundary_vertices();
  FFM::Positions<3> x = positions_of<3>(cube, domain.scale);
  BOOST_TEST_REQUIRE(FFM::internal::uniform_extension(domain, boundary, FFM::Eigen_simplicial_solver(), x));
  std::vector<std::vector<std::int32_t>> neighbors(domain.number_of_vertices);
  for(const auto& element : domain.elements)
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        if(i != j)
          neighbors[element[i]].push_back(element[j]);
  std::vector<char> is_boundary(domain.number_of_vertices, 0);
  for(std::int32_t v : boundary)
    is_boundary[v] = 1;
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    if(is_boundary[v])
      continue;
    std::sort(neighbors[v].begin(), neighbors[v].end());
    neighbors[v].erase(std::unique(neighbors[v].begin(), neighbors[v].end()), neighbors[v].end());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for(std::int32_t w : neighbors[v])
      mean += x.col(w) / static_cast<double>(neighbors[v].size());
    BOOST_TEST((mean - x.col(v)).norm() < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(mirrored_boundary)
{
  // The image of the boundary has the wrong orientation: no map is without flips, wherever the vertex inside goes.
  const Volume cube = bar(2, 2, 2, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(cube);
  FFM::Positions<3> start = positions_of<3>(cube, domain.scale);
  start.row(0) *= -1;
  std::vector<std::int32_t> boundary;
  for(std::int32_t v = 0; v < 27; ++v)
    if(v != 13)
      boundary.push_back(v);
  FFM::Repair_options options;
  options.splitting.max_iterations = 20;
  options.foldover_free.max_levels = 3;
  FFM::Positions<3> x = start;
  const FFM::Summary summary = FFM::map_volume(domain, boundary, x, FFM::Volume_start::extension, options);
  BOOST_TEST((summary.status == FFM::Status::flips_remain));
  BOOST_TEST(summary.flips > 0);
  BOOST_TEST(summary.start.find("foldover-free") != std::string::npos);
  BOOST_TEST((x.array() == start.array()).all());

  // With no vertex left to move it is known at once.
  boundary.push_back(13);
  BOOST_TEST((FFM::map_volume(domain, boundary, x).status == FFM::Status::unreachable_constraints));
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  const FFM::Simplicial_domain<3> domain = make_domain(bar(2, 1, 1, [](const Eigen::Vector3d& p) { return p; }));
  FFM::Positions<3> x(3, 2);
  BOOST_TEST((FFM::map_volume(domain, {0}, x).status == FFM::Status::invalid_option));
  x.setZero(3, domain.number_of_vertices);
  BOOST_TEST((FFM::map_volume(domain, {99}, x).status == FFM::Status::invalid_option));
  BOOST_TEST((FFM::map_volume(domain, {}, x).status == FFM::Status::linear_solver_failed));
}
