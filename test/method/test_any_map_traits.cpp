// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Methods chosen at run time are the compiled ones, and all their names work.

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
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_any_map_traits)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <typename Preconditioner>
using Method = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Preconditioner, CGAL::Default, FFM::Eigen_simplicial_solver,
                                         FFM::No_acceleration, FFM::Every_iteration>;
typedef FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, FFM::Eigen_simplicial_solver> Default_method;

// What the papers say about each of their methods: Liu et al. 2018 (3.3 to 3.6, 4), Claici et al. 2017 (4, 5), Shtengel et al. 2017 (3.2,
// 4, 5), which leave the constants of the "standard Armijo backtracking" to Nocedal and Wright 2006. Energies of Claici et al. are
// four times ours.
struct Paper_row
{
  std::string name, source, preconditioner, class_name;
  bool is_progressive, is_accelerated;
  double fraction;
  bool is_capped; // the first step is at most 1
  double factor, armijo;
  bool has_flaps;
  double decrease, gradient; // at which runs end, 0 where no paper says

  // As in the manual, but for the last column.
  std::string manual_line() const
  {
    const auto power = [](double x) {
      const int exponent = static_cast<int>(std::floor(std::log10(x) + 1e-9));
      std::ostringstream text;
      const double mantissa = x / std::pow(10, exponent);
      if(std::abs(mantissa - 1) > 1e-9)
        text << mantissa << ' ';
      text << "10<sup>" << exponent << "</sup>";
      return text.str();
    };
    std::ostringstream line;
    line << "| `" << name << "` | " << source << " | `" << class_name << '`' << (is_accelerated ? ", `Nesterov`" : "") << " | "
         << (is_progressive ? "progressive" : "fixed") << " | " << (is_capped ? "min(1, " : "") << fraction << " a"
         << (is_capped ? ")" : "") << " | " << factor << " | " << power(armijo) << " | " << (has_flaps ? "yes" : "no") << " | "
         << (decrease > 0 ? "decrease " + power(decrease) : "") << (decrease > 0 && gradient > 0 ? ", " : "")
         << (gradient > 0 ? "gradient " + power(gradient) : "") << (decrease + gradient > 0 ? "" : "-") << " |";
    return line.str();
  }
};

const std::vector<Paper_row>& papers()
{
  const std::string liu = "\\cgalCite{LYNF18}, ", claici = "\\cgalCite{CBSS17}, ", shtengel = "\\cgalCite{SPSKL17}, ";
  static const std::vector<Paper_row> rows{
    {"pp", liu + "3.3 to 3.6", "hybrid", "Hybrid", true, false, 0.9, true, 0.5, 1e-4, false, 1e-6, 1e-6},
    {"cm", shtengel + "3.2, 4, 5", "cm", "Composite_majorization", false, false, 0.9, true, 0.5, 1e-4, false, 1e-6, 1e-6},
    {"slim", "\\cgalCite{RPPS17}", "slim", "Slim", false, false, 0.9, true, 0.5, 1e-4, false, 1e-6, 1e-6},
    {"akvf", claici + "4, 5", "killing", "Killing", false, false, 0.8, false, 0.9, 1e-5, true, 0, 2.5e-6},
    {"p-cm", liu + "4.2", "cm", "Composite_majorization", true, false, 0.9, true, 0.5, 1e-4, false, 1e-6, 1e-6},
    {"p-slim", liu + "4.2", "slim", "Slim", true, false, 0.9, true, 0.5, 1e-4, false, 1e-6, 1e-6},
    {"p-akvf", liu + "4.2", "killing", "Killing", true, false, 0.8, false, 0.9, 1e-5, false, 1e-6, 1e-6},
    {"projected-newton", "\\cgalCite{SGK19}", "projected_newton", "Projected_newton", false, false, 0.9, true, 0.5, 1e-4, false, 0, 0},
    {"newton", shtengel + "2", "newton", "Newton", false, false, 0.9, true, 0.5, 1e-4, false, 0, 0},
    {"aqp", "\\cgalCite{KGL16}", "laplacian", "Laplacian", false, true, 0.9, true, 0.5, 1e-4, false, 0, 0},
    {"sobolev", shtengel + "5 (QP)", "laplacian", "Laplacian", false, false, 0.9, true, 0.5, 1e-4, false, 0, 0}};
  return rows;
}

const Paper_row& paper_of(const std::string& name)
{
  for(const Paper_row& row : papers())
    if(row.name == name)
      return row;
  throw std::invalid_argument(name);
}

// The options of a method that is compiled as its paper has it.
template <typename Traits>
Traits published(const std::string& name)
{
  const Paper_row& row = paper_of(name);
  Traits traits;
  traits.options.step_fraction = row.fraction;
  traits.options.begin_with_largest_step = !row.is_capped;
  traits.options.backtracking = row.factor;
  traits.options.armijo = row.armijo;
  traits.options.max_line_search_steps = 400;
  traits.options.free_blocked_vertices = false;
  traits.options.careful_stagnation = false;
  return traits;
}

// What all methods but the default one have in common.
void check_search(const FFM::Any_map_traits& traits, double fraction, double armijo, double factor, bool begins_with_largest, bool is_own)
{
  const FFM::Map_options& options = traits.options;
  BOOST_TEST(options.step_fraction == fraction);
  BOOST_TEST(options.armijo == armijo);
  BOOST_TEST(options.backtracking == factor);
  BOOST_TEST(options.begin_with_largest_step == begins_with_largest);
  BOOST_TEST(options.extend_steps == is_own);
  BOOST_TEST(options.free_blocked_vertices == is_own);
  BOOST_TEST(options.careful_stagnation == is_own);
}

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
  for(const std::string name : {"projected-newton", "slim", "akvf"})
    BOOST_TEST_CONTEXT(name)
    {
      if(name == "slim")
        compare(name, published<Method<FFM::Slim>>(name));
      else if(name == "akvf")
        compare(name, published<Method<FFM::Killing>>(name));
      else
        compare(name, published<Method<FFM::Projected_newton>>(name));
    }
}

// One object goes through all methods, each as its paper has it, as the manual says, and as this package has improved it.
BOOST_AUTO_TEST_CASE(methods_are_those_of_the_papers)
{
  std::ifstream file(FLIP_FREE_MAPS_SOURCE_DIR "/doc/Flip_free_maps.txt");
  std::ostringstream manual;
  manual << file.rdbuf();
  BOOST_TEST(FFM::Any_map_traits::published_methods().size() == papers().size());
  FFM::Any_map_traits traits;
  for(const Paper_row& row : papers())
    for(const bool is_own : {false, true}) {
      BOOST_TEST_CONTEXT(row.name << (is_own ? "+" : ""))
      {
        BOOST_TEST_REQUIRE(traits.use_method(is_own ? row.name + "+" : row.name));
        BOOST_TEST(traits.preconditioner.preconditioner_name() == row.preconditioner);
        BOOST_TEST(traits.acceleration.acceleration_name() == (row.is_accelerated ? "nesterov" : "none"));
        BOOST_TEST((traits.refactorization_rule(7, 1, 1e-9) == FFM::Refactorization::refresh));
        BOOST_TEST(traits.reference.bound == (row.is_progressive ? 60 : std::numeric_limits<double>::infinity()));
        BOOST_TEST(traits.reference.smallest_decrease == 0.01);
        BOOST_TEST(traits.reference.distorted_fraction == (is_own ? 0 : 0.01));
        BOOST_TEST(traits.start.multilevel_size == -1);
        BOOST_TEST(traits.start.place_flaps == (row.has_flaps && !is_own));
        if(is_own)
          check_search(traits, 0.95, 1e-4, 0, true, true);
        else
          check_search(traits, row.fraction, row.armijo, row.factor, !row.is_capped, false);

        FFM::Any_map_traits stopping = traits;
        BOOST_TEST(stopping.stop_as_published() == (row.decrease + row.gradient > 0));
        BOOST_TEST(stopping.options.characteristic_gradient_tolerance == (row.decrease + row.gradient > 0 ? 0 : 1e-5));
        BOOST_TEST(stopping.options.relative_energy_tolerance == row.decrease);
        BOOST_TEST(stopping.options.gradient_tolerance == row.gradient, boost::test_tools::tolerance(1e-12));
        BOOST_TEST((manual.str().find('\n' + row.manual_line()) != std::string::npos), row.manual_line());
      }
    }
  BOOST_TEST_REQUIRE(traits.use_method("akvf"));
  BOOST_TEST_REQUIRE(traits.use_method("default"));
  check_search(traits, 0.95, 1e-4, 0, false, true);
  BOOST_TEST(traits.options.max_line_search_steps == 60);
  BOOST_TEST(!traits.start.place_flaps);
  BOOST_TEST(!traits.has_progressive_reference());
  BOOST_TEST(!traits.stop_as_published());
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
  for(const char* name :
      {"", "Slim", "p-", "p-pp", "p-aqp", "p-sobolev", "p-default", "default+", "+", "slim++", "slim ", "gradient-descent"}) {
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

BOOST_AUTO_TEST_SUITE_END() // test_any_map_traits
