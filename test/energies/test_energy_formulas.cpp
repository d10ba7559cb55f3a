// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The formulas of the energies, written in matrices, and the tools around energies.

#include "support/unit_test.h"

#include "support/all_energies.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/check_derivatives.h>

#include <algorithm>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_energy_formulas)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

struct Wrong : FFM::Symmetric_gradient
{
  bool gradient_too = false;
  template <int D>
  void derivatives(const Vector<D>& s, Vector<D>& gradient, Matrix<D>& hessian) const
  {
    FFM::Symmetric_gradient::derivatives<D>(s, gradient, hessian);
    hessian(0, 1) += 1e-3;
    if(gradient_too)
      gradient *= 1.001;
  }
};

// The formulas as they are written in terms of J.
template <int D>
void check_in_matrices()
{
  Random random(5);
  for(int k = 0; k < 50; ++k) {
    Vector<D> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(random(-2, 2));
    std::sort(s.data(), s.data() + D, [](double a, double b) { return a > b; });
    const Matrix<D> U = random.rotation<D>(), V = random.rotation<D>();
    const Matrix<D> J = U * s.asDiagonal() * V.transpose();
    const double squares = J.squaredNorm(), inverse_squares = J.inverse().squaredNorm(), d = J.determinant();
    const auto check = [&s](const auto& energy, double expected) {
      BOOST_TEST(std::abs(energy.template value<D>(s) - expected) <= 1e-9 * std::abs(expected));
    };
    const double dirichlet = (squares + inverse_squares) / (2 * D);
    check(FFM::Symmetric_dirichlet(), dirichlet);
    FFM::Exponential_symmetric_dirichlet exponential;
    exponential.factor = 40 / dirichlet;
    check(exponential, std::exp(40));
    check(FFM::Symmetric_gradient(), squares / 2 - std::log(d));
    check(FFM::Arap(), (J - U * V.transpose()).squaredNorm());
    check(FFM::Symmetric_arap(), std::pow(s[0] - 1, 2) + std::pow(1 / s[D - 1] - 1, 2));
    const double conformal = D == 2 ? squares / d : std::pow(squares / 3, 1.5) / d;
    check(FFM::Conformal(), conformal);
    // |J|^2 |J^-1|^2 - 1 is the product of s_i/s_j + s_j/s_i in space.
    const double amips = 0.5 * ((D == 2 ? squares / d : (squares * inverse_squares - 1) / 4) + d + 1 / d);
    check(FFM::Amips(), amips);
    FFM::Exponential_amips exponential_amips;
    exponential_amips.factor = 40 / amips;
    check(exponential_amips, std::exp(40));
    FFM::Neo_hookean rubber;
    rubber.mu = 0.3;
    rubber.kappa = 1.7;
    check(rubber, 0.15 * (squares / std::pow(d, 2. / D) - D) + 0.85 * (d - 1) * (d - 1));
    Conformal_with_size sum;
    sum.first_weight = 0.7;
    sum.second_weight = 0.2;
    check(sum, 0.7 * conformal + 0.2 * (squares / 2 - std::log(d)));
    FFM::Aigerman_isometric maximum;
    maximum.exponent = 400;
    const double expected = std::max(s[0], 1 / s[D - 1]);
    const double ratio = maximum.value<D>(s) / expected;
    BOOST_TEST(ratio <= 1);
    BOOST_TEST(ratio >= std::pow(2 * D, -1. / 400) * (1 - 1e-12));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(wrong_derivatives_are_found)
{
  const Vector<2> s(1.7, 0.6);
  Wrong wrong;
  BOOST_TEST(FFM::check_derivatives<2>(wrong, s).gradient_error < 1e-9);
  BOOST_TEST(FFM::check_derivatives<2>(wrong, s).hessian_error > 1e-4);
  wrong.gradient_too = true;
  BOOST_TEST(FFM::check_derivatives<2>(wrong, s).gradient_error > 1e-4);
}

// The second derivatives at rest are those of linear elasticity: lambda + 2 mu, and lambda. By E = mu (3 lambda + 2 mu) / (lambda + mu)
// and nu = lambda / (2 (lambda + mu)) they lead back to the constants, in plane strain, too.
BOOST_AUTO_TEST_CASE(elastic_constants)
{
  const auto check = [](double young, double poisson, double lambda, double two_mu) {
    const double mu = two_mu / 2;
    BOOST_TEST(mu * (3 * lambda + 2 * mu) / (lambda + mu) == young, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(lambda / (2 * (lambda + mu)) == poisson, boost::test_tools::tolerance(1e-9));
  };
  for(const double young : {1., 2.7})
    for(const double poisson : {-0.4, 0.1, 0.3, 0.495}) {
      Vector<2> gradient;
      Matrix<2> hessian;
      FFM::Neo_hookean::of_material(young, poisson, 2).derivatives<2>(Vector<2>::Ones(), gradient, hessian);
      check(young, poisson, hessian(0, 1), hessian(0, 0) - hessian(0, 1));
      Vector<3> gradient_3;
      Matrix<3> hessian_3;
      FFM::Neo_hookean::of_material(young, poisson, 3).derivatives<3>(Vector<3>::Ones(), gradient_3, hessian_3);
      check(young, poisson, hessian_3(0, 1), hessian_3(0, 0) - hessian_3(0, 1));
    }
}

BOOST_AUTO_TEST_CASE(energies_in_matrices)
{
  check_in_matrices<2>();
  check_in_matrices<3>();
}

// Twice differentiable where the exponential is continued, and finite on starts of any distortion.
BOOST_AUTO_TEST_CASE(continued_exponential)
{
  const FFM::Exponential_symmetric_dirichlet energy;
  for(double squeeze : {1 / std::sqrt(199.9), 1 / std::sqrt(200.1), 0.01, 1e-6}) {
    const Vector<2> s(1.1, squeeze);
    const FFM::Derivative_report report = FFM::check_derivatives<2>(energy, s, 1e-5);
    BOOST_TEST(report.gradient_error <= 1e-6);
    BOOST_TEST(report.hessian_error <= 1e-6);
    BOOST_TEST(std::isfinite(energy.value<2>(s)));
  }
}

BOOST_AUTO_TEST_CASE(any_energy_is_the_energy_it_holds)
{
  FFM::Neo_hookean rubber;
  rubber.mu = 0.2;
  const FFM::Any_energy any(rubber);
  const FFM::Any_energy copy = any;
  const Vector<2> s(1.7, 0.6);
  BOOST_TEST(copy.energy_name() == "neo_hookean");
  BOOST_TEST(FFM::Any_energy().energy_name() == "symmetric_dirichlet");
  BOOST_TEST(copy.value<2>(s) == rubber.value<2>(s));
  BOOST_TEST((copy.slim_target<2>(s) == rubber.slim_target<2>(s)));
  Vector<2> gradient, expected_gradient;
  Matrix<2> hessian, expected_hessian;
  copy.derivatives<2>(s, gradient, hessian);
  rubber.derivatives<2>(s, expected_gradient, expected_hessian);
  BOOST_TEST((gradient == expected_gradient));
  BOOST_TEST((hessian == expected_hessian));
}

BOOST_AUTO_TEST_SUITE_END() // test_energy_formulas
