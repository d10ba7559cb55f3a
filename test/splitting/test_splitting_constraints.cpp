// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The global step: its optimality, linear constraints, soft positions, meshes of several parts, and independence of the threads.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/splitting_checks.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstring>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_splitting_constraints)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Tag = CGAL::Sequential_tag>
using Traits = FFM::Flip_free_map_traits<CGAL::Default, FFM::Symmetric_gradient, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default,
                                         CGAL::Default, Tag>;

// What the global step minimises.
template <int D>
double quadratic(const FFM::Simplicial_domain<D>& domain, const std::vector<FFM::internal::Matrix<D>>& targets,
                 const std::vector<double>& penalties, const FFM::Position_constraints<D>& constraints, const FFM::Positions<D>& x)
{
  double value = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    value += 0.5 * penalties[e] * (domain.jacobian(e, x) - targets[e]).squaredNorm();
  for(const auto& soft : constraints.soft_positions)
    value += soft.weight * (x.col(soft.vertex) - soft.target).squaredNorm();
  return value;
}

template <int D>
void check_global_step(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& start,
                       const FFM::Position_constraints<D>& constraints, const FFM::Linear_constraints<D>& linear)
{
  Random random(21);
  std::vector<FFM::internal::Matrix<D>> targets;
  std::vector<double> penalties;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    targets.push_back(random.matrix<D>());
    penalties.push_back(random(0.01, 1));
  }
  FFM::internal::Element_coloring schedule;
  schedule.build(domain.elements, domain.number_of_vertices);
  FFM::internal::Position_solver<D, Traits<>> positions(domain, schedule, constraints, linear);
  Plain_solver plain;
  FFM::Positions<D> x = start;
  BOOST_TEST_REQUIRE(positions.analyze_pattern(plain));
  BOOST_TEST_REQUIRE(positions.factorize(plain, [&](std::int64_t e) { return penalties[e]; }));
  BOOST_TEST_REQUIRE(positions.move(
    plain, [&](std::int64_t e) { return FFM::internal::Matrix<D>(penalties[e] * (targets[e] - domain.jacobian(e, x))); }, x));

  for(std::int32_t v : constraints.fixed_vertices)
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
  if(!linear.empty())
    BOOST_TEST((linear.matrix * x.transpose() - linear.values).norm() < 1e-11);

  // Feasible increments do not decrease the value, nor does it change to first order.
  const double value = quadratic(domain, targets, penalties, constraints, x);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(linear.matrix.rows() + constraints.fixed_vertices.size(), x.cols());
  if(!linear.empty())
    A.topRows(linear.matrix.rows()) = Eigen::MatrixXd(linear.matrix);
  for(std::size_t i = 0; i < constraints.fixed_vertices.size(); ++i)
    A(linear.matrix.rows() + i, constraints.fixed_vertices[i]) = 1;
  for(int k = 0; k < 20; ++k) {
    Eigen::MatrixXd direction(x.cols(), D);
    for(int c = 0; c < D; ++c)
      direction.col(c) = random.vector(x.cols());
    if(A.rows() > 0)
      direction -= least_squares_solution(A, A * direction);
    const double h = 1e-3;
    const FFM::Positions<D> step = h * direction.transpose();
    const double up = quadratic<D>(domain, targets, penalties, constraints, x + step);
    const double down = quadratic<D>(domain, targets, penalties, constraints, x - step);
    BOOST_TEST(up >= value - 1e-12 * value);
    BOOST_TEST(std::abs(up - down) <= 1e-10 * value);
  }
}

template <int D>
FFM::Linear_constraints<D> random_equations(std::int32_t vertices, int rows)
{
  Random random(22);
  FFM::Linear_constraints<D> linear;
  linear.matrix.resize(rows, vertices);
  linear.values.resize(rows, D);
  for(int i = 0; i < rows; ++i) {
    for(int k = 0; k < 3; ++k)
      linear.matrix.coeffRef(i, (5 * i + 7 * k) % vertices) += random(-1, 1);
    for(int c = 0; c < D; ++c)
      linear.values(i, c) = random(-0.3, 0.3);
  }
  return linear;
}

template <typename Tag>
FFM::Summary shortly(const FFM::Simplicial_domain<2>& domain, FFM::Positions<2>& x)
{
  FFM::Splitting_options options;
  options.max_iterations = 25;
  return FFM::Splitting_minimizer<2, Traits<Tag>>(domain, {}, {}, options).minimize(x);
}

} // namespace

BOOST_AUTO_TEST_CASE(global_step_is_optimal)
{
  const Distorted_example<2> plane;
  const Distorted_example<3> space;
  const std::int32_t n = plane.domain.number_of_vertices, m = space.domain.number_of_vertices;
  FFM::Position_constraints<2> fixed, soft;
  fixed.fixed_vertices = {1, 4, 9, 4};
  soft.soft_positions = {{2, Eigen::Vector2d(0.1, 0.2), 0.7}, {5, Eigen::Vector2d(-0.1, 0.3), 0}};
  FFM::Position_constraints<3> corners;
  corners.fixed_vertices = {0, 3};
  check_global_step<2>(plane.domain, plane.x, {}, {});
  check_global_step<2>(plane.domain, plane.x, soft, {});
  check_global_step<2>(plane.domain, plane.x, {}, random_equations<2>(n, 3));
  check_global_step<2>(plane.domain, plane.x, soft, random_equations<2>(n, 3));
  check_global_step<3>(space.domain, space.x, corners, {});
  check_global_step<3>(space.domain, space.x, {}, random_equations<3>(m, 2));
  fixed.fixed_vertices = {1, 4, 9};
  check_global_step<2>(plane.domain, plane.x, fixed, random_equations<2>(n, 3));
}

BOOST_AUTO_TEST_CASE(redundant_equations_and_differences)
{
  // An equation twice, and one between two vertices that leaves translations free.
  const Distorted_example<2> plane;
  FFM::Linear_constraints<2> linear;
  linear.matrix.resize(3, plane.domain.number_of_vertices);
  for(int i = 0; i < 3; ++i) {
    linear.matrix.coeffRef(i, i == 2 ? 7 : 2) = 1;
    linear.matrix.coeffRef(i, i == 2 ? 3 : 6) = -1;
  }
  linear.values = Eigen::MatrixXd::Constant(3, 2, 0.05);
  check_global_step<2>(plane.domain, plane.x, {}, linear);
}

BOOST_AUTO_TEST_CASE(linear_constraints_of_a_run)
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  const FFM::Positions<2> start = tutte_start(domain);
  // Two pairs of border vertices at given differences, and the mean of all vertices at the origin.
  const std::int32_t n = domain.number_of_vertices;
  FFM::Linear_constraints<2> linear;
  linear.matrix.resize(3, n);
  linear.matrix.coeffRef(0, 0) = -1;
  linear.matrix.coeffRef(0, 8) = 1;
  linear.matrix.coeffRef(1, 0) = -1;
  linear.matrix.coeffRef(1, n - 9) = 1;
  for(std::int32_t v = 0; v < n; ++v)
    linear.matrix.coeffRef(2, v) = 1. / n;
  linear.values.resize(3, 2);
  linear.values << 1, 0.1, -0.1, 0.9, 0, 0;
  FFM::Positions<2> x = start;
  const FFM::Summary summary = FFM::Splitting_minimizer<2, Traits<>>(domain, {}, {}, {}, linear).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST((linear.matrix * x.transpose() - linear.values).norm() < 1e-9);

  linear.values.resize(2, 2);
  BOOST_TEST((FFM::Splitting_minimizer<2, Traits<>>(domain, {}, {}, {}, linear).minimize(x).status == FFM::Status::invalid_option));
}

BOOST_AUTO_TEST_CASE(several_components)
{
  // Two patches and a vertex of no element.
  Surface two = bumpy_patch(4, 3);
  const std::int32_t n = static_cast<std::int32_t>(two.points.size());
  const Surface other = bent_sheet(3, 3);
  for(const auto& p : other.points)
    two.points.push_back(p);
  for(const auto& t : other.triangles)
    two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  two.points.push_back(Eigen::Vector3d(9, 9, 9));
  const FFM::Simplicial_domain<2> domain = make_domain(two);
  FFM::Positions<2> x = positions_of<2>(two, domain.scale);
  const Eigen::Vector2d lonely = x.col(x.cols() - 1);
  const FFM::Summary summary = FFM::Splitting_minimizer<2, Traits<>>(domain).minimize(x);
  BOOST_TEST(summary.converged());
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST((x.col(x.cols() - 1) - lonely).norm() == 0);
  BOOST_TEST(summary.energy < 1.1);
}

BOOST_AUTO_TEST_CASE(threads, *boost::unit_test::label("needs_tbb"))
{
  const FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(30, 30));
  const FFM::Positions<2> start = tutte_start(domain);
  FFM::Positions<2> expected = start;
  const FFM::Summary sequential = shortly<CGAL::Sequential_tag>(domain, expected);
  BOOST_TEST_REQUIRE(sequential.is_valid());
  BOOST_TEST((expected - start).norm() > 0.1);
#ifdef CGAL_LINKED_WITH_TBB
  for(int threads : {1, 2, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    FFM::Positions<2> x = start;
    const FFM::Summary parallel = shortly<CGAL::Parallel_tag>(domain, x);
    BOOST_TEST(parallel.energy == sequential.energy);
    BOOST_TEST(std::memcmp(x.data(), expected.data(), x.size() * sizeof(double)) == 0);
  }
#else
  test_support::skip_case("built without oneTBB: there is one thread only");
#endif
}

BOOST_AUTO_TEST_SUITE_END() // test_splitting_constraints
