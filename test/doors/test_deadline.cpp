// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// A deadline reaches all phases of all doors: whenever a run is cancelled it ends at once, with a valid map or with none.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/pack_charts.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/repair_map.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/LU>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_deadline)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;

namespace {

namespace np = FFM::parameters;
using Pair = std::array<double, 2>;
using Triple = std::array<double, 3>;
using Triangles = std::vector<std::array<int, 3>>;

const double infinity = std::numeric_limits<double>::infinity();
const Pair unset{{-77, 77}};

struct Surface
{
  std::vector<Triple> points;
  Triangles triangles;
};

// A hilly sheet of n x n squares.
Surface sheet(int n, double height = 0.3)
{
  Surface result;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      result.points.push_back({x, y, height * std::sin(9 * x) * std::cos(7 * y)});
    }
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = (n + 1) * j + i, b = a + n + 1;
      result.triangles.push_back({a, a + 1, b + 1});
      result.triangles.push_back({a, b + 1, b});
    }
  return result;
}

// What a summary says of an atlas, by exact orientations and by the definition of the energy.
void check_atlas(const Surface& surface, const std::vector<std::array<Pair, 3>>& uv, const FFM::Unwrap_summary& summary)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  BOOST_TEST_REQUIRE(uv.size() == surface.triangles.size());
  int flips = 0;
  double energy = 0, area = 0;
  for(std::size_t t = 0; t < uv.size(); ++t) {
    const auto image = [&](int k) { return Kernel::Point_2(uv[t][k][0], uv[t][k][1]); };
    flips += CGAL::orientation(image(0), image(1), image(2)) != CGAL::POSITIVE;
    Eigen::Matrix<double, 3, 2> edges;
    Eigen::Matrix2d images;
    for(int k = 0; k < 2; ++k) {
      for(int c = 0; c < 3; ++c)
        edges(c, k) = surface.points[surface.triangles[t][k + 1]][c] - surface.points[surface.triangles[t][0]][c];
      for(int c = 0; c < 2; ++c)
        images(c, k) = (uv[t][k + 1][c] - uv[t][0][c]) / summary.scale;
    }
    const Eigen::Matrix2d metric = edges.transpose() * edges;
    const double face_area = std::sqrt(metric.determinant()) / 2;
    const double stretch = (images * metric.inverse() * images.transpose()).trace(), shrinking = (edges * images.inverse()).squaredNorm();
    energy += face_area * (stretch + shrinking) / 4;
    area += face_area;
  }
  BOOST_TEST(flips == 0);
  BOOST_TEST(energy / area == summary.energy, boost::test_tools::tolerance(1e-9));
}

// A torus, which cutting has to open.
Surface torus(int n, int m)
{
  Surface result;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * j / m, r = 2 + std::cos(v);
      result.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const int a = m * i + j, b = m * ((i + 1) % n) + j, c = m * ((i + 1) % n) + (j + 1) % m, d = m * i + (j + 1) % m;
      result.triangles.push_back({a, b, c});
      result.triangles.push_back({a, c, d});
    }
  return result;
}

std::int64_t flips(const Triangles& triangles, const std::vector<Pair>& x)
{
  std::int64_t result = 0;
  for(const auto& t : triangles) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
    const auto p = [&](int k) { return Point(x[t[k]][0], x[t[k]][1]); };
    result += CGAL::orientation(p(0), p(1), p(2)) != CGAL::LEFT_TURN;
  }
  return result;
}

// How often a run asks.
template <typename Run>
int number_of_questions(Run&& run)
{
  std::atomic<int> questions{0};
  const FFM::Deadline deadline(infinity, [&questions] {
    ++questions;
    return false;
  });
  run();
  return questions;
}

// Cancels runs of `run()`, which returns a status, at questions of theirs, and has each checked by `check(status)`. Where no map is
// valid in the beginning, `has_start` is false.
template <typename Run, typename Check>
void cancel_everywhere(Run&& run, Check&& check, bool has_start = false)
{
  const int questions = number_of_questions(run);
  BOOST_TEST(questions > 3);
  for(int last = 0; last < questions; last += 1 + last / 3) {
    std::atomic<int> asked{0};
    const FFM::Deadline deadline(
      infinity, [&] { return asked++ >= last; }, 0);
    const Status status = run();
    BOOST_TEST_CONTEXT("cancelled at question " << last << " of " << questions << ": " << status)
    {
      // Two tasks may ask at the same time.
      BOOST_TEST(asked <= last + 2);
      BOOST_TEST((status == Status::stopped_by_observer || status == Status::success || (status == Status::interrupted && !has_start)));
      check(status);
    }
  }
  // The next run is as good as any.
  BOOST_TEST(run() == Status::success);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_nearest_of_several)
{
  BOOST_TEST(FFM::Deadline::state().deadline == nullptr);
  {
    const FFM::Deadline none(infinity);
    BOOST_TEST(FFM::Deadline::state().deadline == nullptr);
    const FFM::Deadline far(1000);
    BOOST_TEST(far.status() == Status::success);
    bool is_cancelled = false;
    const FFM::Deadline cancelled(infinity, [&is_cancelled] { return is_cancelled; });
    BOOST_TEST(cancelled.status() == Status::success);
    {
      const FFM::Deadline past(0);
      BOOST_TEST(past.status() == Status::time_limit);
      // The grace is for the first map.
      BOOST_TEST(past.status(false) == Status::success);
      const FFM::Deadline inner(1000);
      BOOST_TEST(inner.status() == Status::time_limit);
    }
    BOOST_TEST(FFM::Deadline::state().deadline == &cancelled);
    is_cancelled = true;
    BOOST_TEST(cancelled.status() == Status::stopped_by_observer);
    BOOST_TEST(far.status() == Status::success);
  }
  BOOST_TEST(FFM::Deadline::state().deadline == nullptr);
}

BOOST_AUTO_TEST_CASE(parameterizations)
{
  const Surface surface = sheet(24);
  for(const std::int64_t multilevel_size : {-1, 0}) {
    std::vector<Pair> uv;
    FFM::Summary summary;
    FFM::internal::Default_method method;
    method.start.multilevel_size = multilevel_size;
    method.start.coarsest_size = 200;
    const auto run = [&] {
      uv.assign(1, unset);
      summary = FFM::parameterize(surface.points, surface.triangles, uv, np::map_traits(method));
      return summary.status;
    };
    cancel_everywhere(run, [&](Status) {
      if(summary.is_valid())
        BOOST_TEST((uv.size() == surface.points.size() && flips(surface.triangles, uv) == 0));
      else
        BOOST_TEST((uv.size() == 1 && uv[0] == unset));
    });
    // With time for nothing, the start is the result.
    const FFM::Deadline late(0, nullptr, infinity);
    BOOST_TEST(run() == Status::time_limit);
    BOOST_TEST(flips(surface.triangles, uv) == 0);
  }
}

BOOST_AUTO_TEST_CASE(atlases)
{
  const Surface surface = torus(24, 16);
  std::vector<std::array<Pair, 3>> uv;
  FFM::Unwrap_summary summary;
  const auto run = [&] {
    uv.clear();
    summary = FFM::unwrap(surface.points, surface.triangles, uv);
    return summary.status;
  };
  cancel_everywhere(run, [&](Status status) {
    BOOST_TEST(uv.size() == (summary.is_valid() ? surface.triangles.size() : 0u));
    // What is cut short is still of use.
    if(summary.is_valid())
      BOOST_TEST(summary.energy < 2);
    static_cast<void>(status);
  });
}

// Once there is a chart, be it one that is to be cut again, a run that has more time does not end with less.
BOOST_AUTO_TEST_CASE(atlases_that_are_cut_again)
{
  const Surface surface = sheet(24, 0.12);
  FFM::Unwrap_options options;
  options.max_distortion = 1.005;
  std::vector<std::array<Pair, 3>> uv;
  FFM::Unwrap_summary summary;
  const auto run = [&] {
    summary = FFM::unwrap(surface.points, surface.triangles, uv, np::unwrap_options(options));
    return summary.status;
  };
  const int questions = number_of_questions(run);
  BOOST_TEST_REQUIRE(summary.status == Status::success);
  const double energy = summary.energy;
  bool is_seen = false;
  for(int i = 0; i < 64; ++i) {
    const int last = static_cast<int>(static_cast<std::int64_t>(questions) * i / 64);
    std::atomic<int> asked{0};
    const FFM::Deadline deadline(
      infinity, [&] { return asked++ >= last; }, 0);
    run();
    BOOST_TEST_CONTEXT("cancelled at question " << last << " of " << questions << ": " << summary.message)
    {
      BOOST_TEST((summary.is_valid() || !is_seen));
      if(summary.is_valid())
        check_atlas(surface, uv, summary);
      for(const FFM::Chart_summary& chart : summary.charts)
        if(chart.message.find("before it was cut again") != std::string::npos) {
          is_seen = true;
          BOOST_TEST(chart.energy > energy);
          BOOST_TEST((chart.status == Status::stopped_by_observer));
        }
    }
  }
  BOOST_TEST(is_seen);
}

BOOST_AUTO_TEST_CASE(cutting_and_packing)
{
  const Surface surface = torus(40, 30);
  std::vector<std::array<int, 2>> seams;
  const auto cut = [&] {
    seams.clear();
    return FFM::cut_to_disk(surface.points, surface.triangles, seams).status;
  };
  cancel_everywhere(cut, [&](Status status) { BOOST_TEST(seams.empty() == (status == Status::interrupted)); });

  FFM::Textured_mesh mesh;
  for(int c = 0; c < 12; ++c)
    for(int k = 0; k < 3; ++k) {
      mesh.points.push_back({1. * c, 1. * k, 0});
      mesh.texture.push_back({10. * c + (k == 1 ? 1 + c : 0), k == 2 ? 3. : 0.});
      if(k == 0) {
        mesh.triangles.push_back({3 * c, 3 * c + 1, 3 * c + 2});
        mesh.texture_triangles.push_back({3 * c, 3 * c + 1, 3 * c + 2});
      }
    }
  const auto pack = [&] {
    FFM::Textured_mesh packed = mesh;
    const FFM::Packing_summary summary = FFM::pack_charts(packed);
    BOOST_TEST(FFM::is_bijective(packed));
    return summary.status;
  };
  const int questions = number_of_questions(pack);
  BOOST_TEST(questions > 10);
  int asked = 0;
  const FFM::Deadline deadline(infinity, [&] { return asked++ >= questions / 3; });
  FFM::Textured_mesh packed = mesh;
  BOOST_TEST(FFM::pack_charts(packed).status == Status::stopped_by_observer);
  BOOST_TEST(asked == questions / 3 + 1);
}

BOOST_AUTO_TEST_CASE(tests_for_overlaps)
{
  FFM::Textured_mesh mesh;
  const Surface surface = sheet(20, 0);
  for(const Triple& p : surface.points) {
    mesh.points.push_back(p);
    mesh.texture.push_back({p[0], p[1]});
  }
  mesh.triangles = mesh.texture_triangles = surface.triangles;
  BOOST_TEST(FFM::is_bijective(mesh));
  const FFM::Deadline deadline(
    infinity, [] { return true; }, 0);
  BOOST_CHECK_EXCEPTION(FFM::is_bijective(mesh), FFM::Interruption,
                        [](const FFM::Interruption& i) { return i.status() == Status::stopped_by_observer; });
}

// The shape on the way is a valid one.
BOOST_AUTO_TEST_CASE(deformations)
{
  const Surface surface = sheet(12, 0);
  std::vector<std::pair<int, Pair>> handles;
  for(int j = 0; j <= 12; ++j) {
    handles.push_back({13 * j, {surface.points[13 * j][0], surface.points[13 * j][1]}});
    // The other side is turned by a right angle.
    handles.push_back({13 * j + 12, {1.5 - surface.points[13 * j + 12][1], 1}});
  }
  std::vector<Pair> result;
  FFM::Summary summary;
  const auto run = [&] {
    result.assign(1, unset);
    summary = FFM::deform(surface.points, surface.triangles, handles, result);
    return summary.status;
  };
  int on_the_way = 0;
  cancel_everywhere(
    run,
    [&](Status) {
      if(!summary.is_valid())
        return;
      BOOST_TEST(flips(surface.triangles, result) == 0);
      bool has_arrived = true;
      for(const auto& [v, p] : handles)
        has_arrived = has_arrived && result[v] == p;
      BOOST_TEST(has_arrived == (summary.message.find("before the fixed vertices reached") == std::string::npos));
      on_the_way += !has_arrived;
    },
    false);
  BOOST_TEST(on_the_way > 0);
}

BOOST_AUTO_TEST_CASE(repairs)
{
  const Surface surface = sheet(12);
  std::vector<Pair> given;
  for(const Triple& p : surface.points)
    given.push_back({p[0], p[1]});
  std::swap(given[5 * 13 + 5], given[5 * 13 + 7]);
  BOOST_TEST(flips(surface.triangles, given) > 0);
  for(const bool only_second : {false, true}) {
    std::vector<Pair> uv;
    FFM::Summary summary;
    FFM::Repair_options options;
    if(only_second)
      options.splitting.max_iterations = 0;
    const auto run = [&] {
      uv = given;
      summary = FFM::repair_map(surface.points, surface.triangles, uv, np::repair_options(options));
      return summary.status == Status::flips_remain ? Status::interrupted : summary.status;
    };
    cancel_everywhere(run, [&](Status) {
      BOOST_TEST((flips(surface.triangles, uv) == 0) == summary.is_valid());
      if(!summary.is_valid())
        BOOST_TEST(uv == given);
    });
  }
}

BOOST_AUTO_TEST_CASE(conjugate_gradients)
{
  // A path with stiffness 1 and its first vertex tied down.
  const std::int32_t n = 400;
  std::vector<std::array<std::int32_t, 2>> edges;
  for(std::int32_t v = 0; v + 1 < n; ++v)
    edges.push_back({{v, v + 1}});
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(n, 1, edges);
  matrix.set_zero();
  for(const auto& e : edges) {
    matrix.diagonal(e[0]) += 1;
    matrix.diagonal(e[1]) += 1;
    matrix.add_block(e[0], e[1], matrix.slot(e[0], e[1]), Eigen::Matrix<double, 1, 1>(-1));
  }
  matrix.diagonal(0) += 1;
  FFM::Conjugate_gradient_solver<FFM::Block_jacobi<1>> solver(1e-6);
  BOOST_TEST((solver.analyze_pattern(matrix) && solver.factorize(matrix)));
  Eigen::VectorXd x;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(n);
  const int questions = number_of_questions([&] { BOOST_TEST(solver.solve(b, x)); });
  BOOST_TEST(solver.iterations() > 100);
  BOOST_TEST(questions >= solver.iterations());
  const FFM::Deadline deadline(
    infinity, [] { return true; }, 0);
  BOOST_CHECK_THROW(solver.solve(b, x), FFM::Interruption);
}

BOOST_AUTO_TEST_SUITE_END() // test_deadline
