// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// TetGen's data structure as a domain, and TetGen as a mesh generator.

#include "support/unit_test.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

#include "support/mesh_checks.h"
#include "support/volume_checks.h"

#include <CGAL/Flip_free_maps/domains/Tetgen_domain.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/tetrahedralize_with_tetgen.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <string>
#include <vector>

#endif

BOOST_AUTO_TEST_SUITE(test_tetgen)

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

void fill(const Volume& volume, int first, int corners, tetgenio& io)
{
  io.firstnumber = first;
  io.numberofpoints = static_cast<int>(volume.points.size());
  io.pointlist = new REAL[3 * volume.points.size()];
  for(std::size_t v = 0; v < volume.points.size(); ++v)
    for(int k = 0; k < 3; ++k)
      io.pointlist[3 * v + k] = volume.points[v][k];
  io.numberoftetrahedra = static_cast<int>(volume.tetrahedra.size());
  io.numberofcorners = corners;
  io.tetrahedronlist = new int[corners * volume.tetrahedra.size()]();
  for(std::size_t e = 0; e < volume.tetrahedra.size(); ++e)
    for(int k = 0; k < 4; ++k)
      io.tetrahedronlist[corners * e + k] = first + volume.tetrahedra[e][k];
}

Mesh surface_of(const Soup& soup)
{
  Mesh mesh;
  for(const auto& p : soup.points)
    mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  for(const auto& t : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

template <std::size_t N>
std::vector<std::array<int, N>> sorted(std::vector<std::array<int, N>> elements)
{
  for(auto& element : elements)
    std::sort(element.begin(), element.end());
  std::sort(elements.begin(), elements.end());
  return elements;
}

double volume_of(const FFM::Tetrahedral_mesh& mesh)
{
  FFM::Tetrahedral_domain domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  return std::pow(domain.domain().scale, 3);
}

// By the divergence theorem.
double enclosed_volume(const Soup& soup)
{
  double sum = 0;
  for(const auto& t : soup.triangles) {
    Eigen::Matrix3d corners;
    for(int k = 0; k < 3; ++k)
      corners.col(k) = Eigen::Map<const Eigen::Vector3d>(soup.points[t[k]].data());
    sum += corners.determinant() / 6;
  }
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(tetgenio_becomes_the_domain)
{
  for(int first : {0, 1})
    for(int corners : {4, 10}) {
      tetgenio io;
      fill(block(), first, corners, io);
      FFM::Tetgen_domain domain;
      std::string message;
      BOOST_TEST_REQUIRE((domain.load(io, message) == Status::success), message);
      BOOST_TEST(Fingerprint::of(domain).distance(fingerprint_of_block()) < 1e-12);
      BOOST_TEST(domain.number(0) >= 0);
      BOOST_TEST(domain.number(io.numberofpoints) == -1);

      io.tetrahedronlist[2] = first - 1;
      BOOST_TEST((domain.load(io, message) == Status::invalid_option));
      io.tetrahedronlist[2] = first + io.numberofpoints;
      BOOST_TEST((domain.load(io, message) == Status::invalid_option));
      BOOST_TEST(contains(message, "tetrahedron number 0"));
    }
  FFM::Tetgen_domain domain;
  std::string message;
  BOOST_TEST((domain.load(tetgenio(), message) == Status::empty_mesh));
}

BOOST_AUTO_TEST_CASE(surface_is_filled_and_kept)
{
  const Soup soup = sphere_soup(12, 9);
  const Mesh surface = surface_of(soup);
  FFM::Tetrahedral_mesh coarse, fine;
  std::string message;
  FFM::Tetgen_options options;
  options.cell_size = 1;
  BOOST_TEST_REQUIRE((FFM::tetrahedralize_with_tetgen(surface, coarse, options, message) == Status::success), message);
  options.cell_size = 0.08;
  BOOST_TEST_REQUIRE((FFM::tetrahedralize_with_tetgen(surface, fine, options, message) == Status::success), message);
  for(const FFM::Tetrahedral_mesh& mesh : {coarse, fine}) {
    BOOST_TEST(std::abs(volume_of(mesh) - enclosed_volume(soup)) < 1e-12);
    BOOST_TEST((sorted(mesh.triangles) == sorted(soup.triangles)));
    BOOST_TEST_REQUIRE(mesh.points.size() >= soup.points.size());
    BOOST_TEST(std::equal(soup.points.begin(), soup.points.end(), mesh.points.begin()));
  }
  BOOST_TEST(fine.tetrahedra.size() > 2 * coarse.tetrahedra.size());
}

BOOST_AUTO_TEST_CASE(surfaces_that_cannot_be_filled)
{
  const Soup soup = sphere_soup(12, 9);
  FFM::Tetrahedral_mesh volume;
  std::string message;
  FFM::Tetgen_options options;
  BOOST_TEST((FFM::tetrahedralize_with_tetgen(surface_of(bumpy_soup()), volume, options, message) == Status::non_manifold));
  BOOST_TEST(contains(message, "not closed"));
  BOOST_TEST((FFM::tetrahedralize_with_tetgen(Mesh(), volume, options, message) == Status::empty_mesh));

  // Two spheres, once apart and once through each other.
  for(double shift : {3., 0.7}) {
    Soup two = soup;
    for(const auto& p : soup.points)
      two.points.push_back({{p[0] + shift, p[1], p[2]}});
    for(const auto& t : soup.triangles)
      two.triangles.push_back({{t[0] + static_cast<int>(soup.points.size()), t[1] + static_cast<int>(soup.points.size()),
                                t[2] + static_cast<int>(soup.points.size())}});
    const Status expected = shift > 2 ? Status::several_components : Status::non_manifold;
    BOOST_TEST((FFM::tetrahedralize_with_tetgen(surface_of(two), volume, options, message) == expected));
  }
  options.cell_size = 0;
  BOOST_TEST((FFM::tetrahedralize_with_tetgen(surface_of(soup), volume, options, message) == Status::invalid_option));
  BOOST_TEST(volume.points.empty());
}

// TetGen 1.5 crashes when it fails, which the checks of the surface leave for rare cases.
BOOST_AUTO_TEST_CASE(crashes_do_not_reach_the_caller)
{
  std::string bytes;
  int code = 0;
  const auto crash = [](std::string& text) -> int {
    text = "half of";
    std::raise(SIGSEGV);
    return 0;
  };
  const auto abandon = [](std::string&) -> int { throw 3; };
  BOOST_TEST((FFM::internal::run_in_subprocess(crash, bytes, code) == FFM::internal::Apart_end::crashed));
  BOOST_TEST((FFM::internal::run_in_subprocess(abandon, bytes, code) == FFM::internal::Apart_end::returned));
  BOOST_TEST(code == 255);
  const auto give_up = [](std::string& text) {
    text.assign(1000000, 'x');
    return 5;
  };
  BOOST_TEST((FFM::internal::run_in_subprocess(give_up, bytes, code) == FFM::internal::Apart_end::returned));
  BOOST_TEST(code == 5);
  BOOST_TEST(bytes.size() == 1000000u);
}

#else

BOOST_AUTO_TEST_CASE(needs_tetgen) { test_support::skip_case("built without TetGen"); }

#endif

BOOST_AUTO_TEST_SUITE_END() // test_tetgen
