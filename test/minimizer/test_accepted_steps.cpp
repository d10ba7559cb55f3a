// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What a step must pass before a map is accepted: exact predicates, which refuse here what energies allow, and a sufficient decrease.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <CGAL/Flip_free_maps/accelerations/No_acceleration.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Minimizer_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Step_finder.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_accepted_steps)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

using Plain_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Is_obstacle = std::function<bool(const Eigen::Vector2d&)>;

// The usual predicates, but an element with a corner in the obstacle counts as flipped. No energy knows of it.
struct Obstacle_kernel : Plain_kernel
{
  static inline Is_obstacle is_obstacle;

  struct Orientation_2
  {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      for(const Point_2* point : {&p, &q, &r})
        if(is_obstacle && is_obstacle(Eigen::Vector2d(point->x(), point->y())))
          return CGAL::NEGATIVE;
      return Plain_kernel::Orientation_2()(p, q, r);
    }
  };
};

// Tells the slopes along the directions.
struct Slope_recorder : FFM::No_acceleration
{
  static inline double slope = 0;

  template <typename Solve>
  bool direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    const bool is_solved = FFM::No_acceleration::direction(x, gradient, solve, direction);
    slope = gradient.dot(direction);
    return is_solved;
  }
};

using Traits = FFM::Flip_free_map_traits<Obstacle_kernel, CGAL::Default, FFM::Projected_newton, CGAL::Default, FFM::Eigen_simplicial_solver,
                                         Slope_recorder, FFM::Every_iteration, CGAL::Sequential_tag>;

// A start of half the size that the map is going to have: all steps go outwards.
struct Fixture
{
  FFM::Simplicial_domain<2> domain = make_domain(bumpy_patch(8, 7));
  FFM::Positions<2> start = 0.5 * tutte_start(domain);
  FFM::Positions<2> x;
  Traits traits;
  FFM::Position_constraints<2> constraints;

  Fixture()
  {
    Obstacle_kernel::is_obstacle = nullptr;
    traits.options.characteristic_gradient_tolerance = 0;
    traits.options.free_blocked_vertices = false;
    traits.options.begin_with_largest_step = false;
  }

  ~Fixture() { Obstacle_kernel::is_obstacle = nullptr; }

  FFM::Summary run(int iterations, const Is_obstacle& is_obstacle = nullptr)
  {
    Obstacle_kernel::is_obstacle = is_obstacle;
    traits.options.max_iterations = iterations;
    x = start;
    return FFM::Map_minimizer<2, Traits>(domain, traits, constraints).minimize(x);
  }

  FFM::Positions<2> unobstructed(int iterations)
  {
    BOOST_TEST(FFM::status_name(run(iterations).status) == "iteration_limit");
    return x;
  }

  // By the definition, without any kernel.
  std::int64_t number_of_refused(const FFM::Positions<2>& y, const Is_obstacle& is_obstacle) const
  {
    return std::count_if(domain.elements.begin(), domain.elements.end(), [&](const auto& element) {
      return std::any_of(element.begin(), element.end(), [&](std::int32_t v) { return is_obstacle(y.col(v)); });
    });
  }
};

Is_obstacle half_plane(const Eigen::Vector2d& normal, double offset)
{
  return [=](const Eigen::Vector2d& p) { return normal.dot(p) > offset; };
}

} // namespace

// A step that leads into the obstacle is taken as far as there is room, but for the twentieth by which each trial is shorter.
BOOST_FIXTURE_TEST_CASE(steps_end_before_an_obstacle, Fixture)
{
  traits.options.extend_steps = false;
  const FFM::Positions<2> step = unobstructed(1) - start;
  for(int i = 0; i < 8; ++i) {
    const Eigen::Vector2d normal(std::cos(0.8 * i), std::sin(0.8 * i));
    const double wall = (normal.transpose() * (start + 0.8 * step)).maxCoeff();
    BOOST_TEST_REQUIRE((normal.transpose() * start).maxCoeff() < wall);
    const FFM::Summary summary = run(1, half_plane(normal, wall));
    BOOST_TEST(FFM::status_name(summary.status) == "iteration_limit");
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST(number_of_refused(x, half_plane(normal, wall)) == 0);
    BOOST_TEST(number_of_flips(domain, x) == 0);
    const double fraction = (x - start).cwiseProduct(step).sum() / step.squaredNorm();
    BOOST_TEST((x - start - fraction * step).norm() <= 1e-12);
    BOOST_TEST(fraction <= 0.8);
    BOOST_TEST(fraction >= 0.95 * 0.8);
    BOOST_TEST(summary.energy == symmetric_dirichlet<2>(domain, x), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(summary.energy < summary.energy_initial);
  }
}

// Whatever becomes of the run.
BOOST_FIXTURE_TEST_CASE(a_refused_map_never_leaves, Fixture)
{
  const FFM::Positions<2> free_map = unobstructed(12);
  int number_valid = 0;
  for(const bool frees_vertices : {false, true})
    for(const double room : {0.02, 0.3, 0.9})
      for(int iterations = 1; iterations <= 12; iterations += iterations < 4 ? 1 : 4) {
        const double wall = (1 - room) * start.row(0).maxCoeff() + room * free_map.row(0).maxCoeff();
        const Is_obstacle is_obstacle = half_plane({1, 0}, wall);
        traits.options.free_blocked_vertices = frees_vertices;
        const FFM::Summary summary = run(iterations, is_obstacle);
        BOOST_TEST(number_of_refused(x, is_obstacle) == 0);
        if(!summary.is_valid()) {
          BOOST_TEST(FFM::status_name(summary.status) == "line_search_failed");
          BOOST_TEST((x.array() == start.array()).all());
          continue;
        }
        ++number_valid;
        BOOST_TEST(summary.flips == 0);
        BOOST_TEST(summary.energy < summary.energy_initial);
      }
  BOOST_TEST(number_of_refused(free_map, half_plane({1, 0}, start.row(0).maxCoeff())) > 0);
  BOOST_TEST(number_valid >= 6);
}

BOOST_FIXTURE_TEST_CASE(starts_in_the_obstacle_are_refused, Fixture)
{
  const Is_obstacle is_obstacle = half_plane({0, 1}, 0.3 * start.row(1).maxCoeff());
  const FFM::Summary summary = run(5, is_obstacle);
  BOOST_TEST(FFM::status_name(summary.status) == "start_not_flip_free");
  BOOST_TEST(summary.flips == number_of_refused(start, is_obstacle));
  BOOST_TEST(summary.flips > 0);
  BOOST_TEST((x.array() == start.array()).all());
}

// The last word is had by a count of its own: predicates that change their mind in the last iteration are believed.
BOOST_FIXTURE_TEST_CASE(flips_are_counted_at_the_end, Fixture)
{
  const Is_obstacle is_obstacle = half_plane({1, 0}, 0);
  traits.options.observer = [&](const FFM::Iteration_report& report) {
    BOOST_TEST(report.flips == 0);
    if(report.iteration == 2)
      Obstacle_kernel::is_obstacle = is_obstacle;
    return report.iteration < 2;
  };
  const FFM::Summary summary = run(5);
  BOOST_TEST(FFM::status_name(summary.status) == "flips_remain");
  BOOST_TEST((x.array() == start.array()).all());
  traits.options.observer = nullptr;
  BOOST_TEST(summary.flips == number_of_refused(unobstructed(2), is_obstacle));
}

// Each point is asked for once at the start, in the first report, and after the first step: predicates that change their mind then are
// believed in the next report.
BOOST_FIXTURE_TEST_CASE(reports_count_flips, Fixture)
{
  std::int64_t questions = 0;
  std::vector<std::int64_t> flips;
  traits.options.observer = [&](const FFM::Iteration_report& report) {
    flips.push_back(report.flips);
    return report.iteration < 1;
  };
  const FFM::Summary summary = run(5, [&](const Eigen::Vector2d&) { return ++questions > 9 * domain.number_of_elements(); });
  BOOST_TEST(flips == (std::vector<std::int64_t>{0, domain.number_of_elements()}), boost::test_tools::per_element());
  BOOST_TEST(summary.flips == domain.number_of_elements());
  BOOST_TEST((x.array() == start.array()).all());
}

// Handles go to their targets around nothing: an obstacle on the way or at its end stops them.
BOOST_FIXTURE_TEST_CASE(fixed_vertices_keep_out_of_the_obstacle, Fixture)
{
  start *= 2;
  const std::int32_t handle = domain.border[0], opposite = domain.border[domain.border.size() / 2];
  constraints.fixed_vertices = {handle, opposite};
  FFM::Positions<2> targets = start;
  targets.col(handle) *= 1.3;
  const double farthest = start.colwise().norm().maxCoeff();
  for(const double radius : {1.1 * farthest, 2 * farthest}) {
    Obstacle_kernel::is_obstacle = [radius](const Eigen::Vector2d& p) { return p.norm() > radius; };
    x = start;
    traits.options.max_iterations = 3;
    const FFM::Summary summary = FFM::Map_minimizer<2, Traits>(domain, traits, constraints).move_fixed_vertices(x, targets);
    BOOST_TEST(number_of_refused(x, Obstacle_kernel::is_obstacle) == 0);
    if(radius < targets.col(handle).norm()) {
      BOOST_TEST(FFM::status_name(summary.status) == "unreachable_constraints");
      BOOST_TEST((x.array() == start.array()).all());
    } else {
      BOOST_TEST(summary.is_valid(), summary.message);
      BOOST_TEST((x.col(handle).array() == targets.col(handle).array()).all());
    }
  }
}

// Vertices are moved one by one, in their order, where the whole map was about to collapse: not to where the obstacle is.
BOOST_FIXTURE_TEST_CASE(blocked_vertices_keep_out_of_the_obstacle, Fixture)
{
  FFM::internal::Map_objective<2, Traits> objective(domain, traits.energy, traits.preconditioner);
  const FFM::internal::Step_finder<2, Traits> steps(domain, traits, objective);
  const auto freed = [&](const Is_obstacle& is_obstacle) {
    Obstacle_kernel::is_obstacle = is_obstacle;
    FFM::Summary summary;
    FFM::Positions<2> y = start;
    FFM::internal::Minimizer_run<2> run(y, summary);
    run.options.free_blocked_vertices = true;
    run.displacement = -start;
    run.progress.largest_step = 0.29;
    run.trial = start;
    FFM::Line_search_result found;
    found.step = 0.2;
    steps.free_blocked_vertices(run, found);
    BOOST_TEST(found.energy == symmetric_dirichlet<2>(domain, run.trial), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(number_of_flips(domain, run.trial) == 0);
    return run.trial;
  };
  const FFM::Positions<2> expected = freed(nullptr);
  BOOST_TEST(symmetric_dirichlet<2>(domain, expected) < symmetric_dirichlet<2>(domain, start));
  int number_tried = 0;
  for(std::int32_t v = 0; v < domain.number_of_vertices; v += 5) {
    const Eigen::Vector2d centre = expected.col(v);
    double radius = 0.5 * (start.col(v) - centre).norm();
    for(std::int32_t w = 0; w < domain.number_of_vertices; ++w)
      if(w != v)
        radius = (std::min)({radius, 0.5 * (start.col(w) - centre).norm(), 0.5 * (expected.col(w) - centre).norm()});
    if(radius < 1e-6)
      continue;
    ++number_tried;
    const Is_obstacle is_obstacle = [=](const Eigen::Vector2d& p) { return (p - centre).norm() < radius; };
    const FFM::Positions<2> y = freed(is_obstacle);
    BOOST_TEST(number_of_refused(y, is_obstacle) == 0);
    BOOST_TEST((y.leftCols(v).array() == expected.leftCols(v).array()).all());
  }
  BOOST_TEST(number_tried >= 5);
}

// Iterates of the splitting do not depend on predicates: the result is the last one out of the obstacle.
BOOST_FIXTURE_TEST_CASE(splitting_ends_before_an_obstacle, Fixture)
{
  using Splitting = FFM::Splitting_minimizer<2, Traits>;
  const int last = 8;
  FFM::Splitting_options options;
  options.absolute_tolerance = options.relative_tolerance = 1e-15;
  options.proximal_rotation = FFM::Proximal_rotation::on;
  const auto split = [&](int iterations) {
    options.max_iterations = iterations;
    x = start;
    return Splitting(domain, traits, {}, options).minimize(x);
  };
  std::vector<FFM::Positions<2>> iterates{start};
  for(int i = 1; i <= last; ++i) {
    BOOST_TEST(FFM::status_name(split(i).status) == "iteration_limit");
    iterates.push_back(x);
  }
  int number_kept = 0;
  for(int kept = 0; kept < last; ++kept) {
    // Between the widths of two iterates.
    const double width = iterates[kept].row(0).maxCoeff(), next = iterates[kept + 1].row(0).maxCoeff();
    const Is_obstacle is_obstacle = half_plane({1, 0}, 0.5 * (width + next));
    int expected = -1;
    for(int i = 0; i <= last; ++i)
      if(number_of_refused(iterates[i], is_obstacle) == 0 && number_of_flips(domain, iterates[i]) == 0)
        expected = i;
    if(expected < 0)
      continue;
    number_kept += expected < last;
    Obstacle_kernel::is_obstacle = is_obstacle;
    const FFM::Summary summary = split(last);
    BOOST_TEST(FFM::status_name(summary.status) == "iteration_limit");
    BOOST_TEST(summary.flips == 0);
    BOOST_TEST((x.array() == iterates[expected].array()).all());
  }
  BOOST_TEST(number_kept >= 2);

  Obstacle_kernel::is_obstacle = half_plane({1, 0}, 0);
  const FFM::Summary summary = split(last);
  BOOST_TEST(FFM::status_name(summary.status) == "flips_remain");
  BOOST_TEST(summary.flips == number_of_refused(iterates[last], Obstacle_kernel::is_obstacle));
  BOOST_TEST((x.array() == start.array()).all());
}

// Armijo's condition on each step that was taken, with a constant that rules many steps out.
BOOST_FIXTURE_TEST_CASE(each_step_decreases_the_energy_sufficiently, Fixture)
{
  start = 3 * tutte_start(domain);
  start.row(0) += 5 * start.row(1);
  traits.options.begin_with_largest_step = true;
  int violations = 0, steps = 0;
  for(const double armijo : {1e-9, 0.45}) {
    traits.options.armijo = armijo;
    double last = 0;
    violations = steps = 0;
    traits.options.observer = [&](const FFM::Iteration_report& report) {
      if(report.iteration > 0) {
        ++steps;
        violations += !(report.energy <= last + 0.45 * report.step * Slope_recorder::slope + 1e-13 * last);
      }
      last = report.energy;
      return report.gradient_norm > 1e-6;
    };
    BOOST_TEST(run(40).is_valid());
    BOOST_TEST(steps > 5);
    if(armijo < 0.45)
      BOOST_TEST(violations > 0);
  }
  BOOST_TEST(violations == 0);
}

BOOST_AUTO_TEST_SUITE_END() // test_accepted_steps
