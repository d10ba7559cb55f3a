// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The largest step against exact rational arithmetic, and the line search's promises.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/elements/largest_flip_free_step.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_largest_step)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef CGAL::Exact_rational Rational;
typedef std::vector<Rational> Polynomial; // coefficients, constant first

const double infinity = std::numeric_limits<double>::infinity();

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

void trim(Polynomial& p)
{
  while(!p.empty() && p.back() == 0)
    p.pop_back();
}

// det(edges + a increment) as a polynomial in a, exactly.
Polynomial determinant(const Matrix<2>& edges, const Matrix<2>& increment)
{
  const auto E = [&](int i, int j) { return Rational(edges(i, j)); };
  const auto I = [&](int i, int j) { return Rational(increment(i, j)); };
  return {E(0, 0) * E(1, 1) - E(0, 1) * E(1, 0), E(0, 0) * I(1, 1) + I(0, 0) * E(1, 1) - E(0, 1) * I(1, 0) - I(0, 1) * E(1, 0),
          I(0, 0) * I(1, 1) - I(0, 1) * I(1, 0)};
}

Polynomial determinant(const Matrix<3>& edges, const Matrix<3>& increment)
{
  Polynomial p(4);
  const int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for(int k = 0; k < 6; ++k)
    for(int mask = 0; mask < 8; ++mask) {
      Rational product = k < 3 ? 1 : -1;
      int degree = 0;
      for(int i = 0; i < 3; ++i) {
        const bool moves = (mask >> i) & 1;
        degree += moves;
        product *= Rational(moves ? increment(i, permutations[k][i]) : edges(i, permutations[k][i]));
      }
      p[degree] += product;
    }
  return p;
}

Rational value(const Polynomial& p, const Rational& a)
{
  Rational result = 0;
  for(std::size_t i = p.size(); i-- > 0;)
    result = result * a + p[i];
  return result;
}

int sign(const Rational& r) { return r > 0 ? 1 : r < 0 ? -1 : 0; }

// Distinct real roots in (0, end], or in (0, infinity) when `end` is null, by Sturm's theorem; p(0) must not vanish.
int number_of_roots(Polynomial p, const Rational* end)
{
  trim(p);
  std::vector<Polynomial> chain{p};
  Polynomial derivative;
  for(std::size_t i = 1; i < p.size(); ++i)
    derivative.push_back(p[i] * Rational(static_cast<int>(i)));
  trim(derivative);
  if(!derivative.empty())
    chain.push_back(derivative);
  while(chain.size() > 1) {
    Polynomial remainder = chain[chain.size() - 2];
    const Polynomial& divisor = chain.back();
    while(remainder.size() >= divisor.size()) {
      const Rational factor = remainder.back() / divisor.back();
      for(std::size_t i = 0; i < divisor.size(); ++i)
        remainder[remainder.size() - divisor.size() + i] -= factor * divisor[i];
      remainder.pop_back();
    }
    trim(remainder);
    if(remainder.empty())
      break;
    for(Rational& coefficient : remainder)
      coefficient = -coefficient;
    chain.push_back(remainder);
  }
  const auto variations = [&chain](auto&& sign_of) {
    int count = 0, last = 0;
    for(const Polynomial& q : chain) {
      const int s = sign_of(q);
      count += s != 0 && last != 0 && s != last;
      last = s != 0 ? s : last;
    }
    return count;
  };
  const int at_zero = variations([](const Polynomial& q) { return sign(q.front()); });
  const int at_end = variations([end](const Polynomial& q) { return end != nullptr ? sign(value(q, *end)) : sign(q.back()); });
  return at_zero - at_end;
}

// No root up to a step shorter by the tolerance, and one up to a step longer by it; "" when all is well. Roots beyond `most`
// do not matter.
template <int D>
std::string fault(const Matrix<D>& edges, const Matrix<D>& increment, double most = infinity)
{
  const double tolerance = 1e-9;
  const Polynomial p = determinant(edges, increment);
  if(!(p[0] > 0))
    return "the element is not positively oriented";
  const double step = FFM::largest_flip_free_step(edges, increment);
  if(!(step > 0))
    return "the step is not positive";
  if(step > most || step == infinity) {
    const Rational end = most < infinity ? Rational(most) : Rational(0);
    return number_of_roots(p, most < infinity ? &end : nullptr) == 0 ? "" : "a collapse is not found";
  }
  const Rational shorter = Rational(step) * Rational(1 - tolerance), longer = Rational(step) * Rational(1 + tolerance);
  if(number_of_roots(p, &shorter) != 0)
    return "the step is too long";
  if(number_of_roots(p, &longer) == 0)
    return "the step is too short";
  return "";
}

template <int D>
Matrix<D> positive(Matrix<D> m)
{
  if(m.determinant() < 0)
    m.col(0) *= -1;
  return m;
}

template <int D>
int number_of_faults(std::uint64_t seed, int samples, double edge_scale, double increment_scale, int* finite = nullptr)
{
  Random random(seed);
  int faults = 0;
  for(int k = 0; k < samples; ++k) {
    const Matrix<D> edges = edge_scale * positive<D>(random.matrix<D>());
    const Matrix<D> increment = increment_scale * random.matrix<D>();
    faults += !fault<D>(edges, increment).empty();
    if(finite != nullptr)
      *finite += FFM::largest_flip_free_step(edges, increment) != infinity;
  }
  return faults;
}

// Elements whose last edge vector has been shortened to `thinness`, so that they are nearly flat, in coordinates in which
// that costs no digits.
template <int D>
int number_of_needle_faults(double thinness)
{
  Random random(33);
  int faults = 0;
  for(int k = 0; k < 300; ++k) {
    Matrix<D> edges = Matrix<D>::Identity();
    for(int i = 0; i < D; ++i)
      for(int j = i + 1; j < D; ++j)
        edges(i, j) = random(-1, 1);
    edges.row(D - 1) *= thinness;
    faults += !fault<D>(edges, random.matrix<D>()).empty();
  }
  return faults;
}

FFM::Line_search_result search(const std::vector<double>* values, double energy_0, double slope, double largest, bool extend,
                               const FFM::Map_options& options = FFM::Map_options())
{
  std::size_t i = 0;
  return FFM::line_search([&](double) { return (*values)[i++ % values->size()]; }, energy_0, slope, largest, extend, options);
}

} // namespace

BOOST_AUTO_TEST_CASE(sturm)
{
  // (a - 1)(a - 2)(a - 3)
  const Polynomial p{Rational(-6), Rational(11), Rational(-6), Rational(1)};
  const Rational ends[4] = {Rational(1) / Rational(2), Rational(1), Rational(2), Rational(10)};
  const int expected[4] = {0, 1, 2, 3};
  for(int i = 0; i < 4; ++i)
    BOOST_TEST(number_of_roots(p, &ends[i]) == expected[i]);
  BOOST_TEST(number_of_roots(p, nullptr) == 3);
  BOOST_TEST(number_of_roots({Rational(1), Rational(-2), Rational(1)}, nullptr) == 1);
  BOOST_TEST(number_of_roots({Rational(1), Rational(0), Rational(1)}, nullptr) == 0);
  BOOST_TEST(number_of_roots({Rational(1)}, nullptr) == 0);
}

BOOST_AUTO_TEST_CASE(random_elements)
{
  int finite_2 = 0, finite_3 = 0;
  BOOST_TEST(number_of_faults<2>(31, 3000, 1, 1, &finite_2) == 0);
  BOOST_TEST(number_of_faults<3>(32, 1500, 1, 1, &finite_3) == 0);
  // Both cases must have been seen.
  BOOST_TEST((finite_2 > 500 && finite_2 < 2900));
  BOOST_TEST((finite_3 > 500 && finite_3 < 1490));
}

BOOST_AUTO_TEST_CASE(increments_of_other_sizes)
{
  for(double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    BOOST_TEST(number_of_faults<2>(34, 300, 1, scale) == 0, "triangles, increment times " << scale);
    BOOST_TEST(number_of_faults<3>(35, 300, 1, scale) == 0, "tetrahedra, increment times " << scale);
  }
}

BOOST_AUTO_TEST_CASE(tiny_and_huge_elements)
{
  for(double scale : {1e-150, 1e-100, 1e-60, 1e-30, 1e30, 1e60, 1e100, 1e150})
    BOOST_TEST(number_of_faults<2>(36, 300, scale, scale) == 0, "triangles of size " << scale);
  for(double scale : {1e-100, 1e-60, 1e-30, 1e30, 1e60, 1e100})
    BOOST_TEST(number_of_faults<3>(37, 300, scale, scale) == 0, "tetrahedra of size " << scale);
}

BOOST_AUTO_TEST_CASE(needles)
{
  for(double thinness : {1e-3, 1e-6, 1e-12, 1e-30}) {
    BOOST_TEST(number_of_needle_faults<2>(thinness) == 0, "triangles, " << thinness);
    BOOST_TEST(number_of_needle_faults<3>(thinness) == 0, "tetrahedra, " << thinness);
  }
}

// Increments of lower rank: the leading coefficients vanish exactly, or are nothing but rounding, which makes roots far away.
BOOST_AUTO_TEST_CASE(vanishing_leading_coefficients)
{
  Random random(38);
  int faults = 0;
  for(int k = 0; k < 500; ++k) {
    Matrix<2> increment_2 = random.matrix<2>();
    increment_2.col(1).setZero();
    faults += !fault<2>(positive<2>(random.matrix<2>()), increment_2).empty();

    Matrix<3> increment_3 = random.matrix<3>();
    increment_3.col(2).setZero(); // a quadratic
    faults += !fault<3>(positive<3>(random.matrix<3>()), increment_3).empty();
    increment_3.col(1).setZero(); // linear
    faults += !fault<3>(positive<3>(random.matrix<3>()), increment_3).empty();

    const Eigen::Vector2d u(random(-1, 1), random(-1, 1)), v(random(-1, 1), random(-1, 1));
    faults += !fault<2>(positive<2>(random.matrix<2>()), Matrix<2>(u * v.transpose()), 1e6).empty();
    const Eigen::Vector3d p = random.matrix<3>().col(0), q = random.matrix<3>().col(0);
    faults += !fault<3>(positive<3>(random.matrix<3>()), Matrix<3>(p * q.transpose()), 100).empty();
  }
  BOOST_TEST(faults == 0);
  BOOST_TEST(FFM::largest_flip_free_step(Matrix<2>(Matrix<2>::Identity()), Matrix<2>(Matrix<2>::Zero())) == infinity);
  BOOST_TEST(FFM::largest_flip_free_step(Matrix<3>(Matrix<3>::Identity()), Matrix<3>(Matrix<3>::Zero())) == infinity);
}

BOOST_AUTO_TEST_CASE(special_roots)
{
  const Matrix<2> one_2 = Matrix<2>::Identity();
  const Matrix<3> one_3 = Matrix<3>::Identity();
  // Double and triple roots: (1 - a/2)^D.
  BOOST_TEST(std::abs(FFM::largest_flip_free_step(one_2, Matrix<2>(-0.5 * one_2)) - 2) <= 1e-9);
  BOOST_TEST(std::abs(FFM::largest_flip_free_step(one_3, Matrix<3>(-0.5 * one_3)) - 2) <= 1e-4);
  // (1 - a)^2 (1 + a): the double root touches zero only.
  BOOST_TEST(std::abs(FFM::largest_flip_free_step(one_3, Matrix<3>(Eigen::Vector3d(-1, -1, 1).asDiagonal())) - 1) <= 1e-7);
  // (1 + a)^D and rotations by 90 degrees, 1 + a^2: no collapse.
  BOOST_TEST(FFM::largest_flip_free_step(one_2, one_2) == infinity);
  BOOST_TEST(FFM::largest_flip_free_step(one_3, one_3) == infinity);
  Matrix<2> quarter_2;
  quarter_2 << 0, -1, 1, 0;
  BOOST_TEST(FFM::largest_flip_free_step(one_2, quarter_2) == infinity);
  Matrix<3> quarter_3 = Matrix<3>::Zero();
  quarter_3.topLeftCorner<2, 2>() = quarter_2;
  BOOST_TEST(FFM::largest_flip_free_step(one_3, quarter_3) == infinity);
  // (1 - a)(1 - a/2)(1 - a/3), all scales of the parameter.
  for(double scale : {1e-8, 1., 1e8}) {
    const Matrix<3> increment = (-scale * Eigen::Vector3d(1. / 3, 1, 0.5)).asDiagonal();
    BOOST_TEST(std::abs(FFM::largest_flip_free_step(one_3, increment) * scale - 1) <= 1e-9);
  }
}

// Nearly double roots: rounding decides whether there is one, but no step may pass an interval in which the element is clearly
// flipped.
BOOST_AUTO_TEST_CASE(nearly_double_roots)
{
  Random random(39);
  int faults_2 = 0, faults_3 = 0;
  for(int k = 0; k < 300; ++k) {
    const double gap = std::pow(10, random(-7, -1));
    const Matrix<2> turn_2 = random.rotation<2>(), back_2 = random.rotation<2>();
    const Matrix<2> increment_2 = turn_2 * Eigen::Vector2d(-1, -1 / (1 + gap)).asDiagonal() * back_2;
    faults_2 += std::abs(FFM::largest_flip_free_step(Matrix<2>(turn_2 * back_2), increment_2) - 1) > 1e-15 / gap + 1e-12;
    const Matrix<3> turn_3 = random.rotation<3>(), back_3 = random.rotation<3>();
    const Matrix<3> increment_3 = turn_3 * Eigen::Vector3d(-1, -1 / (1 + gap), 0.5).asDiagonal() * back_3;
    faults_3 += std::abs(FFM::largest_flip_free_step(Matrix<3>(turn_3 * back_3), increment_3) - 1) > 1e-14 / gap + 1e-12;
  }
  BOOST_TEST(faults_2 == 0);
  BOOST_TEST(faults_3 == 0);
}

BOOST_AUTO_TEST_CASE(nan_and_infinity_are_never_accepted)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FFM::Map_options options;
  for(double bad : {nan, infinity}) {
    const std::vector<double> always{bad};
    const auto none = search(&always, 1, -1, infinity, true);
    BOOST_TEST(!none.success);
    BOOST_TEST(none.step == 0);
    BOOST_TEST(none.evaluations == options.max_line_search_steps);

    // Good only close to the start.
    for(bool extend : {false, true}) {
      const auto near = FFM::line_search([=](double a) { return a < 0.01 ? 1 - a : bad; }, 1, -1, infinity, extend, options);
      BOOST_TEST(near.success);
      BOOST_TEST((near.step > 0 && near.step < 0.01));
      BOOST_TEST(near.energy == 1 - near.step);
      // Bad beyond the first step, where the extension goes.
      const auto first = FFM::line_search([=](double a) { return a <= 1 ? 1 - a : bad; }, 1, -1, infinity, extend, options);
      BOOST_TEST(first.success);
      BOOST_TEST(first.step == 1);
      BOOST_TEST(first.energy == 0);
    }
  }
}

// Where steps are so short that the decrease asked for is below rounding, an equal energy is no decrease.
BOOST_AUTO_TEST_CASE(equal_energies_are_no_decrease)
{
  const std::vector<double> constant{1};
  for(bool extend : {false, true})
    for(double slope : {-1., -1e-10, -1e-20})
      BOOST_TEST(!search(&constant, 1, slope, infinity, extend).success);
}

BOOST_AUTO_TEST_CASE(evaluations_are_bounded)
{
  for(int most : {1, 2, 7, 60}) {
    FFM::Map_options options;
    options.max_line_search_steps = most;
    const std::vector<double> too_large{5};
    BOOST_TEST(search(&too_large, 1, -1, infinity, true, options).evaluations == most);
    BOOST_TEST(!search(&too_large, 1, -1, infinity, true, options).success);
    // Falls forever: the extension must end as well.
    int calls = 0;
    const auto falling = FFM::line_search(
      [&](double a) {
        ++calls;
        return -a * a;
      },
      0, -1, infinity, true, options);
    BOOST_TEST(falling.success);
    BOOST_TEST(falling.evaluations == calls);
    BOOST_TEST(calls <= most);
  }
}

BOOST_AUTO_TEST_CASE(armijo_bounds_and_extension)
{
  Random random(40);
  int extended = 0, shortened = 0;
  for(int k = 0; k < 2000; ++k) {
    FFM::Map_options options;
    options.armijo = random(1e-4, 0.4);
    options.step_fraction = random(0.5, 0.99);
    // Barrier functions: -log(1 - a / pole) grows to infinity at the pole.
    const double slope = -std::exp(random(-5, 5)), curvature = std::exp(random(-5, 8));
    const double pole = std::exp(random(-6, 6)), strength = std::exp(random(-8, 0));
    const auto energy = [=](double a) {
      return a < pole ? 3 + (slope - strength / pole) * a + 0.5 * curvature * a * a - strength * std::log1p(-a / pole) : infinity;
    };
    const auto plain = FFM::line_search(energy, 3, slope, pole, false, options);
    const auto extending = FFM::line_search(energy, 3, slope, pole, true, options);
    for(const auto& found : {plain, extending}) {
      BOOST_TEST_REQUIRE(found.success);
      BOOST_TEST(found.energy == energy(found.step));
      BOOST_TEST(found.energy <= 3 + options.armijo * found.step * slope);
      BOOST_TEST((found.step > 0 && found.step <= options.step_fraction * pole));
    }
    BOOST_TEST(plain.step <= 1);
    BOOST_TEST(extending.energy <= plain.energy);
    BOOST_TEST(extending.step >= plain.step);
    extended += extending.step > plain.step;
    shortened += plain.step < std::min(1., options.step_fraction * pole);
    if(extending.step > plain.step) {
      BOOST_TEST(extending.energy < plain.energy);
    }
  }
  // All branches must have been seen.
  BOOST_TEST(extended > 100);
  BOOST_TEST(shortened > 100);
}

// Every step that was tried is the first one times a power of the factor, and the last is the first that suffices.
BOOST_AUTO_TEST_CASE(plain_backtracking)
{
  Random random(41);
  int beyond = 0, shortened = 0;
  for(int k = 0; k < 500; ++k) {
    FFM::Map_options options;
    options.backtracking = random(0.1, 0.95);
    options.begin_with_largest_step = k % 2 == 0;
    options.max_line_search_steps = 1000;
    const double slope = -std::exp(random(-5, 5)), curvature = std::exp(random(-5, 8)), pole = std::exp(random(-6, 6));
    std::vector<double> steps;
    const auto energy = [&](double a) {
      steps.push_back(a);
      return a < pole ? 3 + slope * a + 0.5 * curvature * a * a : infinity;
    };
    const FFM::Line_search_result found = FFM::line_search(energy, 3, slope, pole, true, options);
    BOOST_TEST_REQUIRE(found.success);
    BOOST_TEST(found.step == steps.back());
    BOOST_TEST(found.evaluations == static_cast<int>(steps.size()));
    BOOST_TEST(steps.front() == (k % 2 == 0 ? 0.95 * pole : std::min(1., 0.95 * pole)));
    for(std::size_t i = 0; i < steps.size(); ++i) {
      BOOST_TEST(steps[i] == steps[0] * std::pow(options.backtracking, i), boost::test_tools::tolerance(1e-12));
      const double bound = 3 + 1e-4 * steps[i] * slope, value = 3 + slope * steps[i] + 0.5 * curvature * steps[i] * steps[i];
      BOOST_TEST((value <= bound) == (i + 1 == steps.size()));
    }
    beyond += found.step > 1;
    shortened += steps.size() > 1;
  }
  BOOST_TEST(beyond > 20);
  BOOST_TEST(shortened > 100);
  // Where nothing collapses there is no largest step.
  FFM::Map_options options;
  options.backtracking = 0.5;
  options.begin_with_largest_step = true;
  BOOST_TEST(FFM::line_search([](double a) { return -a; }, 0, -1, infinity, true, options).step == 1);
}

BOOST_AUTO_TEST_CASE(full_step_first)
{
  int calls = 0;
  const auto parabola = [&calls](double a) {
    ++calls;
    return 0.5 * (a - 1) * (a - 1);
  };
  // The parabola whose minimum is the full step: one energy is enough, extended or not.
  for(bool extend : {false, true}) {
    calls = 0;
    const auto found = FFM::line_search(parabola, 0.5, -1, infinity, extend, FFM::Map_options());
    BOOST_TEST(found.success);
    BOOST_TEST(found.step == 1);
    BOOST_TEST(calls == 1);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_largest_step
