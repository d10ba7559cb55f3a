// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Every preconditioner's form as a matrix on the increment of the Jacobian, against the second differential of the energy and
// against the formulas of the papers.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim_newton.h>

#include <algorithm>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_preconditioners)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

template <int D>
std::vector<Vector<D>> singular_value_samples(bool extreme)
{
  Random random(11);
  std::vector<Vector<D>> samples{Vector<D>::Ones(), Vector<D>::Constant(0.4), Vector<D>::Constant(2.5)};
  const auto add = [&samples](Vector<D> s) {
    std::sort(s.data(), s.data() + D, [](double a, double b) { return a > b; });
    samples.push_back(s);
  };
  for(int k = 0; k < 60; ++k) {
    Vector<D> s;
    for(int i = 0; i < D; ++i)
      s[i] = std::exp(random(-1, 1));
    add(s);
    // Two nearly equal ones, from clearly different down to one unit in the last place.
    s[1] = s[0] * (1 + std::pow(10, -16. * k / 60));
    add(s);
  }
  if(extreme)
    for(int k = 0; k < 30; ++k) {
      Vector<D> s;
      const double smallest = std::pow(10, random(-5, -1));
      for(int i = 1; i < D; ++i)
        s[i] = smallest * std::pow(10, random(0, 6));
      s[0] = smallest * 1e6;
      s[D - 1] = smallest;
      add(s);
    }
  return samples;
}

template <int D>
std::vector<Matrix<D>> jacobian_samples(bool extreme = false)
{
  Random random(12);
  std::vector<Matrix<D>> samples;
  for(const Vector<D>& s : singular_value_samples<D>(extreme))
    samples.push_back(random.rotation<D>() * s.asDiagonal() * random.rotation<D>().transpose());
  return samples;
}

template <int D>
Matrix<D> nearest_rotation(const Matrix<D>& J)
{
  const Singular_value_decomposition<D> svd(J);
  return svd.U * svd.V.transpose();
}

template <int D, typename Energy>
Matrix<D> energy_gradient(const Energy& energy, const Matrix<D>& J)
{
  const Singular_value_decomposition<D> svd(J);
  Vector<D> gradient;
  Matrix<D> hessian;
  energy.template derivatives<D>(svd.s, gradient, hessian);
  return svd.U * gradient.asDiagonal() * svd.V.transpose();
}

// By central differences of the gradient, of fourth order.
template <int D, typename Energy>
Full_matrix<D> finite_difference_hessian(const Energy& energy, const Matrix<D>& J)
{
  Full_matrix<D> hessian;
  const double h = 1e-3 * singular_values(J)[D - 1];
  for(int k = 0; k < D * D; ++k) {
    const auto moved = [&](double distance) {
      Matrix<D> result = J;
      result.data()[k] += distance;
      return vec<D>(energy_gradient<D>(energy, result));
    };
    hessian.col(k) = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
  }
  return 0.5 * (hessian + hessian.transpose());
}

// The second differential of (|J|^2 + |J^-1|^2) / (2 D), without singular values, by polarization of
// |dJ|^2 + |M dJ M|^2 + 2 <M, M dJ M dJ M> with M = J^-1; in the directions that are the columns of `directions`.
template <int D>
Full_matrix<D> symmetric_dirichlet_hessian(const Matrix<D>& J, const Full_matrix<D>& directions)
{
  typedef Eigen::Matrix<long double, D, D> Long_matrix;
  const Long_matrix M = J.template cast<long double>().inverse();
  Full_matrix<D> hessian;
  for(int a = 0; a < D * D; ++a)
    for(int b = 0; b < D * D; ++b) {
      const Matrix<D> X = Eigen::Map<const Matrix<D>>(directions.col(a).data());
      const Matrix<D> Y = Eigen::Map<const Matrix<D>>(directions.col(b).data());
      const Long_matrix x = X.template cast<long double>(), y = Y.template cast<long double>();
      const Long_matrix mxm = M * x * M, mym = M * y * M;
      const long double value =
        (x.array() * y.array()).sum() + (mxm.array() * mym.array()).sum() + (M.array() * (mxm * y * M + mym * x * M).array()).sum();
      hessian(a, b) = static_cast<double>(value / D);
    }
  return hessian;
}

template <int D>
Full_matrix<D> projected(const Full_matrix<D>& m)
{
  return with_changed_eigenvalues(m, [](double value) { return value > 0 ? value : 0; });
}

template <int D, typename Preconditioner>
void check_positive_semidefinite(const Preconditioner& preconditioner)
{
  for(const Matrix<D>& J : jacobian_samples<D>(true)) {
    const Full_matrix<D> full = full_matrix<D>(preconditioner, FFM::Symmetric_dirichlet(), J);
    BOOST_TEST(full.allFinite());
    BOOST_TEST((full - full.transpose()).norm() <= 1e-14 * full.norm());
    BOOST_TEST(relative_smallest_eigenvalue(full) >= -1e-14);
  }
  // Exactly so in the frame of the singular vectors, where no digits are lost: pivots of the 2 x 2 blocks.
  for(const Vector<D>& s : singular_value_samples<D>(true)) {
    FFM::Increment_form<D> form;
    preconditioner.form(state_at<D>(s, FFM::Symmetric_dirichlet()), FFM::Symmetric_dirichlet(), form);
    BOOST_TEST(form.stretch.diagonal().minCoeff() >= 0);
    for(const auto& pair : form.pairs) {
      BOOST_TEST(pair.ij_ij >= 0);
      BOOST_TEST(pair.ji_ji >= 0);
      BOOST_TEST(std::abs(pair.ij_ji) <= std::sqrt(pair.ij_ij) * std::sqrt(pair.ji_ji) * (1 + 1e-14));
    }
  }
}

template <int D>
void check_newton_is_the_projected_hessian()
{
  const FFM::Symmetric_dirichlet energy;
  int projections = 0, positive = 0;
  for(const Matrix<D>& J : jacobian_samples<D>()) {
    const Full_matrix<D> difference = finite_difference_hessian<D>(energy, J);
    const Full_matrix<D> exact = symmetric_dirichlet_hessian<D>(J, Full_matrix<D>::Identity());
    BOOST_TEST((difference - exact).norm() <= 1e-7 * exact.norm());
    const Full_matrix<D> newton = full_matrix<D>(FFM::Projected_newton(), energy, J);
    BOOST_TEST((newton - projected<D>(difference)).norm() <= 1e-7 * exact.norm());
    BOOST_TEST((newton - projected<D>(exact)).norm() <= 1e-9 * exact.norm());
    if(relative_smallest_eigenvalue(exact) > 1e-6) {
      ++positive;
      BOOST_TEST((newton - exact).norm() <= 1e-9 * exact.norm());
    } else if(relative_smallest_eigenvalue(exact) < -1e-6) {
      ++projections;
    }
  }
  // Both kinds must have been seen.
  BOOST_TEST(projections > 5);
  BOOST_TEST(positive > 5);
}

// Ratios of 1e6 between singular values, entry by entry in the frame of the singular vectors.
template <int D>
void check_newton_at_extreme_ratios()
{
  const FFM::Symmetric_dirichlet energy;
  for(const Matrix<D>& J : jacobian_samples<D>(true)) {
    FFM::internal::Signed_svd<D> svd;
    FFM::internal::signed_svd(J, svd);
    const Full_matrix<D> exact = symmetric_dirichlet_hessian<D>(J, to_frame<D>(svd).transpose());
    const Full_matrix<D> newton = frame_matrix<D>(FFM::Projected_newton(), energy, svd.s);
    for(int i = 0; i < D; ++i)
      for(int j = 0; j < D; ++j) {
        const int ij = j * D + i, ji = i * D + j;
        if(i == j) {
          BOOST_TEST(std::abs(newton(ij, ij) - exact(ij, ij)) <= 1e-6 * exact(ij, ij));
        } else if(i < j) {
          // Eigenvalues of the two modes, of which the twist may be negative.
          const double symmetric = exact(ij, ij) + exact(ij, ji), twist = exact(ij, ij) - exact(ij, ji);
          const double tolerance = 1e-6 * (std::abs(symmetric) + std::abs(twist));
          BOOST_TEST(std::abs(newton(ij, ij) + newton(ij, ji) - std::max(symmetric, 0.)) <= tolerance);
          BOOST_TEST(std::abs(newton(ij, ij) - newton(ij, ji) - std::max(twist, 0.)) <= tolerance);
        }
      }
  }
}

template <int D>
void check_slim()
{
  const FFM::Symmetric_dirichlet energy;
  for(const Matrix<D>& J : jacobian_samples<D>(true)) {
    const Full_vector<D> product = full_matrix<D>(FFM::Slim(), energy, J) * vec<D>(J - nearest_rotation<D>(J));
    const Full_vector<D> gradient = vec<D>(energy_gradient<D>(energy, J));
    // Where all singular values are 1 both vanish.
    BOOST_TEST((product - gradient).norm() <= 1e-9 * gradient.norm() + 1e-14);
  }
}

// 2 |W dJ|^2 with W^2 = U diag(psi_i / (2 (s_i - 1))) U^T has the Hessian 2 W^2 on each column of dJ, whatever the column.
template <int D>
void check_slim_in_all_directions()
{
  for(const Matrix<D>& J : jacobian_samples<D>(true)) {
    const Singular_value_decomposition<D> svd(J);
    Vector<D> weights;
    for(int i = 0; i < D; ++i) {
      const double s = svd.s[i];
      weights[i] = std::abs(s - 1) > 1e-7 ? (s - std::pow(s, -3)) / (D * (s - 1)) : 4. / D;
    }
    const Matrix<D> proxy = svd.U * weights.asDiagonal() * svd.U.transpose();
    const Full_matrix<D> full = full_matrix<D>(FFM::Slim(), FFM::Symmetric_dirichlet(), J);
    for(int i = 0; i < D; ++i)
      for(int j = 0; j < D; ++j) {
        Matrix<D> dJ = Matrix<D>::Zero();
        dJ(i, j) = 1;
        BOOST_TEST((full * vec<D>(dJ) - vec<D>(proxy * dJ)).norm() <= 1e-6 * proxy.norm());
      }
  }
}

// Singular values around 1, where the weights are quotients of vanishing numbers.
template <int D>
void check_slim_near_isometry()
{
  for(double distance = 1e-3; distance > 1e-17; distance *= 0.3)
    for(double sign : {-1., 1.}) {
      const Full_matrix<D> slim = frame_matrix<D>(FFM::Slim(), FFM::Symmetric_dirichlet(), Vector<D>::Constant(1 + sign * distance));
      const Full_matrix<D> limit = 4. / D * Full_matrix<D>::Identity();
      BOOST_TEST((slim - limit).cwiseAbs().maxCoeff() <= 10 * distance + 1e-7);
    }
}

template <int D>
void check_killing()
{
  const FFM::Symmetric_dirichlet energy;
  // Half the energy's second derivative along one stretch at the identity.
  const double c = 2. / D;
  Random random(13);
  for(const Matrix<D>& J : jacobian_samples<D>()) {
    FFM::Killing rest, image;
    image.weight = FFM::Killing_weight::image_measure;
    const Full_matrix<D> full = full_matrix<D>(rest, energy, J);
    BOOST_TEST((full_matrix<D>(image, energy, J) - J.determinant() * full).norm() <= 1e-12 * J.determinant() * full.norm());
    for(int k = 0; k < 5; ++k) {
      const Matrix<D> dJ = random.matrix<D>();
      const Matrix<D> S = dJ * J.inverse();
      const double expected = 0.5 * c * (S + S.transpose()).squaredNorm();
      BOOST_TEST(std::abs(vec<D>(dJ).dot(full * vec<D>(dJ)) - expected) <= 1e-10 * expected);

      const Matrix<D> A = S - S.transpose();
      const Full_vector<D> rigid = vec<D>(A * J);
      BOOST_TEST((full * rigid).norm() <= 1e-12 * full.norm() * rigid.norm());
    }
  }
  for(int k = 0; k < 20; ++k) {
    const Matrix<D> R = random.rotation<D>();
    const Full_matrix<D> exact = symmetric_dirichlet_hessian<D>(R, Full_matrix<D>::Identity());
    BOOST_TEST((full_matrix<D>(FFM::Killing(), energy, R) - exact).norm() <= 1e-13 * exact.norm());
  }
}

template <int D>
void check_laplacian()
{
  for(const Matrix<D>& J : jacobian_samples<D>(true))
    BOOST_TEST((full_matrix<D>(FFM::Laplacian(), FFM::Symmetric_dirichlet(), J) - 4. / D * Full_matrix<D>::Identity()).norm() <= 1e-13);
}

template <int D>
void check_slim_newton()
{
  const FFM::Symmetric_dirichlet energy;
  int slim = 0, newton = 0;
  for(double threshold : {1., 3., 20.})
    for(const Vector<D>& s : singular_value_samples<D>(true)) {
      FFM::Slim_newton both;
      both.threshold = threshold;
      const bool is_slim = energy.value<D>(s) > threshold;
      ++(is_slim ? slim : newton);
      const Full_matrix<D> expected =
        is_slim ? frame_matrix<D>(FFM::Slim(), energy, s) : frame_matrix<D>(FFM::Projected_newton(), energy, s);
      BOOST_TEST((frame_matrix<D>(both, energy, s) - expected).norm() == 0);
    }
  BOOST_TEST(slim > 50);
  BOOST_TEST(newton > 50);
}

} // namespace

BOOST_AUTO_TEST_CASE(all_are_positive_semidefinite)
{
  check_positive_semidefinite<2>(FFM::Projected_newton());
  check_positive_semidefinite<3>(FFM::Projected_newton());
  check_positive_semidefinite<2>(FFM::Slim());
  check_positive_semidefinite<3>(FFM::Slim());
  check_positive_semidefinite<2>(FFM::Slim_newton());
  check_positive_semidefinite<3>(FFM::Slim_newton());
  check_positive_semidefinite<2>(FFM::Laplacian());
  check_positive_semidefinite<3>(FFM::Laplacian());
  check_positive_semidefinite<2>(FFM::Composite_majorization<true>());
  check_positive_semidefinite<2>(FFM::Composite_majorization<false>());
  FFM::Killing killing;
  check_positive_semidefinite<2>(killing);
  check_positive_semidefinite<3>(killing);
  killing.weight = FFM::Killing_weight::image_measure;
  check_positive_semidefinite<2>(killing);
  check_positive_semidefinite<3>(killing);
}

BOOST_AUTO_TEST_CASE(newton_is_the_projected_hessian)
{
  check_newton_is_the_projected_hessian<2>();
  check_newton_is_the_projected_hessian<3>();
}

BOOST_AUTO_TEST_CASE(newton_at_extreme_ratios)
{
  check_newton_at_extreme_ratios<2>();
  check_newton_at_extreme_ratios<3>();
}

BOOST_AUTO_TEST_CASE(projection_of_indefinite_stretch_blocks)
{
  Random random(14);
  int indefinite = 0;
  for(int k = 0; k < 500; ++k) {
    const Matrix<3> random_matrix = random.matrix<3>();
    Matrix<3> m = random_matrix + random_matrix.transpose();
    const Eigen_decomposition<3> eigen(m);
    indefinite += eigen.values[0] < 0 && eigen.values[2] > 0;
    const Matrix<3> expected = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
    FFM::internal::project_to_psd(m);
    BOOST_TEST((m - expected).norm() <= 1e-7 * expected.norm() + 1e-7);
  }
  BOOST_TEST(indefinite > 100);
}

BOOST_AUTO_TEST_CASE(slim_reproduces_the_gradient)
{
  check_slim<2>();
  check_slim<3>();
}

BOOST_AUTO_TEST_CASE(slim_is_the_weighted_proxy)
{
  check_slim_in_all_directions<2>();
  check_slim_in_all_directions<3>();
}

BOOST_AUTO_TEST_CASE(slim_near_isometry)
{
  check_slim_near_isometry<2>();
  check_slim_near_isometry<3>();
}

BOOST_AUTO_TEST_CASE(slim_newton_chooses_by_energy)
{
  check_slim_newton<2>();
  check_slim_newton<3>();
}

BOOST_AUTO_TEST_CASE(slim_newton_gives_slim_up_where_distortion_stays)
{
  const FFM::Symmetric_dirichlet energy;
  const Vector<2> distorted(30, 0.05);
  const Full_matrix<2> slim = frame_matrix<2>(FFM::Slim(), energy, distorted);
  const Full_matrix<2> newton = frame_matrix<2>(FFM::Projected_newton(), energy, distorted);
  FFM::Slim_newton both;
  const auto after = [&](int iteration, double decrease, double fraction) {
    FFM::Iteration_state state;
    state.iteration = iteration;
    state.relative_decrease = decrease;
    state.distorted_fraction = [fraction](double) { return fraction; };
    both.begin_iteration(state);
    return frame_matrix<2>(both, energy, distorted);
  };
  BOOST_TEST((after(1, 0.01, 0.01) - slim).norm() == 0);
  BOOST_TEST((after(2, 0.5, 0.9) - slim).norm() == 0);
  BOOST_TEST((after(4, 0.01, 0.3) - newton).norm() == 0);
  BOOST_TEST((after(5, 0.01, 0.01) - newton).norm() == 0);
  BOOST_TEST((after(8, 0.01, 0.01) - slim).norm() == 0);
  after(16, 0.01, 0.3);
  BOOST_TEST((after(0, 1, 0.3) - slim).norm() == 0);
}

BOOST_AUTO_TEST_CASE(killing)
{
  check_killing<2>();
  check_killing<3>();
}

BOOST_AUTO_TEST_CASE(laplacian)
{
  check_laplacian<2>();
  check_laplacian<3>();
}

BOOST_AUTO_TEST_CASE(gathered_majorization_is_projected_newton)
{
  const FFM::Symmetric_dirichlet energy;
  for(const Vector<2>& s : singular_value_samples<2>(true)) {
    const Full_matrix<2> cm = frame_matrix<2>(FFM::Composite_majorization<true>(), energy, s);
    const Full_matrix<2> newton = frame_matrix<2>(FFM::Projected_newton(), energy, s);
    BOOST_TEST((cm - newton).norm() <= 1e-12 * newton.norm());
  }
}

BOOST_AUTO_TEST_CASE(majorization_exceeds_the_hessian)
{
  const FFM::Symmetric_dirichlet energy;
  for(const Matrix<2>& J : jacobian_samples<2>()) {
    const Full_matrix<2> hessian = symmetric_dirichlet_hessian<2>(J, Full_matrix<2>::Identity());
    const Full_matrix<2> gathered = full_matrix<2>(FFM::Composite_majorization<true>(), energy, J);
    const Full_matrix<2> ungathered = full_matrix<2>(FFM::Composite_majorization<false>(), energy, J);
    BOOST_TEST(smallest_eigenvalue(gathered - hessian) >= -1e-9 * hessian.norm());
    // Rounding is relative to the larger matrix: equation (17) has a pole at equal singular values.
    const double tolerance = 1e-9 * hessian.norm() + 1e-14 * ungathered.norm();
    BOOST_TEST(smallest_eigenvalue(ungathered - hessian) >= -tolerance);
    BOOST_TEST(smallest_eigenvalue(ungathered - gathered) >= -tolerance);
  }
}

// Equation (17) around an isometry, where its derivatives vanish together with the difference of the singular values.
BOOST_AUTO_TEST_CASE(ungathered_majorization_near_isometry)
{
  const FFM::Symmetric_dirichlet energy;
  int below = 0;
  for(double distance = 1e-2; distance > 1e-17; distance *= 0.3) {
    const Vector<2> s(1 + distance, 1 - distance);
    const Full_matrix<2> newton = frame_matrix<2>(FFM::Projected_newton(), energy, s);
    const Full_matrix<2> ungathered = frame_matrix<2>(FFM::Composite_majorization<false>(), energy, s);
    const Full_matrix<2> difference = ungathered - newton + 1e-6 * Full_matrix<2>::Identity();
    below += relative_smallest_eigenvalue(difference) < 0;
  }
  BOOST_TEST(below == 0);
}

BOOST_AUTO_TEST_SUITE_END() // test_preconditioners
