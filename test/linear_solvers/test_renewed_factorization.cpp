// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A factorization whose most deformed elements are renewed, against the matrix of the map as it is now.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Renewed_factorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstdint>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_renewed_factorization)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
struct Setting
{
  using Traits = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, CGAL::Default, CGAL::Default,
                                           CGAL::Default, CGAL::Sequential_tag>;
  using Objective = FFM::internal::Map_objective<D, Traits>;

  // `moved` is displaced, by so much that all elements around it are deformed by more than the bound,
  // but not to where one collapses.
  Setting(Distorted_example<D> example, std::int32_t moved, const std::vector<std::int32_t>& fixed)
    : old(example.x),
      x(example.x),
      domain(std::move(example.domain)),
      now(domain, energy, preconditioner),
      objective(domain, energy, preconditioner)
  {
    double lowest = 1e300;
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
      if(has(e, moved)) {
        changed.push_back(e);
        lowest = (std::min)(lowest, height(e, moved));
      }
    x.col(moved)[0] += 0.9 * lowest;
    for(std::int64_t e : changed)
      BOOST_REQUIRE(0.9 * lowest / height(e, moved) > 0.15);
    for(Objective* o : {&now, &objective}) {
      o->fix(fixed);
      o->build_pattern();
      Eigen::VectorXd gradient;
      o->derivatives(FFM::Fixed_reference(), o == &now ? x : old, true, gradient);
      // Translations and the rotation are in the null space where nothing is fixed.
      for(FFM::Block_sparse_matrix::Index i = 0; i < o->matrix().rows(); ++i)
        o->matrix().diagonal(i) += 1e-3;
    }
    BOOST_REQUIRE(solver.analyze_pattern(objective.matrix()));
    BOOST_REQUIRE(solver.factorize(objective.matrix()));
    // So many may be renewed that the changed ones are.
    BOOST_REQUIRE_LE(changed.size(), objective.number_of_unknowns() / 50);
    renewed.renew(objective, FFM::Fixed_reference(), old, x);
  }

  bool has(std::int64_t e, std::int32_t v) const
  {
    return std::find(domain.elements[e].begin(), domain.elements[e].end(), v) != domain.elements[e].end();
  }

  // Of a vertex over the opposite side, in the old map: a displacement by u deforms the element by |u| / height.
  double height(std::int64_t e, std::int32_t v) const
  {
    const Eigen::Matrix<double, D, D> inverse = domain.image_edges(e, old).inverse();
    const auto k = std::find(domain.elements[e].begin(), domain.elements[e].end(), v) - domain.elements[e].begin();
    return 1 / (k == 0 ? inverse.colwise().sum().norm() : inverse.row(k - 1).norm());
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b)
  {
    Eigen::VectorXd y;
    BOOST_REQUIRE(renewed.solve(
      b, [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) { return solver.solve(r, z); }, y));
    return y;
  }

  FFM::Symmetric_dirichlet energy;
  FFM::Projected_newton preconditioner;
  FFM::Positions<D> old, x;
  FFM::Simplicial_domain<D> domain;
  Objective now, objective; // with the matrix at x and at `old`
  std::vector<std::int64_t> changed;
  FFM::Eigen_simplicial_solver solver;
  FFM::internal::Renewed_factorization<D> renewed;
};

Eigen::VectorXd random_vector(Eigen::Index n, std::uint64_t seed)
{
  Random random(seed);
  Eigen::VectorXd v(n);
  for(Eigen::Index i = 0; i < n; ++i)
    v[i] = random(-1, 1);
  return v;
}

Eigen::VectorXd product(const FFM::Block_sparse_matrix& matrix, const Eigen::VectorXd& y)
{
  return matrix.lower().selfadjointView<Eigen::Lower>() * y;
}

// The equations of the renewed vertices hold with the matrix of now, those of vertices away from them with that of then.
template <int D>
void check_equations(Setting<D>& setting)
{
  const Eigen::VectorXd b = random_vector(setting.now.matrix().rows(), 1);
  const Eigen::VectorXd y = setting.solve(b);
  const Eigen::VectorXd residual = product(setting.now.matrix(), y) - b;
  std::vector<char> is_renewed(setting.objective.number_of_unknowns(), 0);
  for(std::int64_t e : setting.changed)
    for(std::int32_t v : setting.objective.unknowns_of_element(e))
      if(v >= 0)
        is_renewed[v] = 1;
  double largest = 0;
  for(std::size_t v = 0; v < is_renewed.size(); ++v)
    if(is_renewed[v])
      largest = (std::max)(largest, residual.template segment<D>(D * v).cwiseAbs().maxCoeff());
  BOOST_TEST(largest < 1e-9);
  // The old factorization does not satisfy them.
  Eigen::VectorXd old;
  BOOST_REQUIRE(setting.solver.solve(b, old));
  BOOST_TEST((product(setting.now.matrix(), old) - b).cwiseAbs().maxCoeff() > 0.1);

  const Eigen::VectorXd c = random_vector(b.size(), 2);
  BOOST_TEST(c.dot(y) == b.dot(setting.solve(c)), boost::test_tools::tolerance(1e-9));
}

std::int32_t middle_of_patch(int columns, int rows) { return (rows / 2) * (columns + 1) + columns / 2; }

} // namespace

BOOST_AUTO_TEST_CASE(equations_in_the_plane)
{
  Setting<2> setting(Distorted_example<2>(24, 20), middle_of_patch(24, 20), {});
  check_equations(setting);
}

BOOST_AUTO_TEST_CASE(equations_beside_fixed_vertices)
{
  const std::int32_t middle = middle_of_patch(24, 20);
  Setting<2> setting(Distorted_example<2>(24, 20), middle, {0, 1, 7, middle + 1});
  check_equations(setting);
}

BOOST_AUTO_TEST_CASE(equations_in_space)
{
  const int n = 11;
  Setting<3> setting(Distorted_example<3>(n, n, n), ((n / 2) * (n + 1) + n / 2) * (n + 1) + n / 2, {});
  check_equations(setting);
}

// Schur complements are minima of the quadratic forms, so a M <= A <= b M holds for them as well: what is renewed comes nearer to
// A, in the sense that eigenvalues of the preconditioned matrix stay within those that the old factorization gives.
BOOST_AUTO_TEST_CASE(eigenvalues_come_nearer_to_one)
{
  Setting<2> setting(Distorted_example<2>(20, 16), middle_of_patch(20, 16), {});
  const auto dense = [](const FFM::Block_sparse_matrix& matrix) {
    return Eigen::MatrixXd(Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>());
  };
  const Eigen::MatrixXd A = dense(setting.now.matrix()), M = dense(setting.objective.matrix());
  Eigen::MatrixXd B(A.rows(), A.cols());
  for(Eigen::Index i = 0; i < A.cols(); ++i)
    B.col(i) = setting.solve(Eigen::VectorXd::Unit(A.cols(), i));
  BOOST_TEST((B - B.transpose()).norm() < 1e-9 * B.norm());

  using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>;
  const Eigen::VectorXd old = Solver(A, M, Eigen::EigenvaluesOnly).eigenvalues();
  // The eigenvalues of B A from those of the symmetric pencil A x = l B^-1 x,
  // with B^-1 replaced by its Cholesky factor's product.
  const Eigen::MatrixXd L = B.llt().matrixL();
  const Eigen::VectorXd now = eigenvalues(L.transpose() * A * L);
  BOOST_TEST(now.minCoeff() > old.minCoeff() - 1e-8);
  BOOST_TEST(now.maxCoeff() < old.maxCoeff() + 1e-8);
  BOOST_TEST(now.maxCoeff() / now.minCoeff() < old.maxCoeff() / old.minCoeff());
}

// A second renewal begins at the factorized matrix, not at the first one's.
BOOST_AUTO_TEST_CASE(a_renewal_replaces_the_one_before)
{
  Setting<2> once(Distorted_example<2>(24, 20), middle_of_patch(24, 20), {});
  Setting<2> twice(Distorted_example<2>(24, 20), middle_of_patch(24, 20), {});
  const Eigen::VectorXd b = random_vector(once.now.matrix().rows(), 3);
  FFM::Positions<2> between = 0.3 * once.old + 0.7 * once.x;
  twice.renewed.renew(twice.objective, FFM::Fixed_reference(), twice.old, between);
  BOOST_TEST((twice.solve(b) - once.solve(b)).norm() > 1e-6);
  twice.renewed.renew(twice.objective, FFM::Fixed_reference(), twice.old, twice.x);
  BOOST_TEST((twice.solve(b) - once.solve(b)).norm() <= 1e-12 * b.norm());

  twice.renewed.clear();
  Eigen::VectorXd old;
  BOOST_REQUIRE(twice.solver.solve(b, old));
  BOOST_TEST((twice.solve(b) - old).norm() == 0);
}

BOOST_AUTO_TEST_SUITE_END() // test_renewed_factorization
