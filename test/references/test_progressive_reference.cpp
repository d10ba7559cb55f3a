// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Progressive references on elements whose Jacobians are given: what distortion they leave, what they leave alone,
// and when they end.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/references/Progressive_reference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_progressive_reference)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

// Elements without common vertices, each with a random rest shape and a Jacobian of its own.
template <int D>
struct Elements
{
  explicit Elements(const std::vector<Matrix<D>>& jacobians)
  {
    Random random(3);
    const std::int32_t n = static_cast<std::int32_t>(jacobians.size());
    std::vector<std::array<std::int32_t, D + 1>> elements(n);
    std::vector<Matrix<D>> rest_edges;
    for(std::int32_t e = 0; e < n; ++e) {
      for(int k = 0; k <= D; ++k)
        elements[e][k] = (D + 1) * e + k;
      rest_edges.push_back(random(0.5, 2) * (Matrix<D>::Identity() + random.matrix<D>(-0.25, 0.25)));
    }
    domain = scaled_domain<D>((D + 1) * n, elements, rest_edges);
    set(jacobians);
  }

  void set(const std::vector<Matrix<D>>& jacobians)
  {
    x.setZero(D, domain.number_of_vertices);
    for(std::size_t e = 0; e < jacobians.size(); ++e)
      x.template middleCols<D>((D + 1) * e + 1) = jacobians[e] * domain.rest_inverses[e].inverse();
  }

  FFM::Simplicial_domain<D> domain;
  FFM::Positions<D> x;
};

template <int D>
Matrix<D> with_singular_values(Random& random, const Vector<D>& s)
{
  return random.rotation<D>() * s.asDiagonal() * random.rotation<D>();
}

template <int D>
double distortion(const Matrix<D>& J)
{
  return (J.squaredNorm() + J.inverse().squaredNorm()) / (2 * D);
}

// A good element for each bad one; the worst singular values are 1/120 and 150.
template <int D>
std::vector<Matrix<D>> bad_and_good()
{
  Random random(5);
  std::vector<Matrix<D>> jacobians;
  for(int k = 0; k < 20; ++k) {
    Vector<D> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(random(-1, 1));
    jacobians.push_back(with_singular_values<D>(random, s));
    s[k % D] = k % 2 == 0 ? random(20, 150) : 1 / random(20, 120);
    jacobians.push_back(with_singular_values<D>(random, s));
  }
  return jacobians;
}

template <int D>
Matrix<D> reference_jacobian(const FFM::Progressive_reference& reference, const Elements<D>& elements, std::int64_t e)
{
  return elements.domain.image_edges(e, elements.x) * reference.rest_inverse(elements.domain, e);
}

// U diag(f(s_i)) V^T.
template <int D, typename Function>
Matrix<D> mapped(const Matrix<D>& J, Function&& f)
{
  const Singular_value_decomposition<D> svd(J);
  return svd.U * Vector<D>(svd.s.unaryExpr(f)).asDiagonal() * svd.V.transpose();
}

template <int D>
void check_interpolation(FFM::Interpolation interpolation, bool is_common)
{
  const std::vector<Matrix<D>> jacobians = bad_and_good<D>();
  const Elements<D> elements(jacobians);
  FFM::Progressive_reference reference;
  reference.interpolation = interpolation;
  reference.has_common_parameter = is_common;
  reference.restart();
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  const double K = reference.bound, m = std::sqrt(K + std::sqrt(K * K - 1));
  const bool is_projection = interpolation == FFM::Interpolation::projection;
  const auto between = [&](double s, double t) {
    return is_projection                                      ? std::min(std::max(s, 1 / m), m)
           : interpolation == FFM::Interpolation::exponential ? std::pow(s, t)
                                                              : t * s + 1 - t;
  };

  // The largest t that keeps the distortion of one element within K.
  const auto largest_parameter = [&](const Matrix<D>& J) {
    const auto exceeds = [&](double t) { return distortion<D>(mapped<D>(J, [&](double s) { return between(s, t); })) > K; };
    double low = 0, high = 1;
    if(!exceeds(high))
      return high;
    for(int i = 0; i < 50; ++i)
      (exceeds(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  };
  double common = 1;
  if(!is_projection)
    for(const Matrix<D>& J : jacobians)
      common = std::min(common, largest_parameter(J));

  double largest = 0;
  for(std::size_t e = 0; e < jacobians.size(); ++e) {
    const Matrix<D> J = reference_jacobian<D>(reference, elements, e);
    const bool is_bad = distortion<D>(jacobians[e]) > K;
    largest = std::max(largest, distortion<D>(J));
    BOOST_TEST(distortion<D>(J) <= K * (1 + 1e-10));
    const double t = is_projection || is_common ? common : largest_parameter(jacobians[e]);
    const Matrix<D> expected = mapped<D>(jacobians[e], [&](double s) { return between(s, t); });
    BOOST_TEST((J - expected).norm() <= 1e-9 * expected.norm());
    if(!is_projection && !is_common && is_bad)
      BOOST_TEST(std::abs(distortion<D>(J) - K) <= 1e-9 * K);
    if(!is_projection && !is_common && !is_bad)
      BOOST_TEST((reference.rest_inverse(elements.domain, e) - elements.domain.rest_inverses[e]).norm() <=
                 1e-12 * elements.domain.rest_inverses[e].norm());
    BOOST_TEST(std::abs(reference.weight(elements.domain, e) * double(jacobians.size()) - 1) <= 1e-15);
  }
  if(!is_projection)
    BOOST_TEST(std::abs(largest - K) <= 1e-9 * K);
}

template <int D>
void check_all_interpolations()
{
  for(const auto interpolation : {FFM::Interpolation::exponential, FFM::Interpolation::linear})
    for(const bool is_common : {true, false})
      check_interpolation<D>(interpolation, is_common);
  check_interpolation<D>(FFM::Interpolation::projection, false);
  check_interpolation<D>(FFM::Interpolation::projection, true);
}

template <int D>
void check_is_rest_shape(const FFM::Progressive_reference& reference, const FFM::Simplicial_domain<D>& domain)
{
  bool is_same = true;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    is_same = is_same && reference.rest_inverse(domain, e) == domain.rest_inverses[e] && reference.weight(domain, e) == domain.measures[e];
  BOOST_TEST(is_same);
}

// `bad` of 200 elements with the distortion `value`, isometries otherwise.
template <int D>
std::vector<Matrix<D>> partly_distorted(int bad, double value)
{
  Random random(9);
  std::vector<Matrix<D>> jacobians;
  for(int k = 0; k < 200; ++k) {
    // (s^2 + s^-2) / 2 = 1 + D (value - 1) for the one singular value that is not 1
    const double v = 1 + D * (value - 1);
    Vector<D> s = Vector<D>::Ones();
    if(k < bad)
      s[0] = std::sqrt(v + std::sqrt(v * v - 1));
    jacobians.push_back(with_singular_values<D>(random, s));
  }
  return jacobians;
}

template <int D>
void check_switching()
{
  // With algorithm 1 no element may be beyond K.
  Elements<D> elements(partly_distorted<D>(1, 1000));
  FFM::Progressive_reference reference;
  reference.distorted_fraction = 0;
  reference.restart();
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  elements.set(partly_distorted<D>(0, 1000));
  BOOST_TEST(reference.update(elements.domain, elements.x));
  check_is_rest_shape<D>(reference, elements.domain);

  // Once it is the rest shape it remains so until a new run begins.
  elements.set(partly_distorted<D>(100, 1000));
  BOOST_TEST(reference.update(elements.domain, elements.x));
  check_is_rest_shape<D>(reference, elements.domain);
  reference.restart();
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  BOOST_TEST((reference.rest_inverse(elements.domain, 0) != elements.domain.rest_inverses[0]));

  // With section 3.6 a percent of them may.
  reference = FFM::Progressive_reference();
  reference.restart();
  elements.set(partly_distorted<D>(3, 1000));
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  elements.set(partly_distorted<D>(2, 1000));
  BOOST_TEST(reference.update(elements.domain, elements.x));

  reference.distorted_fraction = 0;

  // Elements count by their distortion: within K nothing is wrong with them.
  reference.restart();
  elements.set(partly_distorted<D>(200, reference.bound * (1 - 1e-9)));
  BOOST_TEST(reference.update(elements.domain, elements.x));
  reference.restart();
  elements.set(partly_distorted<D>(200, reference.bound * (1 + 1e-9)));
  BOOST_TEST(!reference.update(elements.domain, elements.x));

  // The decrease of the mean distortion in one iteration, relative to the later one. It is far from 0.01 in the first.
  for(const double decrease : {0.0099, -0.0099, 0.0101, -0.0101, 0.5}) {
    reference.restart();
    elements.set(partly_distorted<D>(200, 400));
    BOOST_TEST(!reference.update(elements.domain, elements.x));
    BOOST_TEST(reference.relative_decrease() > 1);
    elements.set(partly_distorted<D>(200, 400 / (1 + decrease)));
    BOOST_TEST(reference.update(elements.domain, elements.x) == (std::abs(decrease) < 0.01));
    BOOST_TEST(std::abs(reference.relative_decrease() - decrease) <= 1e-9);
  }

  // The settings decide.
  reference.restart();
  reference.smallest_decrease = 0;
  reference.distorted_fraction = 0.5;
  elements.set(partly_distorted<D>(101, 400));
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  BOOST_TEST(!reference.update(elements.domain, elements.x));
  elements.set(partly_distorted<D>(100, 400));
  BOOST_TEST(reference.update(elements.domain, elements.x));
}

// Distortions of all sizes on elements of all sizes: the mean of (11) is the one of (5), over the areas at rest, while the
// references' weights are alike.
template <int D>
void check_weights()
{
  Random random(31);
  const auto distorted = [&](double most) {
    std::vector<Matrix<D>> jacobians;
    for(int k = 0; k < 60; ++k) {
      Vector<D> s;
      for(int i = 0; i < D; ++i)
        s[i] = std::exp(random(-most, most));
      jacobians.push_back(with_singular_values<D>(random, s));
    }
    return jacobians;
  };
  const std::vector<Matrix<D>> before = distorted(4), after = distorted(3.5);
  Elements<D> elements(before);
  double sums[3] = {0, 0, 0}, plain[2] = {0, 0};
  for(std::size_t e = 0; e < before.size(); ++e) {
    const double area = 1 / elements.domain.rest_inverses[e].determinant();
    sums[0] += area * distortion<D>(before[e]);
    sums[1] += area * distortion<D>(after[e]);
    sums[2] += area;
    plain[0] += distortion<D>(before[e]);
    plain[1] += distortion<D>(after[e]);
  }
  FFM::Progressive_reference reference;
  reference.restart();
  BOOST_TEST_REQUIRE(!reference.update(elements.domain, elements.x));
  elements.set(after);
  BOOST_TEST_REQUIRE(!reference.update(elements.domain, elements.x));
  const double decrease = (sums[0] - sums[1]) / sums[1];
  BOOST_TEST(std::abs(reference.relative_decrease() - decrease) <= 1e-9);
  BOOST_TEST(std::abs(decrease - (plain[0] - plain[1]) / plain[1]) > 1e-3);
  for(std::size_t e = 0; e < before.size(); ++e) {
    const double area = 1 / elements.domain.rest_inverses[e].determinant() / sums[2];
    BOOST_TEST(reference.weight(elements.domain, e) == 1. / 60);
    BOOST_TEST(std::abs(elements.domain.measures[e] - area) <= 1e-12);
  }
}

} // namespace

// Liu et al. 2018, section 3.6.
BOOST_AUTO_TEST_CASE(settings_of_the_paper)
{
  const FFM::Progressive_reference reference;
  BOOST_TEST(reference.bound == 60);
  BOOST_TEST(reference.smallest_decrease == 0.01);
  BOOST_TEST(reference.distorted_fraction == 0.01);
  BOOST_TEST(reference.has_common_parameter);
  BOOST_TEST((reference.interpolation == FFM::Interpolation::exponential));
}

BOOST_AUTO_TEST_CASE(means_are_over_areas_and_weights_alike)
{
  check_weights<2>();
  check_weights<3>();
}

BOOST_AUTO_TEST_CASE(distortion_from_references_is_bounded_2) { check_all_interpolations<2>(); }

BOOST_AUTO_TEST_CASE(distortion_from_references_is_bounded_3) { check_all_interpolations<3>(); }

BOOST_AUTO_TEST_CASE(rest_shape_takes_over_2) { check_switching<2>(); }

BOOST_AUTO_TEST_CASE(rest_shape_takes_over_3) { check_switching<3>(); }

BOOST_AUTO_TEST_SUITE_END() // test_progressive_reference
