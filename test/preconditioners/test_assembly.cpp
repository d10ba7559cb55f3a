// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The assembled gradient and matrices against dense brute force, and the Killing operator against the closed forms of the paper.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_assembly)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Preconditioner, typename Tag = CGAL::Sequential_tag>
using Traits =
  FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Preconditioner, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, Tag>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

Eigen::MatrixXd symmetric(const FFM::Block_sparse_matrix& matrix)
{
  const Eigen::MatrixXd lower(matrix.lower());
  Eigen::MatrixXd full = lower + lower.transpose();
  full.diagonal() = lower.diagonal();
  return full;
}

template <int D, typename Preconditioner>
Eigen::MatrixXd assembled(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x, const Preconditioner& preconditioner)
{
  const FFM::Symmetric_dirichlet energy;
  FFM::internal::Map_objective<D, Traits<Preconditioner>> objective(domain, energy, preconditioner);
  objective.build_pattern();
  Eigen::VectorXd gradient;
  objective.derivatives(FFM::Fixed_reference(), x, true, gradient);
  return symmetric(objective.matrix());
}

// sum_e w_e B^T H B with every B = d vec(J) / dx from differences of the Jacobian, which is linear in x.
template <int D, typename Preconditioner>
Eigen::MatrixXd brute_force(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x, const Preconditioner& preconditioner)
{
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(x.size(), x.size());
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    Eigen::MatrixXd B(D * D, x.size());
    for(Eigen::Index i = 0; i < x.size(); ++i) {
      FFM::Positions<D> low = x, high = x;
      low.data()[i] -= 1;
      high.data()[i] += 1;
      B.col(i) = 0.5 * (vec<D>(domain.jacobian(e, high)) - vec<D>(domain.jacobian(e, low)));
    }
    const Full_matrix<D> H = full_matrix<D>(preconditioner, FFM::Symmetric_dirichlet(), domain.jacobian(e, x));
    sum += domain.measures[e] * B.transpose() * H * B;
  }
  return sum;
}

template <int D>
Eigen::MatrixXd rigid_motions(const FFM::Positions<D>& x)
{
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(x.size(), D + D * (D - 1) / 2);
  int column = 0;
  for(int i = 0; i < D; ++i, ++column)
    for(Eigen::Index v = 0; v < x.cols(); ++v)
      motions(D * v + i, column) = 1;
  for(int i = 0; i < D; ++i)
    for(int j = i + 1; j < D; ++j, ++column)
      for(Eigen::Index v = 0; v < x.cols(); ++v) {
        motions(D * v + i, column) = -x(j, v);
        motions(D * v + j, column) = x(i, v);
      }
  return motions;
}

template <int D, typename Preconditioner>
void check_assembly(const Preconditioner& preconditioner)
{
  const Distorted_example<D> example;
  const Eigen::MatrixXd matrix = assembled<D>(example.domain, example.x, preconditioner);
  const Eigen::MatrixXd expected = brute_force<D>(example.domain, example.x, preconditioner);
  BOOST_TEST((matrix - expected).norm() <= 1e-12 * expected.norm());
  BOOST_TEST(relative_smallest_eigenvalue(matrix) >= -1e-14);
  const Eigen::MatrixXd translations = rigid_motions<D>(example.x).leftCols(D);
  BOOST_TEST((matrix * translations).norm() <= 1e-13 * matrix.norm() * translations.norm());
}

// Block (i, j) = sum_f A_f [grad phi_j grad phi_i^T + (grad phi_i . grad phi_j) I], equation (6), in the image.
template <int D>
Eigen::MatrixXd killing_of_equation_6(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Matrix<D> edges = domain.image_edges(e, x);
    const double measure = edges.determinant() / (D == 2 ? 2 : 6);
    Eigen::Matrix<double, D, D + 1> gradients;
    gradients.template rightCols<D>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.template rightCols<D>().rowwise().sum();
    for(int i = 0; i <= D; ++i)
      for(int j = 0; j <= D; ++j)
        K.template block<D, D>(D * domain.elements[e][i], D * domain.elements[e][j]) +=
          measure * (gradients.col(j) * gradients.col(i).transpose() + gradients.col(i).dot(gradients.col(j)) * Matrix<D>::Identity());
  }
  return K;
}

// Diagonal blocks from the others: rows sum to zero.
template <int D>
void close_rows(Eigen::MatrixXd& K)
{
  for(Eigen::Index p = 0; p < K.rows(); p += D) {
    Matrix<D> sum = Matrix<D>::Zero();
    for(Eigen::Index q = 0; q < K.rows(); q += D)
      if(q != p)
        sum += K.template block<D, D>(p, q);
    K.template block<D, D>(p, p) = -sum;
  }
}

// Equation (5): off-diagonal block (p, q) = sum over triangles (p, q, r) of e' e^T / (4 A) - cot(theta) I, where e = p - r,
// e' = q - r and theta is the angle at r.
Eigen::MatrixXd killing_of_equation_5(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
  for(const auto& t : domain.elements)
    for(int k = 0; k < 3; ++k)
      for(int flip = 0; flip < 2; ++flip) {
        const int p = t[(k + 1 + flip) % 3], q = t[(k + 2 - flip) % 3], r = t[k];
        const Eigen::Vector2d e = x.col(p) - x.col(r), e_prime = x.col(q) - x.col(r);
        const double area = 0.5 * std::abs(e[0] * e_prime[1] - e[1] * e_prime[0]);
        const double cotangent = e.dot(e_prime) / (2 * area);
        K.block<2, 2>(2 * p, 2 * q) += e_prime * e.transpose() / (4 * area) - cotangent * Eigen::Matrix2d::Identity();
      }
  close_rows<2>(K);
  return K;
}

// Equations (8), (9) and (10).
Eigen::MatrixXd killing_of_equation_10(const FFM::Simplicial_domain<3>& domain, const FFM::Positions<3>& x)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
  for(std::int64_t element = 0; element < domain.number_of_elements(); ++element) {
    const auto& t = domain.elements[element];
    const double volume = std::abs(domain.image_edges(element, x).determinant()) / 6;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j) {
        if(i == j)
          continue;
        int others[2], n = 0;
        for(int k = 0; k < 4; ++k)
          if(k != i && k != j)
            others[n++] = t[k];
        const Eigen::Vector3d x_0 = x.col(t[i]), x_1 = x.col(t[j]), x_2 = x.col(others[0]), x_3 = x.col(others[1]);
        const Eigen::Vector3d a = x_1 - x_3, b = x_3 - x_2, c = x_2 - x_0;
        const Eigen::Vector3d n_1 = b.cross(a), n_2 = b.cross(c);
        K.block<3, 3>(3 * t[i], 3 * t[j]) += (n_2 * n_1.transpose() + n_1.dot(n_2) * Eigen::Matrix3d::Identity()) / (36 * volume);
      }
  }
  close_rows<3>(K);
  return K;
}

template <int D>
void check_killing(const Eigen::MatrixXd& closed_form)
{
  const Distorted_example<D> example;
  FFM::Killing killing;
  killing.weight = FFM::Killing_weight::image_measure;
  const Eigen::MatrixXd matrix = assembled<D>(example.domain, example.x, killing);
  // Half the curvature of the energy along one stretch at the identity, 4 / D for symmetric Dirichlet: the factor between our
  // matrix and the paper's.
  const double factor = 2. / D;
  const Eigen::MatrixXd expected = factor * killing_of_equation_6<D>(example.domain, example.x);
  BOOST_TEST((matrix - expected).norm() <= 1e-12 * expected.norm());
  BOOST_TEST((matrix - factor * closed_form).norm() <= 1e-12 * expected.norm());

  // The null space is that of the rigid motions of the image, for either measure, and nothing else.
  const Eigen::MatrixXd motions = rigid_motions<D>(example.x);
  const Eigen::MatrixXd rest = assembled<D>(example.domain, example.x, FFM::Killing());
  for(const Eigen::MatrixXd* m : {&matrix, &rest}) {
    BOOST_TEST((*m * motions).norm() <= 1e-12 * m->norm() * motions.norm());
    const Eigen::VectorXd values = eigenvalues(*m);
    BOOST_TEST(values[motions.cols()] > 1e-6 * values[values.size() - 1]);
  }
}

template <int D>
void check_gradient()
{
  const Distorted_example<D> example;
  const FFM::Symmetric_dirichlet energy;
  const FFM::Fixed_reference reference;
  const FFM::Laplacian preconditioner;
  FFM::internal::Map_objective<D, Traits<FFM::Laplacian>> objective(example.domain, energy, preconditioner);
  Eigen::VectorXd gradient, differences(example.x.size());
  objective.derivatives(reference, example.x, false, gradient);
  const double h = 1e-5;
  for(Eigen::Index i = 0; i < example.x.size(); ++i) {
    const auto moved = [&](double distance) {
      FFM::Positions<D> x = example.x;
      x.data()[i] += distance;
      return objective.energy(reference, x);
    };
    differences[i] = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
  }
  BOOST_TEST((gradient - differences).norm() <= 1e-8 * gradient.norm());

  // The energy itself, without singular values.
  double expected = 0;
  for(std::int64_t e = 0; e < example.domain.number_of_elements(); ++e) {
    const Matrix<D> J = example.domain.jacobian(e, example.x);
    expected += example.domain.measures[e] * (J.squaredNorm() + J.inverse().squaredNorm()) / (2 * D);
  }
  BOOST_TEST(std::abs(objective.energy(reference, example.x) - expected) <= 1e-12 * expected);
}

template <int D>
void check_energy_of_bad_positions()
{
  const Distorted_example<D> example;
  const FFM::Symmetric_dirichlet energy;
  const FFM::Fixed_reference reference;
  const FFM::Laplacian preconditioner;
  const FFM::internal::Map_objective<D, Traits<FFM::Laplacian>> objective(example.domain, energy, preconditioner);
  const double infinity = std::numeric_limits<double>::infinity();

  FFM::Positions<D> mirrored = example.x;
  mirrored.row(0) *= -1;
  BOOST_TEST(objective.energy(reference, mirrored) == infinity);

  FFM::Positions<D> collapsed = example.x;
  collapsed.row(D - 1).setZero();
  BOOST_TEST(objective.energy(reference, collapsed) == infinity);

  int finite = 0;
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for(Eigen::Index i = 0; i < example.x.size(); ++i) {
      FFM::Positions<D> x = example.x;
      x.data()[i] = bad;
      finite += std::isfinite(objective.energy(reference, x));
    }
  BOOST_TEST(finite == 0, finite << " energies of positions that are not finite are finite, D = " << D);
}

template <typename Vector_1, typename Vector_2>
bool are_same_bits(const Vector_1& a, const Vector_2& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

struct Values
{
  double energy;
  Eigen::VectorXd gradient;
  std::vector<double> matrix;
  double largest_step;
};

template <int D, typename Tag>
Values values_of(const Distorted_example<D>& example)
{
  const FFM::Symmetric_dirichlet energy;
  const FFM::Fixed_reference reference;
  const FFM::Projected_newton preconditioner;
  FFM::internal::Map_objective<D, Traits<FFM::Projected_newton, Tag>> objective(example.domain, energy, preconditioner);
  Values values;
  objective.build_pattern();
  values.energy = objective.energy(reference, example.x);
  objective.derivatives(reference, example.x, true, values.gradient);
  values.matrix = objective.matrix().values();
  const Eigen::VectorXd descent = -values.gradient;
  values.largest_step = objective.largest_step(example.x, Eigen::Map<const FFM::Positions<D>>(descent.data(), D, example.x.cols()));
  return values;
}

template <int D>
void check_concurrency(const Distorted_example<D>& example)
{
  // Several chunks of elements in several colours, or nothing would run in parallel.
  BOOST_TEST_REQUIRE(example.domain.number_of_elements() > 5000);
  const Values sequential = values_of<D, CGAL::Sequential_tag>(example);
  BOOST_TEST(std::isfinite(sequential.energy));
  BOOST_TEST(std::isfinite(sequential.largest_step));
#ifdef CGAL_LINKED_WITH_TBB
  for(int threads : {1, 2, 2, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Values parallel = values_of<D, CGAL::Parallel_tag>(example);
    BOOST_TEST(parallel.energy == sequential.energy);
    BOOST_TEST(parallel.largest_step == sequential.largest_step);
    BOOST_TEST(are_same_bits(parallel.gradient, sequential.gradient));
    BOOST_TEST(are_same_bits(parallel.matrix, sequential.matrix));
  }
#else
  test_support::skip_case("built without oneTBB: there is one thread only");
#endif
}

} // namespace

BOOST_AUTO_TEST_CASE(matrix_is_the_sum_over_elements)
{
  check_assembly<2>(FFM::Projected_newton());
  check_assembly<3>(FFM::Projected_newton());
  check_assembly<2>(FFM::Slim());
  check_assembly<3>(FFM::Slim());
  check_assembly<2>(FFM::Laplacian());
  check_assembly<3>(FFM::Laplacian());
  check_assembly<2>(FFM::Killing());
  check_assembly<3>(FFM::Killing());
  check_assembly<2>(FFM::Composite_majorization<true>());
  check_assembly<2>(FFM::Composite_majorization<false>());
}

BOOST_AUTO_TEST_CASE(killing_in_the_plane)
{
  const Distorted_example<2> example;
  check_killing<2>(killing_of_equation_5(example.domain, example.x));
}

BOOST_AUTO_TEST_CASE(killing_in_space)
{
  const Distorted_example<3> example;
  check_killing<3>(killing_of_equation_10(example.domain, example.x));
}

BOOST_AUTO_TEST_CASE(gradient)
{
  check_gradient<2>();
  check_gradient<3>();
}

BOOST_AUTO_TEST_CASE(energy_of_bad_positions)
{
  check_energy_of_bad_positions<2>();
  check_energy_of_bad_positions<3>();
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_concurrency, *boost::unit_test::label("needs_tbb"))
{
  check_concurrency<2>(Distorted_example<2>(70, 50));
  check_concurrency<3>(Distorted_example<3>(12, 10, 8));
}

BOOST_AUTO_TEST_SUITE_END() // test_assembly
