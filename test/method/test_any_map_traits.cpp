// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Methods chosen at run time are the compiled ones, and all their names work.

#define BOOST_TEST_MODULE any_map_traits
#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/energies/Hencky.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <cmath>
#include <string>
#include <typeinfo>

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Preconditioner>
using Method = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Preconditioner, CGAL::Default, FFM::Eigen_simplicial_solver,
                                         FFM::No_acceleration, FFM::Every_iteration>;
typedef FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, FFM::Eigen_simplicial_solver> Default_method;

struct Fixture
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(9, 8, 0.4));
  FFM::Positions<2> start = tutte_start(domain);
  FFM::Positions<2> x;

  template <typename Traits>
  FFM::Summary run(const Traits& traits)
  {
    x = start;
    const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits).minimize(x);
    BOOST_TEST_MESSAGE(summary);
    return summary;
  }

  template <typename Traits>
  void compare(const std::string& name, Traits traits)
  {
    FFM::Any_map_traits any;
    any.use_linear_solver<FFM::Eigen_simplicial_solver>();
    BOOST_TEST_REQUIRE(any.use_method(name));
    traits.options.begin_with_largest_step = any.options.begin_with_largest_step;
    const FFM::Summary compiled = run(traits);
    const FFM::Positions<2> expected = x;
    FFM::Summary summary = run(any);
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(compiled.converged());
      BOOST_TEST(summary.converged());
      BOOST_TEST(summary.iterations == compiled.iterations);
      BOOST_TEST(summary.factorizations == compiled.factorizations);
      BOOST_TEST(summary.energy_evaluations == compiled.energy_evaluations);
      BOOST_TEST(std::abs(summary.energy - compiled.energy) <= 1e-12 * compiled.energy);
      BOOST_TEST((x - expected).norm() <= 1e-9);
      any.name_choices(summary);
      BOOST_TEST(summary.energy_name == compiled.energy_name);
      BOOST_TEST(summary.preconditioner == compiled.preconditioner);
      BOOST_TEST(summary.reference == compiled.reference);
      BOOST_TEST(summary.acceleration == compiled.acceleration);
    }
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(compiled_methods_give_the_same, Fixture)
{
  compare("default", Default_method());
  compare("projected-newton", Method<FFM::Projected_newton>());
  compare("slim", Method<FFM::Slim>());
  compare("akvf", Method<FFM::Killing>());
}

BOOST_FIXTURE_TEST_CASE(all_names_work, Fixture)
{
  struct Row
  {
    const char *method, *preconditioner, *reference, *acceleration;
  };
  const Row rows[] = {{"default", "adaptive", "fixed", "lbfgs"},
                      {"pp", "hybrid", "progressive", "none"},
                      {"cm", "cm", "fixed", "none"},
                      {"p-cm", "cm", "progressive", "none"},
                      {"slim", "slim", "fixed", "none"},
                      {"p-slim", "slim", "progressive", "none"},
                      {"akvf", "killing", "fixed", "none"},
                      {"p-akvf", "killing", "progressive", "none"},
                      {"projected-newton", "projected_newton", "fixed", "none"},
                      {"newton", "newton", "fixed", "none"},
                      {"aqp", "laplacian", "fixed", "nesterov"},
                      {"sobolev", "laplacian", "fixed", "none"}};
  const double minimum = run(Method<FFM::Projected_newton>()).energy;
  // One object goes through all methods: each sets all that the last one may have changed.
  FFM::Any_map_traits traits;
  for(const Row& row : rows) {
    BOOST_TEST_CONTEXT(row.method)
    {
      BOOST_TEST_REQUIRE(traits.use_method(row.method));
      traits.options.characteristic_gradient_tolerance = 1e-6;
      FFM::Summary summary = run(traits);
      traits.name_choices(summary);
      BOOST_TEST(summary.converged());
      BOOST_TEST(std::abs(summary.energy - minimum) <= 1e-6);
      BOOST_TEST(number_of_flips(domain, x) == 0);
      BOOST_TEST(summary.energy_name == "symmetric_dirichlet");
      BOOST_TEST(summary.preconditioner == row.preconditioner);
      BOOST_TEST(summary.reference == row.reference);
      BOOST_TEST(summary.acceleration == row.acceleration);
      const bool is_constant = std::string(row.preconditioner) == "laplacian";
      if(row.acceleration != std::string("lbfgs"))
        BOOST_TEST(summary.factorizations == (is_constant ? 1 : summary.iterations + summary.fallbacks));
      BOOST_TEST((traits.start.multilevel_size < 0) == (std::string(row.method) != "default"));
    }
  }
}

BOOST_FIXTURE_TEST_CASE(unknown_names_change_nothing, Fixture)
{
  FFM::Any_map_traits traits;
  BOOST_TEST_REQUIRE(traits.use_method("p-slim"));
  for(const char* name : {"", "Slim", "p-", "p-pp", "p-aqp", "p-sobolev", "p-default", "slim ", "gradient-descent"}) {
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(!traits.use_method(name));
      BOOST_TEST(traits.preconditioner.preconditioner_name() == "slim");
      BOOST_TEST(traits.has_progressive_reference());
      BOOST_TEST(traits.acceleration.acceleration_name() == "none");
    }
  }
}

// The energy and the linear solver remain when the method changes, and copies are copies.
BOOST_FIXTURE_TEST_CASE(choices_are_independent, Fixture)
{
  FFM::Any_map_traits traits;
  traits.energy = FFM::Any_energy(FFM::Hencky());
  traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
  BOOST_TEST(traits.use_method("projected-newton"));
  const FFM::Any_map_traits copy = traits;
  traits.preconditioner = FFM::Any_preconditioner(FFM::Slim());
  BOOST_TEST(copy.preconditioner.preconditioner_name() == "projected_newton");
  FFM::Summary summary = run(copy);
  copy.name_choices(summary);
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.energy_name == "hencky");
  BOOST_TEST(summary.linear_solver == FFM::Eigen_simplicial_solver().name());
  BOOST_TEST(std::abs(summary.energy - run(traits).energy) <= 1e-6);
}

// What was chosen instead of a part of the default method stays.
BOOST_AUTO_TEST_CASE(only_the_default_method_is_adapted_to_developable_surfaces)
{
  FFM::Any_map_traits whole, accelerated, preconditioned;
  accelerated.acceleration = FFM::Any_acceleration(FFM::Inexact_newton());
  preconditioned.preconditioner = FFM::Any_preconditioner(FFM::Slim());
  for(FFM::Any_map_traits* traits : {&whole, &accelerated, &preconditioned})
    traits->adapt_to_developable_surface();
  BOOST_TEST(whole.start.unfold);
  BOOST_TEST(!accelerated.start.unfold);
  BOOST_TEST(!preconditioned.start.unfold);
  BOOST_TEST(accelerated.acceleration.acceleration_name() == "inexact_newton");
  BOOST_TEST(preconditioned.preconditioner.preconditioner_name() == "slim");
}

BOOST_AUTO_TEST_CASE(planar_preconditioners_stay_in_the_plane)
{
  const Distorted_example<3> example;
  for(const char* method : {"cm", "slim"}) {
    FFM::Any_map_traits traits;
    BOOST_TEST_REQUIRE(traits.use_method(method));
    FFM::Positions<3> solid = example.x;
    const FFM::Summary summary = FFM::Map_minimizer<3, FFM::Any_map_traits>(example.domain, traits).minimize(solid);
    const bool is_planar = traits.preconditioner.is_planar();
    BOOST_TEST(is_planar == (std::string(method) == "cm"));
    BOOST_TEST(FFM::status_name(summary.status) == (is_planar ? "invalid_option" : "success"));
    BOOST_TEST((solid.array() == example.x.array()).all() == is_planar);
  }
}

// Units with and without the macro may be linked together: what differs has another name.
BOOST_AUTO_TEST_CASE(default_solver_is_part_of_the_name)
{
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  const bool expected = true;
#else
  const bool expected = false;
#endif
  BOOST_TEST((std::string(typeid(FFM::Flip_free_map_traits<>).name()).find("with_cholmod") != std::string::npos) == expected);
  BOOST_TEST((std::string(typeid(FFM::Any_map_traits).name()).find("with_cholmod") != std::string::npos) == expected);
}
