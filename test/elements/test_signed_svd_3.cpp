// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The signed singular value decomposition in space against Eigen's, and against matrices whose singular values are known.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_signed_svd_3)

namespace {

using CGAL::Flip_free_maps::internal::signed_singular_values;
using CGAL::Flip_free_maps::internal::Signed_svd;
using CGAL::Flip_free_maps::internal::signed_svd;
using test_support::Random;

int exact_sign_of_determinant(const Eigen::Matrix3d& J)
{
  const auto r = [&J](int i, int j) { return CGAL::Exact_rational(J(i, j)); };
  const CGAL::Exact_rational determinant = r(0, 0) * (r(1, 1) * r(2, 2) - r(1, 2) * r(2, 1)) -
                                           r(0, 1) * (r(1, 0) * r(2, 2) - r(1, 2) * r(2, 0)) +
                                           r(0, 2) * (r(1, 0) * r(2, 1) - r(1, 1) * r(2, 0));
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

// What is wrong with the decomposition of J; "" when all is well.
std::string fault(const Eigen::Matrix3d& J)
{
  Signed_svd<3> svd;
  signed_svd(J, svd);
  const Eigen::Vector3d values = signed_singular_values(J);
  if(!svd.U.allFinite() || !svd.V.allFinite() || !svd.s.allFinite() || !values.allFinite())
    return "not finite";
  if(!((svd.U.transpose() * svd.U - Eigen::Matrix3d::Identity()).norm() < 4e-15) || !(std::abs(svd.U.determinant() - 1) < 4e-15))
    return "U is no rotation";
  if(!((svd.V.transpose() * svd.V - Eigen::Matrix3d::Identity()).norm() < 8e-15) || !(std::abs(svd.V.determinant() - 1) < 8e-15))
    return "V is no rotation";

  // Of entries of size 1, so that the norms exist.
  const double size = J.cwiseAbs().maxCoeff() > 0 ? J.cwiseAbs().maxCoeff() : 1;
  const Eigen::Matrix3d difference = svd.U * (svd.s / size).asDiagonal() * svd.V.transpose() - J / size;
  if(!(difference.norm() <= 1e-14 * (J / size).norm()))
    return "the product is not the matrix";
  const Eigen::Vector3d expected = test_support::singular_values(J);
  for(const Eigen::Vector3d& s : {svd.s, values}) {
    if(!(s[0] >= s[1]) || !(s[1] >= std::abs(s[2])))
      return "not in descending order";
    if(!((s.cwiseAbs() - expected).cwiseAbs().maxCoeff() <= 1e-12 * expected[0]))
      return "other singular values than Eigen's";
    if(std::abs(s[2]) > 1e-13 * s[0] && (s[2] > 0 ? 1 : -1) != exact_sign_of_determinant(J))
      return "the sign is not that of the determinant";
  }
  return "";
}

// J with the given singular values, correct to a few units in the last place of the largest.
Eigen::Matrix3d with_values(Random& random, double a, double b, double c)
{
  return random.rotation<3>() * Eigen::Vector3d(a, b, c).asDiagonal() * random.rotation<3>().transpose();
}

} // namespace

BOOST_AUTO_TEST_CASE(random_matrices_of_every_size)
{
  Random random(1);
  for(double size : {1., 1e-12, 1e12, 1e-75, 1e75, 1e-290, 1e290})
    for(int i = 0; i < 3000; ++i) {
      const Eigen::Matrix3d J = size * random.matrix<3>();
      BOOST_TEST_REQUIRE(fault(J) == "", "size " << size << ", number " << i << ": " << fault(J));
    }
}

BOOST_AUTO_TEST_CASE(equal_and_nearly_equal_singular_values)
{
  Random random(2);
  for(double gap : {0., 1e-16, 1e-15, 1e-12, 1e-8, 1e-4})
    for(int i = 0; i < 1000; ++i)
      for(int sign : {1, -1}) {
        BOOST_TEST_REQUIRE(fault(with_values(random, 1 + gap, 1, sign)) == "");
        BOOST_TEST_REQUIRE(fault(with_values(random, 1, 1 - gap, sign * 1e-3)) == "");
        BOOST_TEST_REQUIRE(fault(with_values(random, 2, 1 + gap, sign)) == "");
      }
}

BOOST_AUTO_TEST_CASE(rank_deficient_matrices)
{
  Random random(3);
  const double infinity = std::numeric_limits<double>::infinity();
  for(double small : {0., 1e-320, 1e-160, 1e-100, 1e-20, 1e-15})
    for(int i = 0; i < 1000; ++i)
      for(double sign : {1., -1.}) {
        BOOST_TEST_REQUIRE(fault(with_values(random, 1, 0.5, sign * small)) == "");
        BOOST_TEST_REQUIRE(fault(with_values(random, 1, small, sign * small)) == "");
        Eigen::Matrix3d J = random.matrix<3>();
        J.col(i % 3) = small * J.col((i + 1) % 3);
        BOOST_TEST_REQUIRE(fault(J) == "");
        J.row(i % 3) *= small;
        BOOST_TEST_REQUIRE(fault(J) == "");
        Eigen::Matrix3d only = Eigen::Matrix3d::Zero();
        only(i % 3, (i / 3) % 3) = sign * small;
        BOOST_TEST_REQUIRE(fault(only) == "");
      }
  BOOST_TEST(fault(Eigen::Matrix3d::Zero()) == "");
  BOOST_TEST(fault(Eigen::Matrix3d::Identity()) == "");
  BOOST_TEST(fault(-Eigen::Matrix3d::Identity()) == "");
  BOOST_TEST(fault(Eigen::Matrix3d::Ones()) == "");
  for(double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
    J(1, 2) = bad;
    Signed_svd<3> svd;
    signed_svd(J, svd);
    BOOST_TEST(std::isnan(svd.s.sum()));
    BOOST_TEST(std::isnan(signed_singular_values(J).sum()));
  }
}

// Singular values that are far apart are correct relative to themselves when the columns differ as much as they do: the matrix of
// a needle. Decompositions through the eigenvalues of J^T J lose half of the digits.
BOOST_AUTO_TEST_CASE(small_singular_values_of_graded_matrices_are_correct_to_their_last_digits)
{
  Random random(4);
  for(double ratio : {1e-3, 1e-6, 1e-10, 1e-14})
    for(int i = 0; i < 1000; ++i) {
      const double sign = i % 2 == 0 ? 1 : -1;
      const Eigen::Vector3d expected(1, ratio, sign * ratio * ratio);
      std::array<int, 3> order{{0, 1, 2}};
      for(int k = 0; k < i % 6; ++k)
        std::next_permutation(order.begin(), order.end());
      const int parity = i % 6 == 0 || i % 6 == 3 || i % 6 == 4 ? 1 : -1;
      const Eigen::Matrix3d R = random.rotation<3>();
      Eigen::Matrix3d J;
      for(int k = 0; k < 3; ++k)
        J.col(order[k]) = R.col(k) * expected[k] * (k == 2 ? parity : 1);
      Signed_svd<3> svd;
      signed_svd(J, svd);
      for(const Eigen::Vector3d& s : {svd.s, signed_singular_values(J)})
        for(int k = 0; k < 3; ++k)
          BOOST_TEST_REQUIRE(std::abs(s[k] / expected[k] - 1) < 1e-13);
    }
}

// A tetrahedron about to collapse: the sign of the smallest singular value decides whether it is flipped.
BOOST_AUTO_TEST_CASE(sign_and_size_near_collapse)
{
  Random random(5);
  for(double small : {1e-4, 1e-8, 1e-11})
    for(int i = 0; i < 1000; ++i)
      for(double sign : {1., -1.}) {
        const Eigen::Matrix3d J = with_values(random, 1.5, 0.7, sign * small);
        Signed_svd<3> svd;
        signed_svd(J, svd);
        for(double s : {svd.s[2], signed_singular_values(J)[2]})
          BOOST_TEST_REQUIRE(std::abs(s - sign * small) < 4e-15);
      }
}

BOOST_AUTO_TEST_SUITE_END() // test_signed_svd_3
