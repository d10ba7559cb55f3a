// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Accelerations chosen at run time: inexact Newton directions with every preconditioner in the plane and in space, and matrices
// that are assembled for those accelerations only that multiply by them.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_any_acceleration)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

FFM::Any_preconditioner filtered_newton(FFM::Eigenvalue_filter filter)
{
  FFM::Projected_newton newton;
  newton.filter = filter;
  return FFM::Any_preconditioner(newton);
}

const std::vector<std::pair<std::string, FFM::Any_preconditioner>>& preconditioners()
{
  static const std::vector<std::pair<std::string, FFM::Any_preconditioner>> all{
    {"adaptive", FFM::Any_preconditioner()},
    {"laplacian", FFM::Any_preconditioner(FFM::Laplacian())},
    {"killing", FFM::Any_preconditioner(FFM::Killing())},
    {"stiff killing", FFM::Any_preconditioner(FFM::Killing{FFM::Killing_weight::stiffness})},
    {"slim", FFM::Any_preconditioner(FFM::Slim())},
    {"cm", FFM::Any_preconditioner(FFM::Composite_majorization<>())},
    {"cm, ungathered", FFM::Any_preconditioner(FFM::Composite_majorization<false>())},
    {"projected newton", FFM::Any_preconditioner(FFM::Projected_newton())},
    {"absolute newton", filtered_newton(FFM::Eigenvalue_filter::absolute)},
    {"trust-region newton", filtered_newton(FFM::Eigenvalue_filter::trust_region)},
    {"vertex-space newton", FFM::Any_preconditioner(FFM::Vertex_space_newton())},
    {"newton", FFM::Any_preconditioner(FFM::Newton())},
    {"hybrid", FFM::Any_preconditioner(FFM::Hybrid<>())}};
  return all;
}

// Counts the matrices of elements.
template <typename Preconditioner>
struct Counted : Preconditioner
{
  std::shared_ptr<std::atomic<std::int64_t>> count = std::make_shared<std::atomic<std::int64_t>>(0);

  template <int D, typename Energy>
  void form(const FFM::Element_state<D>& state, const Energy& energy, FFM::Increment_form<D>& form) const
  {
    ++*count;
    Preconditioner::form(state, energy, form);
  }
};

template <typename Acceleration>
FFM::Any_map_traits traits_with(const FFM::Any_preconditioner& preconditioner, const Acceleration& acceleration)
{
  FFM::Any_map_traits traits;
  traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
  traits.preconditioner = preconditioner;
  traits.acceleration = FFM::Any_acceleration(acceleration);
  traits.refactorization_rule = FFM::On_demand();
  traits.options.characteristic_gradient_tolerance = 1e-7;
  return traits;
}

template <int D, typename Traits>
FFM::Summary minimized(const Distorted_example<D>& example, const Traits& traits, FFM::Positions<D>& x)
{
  x = example.x;
  const FFM::Summary summary = FFM::Map_minimizer<D, Traits>(example.domain, traits).minimize(x);
  BOOST_TEST_MESSAGE(summary);
  return summary;
}

template <int D>
void check_all_preconditioners(const Distorted_example<D>& example, double minimum)
{
  for(const auto& named : preconditioners()) {
    if(D == 3 && named.second.is_planar())
      continue;
    BOOST_TEST_CONTEXT(named.first << " in dimension " << D)
    {
      FFM::Positions<D> x;
      const FFM::Any_map_traits traits = traits_with(named.second, FFM::Inexact_newton());
      FFM::Summary summary = minimized(example, traits, x);
      traits.name_choices(summary);
      BOOST_TEST(summary.converged());
      BOOST_TEST(summary.acceleration == "inexact_newton");
      BOOST_TEST(summary.energy == minimum, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(summary.energy == symmetric_dirichlet<D>(example.domain, x), boost::test_tools::tolerance(1e-11));
      BOOST_TEST(summary.flips == 0);
      BOOST_TEST(summary.factorizations <= summary.iterations + summary.fallbacks);
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(all_preconditioners_in_the_plane)
{
  const Distorted_example<2> example(12, 10);
  FFM::Any_map_traits newton;
  newton.use_method("projected-newton");
  newton.options.characteristic_gradient_tolerance = 1e-10;
  FFM::Positions<2> x;
  const FFM::Summary summary = minimized(example, newton, x);
  BOOST_TEST_REQUIRE(summary.converged());
  check_all_preconditioners(example, summary.energy);
}

// The rest shape is a map, an isometry.
BOOST_AUTO_TEST_CASE(all_preconditioners_in_space) { check_all_preconditioners(Distorted_example<3>(4, 3, 2), 1); }

BOOST_AUTO_TEST_CASE(run_time_choice_gives_the_compiled_result)
{
  using Traits = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Projected_newton, CGAL::Default, FFM::Eigen_simplicial_solver,
                                           FFM::Inexact_newton, FFM::On_demand>;
  const Distorted_example<2> example(12, 10);
  Traits compiled;
  compiled.options.characteristic_gradient_tolerance = 1e-7;
  FFM::Positions<2> x, y;
  const FFM::Summary a = minimized(example, compiled, x);
  const FFM::Summary b = minimized(example, traits_with(FFM::Any_preconditioner(FFM::Projected_newton()), FFM::Inexact_newton()), y);
  BOOST_TEST(a.converged());
  BOOST_TEST(a.iterations == b.iterations);
  BOOST_TEST(a.factorizations == b.factorizations);
  BOOST_TEST(a.linear_solves == b.linear_solves);
  BOOST_TEST(a.linear_solves > a.iterations);
  BOOST_TEST((x - y).norm() <= 1e-9 * x.norm());
}

// Each matrix of the mesh asks for that of each element once.
BOOST_AUTO_TEST_CASE(matrices_are_assembled_where_they_are_needed)
{
  const Distorted_example<2> example(12, 10);
  const std::int64_t elements = example.domain.number_of_elements();
  FFM::Positions<2> x;

  FFM::Summary summary;
  const auto matrices = [&](const auto& preconditioner, const auto& acceleration) {
    FFM::Any_map_traits traits = traits_with(FFM::Any_preconditioner(preconditioner), acceleration);
    // Its elements are assembled one by one.
    traits.options.renew_factorization = false;
    *preconditioner.count = 0;
    summary = minimized(example, traits, x);
    BOOST_TEST(summary.converged());
    BOOST_TEST(*preconditioner.count % elements == 0);
    return *preconditioner.count / elements;
  };

  const Counted<FFM::Projected_newton> newton;
  std::int64_t number = matrices(newton, FFM::No_acceleration());
  BOOST_TEST(number == summary.factorizations);
  number = matrices(newton, FFM::Nesterov());
  BOOST_TEST(number == summary.factorizations);
  number = matrices(newton, FFM::Lbfgs());
  BOOST_TEST(number == summary.factorizations);
  BOOST_TEST(number < summary.iterations);
  // Also of the map at which the run ends.
  number = matrices(newton, FFM::Inexact_newton());
  BOOST_TEST(number == summary.iterations + 1);
  BOOST_TEST(summary.factorizations < summary.iterations);
  // One that is the same for all maps is not assembled again.
  number = matrices(Counted<FFM::Laplacian>(), FFM::Inexact_newton());
  BOOST_TEST(number == 1);
}

BOOST_AUTO_TEST_SUITE_END() // test_any_acceleration
