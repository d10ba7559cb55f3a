// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The splitting against the Newton minimizer on the same problem, starts with flips, fixed vertices, and how runs end.

#include "support/unit_test.h"

#include "support/splitting_checks.h"
#include "support/starts.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Flip_free_maps/Flip_free_parameterizer_3.h>
#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_map_traits.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <limits>

BOOST_AUTO_TEST_SUITE(test_splitting_minimizer)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// The symmetric Dirichlet energy; its minimizer is compiled for other tests, too.
typedef FFM::Flip_free_map_traits<> Traits;

// Newton's method, converged far beyond the splitting's tolerances.
double minimum_near(const FFM::Simplicial_domain<2>& domain, FFM::Positions<2> x)
{
  Traits traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
  BOOST_TEST(summary.converged());
  return summary.energy;
}

FFM::Summary check_splitting(const FFM::Simplicial_domain<2>& domain, FFM::Positions<2>& x)
{
  const FFM::Summary summary = FFM::Splitting_minimizer<2, Traits>(domain).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(negative_elements(domain, x) == 0);
  BOOST_TEST(summary.factorizations < summary.iterations);
  BOOST_TEST(summary.min_singular_value > 0);
  return summary;
}

// Traits of a user who adds something to those of the splitting.
struct Derived_traits : FFM::Splitting_map_traits<Traits>
{
  int number = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(same_energy_in_the_plane)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(12, 9));
  const FFM::Positions<2> start = tutte_start(domain), flipped = shaken<2>(start, 0.2, 5), wild = shaken<2>(start, 0.5, 5);
  BOOST_TEST_REQUIRE(negative_elements(domain, flipped) > 10);
  BOOST_TEST_REQUIRE(negative_elements(domain, wild) > 10);
  const double minimum = minimum_near(domain, start);
  for(const FFM::Positions<2>& from : {start, flipped}) {
    FFM::Positions<2> x = from;
    const FFM::Summary splitting = check_splitting(domain, x);
    BOOST_TEST(splitting.energy == minimum, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(splitting.energy >= minimum - 1e-9);
  }

  // From a start that is far off, the map may turn twice around a vertex. It is a local minimum all the same.
  FFM::Positions<2> x = wild;
  const FFM::Summary splitting = check_splitting(domain, x);
  const double nearby = minimum_near(domain, x);
  BOOST_TEST(splitting.energy == nearby, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(splitting.energy >= nearby - 1e-9);
  BOOST_TEST(nearby >= minimum - 1e-9);
}

BOOST_AUTO_TEST_CASE(handles_that_jump_from_a_model)
{
  const Surface flat = grid(12, 6, [](double u, double v) { return Eigen::Vector3d(2 * u, v, 0); });
  const FFM::Simplicial_domain<2> domain = make_domain(flat);
  const FFM::Positions<2> rest = positions_of<2>(flat, domain.scale);
  FFM::Positions<2> start = rest;
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices = {0, 12, 45};
  start.col(45) += Eigen::Vector2d(0.35, 0.4);
  BOOST_TEST_REQUIRE(negative_elements(domain, start) > 0);
  FFM::Splitting_options options;
  options.polish = true;
  FFM::Positions<2> x = start;
  FFM::Summary summary;
  FFM::Splitting_minimizer<2, Traits>(domain, {}, constraints, options).minimize(x, rest, summary);
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(summary.start.find("splitting") != std::string::npos);
  for(std::int32_t v : constraints.fixed_vertices)
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
}

BOOST_AUTO_TEST_CASE(derived_traits_split)
{
  // Descending without flips cannot begin at a start with flips, and is called by the name of its preconditioner.
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(6, 5));
  FFM::Positions<2> x = shaken<2>(tutte_start(domain), 0.2, 5);
  BOOST_TEST_REQUIRE(negative_elements(domain, x) > 0);
  const FFM::Summary summary = Derived_traits::Minimizer<2, Derived_traits>(domain).minimize(x);
  BOOST_TEST(summary.converged(), summary.message);
  BOOST_TEST(summary.preconditioner == "admm_splitting");
  BOOST_TEST(negative_elements(domain, x) == 0);
}

BOOST_AUTO_TEST_CASE(drop_in_class_with_another_solver_splits)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Solver_traits = CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
  using Splitting_traits = FFM::Splitting_map_traits<Traits>;
  using Parameterizer = FFM::Flip_free_parameterizer_3<Mesh, CGAL::Default, Solver_traits, Splitting_traits>;
  const Surface surface = bumpy_patch(6, 5);
  Mesh mesh;
  for(const Eigen::Vector3d& p : surface.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for(const auto& t : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2>("v:uv").first;
  FFM::Summary summary;
  Parameterizer parameterizer(Parameterizer::Border_parameterizer(), Solver_traits(), Splitting_traits(), &summary);
  const auto code = CGAL::Surface_mesh_parameterization::parameterize(mesh, parameterizer, border, uv);
  BOOST_TEST(code == CGAL::Surface_mesh_parameterization::OK);
  BOOST_TEST(summary.converged(), summary.message);
  BOOST_TEST(summary.preconditioner == "admm_splitting");
}

BOOST_AUTO_TEST_CASE(session)
{
  // A handle goes up in small moves and comes back; each move has few iterations and keeps what the last one knew.
  const Surface flat = grid(16, 8, [](double u, double v) { return Eigen::Vector3d(2 * u, v, 0); });
  const FFM::Simplicial_domain<2> domain = make_domain(flat);
  const FFM::Positions<2> rest = domain.scale * positions_of<2>(flat, domain.scale);
  typedef FFM::Splitting_map_traits<Traits> Splitting_traits;
  Splitting_traits traits;
  traits.splitting.max_iterations = 4;
  const std::vector<std::int32_t> handles = {0, 16, 17 * 8, 77};
  FFM::Deformation<2, Splitting_traits> deformation(domain, rest, handles, traits);
  FFM::Positions<2> targets(2, 4);
  for(int i = 0; i < 4; ++i)
    targets.col(i) = rest.col(handles[i]);
  const auto move = [&](double height) {
    targets(1, 3) = rest(1, 77) + height;
    const FFM::Summary summary = deformation.move(targets);
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(number_of_flips(domain, deformation.positions()) == 0);
    for(int i = 0; i < 4; ++i)
      BOOST_TEST((deformation.positions().col(handles[i]).array() == targets.col(i).array()).all());
    return summary;
  };
  const FFM::Summary first = move(0);
  BOOST_TEST(first.seconds.analyze > 0);
  for(int i = 1; i <= 10; ++i) {
    const FFM::Summary summary = move(0.02 * i);
    BOOST_TEST(summary.iterations == 4);
    BOOST_TEST(summary.seconds.analyze == 0);
    // Penalties stay as they are in so short a run.
    BOOST_TEST(summary.factorizations == (i == 1 ? 1 : 0));
    BOOST_TEST(summary.energy > 1);
  }
  // Left alone it finds the minimum that a descent from there finds.
  deformation.options().max_iterations = 5000;
  const FFM::Summary last = move(0.2);
  BOOST_TEST(last.converged());
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices = handles;
  FFM::Positions<2> x = deformation.positions() / domain.scale;
  const FFM::Summary newton = FFM::Map_minimizer<2, Traits>(domain, Traits(), constraints).minimize(x);
  BOOST_TEST(last.energy == newton.energy, boost::test_tools::tolerance(1e-5));

  // What cannot be reached leaves the shape as it is.
  const FFM::Positions<2> before = deformation.positions();
  deformation.options().max_iterations = 3;
  targets.col(3) = rest.col(0) + Eigen::Vector2d(-5, 0.01);
  targets.col(2) = rest.col(0) + Eigen::Vector2d(9, 0.01);
  const FFM::Summary failure = deformation.move(targets);
  BOOST_TEST((failure.status == FFM::Status::flips_remain));
  BOOST_TEST((deformation.positions().array() == before.array()).all());
  deformation.options().max_iterations = 5000;
  targets.col(2) = rest.col(handles[2]);
  targets.col(3) = rest.col(handles[3]);
  BOOST_TEST(move(0.1).converged());
}

BOOST_AUTO_TEST_CASE(ends_of_runs)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  const FFM::Positions<2> start = tutte_start(domain), flipped = shaken<2>(start, 0.5, 4);
  const auto run = [&](const FFM::Splitting_options& options, FFM::Positions<2>& x) {
    return FFM::Splitting_minimizer<2, Traits>(domain, {}, {}, options).minimize(x);
  };
  FFM::Splitting_options options;
  options.max_iterations = 0;
  FFM::Positions<2> x = flipped;
  FFM::Summary summary = run(options, x);
  BOOST_TEST(FFM::status_name(summary.status) == "flips_remain");
  BOOST_TEST(summary.flips == number_of_flips(domain, flipped));
  BOOST_TEST(summary.message.find(std::to_string(summary.flips)) != std::string::npos);
  BOOST_TEST((x.array() == flipped.array()).all());
  x = start;
  BOOST_TEST((run(options, x).status == FFM::Status::iteration_limit));

  // The first iterate without flips is the one that the observer is shown.
  options = FFM::Splitting_options();
  options.stop_when_flip_free = true;
  int seen = -1, calls = 0;
  options.observer = [&](const FFM::Splitting_report& report) {
    BOOST_TEST(report.iteration == calls++);
    if(report.flips == 0 && seen < 0)
      seen = report.iteration;
    return true;
  };
  x = flipped;
  summary = run(options, x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.iterations == seen);
  BOOST_TEST(number_of_flips(domain, x) == 0);

  options = FFM::Splitting_options();
  options.observer = [](const FFM::Splitting_report& report) { return report.iteration < 3; };
  x = start;
  summary = run(options, x);
  BOOST_TEST((summary.status == FFM::Status::stopped_by_observer));
  BOOST_TEST(summary.iterations == 3);

  x(0, 3) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((run({}, x).status == FFM::Status::non_finite_input));
  x.resize(2, 5);
  BOOST_TEST((run({}, x).status == FFM::Status::invalid_option));
  options.penalty_factor = 1;
  x = start;
  BOOST_TEST((run(options, x).status == FFM::Status::invalid_option));

  // The target energy is met by the map itself.
  options = FFM::Splitting_options();
  options.target_energy = 1.05;
  x = start;
  summary = run(options, x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.energy <= 1.05);
}

BOOST_AUTO_TEST_SUITE_END() // test_splitting_minimizer
