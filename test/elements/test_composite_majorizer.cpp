// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Majorizers of composite energies against majorizers that are written down as functions of the Jacobian, by differences.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/elements/composite_majorizer.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>

#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_composite_majorizer)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// J = [a b; c d] as two vectors: det J = |alpha|^2 - |beta|^2.
Eigen::Vector2d alpha(const Eigen::Matrix2d& J) { return 0.5 * Eigen::Vector2d(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1)); }

Eigen::Vector2d beta(const Eigen::Matrix2d& J) { return 0.5 * Eigen::Vector2d(J(0, 0) - J(1, 1), J(1, 0) + J(0, 1)); }

// |a|^2 and its tangent at a_0.
double tangent(const Eigen::Vector2d& a, const Eigen::Vector2d& a_0) { return a_0.squaredNorm() + 2 * a_0.dot(a - a_0); }

// The determinant with its concave part replaced by the tangent at J_0; or its convex part.
double convexified_determinant(const Eigen::Matrix2d& J, const Eigen::Matrix2d& J_0)
{
  return alpha(J).squaredNorm() - tangent(beta(J), beta(J_0));
}

double concavified_determinant(const Eigen::Matrix2d& J, const Eigen::Matrix2d& J_0)
{
  return tangent(alpha(J), alpha(J_0)) - beta(J).squaredNorm();
}

double rubber(const FFM::Neo_hookean& energy, double u, double v)
{
  return energy.mu / 2 * (u * u / v - 2) + energy.kappa / 2 * (v - 1) * (v - 1);
}

double slope_in_determinant(const FFM::Neo_hookean& energy, const Eigen::Matrix2d& J)
{
  const double v = J.determinant();
  return -energy.mu / 2 * J.squaredNorm() / (v * v) + energy.kappa * (v - 1);
}

// h([u], [v]): the Frobenius norm is convex and h grows with it, so it stays.
double rubber_majorizer(const FFM::Neo_hookean& energy, const Eigen::Matrix2d& J, const Eigen::Matrix2d& J_0)
{
  return rubber(energy, J.norm(),
                slope_in_determinant(energy, J_0) > 0 ? convexified_determinant(J, J_0) : concavified_determinant(J, J_0));
}

template <typename Function>
Full_matrix<2> hessian_by_differences(Function&& f, const Eigen::Matrix2d& J)
{
  const double h = 2e-3 * J.determinant() / J.norm();
  Full_matrix<2> hessian;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j) {
      const auto moved = [&](double a, double b) {
        Eigen::Matrix2d m = J;
        m.data()[i] += a * h;
        m.data()[j] += b * h;
        return f(m);
      };
      const auto mixed = [&](double k) { return (moved(k, k) - moved(k, -k) - moved(-k, k) + moved(-k, -k)) / (4 * k * k); };
      hessian(i, j) = (4 * mixed(1) - mixed(2)) / (3 * h * h);
    }
  return hessian;
}

std::vector<Eigen::Matrix2d> samples(double spread)
{
  Random random(31);
  std::vector<Eigen::Matrix2d> all{random.rotation<2>()};
  for(int k = 0; k < 200; ++k) {
    const Eigen::Vector2d s(std::exp(random(-spread, spread)), std::exp(random(-spread, spread)));
    all.push_back(random.rotation<2>() * s.asDiagonal() * random.rotation<2>());
  }
  return all;
}

std::vector<FFM::Neo_hookean> materials()
{
  FFM::Neo_hookean soft, stiff;
  soft.mu = 0.002;
  stiff.mu = 3;
  return {FFM::Neo_hookean(), soft, stiff};
}

// det and its parts, in the frame of the singular vectors.
FFM::Inner_function<2> determinant(const Eigen::Vector2d& s)
{
  FFM::Inner_function<2> g;
  g.gradient = Eigen::Vector2d(s[1], s[0]);
  g.convex.stretch << 0.5, 0.5, 0.5, 0.5;
  g.convex.pairs[0].set_modes(0, 1);
  g.concave.stretch << 0.5, -0.5, -0.5, 0.5;
  g.concave.pairs[0].set_modes(1, 0);
  return g;
}

} // namespace

BOOST_AUTO_TEST_CASE(neo_hookean_is_majorized)
{
  const FFM::Composite_majorization<> majorization;
  for(const FFM::Neo_hookean& energy : materials())
    for(const Eigen::Matrix2d& J : samples(1.2)) {
      const Full_matrix<2> majorizer = full_matrix<2>(majorization, energy, J);
      const Full_matrix<2> hessian = full_matrix<2>(FFM::Newton(), energy, J);
      BOOST_TEST(relative_smallest_eigenvalue(majorizer) >= -1e-12);
      const Full_matrix<2> difference = majorizer - hessian;
      const double smallest = smallest_eigenvalue(difference);
      BOOST_TEST(smallest >= -1e-11 * majorizer.norm());
    }
}

BOOST_AUTO_TEST_CASE(neo_hookean_majorizer_is_the_one_of_the_paper)
{
  int convex = 0, concave = 0;
  for(const FFM::Neo_hookean& energy : materials())
    for(const Eigen::Matrix2d& J : samples(0.7)) {
      // The majorizer touches the energy, and both its branches are met.
      BOOST_TEST(std::abs(rubber_majorizer(energy, J, J) - rubber(energy, J.norm(), J.determinant())) <= 1e-12);
      ++(slope_in_determinant(energy, J) > 0 ? convex : concave);
      const Full_matrix<2> expected = hessian_by_differences([&](const Eigen::Matrix2d& m) { return rubber_majorizer(energy, m, J); }, J);
      const Full_matrix<2> majorizer = full_matrix<2>(FFM::Composite_majorization<>(), energy, J);
      BOOST_TEST((majorizer - expected).norm() <= 1e-6 * expected.norm());
      // With the type of the energy forgotten.
      BOOST_TEST((full_matrix<2>(FFM::Composite_majorization<>(), FFM::Any_energy(energy), J) == majorizer));
    }
  BOOST_TEST(convex >= 30);
  BOOST_TEST(concave >= 30);
}

// The majorizer is above the energy everywhere, not only to second order.
BOOST_AUTO_TEST_CASE(written_majorizer_is_above_the_energy)
{
  Random random(37);
  const FFM::Neo_hookean energy;
  int checked = 0;
  for(const Eigen::Matrix2d& J_0 : samples(0.5))
    for(int k = 0; k < 10; ++k) {
      const Eigen::Matrix2d J = J_0 + random(0, 0.4) * random.matrix<2>();
      const double v = slope_in_determinant(energy, J_0) > 0 ? convexified_determinant(J, J_0) : concavified_determinant(J, J_0);
      // Where h is defined and still goes up, or down, with v between the determinant and its replacement.
      const double slope_det = -energy.mu / 2 * J.squaredNorm() / std::pow(J.determinant(), 2) + energy.kappa * (J.determinant() - 1);
      const double slope_v = -energy.mu / 2 * J.squaredNorm() / (v * v) + energy.kappa * (v - 1);
      if(!(J.determinant() > 0.01 && v > 0.01) || slope_det * slope_v < 0 || slope_v * slope_in_determinant(energy, J_0) < 0)
        continue;
      ++checked;
      BOOST_TEST(rubber_majorizer(energy, J, J_0) >= rubber(energy, J.norm(), J.determinant()) - 1e-12);
    }
  BOOST_TEST(checked >= 500);
}

BOOST_AUTO_TEST_CASE(one_inner_function)
{
  for(const double sign : {1., -1.})
    for(const Eigen::Matrix2d& J : samples(0.6)) {
      FFM::internal::Signed_svd<2> svd;
      FFM::internal::signed_svd(J, svd);
      // h = exp(+-g), convex, with g = det J.
      const double h = std::exp(sign * J.determinant());
      const Eigen::Matrix<double, 1, 1> h_gradient(sign * h), h_hessian(h);
      FFM::Increment_form<2> form;
      FFM::composite_majorizer<2, 1>(h_gradient, h_hessian, std::array<FFM::Inner_function<2>, 1>{determinant(svd.s)}, form);
      const Full_matrix<2> turn = to_frame<2>(svd), majorizer = turn.transpose() * matrix_in_frame<2>(form) * turn;

      const Full_matrix<2> expected = hessian_by_differences(
        [&](const Eigen::Matrix2d& m) {
          return std::exp(sign * (sign > 0 ? convexified_determinant(m, J) : concavified_determinant(m, J)));
        },
        J);
      BOOST_TEST((majorizer - expected).norm() <= 1e-6 * expected.norm());
      const Full_matrix<2> hessian = hessian_by_differences([&](const Eigen::Matrix2d& m) { return std::exp(sign * m.determinant()); }, J);
      BOOST_TEST(smallest_eigenvalue(majorizer - hessian) >= -1e-6 * majorizer.norm());
    }
}

BOOST_AUTO_TEST_SUITE_END() // test_composite_majorizer
