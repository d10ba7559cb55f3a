// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The plainest use of CGAL's package Surface_mesh_parameterization, with its parameterizer exchanged.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_parameterizer_3.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <Eigen/SparseLU>

#include <limits>
#include <map>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_drop_in_simple)

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Kernel::Point_3> SurfaceMesh;
typedef boost::graph_traits<SurfaceMesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<SurfaceMesh>::halfedge_descriptor halfedge_descriptor;
typedef SurfaceMesh::Property_map<vertex_descriptor, Point_2> UV_pmap;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace FFM = CGAL::Flip_free_maps;
using test_support::add_soup;
using test_support::bumpy_soup;

typedef FFM::Flip_free_parameterizer_3<SurfaceMesh> Parameterizer;

namespace {

const Point_2 sentinel(12345, -54321);

struct Fixture
{
  SurfaceMesh sm;
  std::vector<vertex_descriptor> vertices;
  UV_pmap uv_map;

  explicit Fixture(const test_support::Soup& soup = bumpy_soup()) : vertices(add_soup(soup, sm))
  {
    uv_map = sm.add_property_map<vertex_descriptor, Point_2>("h:uv", sentinel).first;
  }

  halfedge_descriptor border() const { return CGAL::Polygon_mesh_processing::longest_border(sm).first; }

  bool is_untouched() const
  {
    for(vertex_descriptor v : sm.vertices())
      if(uv_map[v] != sentinel)
        return false;
    return true;
  }
};

} // namespace

static_assert(std::is_same<Parameterizer::TriangleMesh, SurfaceMesh>::value, "");
static_assert(std::is_same<Parameterizer::Triangle_mesh, SurfaceMesh>::value, "");
static_assert(std::is_same<Parameterizer::vertex_descriptor, vertex_descriptor>::value, "");
static_assert(std::is_same<Parameterizer::halfedge_descriptor, halfedge_descriptor>::value, "");
static_assert(std::is_same<Parameterizer::Border_parameterizer, SMP::Circular_border_arc_length_parameterizer_3<SurfaceMesh>>::value, "");
static_assert(std::is_copy_constructible<Parameterizer>::value, "CGAL passes parameterizers by value");

BOOST_FIXTURE_TEST_CASE(parameterizer_by_value, Fixture)
{
  BOOST_TEST(SMP::parameterize(sm, Parameterizer(), border(), uv_map) == SMP::OK);
  BOOST_TEST(FFM::number_of_flipped_elements(sm, uv_map) == 0);
  const double energy = test_support::plain_result(bumpy_soup()).summary.energy;
  BOOST_TEST(std::abs(FFM::measure_distortion(sm, uv_map).energy - energy) <= 1e-6);
}

BOOST_FIXTURE_TEST_CASE(account_of_the_run, Fixture)
{
  FFM::Summary summary;
  BOOST_TEST(SMP::parameterize(sm, Parameterizer(&summary), border(), uv_map) == SMP::OK);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(sm.number_of_faces()));
  // Without a border parameterizer of the caller's the start is the package's own.
  BOOST_TEST(summary.start.find("tutte (circle") != std::string::npos);
  BOOST_TEST(std::abs(FFM::measure_distortion(sm, uv_map).energy - summary.energy) <= 1e-11);

  FFM::Flip_free_map_traits<> traits;
  traits.options.max_iterations = 1;
  BOOST_TEST(SMP::parameterize(sm, Parameterizer(traits, &summary), border(), uv_map) == SMP::OK);
  BOOST_TEST(summary.iterations == 1);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::iteration_limit));
  BOOST_TEST(FFM::number_of_flipped_elements(sm, uv_map) == 0);
}

BOOST_FIXTURE_TEST_CASE(members_like_those_of_the_concept, Fixture)
{
  // What CGAL's function calls, with maps of ours.
  std::map<vertex_descriptor, bool> is_parameterized;
  std::map<vertex_descriptor, int> index;
  int n = 0;
  for(vertex_descriptor v : sm.vertices()) {
    index[v] = n++;
    is_parameterized[v] = false;
  }
  const vertex_descriptor beside = sm.add_vertex(Kernel::Point_3(9, 9, 9));
  is_parameterized[beside] = false;
  uv_map[beside] = sentinel;
  Parameterizer parameterizer;
  BOOST_TEST(parameterizer.parameterize(sm, border(), uv_map, boost::make_assoc_property_map(index),
                                        boost::make_assoc_property_map(is_parameterized)) == SMP::OK);
  for(vertex_descriptor v : vertices)
    BOOST_TEST(is_parameterized[v]);
  BOOST_TEST(!is_parameterized[beside]);
  BOOST_TEST((uv_map[beside] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(one_component_of_several, Fixture)
{
  test_support::Soup other = bumpy_soup(4, 3);
  for(auto& p : other.points)
    p[0] = 0.1 * p[0] + 10;
  const auto others = add_soup(other, sm);
  FFM::Summary summary;
  BOOST_TEST(SMP::parameterize(sm, Parameterizer(&summary), border(), uv_map) == SMP::OK);
  BOOST_TEST(summary.elements == static_cast<std::int64_t>(bumpy_soup().triangles.size()));
  for(vertex_descriptor v : others)
    BOOST_TEST((uv_map[v] == sentinel));
}

BOOST_FIXTURE_TEST_CASE(solver_traits_are_honoured, Fixture)
{
  typedef CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>
    Solver_traits;
  typedef FFM::Flip_free_parameterizer_3<SurfaceMesh, CGAL::Default, Solver_traits> With_solver;
  FFM::Summary summary, plain;
  BOOST_TEST(SMP::parameterize(sm, With_solver(With_solver::Border_parameterizer(), Solver_traits(), With_solver::Map_traits(), &summary),
                               border(), uv_map) == SMP::OK);
  BOOST_TEST(summary.linear_solver == "sparse_linear_algebra_traits");
  BOOST_TEST(FFM::number_of_flipped_elements(sm, uv_map) == 0);
  BOOST_TEST(SMP::parameterize(sm, Parameterizer(&plain), border(), uv_map) == SMP::OK);
  BOOST_TEST(plain.linear_solver != summary.linear_solver);
  BOOST_TEST(std::abs(plain.energy - summary.energy) <= 1e-6);
}

BOOST_AUTO_TEST_CASE(every_status_has_a_code)
{
  using FFM::Status;
  const struct
  {
    Status status;
    SMP::Error_code code;
  } cases[] = {{Status::success, SMP::OK},
               {Status::iteration_limit, SMP::OK},
               {Status::time_limit, SMP::OK},
               {Status::stopped_by_observer, SMP::OK},
               {Status::empty_mesh, SMP::ERROR_EMPTY_MESH},
               {Status::not_triangular, SMP::ERROR_NON_TRIANGULAR_MESH},
               {Status::no_border, SMP::ERROR_NO_TOPOLOGICAL_DISC},
               {Status::several_components, SMP::ERROR_NO_TOPOLOGICAL_DISC},
               {Status::not_a_disk, SMP::ERROR_NO_TOPOLOGICAL_DISC},
               {Status::non_manifold, SMP::ERROR_NO_TOPOLOGICAL_DISC},
               {Status::degenerate_rest_element, SMP::ERROR_WRONG_PARAMETER},
               {Status::non_finite_input, SMP::ERROR_WRONG_PARAMETER},
               {Status::start_not_flip_free, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::unreachable_constraints, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::linear_solver_failed, SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM},
               {Status::line_search_failed, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::result_not_representable, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::invalid_option, SMP::ERROR_WRONG_PARAMETER},
               {Status::file_error, SMP::ERROR_WRONG_PARAMETER},
               {Status::out_of_memory, SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM},
               {Status::not_planar, SMP::ERROR_WRONG_PARAMETER},
               {Status::flips_remain, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::not_bijective, SMP::ERROR_NO_1_TO_1_MAPPING},
               {Status::interrupted, SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM}};
  BOOST_TEST(std::size(cases) == static_cast<std::size_t>(Status::interrupted) + 1);
  for(const auto& c : cases) {
    BOOST_TEST(FFM::to_error_code(c.status) == c.code);
    BOOST_TEST(FFM::is_valid_map(c.status) == (c.code == SMP::OK));
  }
}

BOOST_AUTO_TEST_CASE(hole)
{
  test_support::Soup soup = bumpy_soup(3, 3);
  soup.triangles.erase(soup.triangles.begin() + 8, soup.triangles.begin() + 10);
  Fixture fixture(soup);
  FFM::Summary summary;
  BOOST_TEST(SMP::parameterize(fixture.sm, Parameterizer(&summary), fixture.border(), fixture.uv_map) == SMP::OK);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::success));
  BOOST_TEST(FFM::number_of_flipped_elements(fixture.sm, fixture.uv_map) == 0);
}

BOOST_AUTO_TEST_CASE(failures)
{
  FFM::Summary summary;
  {
    // Two holes that meet at a vertex.
    test_support::Soup soup = bumpy_soup(4, 4);
    soup.triangles.erase(soup.triangles.begin() + 20, soup.triangles.begin() + 22);
    soup.triangles.erase(soup.triangles.begin() + 10, soup.triangles.begin() + 12);
    Fixture fixture(soup);
    BOOST_TEST(SMP::parameterize(fixture.sm, Parameterizer(&summary), fixture.border(), fixture.uv_map) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
    BOOST_TEST(fixture.is_untouched());
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::non_manifold));
    BOOST_TEST(!summary.message.empty());
  }
  {
    Fixture fixture(bumpy_soup(3, 3));
    fixture.sm.add_face(fixture.vertices[3], fixture.vertices[2], fixture.sm.add_vertex(Kernel::Point_3(0.5, -1, 0)),
                        fixture.sm.add_vertex(Kernel::Point_3(1, -1, 0)));
    for(vertex_descriptor v : fixture.sm.vertices())
      fixture.uv_map[v] = sentinel;
    BOOST_TEST(SMP::parameterize(fixture.sm, Parameterizer(), fixture.border(), fixture.uv_map) == SMP::ERROR_NON_TRIANGULAR_MESH);
    BOOST_TEST(fixture.is_untouched());
  }
  {
    test_support::Soup soup = bumpy_soup(3, 3);
    soup.points[5][2] = std::numeric_limits<double>::quiet_NaN();
    Fixture fixture(soup);
    BOOST_TEST(SMP::parameterize(fixture.sm, Parameterizer(&summary), fixture.border(), fixture.uv_map) == SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST(fixture.is_untouched());
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::non_finite_input));
  }
  {
    Fixture fixture;
    FFM::Flip_free_map_traits<> traits;
    traits.options.armijo = 2;
    BOOST_TEST(SMP::parameterize(fixture.sm, Parameterizer(traits, &summary), fixture.border(), fixture.uv_map) ==
               SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST(fixture.is_untouched());
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_drop_in_simple
