// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Newton's form and the ways to make it positive semidefinite, against differences of the energy and dense eigendecompositions.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Vertex_space_newton.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_newton_variants)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

template <typename Preconditioner>
using Traits = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Preconditioner>;

// psi of a positive J in terms of its entries, without singular values.
struct Dirichlet_value
{
  template <int D>
  double operator()(const Matrix<D>& J) const
  {
    return (J.squaredNorm() + J.inverse().squaredNorm()) / (2 * D);
  }
};

struct Rubber_value
{
  template <int D>
  double operator()(const Matrix<D>& J) const
  {
    const double d = J.determinant();
    return 0.5 * (J.squaredNorm() / std::pow(d, 2. / D) - D) + 0.5 * (d - 1) * (d - 1);
  }
};

double clamp(double value) { return value > 0 ? value : 0; }

double mirror(double value) { return value > 0 ? value : -value; }

template <int D>
std::vector<Matrix<D>> samples()
{
  Random random(23);
  std::vector<Matrix<D>> all;
  for(int k = 0; k < 40; ++k) {
    Eigen::Matrix<double, D, 1> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(random(-0.9, 0.9));
    all.push_back(random.rotation<D>() * s.asDiagonal() * random.rotation<D>());
  }
  return all;
}

template <int D, typename Energy, typename Value>
void check_filters(const Energy& energy, const Value& value)
{
  FFM::Projected_newton clamping, absolute;
  absolute.filter = FFM::Eigenvalue_filter::absolute;
  absolute.begin_iteration(FFM::Iteration_state());
  int indefinite = 0;
  for(const Matrix<D>& J : samples<D>()) {
    const Eigen::MatrixXd hessian = full_matrix<D>(FFM::Newton(), energy, J);
    BOOST_TEST((hessian - hessian_by_differences<D>([&value](const Matrix<D>& m) { return value.template operator()<D>(m); }, J)).norm() <=
               1e-6 * hessian.norm());
    const Eigen::MatrixXd clamped = with_changed_eigenvalues(hessian, clamp), mirrored = with_changed_eigenvalues(hessian, mirror);
    BOOST_TEST((full_matrix<D>(clamping, energy, J) - clamped).norm() <= 1e-10 * hessian.norm());
    BOOST_TEST((full_matrix<D>(absolute, energy, J) - mirrored).norm() <= 1e-10 * hessian.norm());
    indefinite += (clamped - mirrored).norm() > 1e-3 * hessian.norm();
  }
  BOOST_TEST(indefinite >= 10);
}

// The assembled matrix as a dense symmetric one.
template <int D, typename Preconditioner>
Eigen::MatrixXd assembled(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x, const Preconditioner& preconditioner)
{
  const FFM::Symmetric_dirichlet energy;
  FFM::internal::Map_objective<D, Traits<Preconditioner>> objective(domain, energy, preconditioner);
  objective.build_pattern();
  Eigen::VectorXd gradient;
  objective.derivatives(FFM::Fixed_reference(), x, true, gradient);
  const Eigen::MatrixXd lower(objective.matrix().lower());
  return lower.template selfadjointView<Eigen::Lower>();
}

template <int D>
void check_vertex_space()
{
  constexpr int N = D * (D + 1);
  Distorted_example<D> example;
  example.x *= 0.6;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(example.x.size(), example.x.size());
  double changed = 0;
  for(std::int64_t e = 0; e < example.domain.number_of_elements(); ++e) {
    // vec(J) = B times the positions of the element's vertices.
    Eigen::MatrixXd B(D * D, N);
    const auto& v = example.domain.elements[e];
    for(int i = 0; i < N; ++i) {
      FFM::Positions<D> unit = FFM::Positions<D>::Zero(D, example.x.cols());
      unit(i % D, v[i / D]) = 1;
      B.col(i) = vec<D>(example.domain.jacobian(e, unit));
    }
    const Eigen::MatrixXd H = full_matrix<D>(FFM::Newton(), FFM::Symmetric_dirichlet(), example.domain.jacobian(e, example.x));
    const Eigen::MatrixXd hessian = example.domain.measures[e] * B.transpose() * H * B;
    const Eigen::MatrixXd clamped = with_changed_eigenvalues(hessian, clamp);
    changed += (hessian - clamped).norm();
    for(int i = 0; i < N; ++i)
      for(int j = 0; j < N; ++j)
        expected(D * v[i / D] + i % D, D * v[j / D] + j % D) += clamped(i, j);
  }
  const Eigen::MatrixXd matrix = assembled<D>(example.domain, example.x, FFM::Vertex_space_newton());
  BOOST_TEST(changed > 0.05 * expected.norm());
  BOOST_TEST((matrix - expected).norm() <= 1e-11 * expected.norm());
  BOOST_TEST((matrix - assembled<D>(example.domain, example.x, FFM::Projected_newton())).norm() > 1e-3 * expected.norm());
}

} // namespace

BOOST_AUTO_TEST_CASE(filters_act_on_the_eigenvalues_of_the_hessian)
{
  check_filters<2>(FFM::Symmetric_dirichlet(), Dirichlet_value());
  check_filters<3>(FFM::Symmetric_dirichlet(), Dirichlet_value());
  check_filters<2>(FFM::Neo_hookean(), Rubber_value());
  check_filters<3>(FFM::Neo_hookean(), Rubber_value());
}

BOOST_AUTO_TEST_CASE(trust_region_follows_the_model)
{
  const FFM::Neo_hookean energy;
  const Eigen::Vector2d s(2.1, 0.3);
  FFM::Projected_newton clamping, absolute, filter;
  absolute.filter = FFM::Eigenvalue_filter::absolute;
  absolute.begin_iteration(FFM::Iteration_state());
  filter.filter = FFM::Eigenvalue_filter::trust_region;
  const Full_matrix<2> clamped = frame_matrix<2>(clamping, energy, s), mirrored = frame_matrix<2>(absolute, energy, s);
  BOOST_TEST((clamped - mirrored).norm() > 0.1);
  const auto takes_absolute_values = [&](double model_ratio) {
    FFM::Iteration_state state;
    state.model_ratio = model_ratio;
    filter.begin_iteration(state);
    const Full_matrix<2> form = frame_matrix<2>(filter, energy, s);
    BOOST_TEST((form == clamped || form == mirrored));
    return form == mirrored;
  };
  BOOST_TEST(!takes_absolute_values(std::numeric_limits<double>::quiet_NaN()));
  BOOST_TEST(!takes_absolute_values(1.009));
  BOOST_TEST(!takes_absolute_values(0.991));
  BOOST_TEST(takes_absolute_values(1.011));
  BOOST_TEST(takes_absolute_values(0.989));
  BOOST_TEST(takes_absolute_values(-3));
  BOOST_TEST(!takes_absolute_values(1));
  filter.trust_tolerance = 0.5;
  BOOST_TEST(!takes_absolute_values(1.4));
}

BOOST_AUTO_TEST_CASE(element_matrices_are_clamped_on_the_vertices)
{
  check_vertex_space<2>();
  check_vertex_space<3>();
}

BOOST_AUTO_TEST_SUITE_END() // test_newton_variants
