// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The multigrid of PETSc as a preconditioner, MUMPS as a direct solver, and maps that are found with them.

#include "support/unit_test.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/linear_solvers/Automatic_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_direct_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
#include <CGAL/Flip_free_maps/linear_solvers/Cholmod_solver.h>
#endif
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#endif

BOOST_AUTO_TEST_SUITE(test_petsc_solvers)

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef FFM::Conjugate_gradient_solver<FFM::Petsc_multigrid> Multigrid_solver;

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
typedef FFM::Cholmod_solver Direct_solver;
#else
typedef FFM::Eigen_simplicial_solver Direct_solver;
#endif

// The stiffness of an elastic strip of unit width in the plane, of which one end is held.
struct Planar_system
{
  FFM::Block_sparse_matrix matrix;
  Eigen::VectorXd positions, right;

  Planar_system(int rows, int length)
  {
    const Surface surface = grid(rows * length, rows, [length](double u, double v) { return Eigen::Vector3d(length * u, v, 0); });
    std::vector<std::int32_t> number(surface.points.size(), -1);
    std::int32_t unknowns = 0;
    std::vector<double> coordinates;
    for(std::size_t v = 0; v < surface.points.size(); ++v)
      if(surface.points[v][0] > 0) {
        number[v] = unknowns++;
        coordinates.insert(coordinates.end(), {surface.points[v][0], surface.points[v][1]});
      }
    positions = Eigen::Map<Eigen::VectorXd>(coordinates.data(), coordinates.size());
    std::vector<std::array<std::int32_t, 3>> stencils;
    for(const auto& t : surface.triangles)
      stencils.push_back({number[t[0]], number[t[1]], number[t[2]]});
    matrix.build_pattern(unknowns, 2, stencils);
    for(std::size_t e = 0; e < stencils.size(); ++e) {
      const auto& t = surface.triangles[e];
      Eigen::Matrix2d edges;
      for(int k = 0; k < 2; ++k)
        edges.col(k) = (surface.points[t[k + 1]] - surface.points[t[0]]).head<2>();
      Eigen::Matrix<double, 2, 3> gradients;
      gradients.rightCols<2>() = edges.inverse().transpose();
      gradients.col(0) = -gradients.rightCols<2>().rowwise().sum();
      const auto& v = stencils[e];
      for(int k = 0; k < 3; ++k)
        for(int l = k; l < 3; ++l) {
          if(v[k] < 0 || v[l] < 0)
            continue;
          const Eigen::Vector2d g = gradients.col(k), h = gradients.col(l);
          const Eigen::Matrix2d block = g.dot(h) * Eigen::Matrix2d::Identity() + 4 * g * h.transpose() + h * g.transpose();
          matrix.add_block(v[k], v[l], matrix.slot(v[k], v[l]), Eigen::Matrix2d(0.5 * edges.determinant() * block));
        }
    }
    right = Random(83).vector(static_cast<int>(matrix.rows()));
  }
};

// The stiffness of an elastic bar of which one end is held, or, with one row per vertex, its Laplacian.
struct System
{
  FFM::Block_sparse_matrix matrix;
  Eigen::VectorXd positions, right;

  explicit System(int width, int length, int block_size = 3)
  {
    const Volume volume = bar(length, width, width, [](const Eigen::Vector3d& p) { return p; });
    // The vertices of the held end are no unknowns.
    std::vector<std::int32_t> number(volume.points.size(), -1);
    std::int32_t unknowns = 0;
    std::vector<double> coordinates;
    for(std::size_t v = 0; v < volume.points.size(); ++v)
      if(volume.points[v][0] > 0) {
        number[v] = unknowns++;
        for(int i = 0; i < block_size; ++i)
          coordinates.push_back(volume.points[v][i]);
      }
    positions = Eigen::Map<Eigen::VectorXd>(coordinates.data(), coordinates.size());
    std::vector<std::array<std::int32_t, 4>> stencils;
    for(const auto& t : volume.tetrahedra)
      stencils.push_back({number[t[0]], number[t[1]], number[t[2]], number[t[3]]});
    matrix.build_pattern(unknowns, block_size, stencils);
    for(std::size_t e = 0; e < stencils.size(); ++e)
      add_element(volume, volume.tetrahedra[e], stencils[e]);
    right = Random(81).vector(static_cast<int>(matrix.rows()));
  }

  void add_element(const Volume& volume, const std::array<std::int32_t, 4>& t, const std::array<std::int32_t, 4>& v)
  {
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.col(k) = volume.points[t[k + 1]] - volume.points[t[0]];
    Eigen::Matrix<double, 3, 4> gradients;
    gradients.rightCols<3>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    const double size = std::abs(edges.determinant()) / 6;
    for(int k = 0; k < 4; ++k)
      for(int l = k; l < 4; ++l) {
        if(v[k] < 0 || v[l] < 0)
          continue;
        const Eigen::Vector3d g = gradients.col(k), h = gradients.col(l);
        Eigen::MatrixXd block = size * g.dot(h) * Eigen::MatrixXd::Identity(matrix.block_size(), matrix.block_size());
        // Blocks off the diagonal are not symmetric.
        if(matrix.block_size() == 3)
          block += size * (4 * g * h.transpose() + h * g.transpose());
        matrix.add_block(v[k], v[l], matrix.slot(v[k], v[l]), block);
      }
  }
};

Eigen::VectorXd product(const FFM::Block_sparse_matrix& matrix, const Eigen::VectorXd& x)
{
  return matrix.lower().selfadjointView<Eigen::Lower>() * x;
}

template <typename AnySystem>
double residual(const AnySystem& system, const Eigen::VectorXd& x)
{
  return (product(system.matrix, x) - system.right).norm() / system.right.norm();
}

template <typename Solver, typename AnySystem>
int iterations(const AnySystem& system, bool with_positions)
{
  Solver solver(1e-6);
  BOOST_TEST_REQUIRE(solver.analyze_pattern(system.matrix));
  if(with_positions)
    solver.set_positions(system.positions);
  BOOST_TEST_REQUIRE(solver.factorize(system.matrix));
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE(solver.solve(system.right, x));
  BOOST_TEST(solver.converged());
  BOOST_TEST(residual(system, x) <= 1.01e-6);
  return solver.iterations();
}

} // namespace

BOOST_AUTO_TEST_CASE(a_cycle_is_symmetric_and_positive_definite, *boost::unit_test::label("needs_petsc"))
{
  for(int b : {1, 3}) {
    const System system(6, 24, b);
    FFM::Petsc_multigrid multigrid;
    BOOST_TEST_REQUIRE(multigrid.analyze_pattern(system.matrix));
    multigrid.set_positions(system.positions);
    BOOST_TEST_REQUIRE(multigrid.factorize(system.matrix));
    Random random(82);
    for(int k = 0; k < 5; ++k) {
      const Eigen::VectorXd x = random.vector(static_cast<int>(system.matrix.rows()));
      // Smooth vectors are what coarse levels are for.
      const Eigen::VectorXd y = k == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(x.size())) : random.vector(static_cast<int>(x.size()));
      Eigen::VectorXd from_x, from_y;
      BOOST_TEST_REQUIRE((multigrid.solve(x, from_x) && multigrid.solve(y, from_y)));
      BOOST_TEST(x.dot(from_x) > 0);
      BOOST_TEST(y.dot(from_y) > 0);
      BOOST_TEST(std::abs(x.dot(from_y) - y.dot(from_x)) <= 1e-10 * std::sqrt(x.dot(from_x) * y.dot(from_y)));
      // The same again: nothing is left of other right-hand sides.
      Eigen::VectorXd again = Eigen::VectorXd::Constant(3, 7.);
      BOOST_TEST_REQUIRE(multigrid.solve(x, again));
      BOOST_TEST((again.array() == from_x.array()).all());
    }
  }
}

BOOST_AUTO_TEST_CASE(conjugate_gradients_find_the_solution, *boost::unit_test::label("needs_petsc"))
{
  for(int b : {1, 3}) {
    System system(6, 24, b);
    Multigrid_solver iterative(1e-13);
    Direct_solver direct;
    BOOST_TEST_REQUIRE((iterative.analyze_pattern(system.matrix) && direct.analyze_pattern(system.matrix)));
    // Another matrix with the same pattern and the same object, too.
    for(int k = 0; k < 2; ++k) {
      iterative.set_positions(system.positions);
      BOOST_TEST_REQUIRE((iterative.factorize(system.matrix) && direct.factorize(system.matrix)));
      Eigen::VectorXd x, expected;
      BOOST_TEST_REQUIRE((iterative.solve(system.right, x) && direct.solve(system.right, expected)));
      BOOST_TEST((x - expected).norm() <= 1e-9 * expected.norm());
      BOOST_TEST(iterative.iterations() <= 60);
      for(FFM::Block_sparse_matrix::Index i = 0; i < system.matrix.rows(); ++i)
        system.matrix.diagonal(i) *= i % 2 == 0 ? 1.5 : 3;
    }
  }
}

// From 6000 to 48000 tetrahedra.
BOOST_AUTO_TEST_CASE(iterations_hardly_grow_with_the_mesh, *boost::unit_test::label("needs_petsc"))
{
  const System coarse(5, 40), fine(10, 80);
  const double multigrid = 1. * iterations<Multigrid_solver>(fine, true) / iterations<Multigrid_solver>(coarse, true);
  const double factor =
    1. * iterations<FFM::Conjugate_gradient_solver<>>(fine, false) / iterations<FFM::Conjugate_gradient_solver<>>(coarse, false);
  BOOST_TEST(multigrid < 1.5);
  BOOST_TEST(factor > multigrid);
  BOOST_TEST(iterations<Multigrid_solver>(fine, true) < iterations<FFM::Conjugate_gradient_solver<>>(fine, false) / 3);
}

// Rotations are what translations alone do not make of a long bar.
BOOST_AUTO_TEST_CASE(positions_give_the_rotations, *boost::unit_test::label("needs_petsc"))
{
  const System system(5, 60);
  BOOST_TEST(iterations<Multigrid_solver>(system, true) < 0.7 * iterations<Multigrid_solver>(system, false));
  const Planar_system planar(12, 20);
  BOOST_TEST(iterations<Multigrid_solver>(planar, true) < 0.7 * iterations<Multigrid_solver>(planar, false));
  BOOST_TEST(1. * iterations<Multigrid_solver>(Planar_system(24, 20), true) < 1.5 * iterations<Multigrid_solver>(planar, true));
}

BOOST_AUTO_TEST_CASE(mumps_is_as_exact_as_another_direct_solver, *boost::unit_test::label("needs_petsc"))
{
  for(int b : {1, 3}) {
    System system(6, 24, b);
    FFM::Petsc_direct_solver solver;
    Direct_solver other;
    Eigen::VectorXd x, expected;
    BOOST_TEST(!solver.factorize(system.matrix));
    BOOST_TEST_REQUIRE((solver.analyze_pattern(system.matrix) && other.analyze_pattern(system.matrix)));
    BOOST_TEST(!solver.solve(system.right, x));
    for(int k = 0; k < 2; ++k) {
      BOOST_TEST_REQUIRE((solver.factorize(system.matrix) && other.factorize(system.matrix)));
      BOOST_TEST_REQUIRE((solver.solve(system.right, x) && other.solve(system.right, expected)));
      BOOST_TEST((x - expected).norm() <= 1e-10 * expected.norm());
      BOOST_TEST(residual(system, x) <= 1e-11);
      BOOST_TEST(solver.factor_entries() > system.matrix.number_of_entries());
      system.matrix.diagonal(7) *= 2;
    }
  }
}

BOOST_AUTO_TEST_CASE(matrices_that_are_not_positive_definite_are_refused, *boost::unit_test::label("needs_petsc"))
{
  System system(3, 9);
  const Eigen::VectorXd right = system.right;
  Eigen::VectorXd x;
  FFM::Petsc_direct_solver direct;
  Multigrid_solver iterative;
  BOOST_TEST_REQUIRE((direct.analyze_pattern(system.matrix) && iterative.analyze_pattern(system.matrix)));
  iterative.set_positions(system.positions);
  const double good = system.matrix.diagonal(40);
  for(double bad : {-good, 0., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    system.matrix.diagonal(40) = bad;
    BOOST_TEST(!direct.factorize(system.matrix));
    BOOST_TEST(!direct.solve(right, x));
    BOOST_TEST(!iterative.factorize(system.matrix));
    BOOST_TEST(!iterative.solve(right, x));
  }
  system.matrix.diagonal(40) = good;
  // Positive on the diagonal, and not definite all the same.
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(1, 0) = shear(0, 1) = 2 * good;
  system.matrix.add_block(10, 10, 0, shear);
  BOOST_TEST(!direct.factorize(system.matrix));
  BOOST_TEST(!iterative.factorize(system.matrix));
  system.matrix.add_block(10, 10, 0, Eigen::Matrix3d(-shear));
  // Objects are as good as new afterwards.
  BOOST_TEST_REQUIRE((direct.factorize(system.matrix) && iterative.factorize(system.matrix)));
  BOOST_TEST_REQUIRE((direct.solve(right, x) && residual(system, x) <= 1e-11));
  BOOST_TEST_REQUIRE((iterative.solve(right, x) && residual(system, x) <= 0.01));
  // Other patterns are refused until they are analysed.
  const System other(2, 5);
  BOOST_TEST((!direct.factorize(other.matrix) && !iterative.factorize(other.matrix)));
  BOOST_TEST((direct.analyze_pattern(other.matrix) && iterative.analyze_pattern(other.matrix)));
  BOOST_TEST((direct.factorize(other.matrix) && iterative.factorize(other.matrix)));
  BOOST_TEST_REQUIRE((direct.solve(other.right, x) && residual(other, x) <= 1e-11));
  BOOST_TEST_REQUIRE((iterative.solve(other.right, x) && residual(other, x) <= 0.01));
}

BOOST_AUTO_TEST_CASE(the_smallest_matrices, *boost::unit_test::label("needs_petsc"))
{
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(1, 3, std::vector<std::array<std::int32_t, 2>>());
  for(int i = 0; i < 3; ++i)
    matrix.diagonal(i) = i + 1;
  const Eigen::VectorXd right = Eigen::Vector3d(1, 2, 3);
  FFM::Petsc_direct_solver direct;
  Multigrid_solver iterative(1e-12);
  Eigen::VectorXd x;
  BOOST_TEST((direct.analyze_pattern(matrix) && direct.factorize(matrix) && direct.solve(right, x)));
  BOOST_TEST((x - Eigen::VectorXd::Ones(3)).norm() <= 1e-14);
  BOOST_TEST_REQUIRE(iterative.analyze_pattern(matrix));
  iterative.set_positions(Eigen::VectorXd::Zero(3));
  BOOST_TEST((iterative.factorize(matrix) && iterative.solve(right, x)));
  BOOST_TEST((x - Eigen::VectorXd::Ones(3)).norm() <= 1e-11);
}

BOOST_AUTO_TEST_CASE(a_bar_is_bent_to_the_same_energy, *boost::unit_test::label("needs_petsc"))
{
  const Volume volume = bar(16, 4, 4, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(volume);
  const FFM::Positions<3> rest = positions_of<3>(volume, domain.scale);
  FFM::Position_constraints<3> constraints;
  FFM::Positions<3> targets = rest;
  const double begin = rest.row(0).minCoeff(), end = rest.row(0).maxCoeff();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 0.3, 0).normalized()).toRotationMatrix();
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const double x = rest(0, v);
    if(x == begin || x == end)
      constraints.fixed_vertices.push_back(v);
    if(x == end)
      targets.col(v) = turn * rest.col(v);
  }
  const auto energy = [&](auto choose) {
    FFM::Any_map_traits traits;
    traits.options.characteristic_gradient_tolerance = 1e-7;
    choose(traits);
    FFM::Positions<3> x = rest;
    const FFM::Summary summary = FFM::Map_minimizer<3, FFM::Any_map_traits>(domain, traits, constraints).move_fixed_vertices(x, targets);
    BOOST_TEST(summary.converged());
    BOOST_TEST(summary.flips == 0);
    return summary.energy;
  };
  const double expected = energy([](FFM::Any_map_traits&) {});
  const double multigrid = energy([](FFM::Any_map_traits& traits) { traits.use_linear_solver<Multigrid_solver>(); });
  const double mumps = energy([](FFM::Any_map_traits& traits) { traits.use_linear_solver<FFM::Petsc_direct_solver>(); });
  BOOST_TEST(multigrid == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(mumps == expected, boost::test_tools::tolerance(1e-9));
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
BOOST_AUTO_TEST_CASE(the_default_takes_it_beyond_the_budget, *boost::unit_test::label("needs_petsc"))
{
  const System system(5, 40);
  FFM::Flip_free_map_traits<> traits;
  traits.options.memory_budget = 1;
  auto solver = traits.make_linear_solver();
  BOOST_TEST_REQUIRE(solver.analyze_pattern(system.matrix));
  solver.set_positions(system.positions);
  BOOST_TEST_REQUIRE(solver.factorize(system.matrix));
  Eigen::VectorXd x;
  BOOST_TEST_REQUIRE(solver.solve(system.right, x));
  BOOST_TEST(solver.name().find("multigrid") != std::string::npos);
  BOOST_TEST(residual(system, x) <= 0.01);
  BOOST_TEST(solver.iterations() <= 30);
}
#endif

#else
BOOST_AUTO_TEST_CASE(petsc, *boost::unit_test::label("needs_petsc")) { test_support::skip_case("built without PETSc"); }
#endif

BOOST_AUTO_TEST_SUITE_END() // test_petsc_solvers
