// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Preconditioners and all energies: matrices are positive semidefinite, SLIM's weights are positive and reproduce the gradient,
// and Hessians agree with differences.

#include "support/unit_test.h"

#include "support/all_energies.h"
#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim_newton.h>

#include <algorithm>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_preconditioners_of_energies)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
std::vector<Vector<D>> samples(double range)
{
  Random random(21);
  std::vector<Vector<D>> result{Vector<D>::Ones(), Vector<D>::Constant(0.4), Vector<D>::Constant(2.5)};
  for(int k = 0; k < 100; ++k) {
    Vector<D> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(random(-range, range));
    // Some nearly equal ones.
    if(k % 4 == 0)
      s[1] = s[0] * (1 - std::pow(10, -1 - k / 7.));
    std::sort(s.data(), s.data() + D, [](double a, double b) { return a > b; });
    result.push_back(s);
  }
  return result;
}

template <int D>
void check_matrix(const Full_matrix<D>& full)
{
  BOOST_TEST(full.allFinite());
  BOOST_TEST((full - full.transpose()).norm() <= 1e-14 * full.norm());
  BOOST_TEST(relative_smallest_eigenvalue(full) >= -1e-14);
  BOOST_TEST(full.norm() > 0);
}

template <int D, typename Energy, typename Preconditioner>
void check_positive_semidefinite(const Energy& energy, const Preconditioner& preconditioner)
{
  for(const Vector<D>& s : samples<D>(5))
    check_matrix<D>(frame_matrix<D>(preconditioner, energy, s));
}

template <int D, typename Energy>
void check_all(const Energy& energy)
{
  check_positive_semidefinite<D>(energy, FFM::Projected_newton());
  check_positive_semidefinite<D>(energy, FFM::Slim());
  check_positive_semidefinite<D>(energy, FFM::Slim_newton());
  check_positive_semidefinite<D>(energy, FFM::Killing());
  check_positive_semidefinite<D>(energy, FFM::Killing{FFM::Killing_weight::stiffness});
  check_positive_semidefinite<D>(energy, FFM::Laplacian());
}

// 2 W^T W (J - U diag(t) V^T) = dpsi/dJ, in the frame of the singular vectors.
template <int D, typename Energy>
void check_slim(const Energy& energy)
{
  const double smallest = 1e-6 * FFM::internal::curvature_at_identity<D>(energy);
  int compared = 0;
  for(const Vector<D>& s : samples<D>(2)) {
    const FFM::Element_state<D> state = state_at<D>(s, energy);
    FFM::Increment_form<D> form;
    FFM::Slim().form(state, energy, form);
    const Vector<D> target = FFM::internal::slim_target<D>(energy, s);
    for(int i = 0; i < D; ++i) {
      const double weight = form.stretch(i, i);
      BOOST_TEST(weight >= smallest);
      if(weight == smallest || std::abs(s[i] - target[i]) < 1e-6 * target[i])
        continue;
      BOOST_TEST(std::abs(weight * (s[i] - target[i]) - state.gradient[i]) <= 1e-12 * std::abs(state.gradient[i]));
      ++compared;
    }
  }
  BOOST_TEST(compared > 100);
}

// The Hessian on Jacobians against differences of the energy, by way of another decomposition.
template <int D, typename Energy>
void check_hessian(const Energy& energy)
{
  typedef Eigen::Matrix<double, D, D> Jacobian;
  const auto value = [&energy](const Jacobian& J) { return energy.template value<D>(singular_values(J)); };
  Random random(22);
  for(int k = 0; k < 12; ++k) {
    // Away from 1 and from each other, where energies with absolute values and maxima have kinks.
    Vector<D> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(0.45 * (i - 0.5 * (D - 1)) + 0.2 + random(-0.1, 0.1));
    const Jacobian J = random.rotation<D>() * s.asDiagonal() * random.rotation<D>();
    const Eigen::MatrixXd hessian = full_matrix<D>(FFM::Newton(), energy, J);
    BOOST_TEST((hessian - hessian_by_differences<D>(value, J)).norm() <= 1e-6 * hessian.norm());
  }
}

// The Killing operator, scaled until no element is stiffer against stretching than the form says, and not more.
template <int D, typename Energy>
void check_stiff_killing(const Energy& energy)
{
  int scaled = 0;
  for(const Vector<D>& s : samples<D>(1)) {
    const FFM::Element_state<D> state = state_at<D>(s, energy);
    FFM::Increment_form<D> plain, stiff;
    FFM::Killing().form(state, energy, plain);
    FFM::Killing{FFM::Killing_weight::stiffness}.form(state, energy, stiff);
    const double factor = stiff.stretch(0, 0) / plain.stretch(0, 0);
    BOOST_TEST(
      (frame_matrix<D>(FFM::Killing{FFM::Killing_weight::stiffness}, energy, s) - factor * frame_matrix<D>(FFM::Killing(), energy, s))
        .norm() <= 1e-12 * factor * plain.stretch.norm());
    double largest = 0;
    for(int i = 0; i < D; ++i)
      largest = (std::max)(largest, state.hessian(i, i) / plain.stretch(i, i));
    BOOST_TEST(factor == (std::max)(1., largest), boost::test_tools::tolerance(1e-12));
    scaled += factor > 1;
  }
  BOOST_TEST(scaled > 0);
}

template <typename Energy>
void check_majorization()
{
  check_positive_semidefinite<2>(Energy(), FFM::Composite_majorization<true>());
  check_positive_semidefinite<2>(Energy(), FFM::Composite_majorization<false>());
}

} // namespace

BOOST_AUTO_TEST_CASE(all_are_positive_semidefinite)
{
  for(const FFM::Any_energy& energy : energies_with_barrier()) {
    BOOST_TEST_CONTEXT(energy.energy_name())
    {
      check_all<2>(energy);
      check_all<3>(energy);
    }
  }
}

BOOST_AUTO_TEST_CASE(killing_by_stiffness)
{
  check_stiff_killing<2>(FFM::Any_energy(FFM::Exponential_symmetric_dirichlet()));
  check_stiff_killing<3>(FFM::Any_energy(FFM::Exponential_symmetric_dirichlet()));
  check_stiff_killing<2>(FFM::Any_energy(FFM::Symmetric_dirichlet()));
}

BOOST_AUTO_TEST_CASE(hessians_of_all_energies)
{
  std::vector<FFM::Any_energy> energies = energies_with_barrier();
  energies.emplace_back(FFM::Arap());
  for(const FFM::Any_energy& energy : energies) {
    BOOST_TEST_CONTEXT(energy.energy_name())
    {
      check_hessian<2>(energy);
      check_hessian<3>(energy);
    }
  }
}

BOOST_AUTO_TEST_CASE(slim_reproduces_the_gradient)
{
  for(const FFM::Any_energy& energy : energies_with_barrier()) {
    BOOST_TEST_CONTEXT(energy.energy_name())
    {
      check_slim<2>(energy);
      check_slim<3>(energy);
    }
  }
  check_slim<2>(FFM::Arap());
  check_slim<3>(FFM::Arap());
}

BOOST_AUTO_TEST_CASE(majorizations_are_positive_semidefinite)
{
  check_majorization<FFM::Exponential_symmetric_dirichlet>();
  check_majorization<FFM::Symmetric_gradient>();
  check_majorization<FFM::Symmetric_arap>();
  check_majorization<FFM::Arap>();
  check_majorization<FFM::Hencky>();
  check_majorization<FFM::Aigerman_isometric>();
}

// The default preconditioner chooses by shape, whatever the energy's value at the identity.
BOOST_AUTO_TEST_CASE(slim_newton_chooses_by_shape)
{
  for(const FFM::Any_energy& energy : energies_with_barrier()) {
    BOOST_TEST_CONTEXT(energy.energy_name())
    {
      const Vector<2> good(1.5, 0.7), bad(2, 0.1);
      BOOST_TEST((frame_matrix<2>(FFM::Slim_newton(), energy, good) - frame_matrix<2>(FFM::Projected_newton(), energy, good)).norm() == 0);
      BOOST_TEST((frame_matrix<2>(FFM::Slim_newton(), energy, bad) - frame_matrix<2>(FFM::Slim(), energy, bad)).norm() == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_preconditioners_of_energies
