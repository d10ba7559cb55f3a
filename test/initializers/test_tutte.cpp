// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Starts: flip-free for all borders and weights, exact where the answer is known, and honest when they fail.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tutte)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

const std::vector<FFM::Tutte_weights> all_weights{FFM::Tutte_weights::uniform, FFM::Tutte_weights::mean_value,
                                                  FFM::Tutte_weights::cotangent};
const std::vector<FFM::Border_shape> all_borders{FFM::Border_shape::circle, FFM::Border_shape::square, FFM::Border_shape::polygon};

std::vector<std::array<double, 2>> pentagon() { return {{{0, 0}}, {{3, 0}}, {{4, 2}}, {{1, 4}}, {{-1, 1}}}; }

struct Result
{
  FFM::Status status;
  FFM::Positions<2> x;
  std::string name;
  std::string message;
};

Result start_of(const FFM::Simplicial_domain<2>& domain, const FFM::Start_options& options)
{
  Result result;
  result.status = Tutte(options)(domain, make_eigen_solver, result.x, result.name, result.message);
  return result;
}

FFM::Start_options plain_options()
{
  FFM::Start_options options;
  options.fall_back = false;
  options.place_flaps = false;
  return options;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

double area(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  double sum = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    sum += 0.5 * domain.image_edges(e, x).determinant();
  return sum;
}

// An uneven planar patch, its inner vertices away from the regular places.
Surface planar_patch()
{
  Random random(71);
  return grid(9, 7, [&random](double u, double v) {
    const double moved = 0.02 * (u > 0 && u < 1 && v > 0 && v < 1);
    return Eigen::Vector3d(1.5 * u + moved * random(-1, 1), v + moved * random(-1, 1), 0);
  });
}

// No edge joins two border vertices but those on the border: a triangle at such an edge may have all its vertices on one side of
// a square, where no weights save it.
Surface patch_without_chords()
{
  return grid(
    12, 10, [](double u, double v) { return Eigen::Vector3d(1.3 * u, v, 0.25 * std::sin(6.6 * u + 0.3) * std::cos(5.3 * v + 0.1)); }, true);
}

bool is_border(const FFM::Simplicial_domain<2>& domain, std::int32_t v)
{
  return std::find(domain.border.begin(), domain.border.end(), v) != domain.border.end();
}

} // namespace

BOOST_AUTO_TEST_CASE(all_borders_and_weights)
{
  const auto domain = make_domain(patch_without_chords());
  for(FFM::Border_shape border : all_borders)
    for(FFM::Tutte_weights weights : all_weights)
      for(bool place_flaps : {false, true}) {
        FFM::Start_options options = plain_options();
        options.border = border;
        options.polygon = pentagon();
        options.weights = weights;
        options.place_flaps = place_flaps;
        const Result result = start_of(domain, options);
        BOOST_TEST((result.status == FFM::Status::success), result.message);
        BOOST_TEST(number_of_flips(domain, result.x) == 0);
        // There are no flaps in this patch, so none can have been placed.
        BOOST_TEST(result.name == std::string("tutte (") + FFM::border_name(border) + ", " + FFM::weights_name(weights) + ")");
        if(!place_flaps) {
          // The border encloses area 1; a polygon's vertices cut corners of the circle.
          BOOST_TEST(area(domain, result.x) <= 1 + 1e-12);
          BOOST_TEST(area(domain, result.x) >= 0.95);
        }
      }
}

BOOST_AUTO_TEST_CASE(inner_vertices_are_means)
{
  const auto domain = make_domain(bumpy_patch(6, 5));
  const Result result = start_of(domain, plain_options());
  std::vector<std::vector<std::int32_t>> neighbors(domain.number_of_vertices);
  for(const auto& t : domain.elements)
    for(int k = 0; k < 3; ++k)
      neighbors[t[k]].push_back(t[(k + 1) % 3]);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    if(is_border(domain, v))
      continue;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for(std::int32_t w : neighbors[v])
      mean += result.x.col(w) / neighbors[v].size();
    BOOST_TEST((mean - result.x.col(v)).norm() <= 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(borders_lie_where_they_should)
{
  const auto domain = make_domain(patch_without_chords());
  const std::size_t n = domain.border.size();
  double length = 0;
  for(double l : domain.border_lengths)
    length += l;

  const Result circle = start_of(domain, plain_options());
  for(std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d p = circle.x.col(domain.border[i]), q = circle.x.col(domain.border[(i + 1) % n]);
    BOOST_TEST(std::abs(p.norm() - 1 / std::sqrt(pi)) <= 1e-13);
    const double angle = std::atan2(p[0] * q[1] - p[1] * q[0], p.dot(q));
    BOOST_TEST(std::abs(angle - 2 * pi * domain.border_lengths[i] / length) <= 1e-12);
  }

  FFM::Start_options options = plain_options();
  options.border = FFM::Border_shape::square;
  const Result square = start_of(domain, options);
  int corners = 0;
  for(std::int32_t v : domain.border) {
    BOOST_TEST(std::abs(square.x.col(v).cwiseAbs().maxCoeff() - 0.5) <= 1e-13);
    corners += square.x.col(v).cwiseAbs().minCoeff() >= 0.5 - 1e-13;
  }
  BOOST_TEST(corners == 4);
}

BOOST_AUTO_TEST_CASE(polygons_are_checked)
{
  const auto domain = make_domain(bumpy_patch(6, 5));
  const auto status = [&domain](const std::vector<std::array<double, 2>>& polygon) {
    FFM::Start_options options;
    options.border = FFM::Border_shape::polygon;
    options.polygon = std::vector<std::array<double, 2>>(polygon);
    const Result result = start_of(domain, options);
    BOOST_TEST(options.is_valid() == (result.status == FFM::Status::success));
    if(result.status != FFM::Status::success) {
      BOOST_TEST((result.status == FFM::Status::invalid_option));
      BOOST_TEST(contains(result.message, "polygon"));
    }
    return result.status == FFM::Status::success;
  };
  BOOST_TEST(status(pentagon()));
  BOOST_TEST(status({{{0, 0}}, {{1, 0}}, {{0, 1}}}));
  BOOST_TEST(!status({}));
  BOOST_TEST(!status({{{0, 0}}, {{1, 0}}}));
  // Clockwise, not convex, with a straight corner, with a repeated corner, a pentagram, NaN.
  BOOST_TEST(!status({{{0, 0}}, {{0, 1}}, {{1, 0}}}));
  BOOST_TEST(!status({{{0, 0}}, {{2, 0}}, {{0.5, 0.5}}, {{0, 2}}}));
  BOOST_TEST(!status({{{0, 0}}, {{1, 0}}, {{2, 0}}, {{0, 2}}}));
  BOOST_TEST(!status({{{0, 0}}, {{1, 0}}, {{1, 0}}, {{0, 2}}}));
  std::vector<std::array<double, 2>> star;
  for(int i = 0; i < 5; ++i)
    star.push_back({{std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5)}});
  BOOST_TEST(!status(star));
  BOOST_TEST(!status({{{0, 0}}, {{1, 0}}, {{0, std::numeric_limits<double>::quiet_NaN()}}}));
}

// More corners than border vertices: nothing sensible fits, but a start comes out.
BOOST_AUTO_TEST_CASE(polygon_with_too_many_corners)
{
  const auto domain = make_domain(bumpy_patch(2, 2));
  FFM::Start_options options;
  options.border = FFM::Border_shape::polygon;
  for(int i = 0; i < 40; ++i)
    options.polygon.push_back({{std::cos(2 * pi * i / 40), std::sin(2 * pi * i / 40)}});
  const Result result = start_of(domain, options);
  BOOST_TEST((result.status == FFM::Status::success), result.message);
  BOOST_TEST(number_of_flips(domain, result.x) == 0);
}

BOOST_AUTO_TEST_CASE(linear_maps_are_reproduced)
{
  const Surface surface = planar_patch();
  const auto domain = make_domain(surface);
  const FFM::Positions<2> rest = positions_of<2>(surface, domain.scale);
  Eigen::Matrix2d linear;
  linear << 1.3, 0.4, -0.2, 0.9;
  for(bool mirrored : {false, true}) {
    Eigen::Matrix2d map = linear;
    if(mirrored)
      map.row(0) *= -1;
    const FFM::Positions<2> expected = (linear * rest).colwise() + Eigen::Vector2d(mirrored ? -3 : 3, 2);
    const FFM::Positions<2> given = (map * rest).colwise() + Eigen::Vector2d(3, 2);
    FFM::Positions<2> border(2, domain.border.size());
    for(std::size_t i = 0; i < domain.border.size(); ++i)
      border.col(i) = given.col(domain.border[i]);
    for(FFM::Tutte_weights weights : {FFM::Tutte_weights::cotangent, FFM::Tutte_weights::mean_value}) {
      FFM::Start_options options = plain_options();
      options.weights = weights;
      FFM::Positions<2> x;
      std::string name, failed;
      BOOST_TEST((Tutte(options).with_border(domain, border, "given", make_eigen_solver, x, name, failed) == FFM::Status::success));
      // A clockwise border is mirrored.
      BOOST_TEST((x - expected).cwiseAbs().maxCoeff() <= 1e-12);
      BOOST_TEST(name == std::string("tutte (given, ") + FFM::weights_name(weights) + ")");
      BOOST_TEST(failed.empty());
    }
  }
}

BOOST_AUTO_TEST_CASE(long_tubes_fail_and_say_so)
{
  const auto domain = make_domain(closed_tube(6, 150));
  FFM::Start_options options;
  options.border = FFM::Border_shape::square;
  const Result all = start_of(domain, options);
  BOOST_TEST((all.status == FFM::Status::start_not_flip_free));
  for(const char* border : {"square", "circle"})
    for(const char* weights : {"uniform", "mean_value", "cotangent"})
      BOOST_TEST(contains(all.message, std::string(border) + ", " + weights), all.message);

  options = plain_options();
  options.weights = FFM::Tutte_weights::mean_value;
  const Result one = start_of(domain, options);
  BOOST_TEST((one.status == FFM::Status::start_not_flip_free));
  BOOST_TEST(contains(one.message, "circle, mean_value"));
  BOOST_TEST(!contains(one.message, "uniform"));
  BOOST_TEST(!contains(one.message, "cotangent"));

  // Short tubes are fine.
  BOOST_TEST((start_of(make_domain(closed_tube(6, 8)), FFM::Start_options()).status == FFM::Status::success));
}

// With the given weights flips appear; the name tells the way to the start that was found in the end.
BOOST_AUTO_TEST_CASE(fallback_to_other_weights)
{
  // Spikes have obtuse triangles, which make cotangents negative.
  Random random(72);
  const auto domain = make_domain(grid(
    10, 10, [&random](double u, double v) { return Eigen::Vector3d(u, v, random(-1, 1)); }, true));
  FFM::Start_options options = plain_options();
  options.weights = FFM::Tutte_weights::cotangent;
  BOOST_TEST_REQUIRE((start_of(domain, options).status == FFM::Status::start_not_flip_free));
  options.fall_back = true;
  const Result result = start_of(domain, options);
  BOOST_TEST((result.status == FFM::Status::success));
  BOOST_TEST(number_of_flips(domain, result.x) == 0);
  BOOST_TEST(contains(result.name, "tutte (circle, uniform; after circle, cotangent with "));
}

// Two corners of this patch are triangles with all vertices on the border, which collapse on a square whatever the weights; they
// are flaps, whose apexes have a better place.
BOOST_AUTO_TEST_CASE(flaps_on_a_square)
{
  const auto domain = make_domain(bumpy_patch(12, 9));
  FFM::Start_options options = plain_options();
  options.border = FFM::Border_shape::square;
  const Result result = start_of(domain, options);
  BOOST_TEST((result.status == FFM::Status::success), result.message);
  BOOST_TEST(number_of_flips(domain, result.x) == 0);
  BOOST_TEST(result.name == "tutte (square, uniform, flaps placed)");
}

// An ear of two triangles in the middle of a side: the inner one is no flap and collapses on a square.
BOOST_AUTO_TEST_CASE(fallback_to_a_circle)
{
  Surface surface = patch_without_chords();
  const std::int32_t a = 5, b = 6, c = static_cast<std::int32_t>(surface.points.size()), d = c + 1;
  for(std::int32_t v : {a, b})
    surface.points.push_back(Eigen::Vector3d(surface.points[v] - Eigen::Vector3d(0, 0.1, 0)));
  surface.triangles.push_back({a, c, d});
  surface.triangles.push_back({a, d, b});
  const auto domain = make_domain(surface);
  FFM::Start_options options = plain_options();
  options.border = FFM::Border_shape::square;
  BOOST_TEST((start_of(domain, options).status == FFM::Status::start_not_flip_free));
  options.fall_back = true;
  const Result result = start_of(domain, options);
  BOOST_TEST((result.status == FFM::Status::success));
  BOOST_TEST(number_of_flips(domain, result.x) == 0);
  BOOST_TEST(contains(result.name, "tutte (circle, uniform"), result.name);
  for(const char* weights : {"uniform", "mean_value", "cotangent"})
    BOOST_TEST(contains(result.name, std::string("square, ") + weights + " with "), result.name);
}

// The apex of every flap minimises the energy of its triangle while the opposite edge stays.
BOOST_AUTO_TEST_CASE(flaps_are_at_their_optimum)
{
  const auto domain = make_domain(bumpy_patch(7, 6));
  FFM::Start_options options = plain_options();
  const FFM::Positions<2> before = start_of(domain, options).x;
  options.place_flaps = true;
  const FFM::Positions<2> after = start_of(domain, options).x;

  std::vector<int> degree(domain.number_of_vertices, 0);
  for(const auto& t : domain.elements)
    for(std::int32_t v : t)
      ++degree[v];
  int flaps = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    for(std::int32_t apex : domain.elements[e]) {
      if(degree[apex] != 1)
        continue;
      ++flaps;
      const auto energy = [&](const Eigen::Vector2d& p) {
        FFM::Positions<2> x = before;
        x.col(apex) = p;
        const Eigen::Matrix2d J = domain.jacobian(e, x);
        return J.determinant() > 0 ? J.squaredNorm() + J.inverse().squaredNorm() : std::numeric_limits<double>::infinity();
      };
      // Pattern search from where the vertex was.
      Eigen::Vector2d best = before.col(apex);
      for(double reach = 0.1; reach > 1e-9; reach *= 0.5)
        for(bool better = true; better;) {
          better = false;
          for(const Eigen::Vector2d& d : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)})
            if(energy(best + reach * d) < energy(best)) {
              best += reach * d;
              better = true;
            }
        }
      BOOST_TEST((best - after.col(apex)).norm() <= 1e-6);
      BOOST_TEST(energy(after.col(apex)) <= energy(best) * (1 + 1e-14));
      BOOST_TEST(energy(after.col(apex)) < energy(before.col(apex)));
    }
  BOOST_TEST(flaps == 2);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
    if(degree[v] != 1) {
      BOOST_TEST((before.col(v) == after.col(v)));
    }
}

BOOST_AUTO_TEST_CASE(smallest_meshes)
{
  // One triangle, which is nothing but flaps; two; a fan with one inner vertex.
  Surface triangle;
  triangle.points = {{0, 0, 0}, {2, 0, 0}, {0.5, 1, 1}};
  triangle.triangles = {{0, 1, 2}};
  Surface two = triangle;
  two.points.push_back({2, 2, 0.5});
  two.triangles.push_back({2, 1, 3});
  Surface fan;
  fan.points = {{0, 0, 0.4}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  fan.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  for(const Surface& surface : {triangle, two, fan})
    for(FFM::Border_shape border : all_borders)
      for(FFM::Tutte_weights weights : all_weights) {
        const auto domain = make_domain(surface);
        FFM::Start_options options;
        options.border = border;
        options.polygon = pentagon();
        options.weights = weights;
        const Result result = start_of(domain, options);
        BOOST_TEST((result.status == FFM::Status::success), result.message);
        BOOST_TEST(number_of_flips(domain, result.x) == 0);
      }
}

BOOST_AUTO_TEST_SUITE_END() // test_tutte
