// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Every energy in the plane and in space: its derivatives against finite differences, and the properties that its
// documentation promises.

#define BOOST_TEST_MODULE energies
#include <boost/test/included/unit_test.hpp>

#include "support/generated_domains.h"
#include "support/full_matrix.h"

#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef std::tuple<FFM::Symmetric_dirichlet> Energies;

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

// Singular values from 1/20 to 20, descending.
template <int D>
Vector<D> random_singular_values(Random& random)
{
  Vector<D> s;
  for(int i = 0; i < D; ++i)
    s[i] = std::exp(random(-3, 3));
  std::sort(s.data(), s.data() + D, [](double a, double b) { return a > b; });
  return s;
}

template <int D, typename Energy>
void check_derivatives(const Energy& energy)
{
  Random random(1);
  for(int k = 0; k < 200; ++k) {
    const Vector<D> s = random_singular_values<D>(random);
    Vector<D> gradient, difference_gradient;
    Matrix<D> hessian, difference_hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    for(int i = 0; i < D; ++i) {
      const double h = 1e-4 * s[i];
      Vector<D> low = s, high = s, gradient_low, gradient_high;
      Matrix<D> ignored;
      low[i] -= h;
      high[i] += h;
      const double width = high[i] - low[i];
      difference_gradient[i] = (energy.template value<D>(high) - energy.template value<D>(low)) / width;
      energy.template derivatives<D>(low, gradient_low, ignored);
      energy.template derivatives<D>(high, gradient_high, ignored);
      difference_hessian.col(i) = (gradient_high - gradient_low) / width;
    }
    BOOST_TEST((gradient - difference_gradient).norm() <= 1e-6 * gradient.norm());
    BOOST_TEST((hessian - difference_hessian).norm() <= 1e-6 * hessian.norm());
    BOOST_TEST((hessian - hessian.transpose()).norm() == 0);
  }
}

// The rows of a matrix in the order that `s` has after a permutation must not matter.
template <int D, typename Energy>
void check_symmetry(const Energy& energy)
{
  Random random(2);
  for(int k = 0; k < 50; ++k) {
    const Vector<D> s = random_singular_values<D>(random);
    Vector<D> gradient;
    Matrix<D> hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    Eigen::PermutationMatrix<D> permutation;
    permutation.setIdentity();
    while(std::next_permutation(permutation.indices().data(), permutation.indices().data() + D)) {
      const Vector<D> t = permutation * s;
      Vector<D> permuted_gradient;
      Matrix<D> permuted_hessian;
      energy.template derivatives<D>(t, permuted_gradient, permuted_hessian);
      BOOST_TEST(std::abs(energy.template value<D>(t) - energy.template value<D>(s)) <= 1e-14 * energy.template value<D>(s));
      BOOST_TEST((permuted_gradient - permutation * gradient).norm() <= 1e-14 * gradient.norm());
      BOOST_TEST((permuted_hessian - permutation * hessian * permutation.transpose()).norm() <= 1e-14 * hessian.norm());
    }
  }
}

template <int D, typename Energy>
void check_isometry(const Energy& energy)
{
  const Vector<D> one = Vector<D>::Ones();
  Vector<D> gradient;
  Matrix<D> hessian;
  energy.template derivatives<D>(one, gradient, hessian);
  BOOST_TEST(std::abs(energy.template value<D>(one) - 1) <= 1e-15);
  BOOST_TEST(gradient.norm() <= 1e-15);
  BOOST_TEST(relative_smallest_eigenvalue(hessian) > 0);

  Random random(3);
  for(int k = 0; k < 200; ++k)
    BOOST_TEST(energy.template value<D>(random_singular_values<D>(random)) > 1);
}

template <int D, typename Energy>
void check_barrier(const Energy& energy)
{
  if(!Energy::has_barrier)
    return;
  double last = 1;
  for(double s = 0.1; s > 1e-320; s *= 0.1) {
    Vector<D> values = Vector<D>::Ones();
    values[D - 1] = s;
    const double value = energy.template value<D>(values);
    BOOST_TEST((value > last || value == std::numeric_limits<double>::infinity()));
    last = value;
  }
  BOOST_TEST(last > 1e300);
}

// The Hessian is the difference of two positive semidefinite matrices, the convex part and minus the concave one.
template <int D, typename Energy>
void check_convex_part(const Energy& energy)
{
  Random random(4);
  for(int k = 0; k < 200; ++k) {
    const Vector<D> s = random_singular_values<D>(random);
    Vector<D> gradient;
    Matrix<D> hessian, convex;
    energy.template derivatives<D>(s, gradient, hessian);
    energy.template convex_hessian<D>(s, hessian, convex);
    BOOST_TEST(relative_smallest_eigenvalue(convex) >= -1e-14);
    const double concave = Eigen::SelfAdjointEigenSolver<Matrix<D>>(convex - hessian).eigenvalues().minCoeff();
    BOOST_TEST(concave >= -1e-14 * hessian.norm());
  }
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives, Energy, Energies)
{
  check_derivatives<2>(Energy());
  check_derivatives<3>(Energy());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(symmetric_in_the_singular_values, Energy, Energies)
{
  check_symmetry<2>(Energy());
  check_symmetry<3>(Energy());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(isometry_is_the_minimum, Energy, Energies)
{
  check_isometry<2>(Energy());
  check_isometry<3>(Energy());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(barrier, Energy, Energies)
{
  check_barrier<2>(Energy());
  check_barrier<3>(Energy());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(convex_part, Energy, Energies)
{
  check_convex_part<2>(Energy());
  check_convex_part<3>(Energy());
}

BOOST_AUTO_TEST_CASE(symmetric_dirichlet_in_matrices)
{
  BOOST_TEST(std::string(FFM::Symmetric_dirichlet::name()) == "symmetric_dirichlet");
  Random random(5);
  for(int k = 0; k < 50; ++k) {
    Matrix<3> J = random.matrix<3>();
    if(J.determinant() < 0)
      J.col(0) *= -1;
    FFM::internal::Signed_svd<3> svd;
    FFM::internal::signed_svd(J, svd);
    const double expected = (J.squaredNorm() + J.inverse().squaredNorm()) / 6;
    BOOST_TEST(std::abs(FFM::Symmetric_dirichlet().value<3>(svd.s) - expected) <= 1e-9 * expected);
  }
}
