// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Number types of the mesh' points and of the map: float, and exact numbers.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

BOOST_AUTO_TEST_SUITE(test_surface_mesh_kernels)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// The tolerance is for the rounding of the map to its number type.
template <typename Kernel>
void check_kernel(double tolerance)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  const Soup soup = bumpy_soup();
  const Plain_result plain = plain_result(soup);
  Mesh mesh;
  const auto vertices = add_soup(soup, mesh);
  auto uv = mesh.template add_property_map<typename Mesh::Vertex_index, typename Kernel::Point_2>("v:uv").first;
  const FFM::Summary summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, tight_traits());
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  BOOST_TEST(std::abs(summary.energy - plain.summary.energy) <= 1e-9);
  const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
  BOOST_TEST(std::abs(report.energy - plain.summary.energy) <= tolerance);
  BOOST_TEST(std::abs(report.energy_of_similarity - report.energy) <= tolerance);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    for(int c = 0; c < 2; ++c)
      BOOST_TEST(std::abs(CGAL::to_double(uv[vertices[i]][c]) - plain.uv[i][c]) <= tolerance);
}

} // namespace

BOOST_AUTO_TEST_CASE(float_coordinates) { check_kernel<CGAL::Simple_cartesian<float>>(1e-6); }

BOOST_AUTO_TEST_CASE(inexact_constructions) { check_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(1e-9); }

BOOST_AUTO_TEST_CASE(exact_constructions) { check_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(1e-9); }

BOOST_AUTO_TEST_SUITE_END() // test_surface_mesh_kernels
