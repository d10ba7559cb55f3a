// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Every energy with a barrier, minimised by different methods, ends at the same energy without flips.

#include "support/unit_test.h"

#include "support/all_energies.h"
#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_minimize_energies)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Preconditioner>
using Plain_traits = FFM::Flip_free_map_traits<CGAL::Default, FFM::Any_energy, Preconditioner, CGAL::Default, CGAL::Default,
                                               FFM::No_acceleration, FFM::Every_iteration>;

double energy_at(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x, const FFM::Any_energy& energy)
{
  double sum = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    sum += domain.measures[e] * energy.value<2>(FFM::internal::signed_singular_values(domain.jacobian(e, x)));
  return sum;
}

// By differences of the energy, in units of the curvature at the identity.
double gradient_norm(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x, const FFM::Any_energy& energy)
{
  Eigen::VectorXd gradient(x.size());
  for(Eigen::Index i = 0; i < gradient.size(); ++i) {
    FFM::Positions<2> low = x, high = x;
    low.data()[i] -= 1e-5;
    high.data()[i] += 1e-5;
    gradient[i] = (energy_at(domain, high, energy) - energy_at(domain, low, energy)) / 2e-5;
  }
  return gradient.norm() / FFM::internal::curvature_at_identity<2>(energy);
}

template <typename Traits>
double minimum(const FFM::Simplicial_domain<2>& domain, const FFM::Any_energy& energy, FFM::Positions<2>& x)
{
  Traits traits;
  traits.energy = energy;
  traits.options.characteristic_gradient_tolerance = 1e-8;
  const FFM::Positions<2> start = tutte_start(domain);
  x = start;
  const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
  BOOST_TEST_MESSAGE(energy.energy_name() << " " << summary.preconditioner << ": " << summary.iterations << " iterations, energy "
                                          << summary.energy << ", " << summary.message);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.energy_name == "any");
  BOOST_TEST(number_of_flips(domain, x) == 0);
  BOOST_TEST(std::abs(energy_at(domain, x, energy) - summary.energy) <= 1e-10 * summary.energy);
  BOOST_TEST(summary.energy < energy_at(domain, start, energy));
  return summary.energy;
}

} // namespace

BOOST_AUTO_TEST_CASE(methods_end_at_the_same_energy)
{
  const auto domain = make_domain(bumpy_patch(10, 8));
  for(const FFM::Any_energy& energy : energies_with_barrier()) {
    BOOST_TEST_CONTEXT(energy.energy_name())
    {
      FFM::Positions<2> x;
      const double newton = minimum<Plain_traits<FFM::Projected_newton>>(domain, energy, x);
      // Derivatives are those of one side at kinks.
      const bool has_kinks = energy.energy_name() == "symmetric_arap";
      if(!has_kinks)
        BOOST_TEST(gradient_norm(domain, x, energy) <= 1e-6);
      const double slim = minimum<Plain_traits<FFM::Slim>>(domain, energy, x);
      if(!has_kinks)
        BOOST_TEST(gradient_norm(domain, x, energy) <= 1e-6);
      const double preset = minimum<FFM::Flip_free_map_traits<CGAL::Default, FFM::Any_energy>>(domain, energy, x);
      BOOST_TEST(std::abs(slim - newton) <= 1e-6 * newton);
      BOOST_TEST(std::abs(preset - newton) <= 1e-6 * newton);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_minimize_energies
