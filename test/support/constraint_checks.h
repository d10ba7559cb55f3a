// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_CONSTRAINT_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_CONSTRAINT_CHECKS_H

// Constrained optima, and what must hold of them. To be included after Boost.Test.

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

typedef FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, FFM::Eigen_simplicial_solver,
                                  FFM::No_acceleration, FFM::Every_iteration>
  Constrained_traits;

template <int D>
using Constraints = FFM::Position_constraints<D>;

template <int D>
using Term = std::shared_ptr<const FFM::Objective_term<D>>;

// stiffness |x_v - x_w|^2, as a user may write it.
template <int D>
struct Spring : FFM::Objective_term<D>
{
  std::int32_t v, w;
  double stiffness;
  Spring(std::int32_t first, std::int32_t second, double k) : v(first), w(second), stiffness(k) {}

  bool is_rigid_motion_invariant() const override { return true; }
  std::vector<std::vector<std::int32_t>> stencils() const override { return {{v, w}}; }
  double value(const FFM::Positions<D>& x) const override { return stiffness * (x.col(v) - x.col(w)).squaredNorm(); }
  void add_derivatives(const FFM::Positions<D>& x, FFM::Positions<D>& gradient, FFM::Term_matrix<D>* matrix) const override
  {
    gradient.col(v) += 2 * stiffness * (x.col(v) - x.col(w));
    gradient.col(w) -= 2 * stiffness * (x.col(v) - x.col(w));
    if(matrix == nullptr)
      return;
    const Eigen::Matrix<double, D, D> block = 2 * stiffness * Eigen::Matrix<double, D, D>::Identity();
    matrix->add(v, v, block);
    matrix->add(w, w, block);
    matrix->add(v, w, -block);
  }
};

template <int D>
double soft_energy(const Constraints<D>& constraints, const FFM::Positions<D>& x)
{
  double sum = 0;
  for(const auto& soft : constraints.soft_positions)
    sum += soft.weight * (x.col(soft.vertex) - soft.target).squaredNorm();
  return sum;
}

template <int D, typename Function>
FFM::Positions<D> gradient_by_differences(Function&& f, const FFM::Positions<D>& x)
{
  FFM::Positions<D> gradient(D, x.cols());
  for(Eigen::Index i = 0; i < x.size(); ++i) {
    const auto at = [&](double h) {
      FFM::Positions<D> moved = x;
      moved.data()[i] += h;
      return f(moved);
    };
    const double h = 1e-4;
    gradient.data()[i] = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  }
  return gradient;
}

inline FFM::Map_options tight_options()
{
  FFM::Map_options options;
  options.characteristic_gradient_tolerance = 1e-10;
  return options;
}

template <int D>
FFM::Summary minimized(const FFM::Simplicial_domain<D>& domain, const Constraints<D>& constraints, FFM::Positions<D>& x,
                       const Term<D>& term = nullptr)
{
  Constrained_traits traits;
  traits.options = tight_options();
  FFM::Map_minimizer<D, Constrained_traits> minimizer(domain, traits, constraints);
  minimizer.add_term(term);
  const FFM::Summary summary = minimizer.minimize(x);
  BOOST_TEST_MESSAGE(summary);
  return summary;
}

// The run converged, fixed vertices are where they were, and no displacement of the others lowers the sum of energy and terms. Returns
// the forces that hold the sliding ones.
template <int D>
double check_optimum(const FFM::Simplicial_domain<D>& domain, const Constraints<D>& constraints, const FFM::Positions<D>& start,
                     const Term<D>& term = nullptr)
{
  FFM::Positions<D> x = start;
  const FFM::Summary summary = minimized<D>(domain, constraints, x, term);
  BOOST_TEST(FFM::status_name(summary.status) == "success");
  BOOST_TEST(summary.flips == 0);
  const auto terms = [&](const FFM::Positions<D>& y) { return soft_energy<D>(constraints, y) + (term ? term->value(y) : 0); };
  FFM::Positions<D> gradient =
    gradient_by_differences<D>([&](const FFM::Positions<D>& y) { return symmetric_dirichlet<D>(domain, y) + terms(y); }, x);
  for(std::int32_t v : constraints.fixed_vertices) {
    BOOST_TEST((x.col(v).array() == start.col(v).array()).all());
    gradient.col(v).setZero();
  }
  double forces = 0;
  for(const auto& sliding : constraints.sliding_vertices) {
    const Eigen::Matrix<double, D, 1> path = x.col(sliding.vertex) - start.col(sliding.vertex);
    BOOST_TEST((sliding.projection * path - path).norm() <= 1e-14);
    BOOST_TEST(path.norm() > 1e-6);
    forces += gradient.col(sliding.vertex).norm();
    gradient.col(sliding.vertex) = (sliding.projection * gradient.col(sliding.vertex)).eval();
  }
  BOOST_TEST(gradient.norm() <= 1e-7);
  BOOST_TEST((x - start).norm() > 1e-3);
  BOOST_TEST(std::abs(summary.energy_of_terms - terms(x)) <= 1e-12 * (1 + terms(x)));
  BOOST_TEST(std::abs(summary.energy - symmetric_dirichlet<D>(domain, x) - terms(x)) <= 1e-11 * summary.energy);
  return forces;
}

template <int D>
void check_all_optima()
{
  const Distorted_example<D> example;
  const std::int32_t n = example.domain.number_of_vertices;
  Constraints<D> fixed, soft, both;
  fixed.fixed_vertices = {0, n / 2, n - 1, n / 2};
  check_optimum<D>(example.domain, fixed, example.x);
  soft.soft_positions = {{0, 1.2 * example.x.col(0), 0.3}, {n - 1, 0.8 * example.x.col(n - 1), 2}, {1, example.x.col(1), 0.05}};
  check_optimum<D>(example.domain, soft, example.x);
  both.fixed_vertices = {0, 2};
  both.soft_positions = soft.soft_positions;
  check_optimum<D>(example.domain, both, example.x);
  const Term<D> spring = std::make_shared<Spring<D>>(0, n - 1, 0.4);
  check_optimum<D>(example.domain, Constraints<D>(), example.x, spring);
  check_optimum<D>(example.domain, both, example.x, spring);

  // With a term between two that slide, and one between a vertex that does and a free one.
  Random random(23);
  Constraints<D> sliding;
  for(std::int32_t v : {0, 3, n - 1})
    sliding.sliding_vertices.push_back(v == 3 ? FFM::Sliding_vertex<D>::normal_to(v, random.vector(D))
                                              : FFM::Sliding_vertex<D>::along(v, random.vector(D)));
  check_optimum<D>(example.domain, sliding, example.x);
  check_optimum<D>(example.domain, sliding, example.x, spring);
  sliding.soft_positions = soft.soft_positions;
  BOOST_TEST(check_optimum<D>(example.domain, sliding, example.x, std::make_shared<Spring<D>>(3, 4, 0.4)) > 1e-2);

  // Where everything is fixed nothing is to be done.
  Constraints<D> all;
  for(std::int32_t v = 0; v < n; ++v)
    all.fixed_vertices.push_back(v);
  FFM::Positions<D> x = example.x;
  const FFM::Summary summary = minimized<D>(example.domain, all, x);
  BOOST_TEST(FFM::status_name(summary.status) == "success");
  BOOST_TEST(summary.iterations == 0);
  BOOST_TEST((x.array() == example.x.array()).all());
}

template <int D>
void check_message(const Constraints<D>& constraints, const std::string& part)
{
  const Distorted_example<D> example;
  FFM::Positions<D> x = example.x;
  const FFM::Summary summary = minimized<D>(example.domain, constraints, x);
  BOOST_TEST(FFM::status_name(summary.status) == "invalid_option");
  BOOST_TEST_CONTEXT(summary.message)
  BOOST_TEST(summary.message.find(part) != std::string::npos);
  BOOST_TEST((x.array() == example.x.array()).all());
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_CONSTRAINT_CHECKS_H
