// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Starts from coarse to fine: simplification that is undone exactly, valid starts near the optimum, tubes on which Tutte fails.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/initializers/Multilevel_initializer.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_multilevel)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Traits = FFM::Flip_free_map_traits<>;

namespace {

// Every edge has one face on each side or one in all, the border is one loop through them, and the Euler characteristic is 1.
void check_disk(const FFM::Simplicial_domain<2>& domain)
{
  std::map<std::pair<int, int>, int> halfedges;
  std::set<int> vertices;
  for(const auto& t : domain.elements)
    for(int k = 0; k < 3; ++k) {
      ++halfedges[{t[k], t[(k + 1) % 3]}];
      vertices.insert(t[k]);
    }
  std::set<std::pair<int, int>> border;
  std::size_t inner = 0;
  for(const auto& h : halfedges) {
    BOOST_REQUIRE_EQUAL(h.second, 1);
    if(halfedges.count({h.first.second, h.first.first}) == 0)
      border.insert(h.first);
    else
      ++inner;
  }
  BOOST_REQUIRE_EQUAL(border.size(), domain.border.size());
  for(std::size_t i = 0; i < domain.border.size(); ++i)
    BOOST_REQUIRE_EQUAL(border.count({domain.border[i], domain.border[(i + 1) % domain.border.size()]}), 1u);
  BOOST_CHECK_EQUAL(static_cast<long>(vertices.size() + domain.elements.size()) - static_cast<long>(border.size() + inner / 2), 1);
  BOOST_CHECK_EQUAL(static_cast<int>(vertices.size()), domain.number_of_vertices);
}

struct Start
{
  FFM::Status status;
  FFM::Positions<2> x;
  std::string name;
  std::string message;
};

Start multilevel_start(const FFM::Simplicial_domain<2>& domain, const Traits& traits)
{
  Start start;
  start.status = FFM::Multilevel_initializer<Traits>(traits)(domain, start.x, start.name, start.message);
  return start;
}

Traits small_levels()
{
  Traits traits;
  traits.start.coarsest_size = 60;
  return traits;
}

} // namespace

BOOST_AUTO_TEST_CASE(simplification_keeps_a_disk_and_is_undone_exactly)
{
  for(const Surface& surface : {bumpy_patch(30, 20), closed_tube(9, 25), cone_patch(25, 12)}) {
    const auto domain = make_domain(surface);
    FFM::internal::Progressive_disk disk(domain);
    disk.coarsen<CGAL::Parallel_if_available_tag>(40);
    BOOST_TEST(disk.number_of_triangles() <= 60);
    std::vector<std::int32_t> vertices;
    check_disk(disk.domain(vertices));
    while(disk.number_of_passes() > 0) {
      for(std::int32_t v : disk.take_pass()) {
        BOOST_TEST(!disk.is_awake(v));
        disk.restore(v);
      }
      check_disk(disk.domain(vertices));
    }
    BOOST_REQUIRE_EQUAL(disk.number_of_triangles(), domain.number_of_elements());
    for(std::size_t t = 0; t < domain.elements.size(); ++t)
      BOOST_REQUIRE(disk.triangle(static_cast<std::int32_t>(t)) == domain.elements[t]);
  }
}

// Fewer triangles are asked for than a disk can have.
BOOST_AUTO_TEST_CASE(simplification_of_small_disks_ends)
{
  for(int columns = 1; columns <= 6; ++columns) {
    const auto domain = make_domain(bumpy_patch(columns, 1));
    FFM::internal::Progressive_disk disk(domain);
    disk.coarsen<CGAL::Parallel_if_available_tag>(0);
    BOOST_TEST(disk.number_of_triangles() >= 1);
    std::vector<std::int32_t> vertices;
    check_disk(disk.domain(vertices));
  }
}

BOOST_AUTO_TEST_CASE(removing_again_undoes_restoring)
{
  const auto domain = make_domain(bumpy_patch(12, 9));
  FFM::internal::Progressive_disk disk(domain);
  disk.coarsen<CGAL::Parallel_if_available_tag>(30);
  std::vector<std::int32_t> vertices;
  const auto before = disk.domain(vertices);
  for(std::int32_t v : disk.take_pass())
    disk.remove(v, disk.restore(v));
  const auto after = disk.domain(vertices);
  BOOST_REQUIRE_EQUAL(after.number_of_elements(), before.number_of_elements());
  for(std::size_t t = 0; t < before.elements.size(); ++t)
    BOOST_REQUIRE(before.elements[t] == after.elements[t]);
  BOOST_CHECK(before.border == after.border);
}

BOOST_AUTO_TEST_CASE(relaxation_finds_the_local_optimum)
{
  // A hexagon of unit triangles around a vertex that begins off the centre: by symmetry its optimum is the centre.
  const FFM::Symmetric_dirichlet energy;
  FFM::internal::Vertex_relaxation<2, FFM::Symmetric_dirichlet> relaxation(energy);
  const Eigen::Vector2d begin(0.3, -0.45);
  for(int i = 0; i < 6; ++i) {
    const Eigen::Vector2d a(std::cos(i * pi / 3), std::sin(i * pi / 3)), b(std::cos((i + 1) * pi / 3), std::sin((i + 1) * pi / 3));
    Eigen::Matrix2d rest, image;
    rest << a, b;
    image << a - begin, b - begin;
    const Eigen::Matrix2d rest_inverse = rest.inverse();
    relaxation.add(image * rest_inverse, -rest_inverse.colwise().sum().transpose(), 1. / 6);
  }
  Eigen::Vector2d u = Eigen::Vector2d::Zero();
  relaxation.relax(u, 20, [](const Eigen::Vector2d&) { return true; });
  // It stops when the predicted relative decrease is 1e-4, so the distance is about its square root.
  BOOST_TEST((begin + u).norm() < 2e-2);

  Eigen::Vector2d held = Eigen::Vector2d::Zero();
  relaxation.relax(held, 20, [](const Eigen::Vector2d&) { return false; });
  BOOST_TEST(held.norm() == 0);
}

BOOST_AUTO_TEST_CASE(start_is_valid_and_near_the_optimum)
{
  const auto domain = make_domain(bumpy_patch(45, 30, 0.35));
  const Start start = multilevel_start(domain, small_levels());
  BOOST_REQUIRE(start.status == FFM::Status::success);
  BOOST_TEST(number_of_flips(domain, start.x) == 0);
  BOOST_TEST(start.name.find("multilevel") != std::string::npos);

  FFM::Positions<2> from_coarse = start.x, from_tutte = tutte_start(domain);
  const double tutte_energy = symmetric_dirichlet(domain, from_tutte), start_energy = symmetric_dirichlet(domain, from_coarse);
  FFM::Map_minimizer<2> minimizer(domain);
  BOOST_REQUIRE(minimizer.minimize(from_coarse).converged());
  BOOST_REQUIRE(minimizer.minimize(from_tutte).converged());
  const double optimum = symmetric_dirichlet(domain, from_tutte);
  BOOST_TEST(symmetric_dirichlet(domain, from_coarse) == optimum, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(start_energy - optimum < 0.1 * (tutte_energy - optimum));
}

BOOST_AUTO_TEST_CASE(start_does_not_depend_on_threads)
{
  const auto domain = make_domain(bumpy_patch(30, 20));
  const Start first = multilevel_start(domain, small_levels());
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
#endif
  const Start second = multilevel_start(domain, small_levels());
  BOOST_REQUIRE(first.status == FFM::Status::success);
  BOOST_CHECK(first.x == second.x);
}

BOOST_AUTO_TEST_CASE(long_tube_on_which_tutte_fails)
{
  // Each ring is drawn e times smaller than the one before it, the last one far below the rounding of any solver.
  const auto domain = make_domain(closed_tube(6, 120));
  BOOST_REQUIRE(tutte_start(domain).cols() == 0);
  const Start start = multilevel_start(domain, small_levels());
  BOOST_TEST_MESSAGE(start.name + start.message);
  BOOST_REQUIRE(start.status == FFM::Status::success);
  BOOST_TEST(number_of_flips(domain, start.x) == 0);
}

BOOST_AUTO_TEST_CASE(invalid_polygon_is_an_invalid_option)
{
  Traits traits = small_levels();
  traits.start.border = FFM::Border_shape::polygon;
  BOOST_CHECK(multilevel_start(make_domain(bumpy_patch(12, 9)), traits).status == FFM::Status::invalid_option);
}

BOOST_AUTO_TEST_SUITE_END() // test_multilevel
