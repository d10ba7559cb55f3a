// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Energies and gradients of several triangles at once against those of one at a time.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/domains/internal/Triangle_batch.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>

#include <array>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_energy_lanes)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// The same energy without the functions for several elements.
struct One_at_a_time
{
  static constexpr bool has_barrier = true;
  static const char* name() { return "one_at_a_time"; }

  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return FFM::Symmetric_dirichlet().value<D>(s);
  }

  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    FFM::Symmetric_dirichlet().derivatives<D>(s, gradient, hessian);
  }
};

// Inherits the functions for several elements, which are not its own.
struct Doubled : FFM::Symmetric_dirichlet
{
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return 2 * FFM::Symmetric_dirichlet::value<D>(s);
  }
};

static_assert(FFM::internal::Has_lanes<FFM::Symmetric_dirichlet>::value, "the default energy has lanes");
static_assert(!FFM::internal::Has_lanes<One_at_a_time>::value && !FFM::internal::Has_lanes<Doubled>::value, "these have not");

template <typename Energy>
struct Objective
{
  using Traits = FFM::Flip_free_map_traits<CGAL::Default, Energy>;

  explicit Objective(const FFM::Simplicial_domain<2>& domain) : objective(domain, energy, preconditioner) {}

  double value(const FFM::Positions<2>& x) const { return objective.mean_energy(FFM::Fixed_reference(), x); }

  Eigen::VectorXd gradient(const FFM::Positions<2>& x)
  {
    Eigen::VectorXd g;
    objective.derivatives(FFM::Fixed_reference(), x, false, g);
    return g;
  }

  Energy energy;
  typename Traits::Preconditioner preconditioner;
  FFM::internal::Map_objective<2, Traits> objective;
};

void check_same(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  Objective<FFM::Symmetric_dirichlet> several(domain);
  Objective<One_at_a_time> one(domain);
  BOOST_TEST(several.value(x) == one.value(x), boost::test_tools::tolerance(1e-13));
  const Eigen::VectorXd g = one.gradient(x);
  BOOST_TEST((several.gradient(x) - g).norm() <= 1e-12 * g.norm());
}

} // namespace

BOOST_AUTO_TEST_CASE(values_and_gradients_of_singular_values)
{
  const FFM::Symmetric_dirichlet energy;
  Random random(5);
  for(int i = 0; i < 1000; ++i) {
    std::array<FFM::internal::Lanes, 2> s, gradient;
    for(int l = 0; l < FFM::internal::NUMBER_OF_LANES; ++l) {
      s[0][l] = std::exp(random(-15, 15));
      s[1][l] = std::exp(random(-15, 15));
    }
    const FFM::internal::Lanes values = energy.values<2>(s);
    energy.gradients<2>(s, gradient);
    for(int l = 0; l < FFM::internal::NUMBER_OF_LANES; ++l) {
      const Eigen::Vector2d one(s[0][l], s[1][l]);
      Eigen::Vector2d slope;
      Eigen::Matrix2d hessian;
      energy.derivatives<2>(one, slope, hessian);
      BOOST_TEST(values[l] == energy.value<2>(one), boost::test_tools::tolerance(1e-14));
      BOOST_TEST(gradient[0][l] == slope[0], boost::test_tools::tolerance(1e-14));
      BOOST_TEST(gradient[1][l] == slope[1], boost::test_tools::tolerance(1e-14));
    }
  }
}

// Numbers of triangles that leave every remainder, from less than one register to several chunks.
BOOST_AUTO_TEST_CASE(meshes_of_all_sizes)
{
  for(int columns : {1, 2, 3, 5, 23})
    for(int rows : {1, 2, 4, 25}) {
      const Distorted_example<2> example(columns, rows);
      check_same(example.domain, example.x);
    }
}

BOOST_AUTO_TEST_CASE(an_energy_that_inherits_has_its_own_value)
{
  const Distorted_example<2> example(6, 5);
  Objective<FFM::Symmetric_dirichlet> base(example.domain);
  Objective<Doubled> doubled(example.domain);
  BOOST_TEST(doubled.value(example.x) == 2 * base.value(example.x), boost::test_tools::tolerance(1e-13));
}

// Isometries and similarities, where the reflected part of the Jacobian vanishes.
BOOST_AUTO_TEST_CASE(similarities)
{
  Surface surface = grid(7, 5, [](double u, double v) { return Eigen::Vector3d(2 * u, v, 0); });
  const FFM::Simplicial_domain<2> domain = make_domain(surface);
  const FFM::Positions<2> x = positions_of<2>(surface, domain.scale);
  Objective<FFM::Symmetric_dirichlet> several(domain);
  BOOST_TEST(several.value(x) == 1, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(several.gradient(x).norm() < 1e-14);
  check_same(domain, 1.7 * x);
}

BOOST_AUTO_TEST_CASE(thin_triangles)
{
  const Distorted_example<2> example(9, 7);
  for(double factor : {1e-3, 1e-6, 1e-9}) {
    FFM::Positions<2> x = example.x;
    x.row(1) *= factor;
    check_same(example.domain, x);
  }
}

BOOST_AUTO_TEST_CASE(one_flipped_triangle_makes_the_energy_infinite)
{
  const Distorted_example<2> example(6, 5);
  Objective<FFM::Symmetric_dirichlet> several(example.domain);
  BOOST_TEST(std::isfinite(several.value(example.x)));
  for(const auto& triangle : example.domain.elements) {
    FFM::Positions<2> x = example.x;
    x.col(triangle[0]) = x.col(triangle[1]) + x.col(triangle[2]) - x.col(triangle[0]);
    BOOST_TEST(several.value(x) == std::numeric_limits<double>::infinity());
    x.col(triangle[0]) = x.col(triangle[1]);
    BOOST_TEST(several.value(x) == std::numeric_limits<double>::infinity());
    x.col(triangle[0]).setConstant(std::numeric_limits<double>::quiet_NaN());
    BOOST_TEST(several.value(x) == std::numeric_limits<double>::infinity());
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_energy_lanes
