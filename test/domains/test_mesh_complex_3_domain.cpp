// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Cells of a mesh complex with two parts.

#include "support/unit_test.h"

#include "support/volume_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/IO/Medit.h>
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Mesh_complex_3_domain.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN
#include <CGAL/Flip_free_maps/domains/Tetgen_domain.h>
#endif
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_mesh_complex_3_domain)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Mesh_domain;
typedef CGAL::Mesh_triangulation_3<Mesh_domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> Mesh_complex;

// The tetrahedra of a body-centred cubic lattice within the unit ball, label 2 on the right of a plane and 1 on the left of it. They are
// those of Delaunay, without a choice.
const double spacing = 0.4;

Mesh_complex ball_of_two_parts()
{
  std::vector<Triangulation::Weighted_point> points;
  for(int i = -5; i < 5; ++i)
    for(int j = -5; j < 5; ++j)
      for(int k = -5; k < 5; ++k)
        for(double offset : {0., 0.5})
          points.emplace_back(Kernel::Point_3(spacing * (i + offset), spacing * (j + offset), spacing * (k + offset)));
  Mesh_complex complex;
  Triangulation& triangulation = complex.triangulation();
  triangulation.insert(points.begin(), points.end());
  for(auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
    bool is_inside = true;
    double x = 0;
    for(int k = 0; k < 4; ++k) {
      const Kernel::Point_3 p = c->vertex(k)->point().point();
      is_inside = is_inside && CGAL::squared_distance(p, Kernel::Point_3(CGAL::ORIGIN)) <= 1;
      x += p.x() / 4;
    }
    if(is_inside)
      complex.add_to_complex(c, x > 0.2 ? 2 : 1);
  }
  return complex;
}

// The left of the ball is held, the right is turned by an angle around the x-axis and drawn out.
bool place_of_handle(const Eigen::Vector3d& p, Kernel::Point_3& place)
{
  const double angle = p.x() > 0.7 ? 0.9 : 0, shift = p.x() > 0.7 ? 0.3 : 0;
  place =
    Kernel::Point_3(p.x() + shift, std::cos(angle) * p.y() - std::sin(angle) * p.z(), std::sin(angle) * p.y() + std::cos(angle) * p.z());
  return p.x() > 0.7 || p.x() < -0.7;
}

FFM::Flip_free_map_traits<> tight_traits()
{
  FFM::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  return traits;
}

// The same for vertices that are numbers.
double energy_of(const FFM::Volume_domain<std::size_t>& domain, const FFM::Tetrahedral_mesh& mesh)
{
  std::vector<std::pair<std::size_t, Kernel::Point_3>> handles;
  for(std::size_t v = 0; v < mesh.points.size(); ++v) {
    Kernel::Point_3 place;
    if(place_of_handle(Eigen::Vector3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]), place))
      handles.emplace_back(v, place);
  }
  std::vector<Kernel::Point_3> result(mesh.points.size(), Kernel::Point_3(CGAL::ORIGIN));
  const FFM::Summary summary = FFM::deform_volume(domain, handles, CGAL::make_property_map(result), tight_traits());
  BOOST_TEST(summary.converged(), summary.message);
  BOOST_TEST(summary.flips == 0);
  return summary.energy;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_tetrahedra_have_the_same_energies_from_every_source, *boost::unit_test::label("needs_tetgen"))
{
  const Mesh_complex complex = ball_of_two_parts();
  FFM::Mesh_complex_3_domain<Mesh_complex> domain;
  std::string message;
  BOOST_TEST_REQUIRE((domain.load(complex, message) == Status::success), message);
  std::vector<std::pair<Mesh_complex::Vertex_handle, Kernel::Point_3>> handles;
  FFM::Tetrahedral_mesh mesh;
  std::unordered_map<Mesh_complex::Vertex_handle, int> numbers;
  for(const auto v : domain.vertices()) {
    const Kernel::Point_3 p = v->point().point();
    numbers.emplace(v, static_cast<int>(mesh.points.size()));
    mesh.points.push_back({{p.x(), p.y(), p.z()}});
    Kernel::Point_3 place;
    if(place_of_handle(Eigen::Vector3d(p.x(), p.y(), p.z()), place))
      handles.emplace_back(v, place);
  }
  std::unordered_map<Mesh_complex::Vertex_handle, Kernel::Point_3> result;
  const FFM::Summary summary = FFM::deform_volume(domain, handles, boost::make_assoc_property_map(result), tight_traits());
  BOOST_TEST_REQUIRE(summary.converged(), summary.message);
  BOOST_TEST(summary.energy > 1.01);

  auto contradictory = handles;
  contradictory.emplace_back(handles[0].first, handles[1].second);
  std::unordered_map<Mesh_complex::Vertex_handle, Kernel::Point_3> untouched;
  const FFM::Summary refused = FFM::deform_volume(domain, contradictory, boost::make_assoc_property_map(untouched), tight_traits());
  BOOST_TEST((refused.status == Status::invalid_option));
  BOOST_TEST(refused.message.find("different targets") != std::string::npos);
  BOOST_TEST(untouched.empty());

  // In another order and through a file.
  for(auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c)
    mesh.tetrahedra.push_back({numbers.at(c->vertex(0)), numbers.at(c->vertex(1)), numbers.at(c->vertex(2)), numbers.at(c->vertex(3))});
  std::reverse(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  FFM::Tetrahedral_mesh copy;
  BOOST_TEST_REQUIRE(FFM::write_Medit("same_energies.mesh", mesh, &message), message);
  BOOST_TEST_REQUIRE(FFM::read_Medit("same_energies.mesh", copy, &message), message);
  FFM::Tetrahedral_domain arrays;
  BOOST_TEST_REQUIRE((arrays.load(copy.points, copy.tetrahedra, message) == Status::success), message);
  BOOST_TEST(energy_of(arrays, copy) == summary.energy, boost::test_tools::tolerance(1e-11));

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN
  tetgenio io;
  io.numberofpoints = static_cast<int>(copy.points.size());
  io.pointlist = new double[3 * copy.points.size()];
  for(std::size_t v = 0; v < copy.points.size(); ++v)
    std::copy(copy.points[v].begin(), copy.points[v].end(), io.pointlist + 3 * v);
  io.numberofcorners = 4;
  io.numberoftetrahedra = static_cast<int>(copy.tetrahedra.size());
  io.tetrahedronlist = new int[4 * copy.tetrahedra.size()];
  for(std::size_t t = 0; t < copy.tetrahedra.size(); ++t)
    std::copy(copy.tetrahedra[t].begin(), copy.tetrahedra[t].end(), io.tetrahedronlist + 4 * t);
  FFM::Tetgen_domain tetgen;
  BOOST_TEST_REQUIRE((tetgen.load(io, message) == Status::success), message);
  BOOST_TEST(energy_of(tetgen, copy) == summary.energy, boost::test_tools::tolerance(1e-11));
#else
  test_support::skip_case("built without TetGen: all sources but that one are compared");
#endif
}

BOOST_AUTO_TEST_CASE(mesh_complex)
{
  const Mesh_complex complex = ball_of_two_parts();
  BOOST_TEST_REQUIRE(complex.number_of_cells_in_complex() > 100);
  std::map<Mesh_complex::Vertex_handle, int> numbers;
  FFM::Tetrahedral_mesh mesh, right;
  double volume = 0;
  for(auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
    std::array<int, 4> t;
    for(int k = 0; k < 4; ++k) {
      const auto entry = numbers.emplace(c->vertex(k), static_cast<int>(mesh.points.size()));
      if(entry.second) {
        const Kernel::Point_3 p = c->vertex(k)->point().point();
        mesh.points.push_back({{p.x(), p.y(), p.z()}});
      }
      t[k] = entry.first->second;
    }
    mesh.tetrahedra.push_back(t);
    if(complex.subdomain_index(c) == 2)
      right.tetrahedra.push_back(t);
    volume += CGAL::abs(CGAL::volume(c->vertex(0)->point().point(), c->vertex(1)->point().point(), c->vertex(2)->point().point(),
                                     c->vertex(3)->point().point()));
  }
  right.points = mesh.points;

  FFM::Tetrahedral_domain expected;
  FFM::Mesh_complex_3_domain<Mesh_complex> domain;
  std::string message;
  BOOST_TEST_REQUIRE((expected.load(mesh.points, mesh.tetrahedra, message) == Status::success), message);
  BOOST_TEST_REQUIRE((domain.load(complex, message) == Status::success), message);
  BOOST_TEST(Fingerprint::of(domain).distance(Fingerprint::of(expected)) < 1e-11);
  BOOST_TEST(std::abs(domain.domain().scale / std::cbrt(volume) - 1) < 1e-12);
  BOOST_TEST(volume == complex.number_of_cells_in_complex() * std::pow(spacing, 3) / 12, boost::test_tools::tolerance(1e-12));

  // The right part alone has fewer vertices.
  BOOST_TEST_REQUIRE((expected.load(right.points, right.tetrahedra, message) == Status::success), message);
  FFM::Mesh_complex_3_domain<Mesh_complex> part;
  BOOST_TEST_REQUIRE((part.load(complex, 2, message) == Status::success), message);
  BOOST_TEST(Fingerprint::of(part).distance(Fingerprint::of(expected)) < 1e-11);
  BOOST_TEST(part.vertices().size() < domain.vertices().size());
  BOOST_TEST((part.load(complex, 3, message) == Status::empty_mesh));

  std::unordered_map<Mesh_complex::Vertex_handle, Kernel::Point_3> result;
  BOOST_TEST((domain.write_back(domain.domain().rest_points, boost::make_assoc_property_map(result), message) == Status::success));
  BOOST_TEST(result.size() == mesh.points.size());
  for(const auto& entry : result)
    BOOST_TEST(CGAL::squared_distance(entry.second, entry.first->point().point()) < 1e-28);
}

BOOST_AUTO_TEST_SUITE_END() // test_mesh_complex_3_domain
