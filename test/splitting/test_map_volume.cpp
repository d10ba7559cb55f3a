// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Volume correspondence: the boundary of a bar is mapped, the inside follows without flips.

#include "support/unit_test.h"

#include "support/splitting_checks.h"

#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/domains/refine_obstructions.h>
#include <CGAL/Flip_free_maps/map_volume.h>
#include <CGAL/Flip_free_maps/measure/Element_quality.h>
#include <CGAL/Flip_free_maps/morph_volume.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_map_volume)

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
  std::vector<std::int64_t> held;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    if(std::count(domain.elements[e].begin(), domain.elements[e].end(), 13) == 0)
      held.push_back(e);
  BOOST_TEST((summary.status == FFM::Status::unreachable_constraints));
  BOOST_TEST(summary.impossible_elements == held, boost::test_tools::per_element());
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST((x.array() == start.array()).all());

  // The splitting scheme alone goes on as long as it may, or until flips become no fewer.
  FFM::Position_constraints<3> constraints;
  constraints.fixed_vertices = boundary;
  FFM::Splitting_options splitting;
  splitting.stop_when_flip_free = true;
  splitting.max_iterations = 200;
  for(int stalled : {0, 7}) {
    splitting.max_stalled_iterations = stalled;
    FFM::Splitting_minimizer<3> minimizer(domain, FFM::Flip_free_map_traits<CGAL::Default, FFM::Symmetric_gradient>(), constraints,
                                          splitting);
    FFM::Positions<3> fewest, y = start;
    FFM::Summary account;
    minimizer.split(y, start, account, &fewest);
    BOOST_TEST((account.status == FFM::Status::flips_remain));
    BOOST_TEST((stalled == 0 ? account.iterations == 200 : account.iterations < 100));
    BOOST_TEST_REQUIRE(fewest.cols() == start.cols());
    BOOST_TEST(negative_elements(domain, fewest) <= negative_elements(domain, start));
  }

  // With no vertex left to move it is known at once.
  boundary.push_back(13);
  BOOST_TEST((FFM::map_volume(domain, boundary, x).status == FFM::Status::unreachable_constraints));
}

// Two sides of a cube go to one plane, and the edges inside that join them have no room.
BOOST_AUTO_TEST_CASE(edges_within_a_flat_side)
{
  const Volume cube = bar(n, n, n, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(cube);
  const auto opened = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double less = 0.5 * (std::min)(p[0], n - p[1]);
    return {p[0] - less, p[1] + less, p[2]};
  };
  FFM::Positions<3> x(3, domain.number_of_vertices);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
    x.col(v) = opened(cube.points[v]);
  std::vector<std::array<std::int32_t, 2>> expected;
  for(const auto& element : domain.elements)
    for(std::int32_t v : element)
      for(std::int32_t w : element) {
        const Eigen::Vector3d a = cube.points[v], b = cube.points[w];
        const auto is_on_side = [](const Eigen::Vector3d& p) { return (std::max)(p[0], n - p[1]) == n; };
        const bool share_side = (a[0] == n && b[0] == n) || (a[1] == 0 && b[1] == 0) || (a[2] == b[2] && (a[2] == 0 || a[2] == n));
        if(v < w && is_on_side(a) && is_on_side(b) && !share_side)
          expected.push_back({v, w});
      }
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  BOOST_TEST_REQUIRE(!expected.empty());

  const FFM::Positions<3> start = x;
  const FFM::Summary summary = FFM::map_volume(domain, boundary_vertices(), x);
  BOOST_TEST((summary.status == FFM::Status::unreachable_constraints));
  BOOST_TEST((summary.impossible_edges == expected));
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST((x.array() == start.array()).all());

  // Each gets a vertex in its middle.
  FFM::Tetrahedral_mesh mesh;
  for(const Eigen::Vector3d& p : cube.points)
    mesh.points.push_back({{p[0], p[1], p[2]}});
  for(const auto& t : cube.tetrahedra)
    mesh.tetrahedra.push_back({{t[0], t[1], t[2], t[3]}});
  const FFM::Tetrahedral_mesh coarse = mesh;
  const std::vector<FFM::Edge_split> splits = FFM::refine_obstructions(mesh, summary);
  for(const auto& edge : expected)
    BOOST_TEST(std::count_if(splits.begin(), splits.end(), [&](const FFM::Edge_split& s) { return s.ends == edge; }) == 1);
  BOOST_TEST(mesh.points.size() == coarse.points.size() + splits.size());
  Volume refined;
  for(const auto& p : mesh.points)
    refined.points.emplace_back(p[0], p[1], p[2]);
  for(std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& v = mesh.tetrahedra[t];
    refined.tetrahedra.push_back({{v[0], v[1], v[2], v[3]}});
    if(t < coarse.tetrahedra.size() && (std::max)({v[0], v[1], v[2], v[3]}) < static_cast<int>(coarse.points.size()))
      BOOST_TEST((v == coarse.tetrahedra[t]));
  }
  // No hole and no overlap: the boundary is the same, and so is the volume, of tetrahedra that are all positive.
  auto before = FFM::boundary_triangles(coarse), after = FFM::boundary_triangles(mesh);
  const auto canonical = [](std::vector<std::array<int, 3>>& triangles) {
    for(auto& t : triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
  };
  canonical(before);
  canonical(after);
  BOOST_TEST((before == after));
  double volume = 0;
  for(const auto& v : refined.tetrahedra) {
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.col(k) = refined.points[v[k + 1]] - refined.points[v[0]];
    BOOST_TEST(edges.determinant() > 0);
    volume += edges.determinant() / 6;
  }
  BOOST_TEST(volume == n * n * n, boost::test_tools::tolerance(1e-12));
}

// Four tetrahedra around an edge, one of which is to be flat: all vertices are held, two on either side of it. With a vertex in the
// middle of the edge there is a map.
BOOST_AUTO_TEST_CASE(a_flat_tetrahedron_is_split)
{
  FFM::Tetrahedral_mesh mesh;
  mesh.points = {{{0, -1, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}, {{-1, 0, 0}}, {{0, 0, -1}}};
  mesh.tetrahedra = {{{1, 0, 2, 3}}, {{1, 0, 3, 4}}, {{1, 0, 4, 5}}, {{1, 0, 5, 2}}};
  const std::vector<std::array<double, 3>> target = {{{0, -1, 0}}, {{0, 1, 0}},       {{1, 0, 0}},
                                                     {{-1, 0, 0}}, {{-0.5, 0, -0.9}}, {{0.5, 0, -0.9}}};
  std::vector<std::pair<std::size_t, std::array<double, 3>>> places;
  for(std::size_t v = 0; v < target.size(); ++v)
    places.emplace_back(v, target[v]);
  const auto morphed = [&] {
    FFM::Tetrahedral_domain volume;
    std::string message;
    BOOST_TEST_REQUIRE((volume.load(mesh.points, mesh.tetrahedra, message) == FFM::Status::success));
    std::vector<std::array<double, 3>> result = mesh.points;
    const FFM::Morph_summary summary = FFM::morph_volume(volume, places, result.data());
    if(summary.is_valid())
      for(std::size_t v = 0; v < target.size(); ++v)
        BOOST_TEST((result[v] == target[v]));
    return summary;
  };
  const FFM::Morph_summary blocked = morphed();
  BOOST_TEST((blocked.status == FFM::Status::unreachable_constraints));
  BOOST_TEST(blocked.impossible_elements == std::vector<std::int64_t>(1, 0), boost::test_tools::per_element());
  const std::vector<FFM::Edge_split> splits = FFM::refine_obstructions(mesh, blocked);
  BOOST_TEST_REQUIRE(splits.size() == 1u);
  BOOST_TEST((splits[0].ends == std::array<int, 2>{{0, 1}}));
  BOOST_TEST(splits[0].vertex == 6);
  BOOST_TEST(mesh.tetrahedra.size() == 8u);
  const FFM::Morph_summary found = morphed();
  BOOST_TEST(FFM::status_name(found.status) == "success");
  BOOST_TEST(found.flips == 0);
}

// What is far from the flips stays where it is, and an affine boundary has an affine map.
BOOST_AUTO_TEST_CASE(only_what_is_near_the_flips_moves)
{
  const int m = 7, corner = m + 1;
  const Volume cube = bar(m, m, m, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(cube);
  Eigen::Matrix3d affine;
  affine << 1.2, 0.3, 0, -0.1, 0.9, 0.2, 0.1, 0, 1.1;
  const FFM::Positions<3> image = affine * positions_of<3>(cube, domain.scale);
  const auto number = [=](int i, int j, int k) { return (k * corner + j) * corner + i; };
  const std::int32_t flipped = number(2, 2, 2);
  FFM::Positions<3> start = image;
  start.col(flipped) += affine * Eigen::Vector3d(1.6, 0.1, 0.3) / domain.scale;
  std::vector<std::int32_t> boundary;
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
    for(int c = 0; c < 3; ++c)
      if(cube.points[v][c] == 0 || cube.points[v][c] == m) {
        boundary.push_back(v);
        break;
      }
  FFM::Repair_options options;
  options.polish = false;
  FFM::Positions<3> x = start;
  const FFM::Summary first = FFM::map_volume(domain, boundary, x, FFM::Volume_start::given, options);
  BOOST_TEST(first.is_valid());
  BOOST_TEST(first.start.find("near the flips") != std::string::npos);
  BOOST_TEST(first.start.find("splitting") == std::string::npos);
  BOOST_TEST(negative_elements(domain, x) == 0);
  BOOST_TEST((x.col(number(6, 6, 6)).array() == start.col(number(6, 6, 6)).array()).all());
  BOOST_TEST((x.col(flipped) - start.col(flipped)).norm() > 0);

  options.polish = true;
  x = start;
  const FFM::Summary polished = FFM::map_volume(domain, boundary, x, FFM::Volume_start::given, options);
  BOOST_TEST(polished.converged());
  BOOST_TEST((x - image).norm() < 1e-3 * image.norm());
}

// Morphing: displacements of the boundary, in the user's coordinates.
BOOST_AUTO_TEST_CASE(morphed_solids)
{
  const Volume cube = bar(n, n, n, [](const Eigen::Vector3d& p) { return p; });
  // A second body, which nobody moves.
  std::vector<Eigen::Vector3d> points = cube.points;
  auto tetrahedra = cube.tetrahedra;
  const std::int32_t size = static_cast<std::int32_t>(cube.points.size());
  for(const Eigen::Vector3d& p : cube.points)
    points.push_back(p + Eigen::Vector3d(3 * n, 0, 0));
  for(auto t : cube.tetrahedra) {
    for(std::int32_t& v : t)
      v += size;
    tetrahedra.push_back(t);
  }
  FFM::Tetrahedral_domain volume;
  std::string message;
  BOOST_TEST((volume.load(points, tetrahedra, message) == FFM::Status::several_components));

  Eigen::Matrix3d affine;
  affine << 1.5, 0.4, 0, -0.2, 0.8, 0.3, 0.1, 0, 1.2;
  const auto twisted = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double angle = 1.6 * p[2] / n, x = p[0] - n / 2., y = p[1] - n / 2.;
    return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, p[2]};
  };
  for(bool is_affine : {true, false}) {
    std::vector<std::pair<std::size_t, std::array<double, 3>>> places;
    for(std::int32_t v : boundary_vertices()) {
      const Eigen::Vector3d p = is_affine ? Eigen::Vector3d(affine * points[v]) : twisted(points[v]);
      places.push_back({static_cast<std::size_t>(v), {p[0], p[1], p[2]}});
    }
    std::vector<std::array<double, 3>> result(points.size());
    const FFM::Morph_summary summary = FFM::morph_volume(volume, places, result.data());
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(summary.quality.min_scaled_jacobian > 0);
    // The six tetrahedra of a cube around its diagonal have edges of 1, sqrt(2) and sqrt(3), and the determinant 1.
    BOOST_TEST(summary.quality_before.min_scaled_jacobian == std::sqrt(2.) / std::sqrt(6.), boost::test_tools::tolerance(1e-9));
    for(const auto& [v, place] : places)
      BOOST_TEST((result[v] == place));
    double error = 0, moved = 0;
    for(std::int32_t v = 0; v < size; ++v) {
      if(is_affine)
        error = (std::max)(error, (affine * points[v] - Eigen::Map<const Eigen::Vector3d>(result[v].data())).norm());
      moved = (std::max)(moved, (points[size + v] - Eigen::Map<const Eigen::Vector3d>(result[size + v].data())).norm());
    }
    BOOST_TEST(error < 1e-6);
    BOOST_TEST(moved < 1e-12);
  }

  // One vertex at two places.
  std::vector<std::pair<std::size_t, std::array<double, 3>>> places = {{0, {0, 0, 0}}, {0, {0, 0, 1}}};
  std::vector<std::array<double, 3>> result(points.size(), {7, 7, 7});
  const FFM::Morph_summary refused = FFM::morph_volume(volume, places, result.data());
  BOOST_TEST((refused.status == FFM::Status::invalid_option));
  BOOST_TEST((result[0] == std::array<double, 3>{7, 7, 7}));
}

// A bar whose ends are pulled apart and whose sides keep to their planes: stresses of the affine map are normal to the sides, so that
// it is the optimum. Where one end goes sideways, sides that are free leave their planes.
BOOST_AUTO_TEST_CASE(sides_slide_in_their_planes)
{
  Random random(5);
  const Eigen::Matrix3d turn = random.rotation<3>();
  const int length = 6, width = 3;
  const auto stretched = [&](const Eigen::Vector3d& p, double factor, double aside = 0) -> Eigen::Vector3d {
    return turn * Eigen::Vector3d(factor * p[0], p[1] + (p[0] == length ? aside : 0), p[2]);
  };
  const Volume rest = bar(length, width, width, [](const Eigen::Vector3d& p) { return p; });
  const Volume turned = bar(length, width, width, [&](const Eigen::Vector3d& p) { return stretched(p, 1); });
  FFM::Tetrahedral_domain volume;
  std::string message;
  BOOST_TEST_REQUIRE((volume.load(turned.points, turned.tetrahedra, message) == FFM::Status::success));
  for(const auto& [factor, aside] : {std::make_pair(1.7, 0.), std::make_pair(0.6, 0.), std::make_pair(1.2, 0.7)}) {
    std::vector<std::pair<std::size_t, std::array<double, 3>>> places;
    const auto is_given = [&](std::size_t v) { return rest.points[v][0] == 0 || rest.points[v][0] == length; };
    for(std::size_t v = 0; v < rest.points.size(); ++v)
      if(is_given(v)) {
        const Eigen::Vector3d p = stretched(rest.points[v], factor, aside);
        places.push_back({v, {{p[0], p[1], p[2]}}});
      }
    FFM::Flip_free_map_traits<CGAL::Default, FFM::Symmetric_gradient> traits;
    traits.options.characteristic_gradient_tolerance = 1e-8;
    FFM::Morph_options options;
    for(const bool slides : {true, false}) {
      options.slide_on_boundary = slides;
      std::vector<std::array<double, 3>> result(rest.points.size());
      const FFM::Morph_summary summary = FFM::morph_volume(volume, places, result.data(), traits, options);
      BOOST_TEST(summary.is_valid());
      BOOST_TEST(summary.flips == 0);
      double error = 0, off_planes = 0;
      for(std::size_t v = 0; v < rest.points.size(); ++v) {
        const Eigen::Vector3d p(result[v].data());
        error = (std::max)(error, (p - stretched(rest.points[v], factor)).norm());
        const Eigen::Vector3d back = turn.transpose() * p;
        for(int i = 1; i < 3 && !is_given(v); ++i)
          if(rest.points[v][i] == 0 || rest.points[v][i] == width)
            off_planes = (std::max)(off_planes, std::abs(back[i] - rest.points[v][i]));
      }
      if(slides && aside == 0)
        BOOST_TEST(error < 1e-5);
      if(slides)
        BOOST_TEST(off_planes < 1e-12);
      else if(aside > 0)
        BOOST_TEST(off_planes > 0.05);
    }
  }

  // The methods for flips refuse what they do not know.
  const FFM::Simplicial_domain<3> domain = make_domain(turned);
  FFM::Positions<3> x = positions_of<3>(turned, domain.scale);
  FFM::Position_constraints<3> constraints;
  constraints.sliding_vertices = {FFM::Sliding_vertex<3>::normal_to(0, Eigen::Vector3d(1, 0, 0))};
  BOOST_TEST((FFM::repair_map(domain, x, constraints).status == FFM::Status::invalid_option));
  BOOST_TEST((FFM::Splitting_minimizer<3>(domain, FFM::Flip_free_map_traits<CGAL::Default, FFM::Symmetric_gradient>(), constraints)
                .minimize(x)
                .status == FFM::Status::invalid_option));
}

BOOST_AUTO_TEST_CASE(scaled_jacobian_of_known_shapes)
{
  const Eigen::Vector3d a(1, 1, 1), b(1, -1, -1), c(-1, 1, -1), d(-1, -1, 1);
  BOOST_TEST(FFM::scaled_jacobian(a, b, d, c) == 1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(FFM::scaled_jacobian(a, b, c, d) == -1, boost::test_tools::tolerance(1e-12));
  // The corner of a cube: determinant 1, largest product 2 at the other corners.
  BOOST_TEST(FFM::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == std::sqrt(2.) / 2, boost::test_tools::tolerance(1e-12));
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

BOOST_AUTO_TEST_SUITE_END() // test_map_volume
