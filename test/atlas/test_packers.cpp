// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Packings whose optima are known, and distances of all others, by segments.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer.h>
#include <CGAL/Flip_free_maps/atlas/internal/Rectangle_packer.h>
#include <CGAL/Flip_free_maps/atlas/internal/smallest_boxes.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_packers)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

using Sizes = std::vector<std::array<double, 2>>;
using Polygon = std::vector<Eigen::Vector2d>;

// Packs, and checks that rectangles keep the margin from each other and half of it from the sides. Returns the scale.
double packed_rectangles(const Sizes& sizes, double margin)
{
  FFM::internal::Rectangle_packer packer(sizes, margin);
  BOOST_TEST_REQUIRE(packer.pack());
  BOOST_TEST_REQUIRE(packer.places().size() == sizes.size());
  struct Box
  {
    Eigen::Vector2d low, high;
  };
  std::vector<Box> boxes;
  for(std::size_t i = 0; i < sizes.size(); ++i) {
    const auto& place = packer.places()[i];
    Eigen::Vector2d extent(sizes[i][0], sizes[i][1]);
    if(place.is_turned)
      std::swap(extent[0], extent[1]);
    boxes.push_back({Eigen::Vector2d(place.x, place.y), Eigen::Vector2d(place.x, place.y) + packer.scale() * extent});
    BOOST_TEST(boxes.back().low.minCoeff() >= 0.5 * margin - 1e-12);
    BOOST_TEST(boxes.back().high.maxCoeff() <= 1 - 0.5 * margin + 1e-12);
    for(std::size_t j = 0; j < i; ++j)
      BOOST_TEST((boxes[j].low - boxes[i].high).cwiseMax(boxes[i].low - boxes[j].high).maxCoeff() >= margin - 1e-12);
  }
  return packer.scale();
}

FFM::internal::Chart_outline outline_of(const std::vector<Polygon>& borders)
{
  FFM::internal::Chart_outline outline;
  Eigen::Index n = 0;
  for(const Polygon& polygon : borders)
    n += polygon.size();
  outline.sources.resize(2, n);
  outline.targets.resize(2, n);
  n = 0;
  for(const Polygon& polygon : borders)
    for(std::size_t i = 0; i < polygon.size(); ++i, ++n) {
      outline.sources.col(n) = polygon[i];
      outline.targets.col(n) = polygon[(i + 1) % polygon.size()];
    }
  return outline;
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const double t = (std::min)(1., (std::max)(0., (p - a).dot(b - a) / (b - a).squaredNorm()));
  return (p - a - t * (b - a)).norm();
}

bool do_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  const auto side = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Packs, and checks the distances between all borders and that rotations are such. Returns the scale and the placed outlines.
double packed_outlines(const std::vector<FFM::internal::Chart_outline>& outlines, double low, double high, double distance,
                       bool turns_freely, std::vector<FFM::internal::Chart_outline>& placed)
{
  FFM::internal::Outline_packer packer(outlines, distance, turns_freely ? 16 : 4, turns_freely);
  BOOST_TEST_REQUIRE(packer.pack(low, high, [] { return false; }));
  placed.clear();
  for(std::size_t c = 0; c < outlines.size(); ++c) {
    const auto& place = packer.places()[c];
    BOOST_TEST(place.cosine * place.cosine + place.sine * place.sine == 1, boost::test_tools::tolerance(1e-14));
    if(!turns_freely)
      BOOST_TEST(place.cosine * place.sine == 0);
    Eigen::Matrix2d rotation;
    rotation << place.cosine, -place.sine, place.sine, place.cosine;
    FFM::internal::Chart_outline result = outlines[c];
    result.sources = packer.scale() * rotation * result.sources;
    result.targets = packer.scale() * rotation * result.targets;
    // Places are those of the lower left corners of boxes.
    const Eigen::Vector2d shift = Eigen::Vector2d(place.x, place.y) - result.sources.rowwise().minCoeff();
    result.sources.colwise() += shift;
    result.targets.colwise() += shift;
    BOOST_TEST(result.sources.minCoeff() >= -1e-12);
    BOOST_TEST(result.sources.maxCoeff() <= 1 + 1e-12);
    placed.push_back(result);
    for(std::size_t o = 0; o < c; ++o)
      for(Eigen::Index i = 0; i < placed[c].sources.cols(); ++i)
        for(Eigen::Index j = 0; j < placed[o].sources.cols(); ++j) {
          const Eigen::Vector2d a = placed[c].sources.col(i), b = placed[c].targets.col(i), p = placed[o].sources.col(j),
                                q = placed[o].targets.col(j);
          BOOST_TEST(!do_cross(a, b, p, q));
          BOOST_TEST((std::min)({distance_to_segment(a, p, q), distance_to_segment(b, p, q), distance_to_segment(p, a, b),
                                 distance_to_segment(q, a, b)}) >= distance - 1e-9);
        }
  }
  return packer.scale();
}

const Polygon triangle{{0, 0}, {1, 0}, {0, 1}};
const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

} // namespace

BOOST_AUTO_TEST_CASE(rectangles_with_known_optima)
{
  const double near = 0.998;
  for(const double margin : {0.001, 0.02, 0.1}) {
    const double one = packed_rectangles({{{3, 2}}}, margin), optimum = (1 - margin) / 3;
    BOOST_TEST(one <= optimum * (1 + 1e-12));
    BOOST_TEST(one >= near * optimum);
    for(const int side : {2, 3}) {
      const double scale = packed_rectangles(Sizes(side * side, {{1, 1}}), margin), best = 1. / side - margin;
      BOOST_TEST(scale <= best * (1 + 1e-12));
      BOOST_TEST(scale >= near * best);
    }
    // Two of them fill a square only if one or both are turned.
    const double two = packed_rectangles({{{2, 1}, {1, 2}}}, margin), best = (std::min)((1 - margin) / 2, 0.5 - margin);
    BOOST_TEST(two <= best * (1 + 1e-12));
    BOOST_TEST(two >= near * best);
  }
  // So much for margins.
  const Sizes nine(9, {{1, 1}}), none(2, {{0, 0}});
  BOOST_TEST(!FFM::internal::Rectangle_packer(nine, 0.34).pack());
  BOOST_TEST(!FFM::internal::Rectangle_packer(none, 0.01).pack());
}

BOOST_AUTO_TEST_CASE(many_rectangles_keep_apart)
{
  Random random(31);
  for(const int number : {2, 7, 30, 150}) {
    Sizes sizes;
    double area = 0;
    for(int i = 0; i < number; ++i) {
      sizes.push_back({{random(0.1, 1), random(0.1, 1)}});
      area += sizes.back()[0] * sizes.back()[1];
    }
    const double scale = packed_rectangles(sizes, 0.004);
    BOOST_TEST(scale * scale * area <= 1);
    BOOST_TEST(scale * scale * area >= (number < 10 ? 0.4 : 0.6));
  }
}

// The side of the square around points with a side in this direction.
double side_of_square(const Eigen::Matrix2Xd& x, const Eigen::Vector2d& u)
{
  const Eigen::RowVectorXd along = u.transpose() * x, across = Eigen::RowVector2d(-u[1], u[0]) * x;
  return (std::max)(along.maxCoeff() - along.minCoeff(), across.maxCoeff() - across.minCoeff());
}

BOOST_AUTO_TEST_CASE(smallest_squares)
{
  // An equilateral triangle stands with a corner in one of the square, and both its other corners on sides.
  Eigen::Matrix2Xd triangle(2, 3);
  triangle << 0, 1, 0.5, 0, 0, std::sqrt(0.75);
  BOOST_TEST(side_of_square(triangle, FFM::internal::direction_of_smallest_square(triangle)) == std::cos(CGAL_PI / 12),
             boost::test_tools::tolerance(1e-12));
  // Points on a line have no inside.
  const Eigen::Matrix2Xd line = Eigen::Vector2d(1, 2) * Eigen::RowVector3d(0, 1, 3);
  BOOST_TEST(FFM::internal::direction_of_smallest_square(line) == Eigen::Vector2d(1, 0));
  Random random(5);
  for(int i = 0; i < 200; ++i) {
    Eigen::Matrix2Xd x(2, 3 + i % 9);
    for(Eigen::Index v = 0; v < x.cols(); ++v)
      x.col(v) << random(-1, 1), random(-0.3, 0.3) + (i % 2) * random(-1, 1);
    double least = 10;
    const int steps = 3000;
    for(int k = 0; k < steps; ++k)
      least = (std::min)(least, side_of_square(x, {std::cos(CGAL_PI / 2 * k / steps), std::sin(CGAL_PI / 2 * k / steps)}));
    const double side = side_of_square(x, FFM::internal::direction_of_smallest_square(x));
    BOOST_TEST(side <= least * (1 + 1e-12));
    BOOST_TEST(side >= least * (1 - CGAL_PI / steps)); // what a turn by half a step gains at most
  }
}

// Whether the segment between two points has a point in the box with this lower left corner and side.
bool meets_box(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& corner, double side)
{
  double first = 0, last = 1;
  for(int k = 0; k < 2; ++k) {
    const double way = q[k] - p[k];
    double in = (corner[k] - p[k]) / way, out = (corner[k] + side - p[k]) / way;
    if(in > out)
      std::swap(in, out);
    first = (std::max)(first, in);
    last = (std::min)(last, out);
  }
  return first <= last;
}

// By the number of edges of the polygon that a ray to the right crosses.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point)
{
  bool is_inside = false;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d p = polygon[i] - point, q = polygon[(i + 1) % polygon.size()] - point;
    if((p[1] > 0) != (q[1] > 0) && p[0] - p[1] * (q[0] - p[0]) / (q[1] - p[1]) > 0)
      is_inside = !is_inside;
  }
  return is_inside;
}

// A figure's cells are those that the turned outline meets or of which it contains the centres.
BOOST_AUTO_TEST_CASE(figures_are_cells_of_turned_outlines)
{
  const int size = 256; // more than a word in a row
  const double rounding = 1e-5;
  Random random(11);
  for(int i = 0; i < 12; ++i) {
    Polygon star;
    const double longest = random(2, i % 2 == 0 ? 90 : 20), thinnest = random(0.2, 1);
    const Eigen::Vector2d place(random(-50, 50), random(-50, 50));
    for(int k = 0; k < 11; ++k) {
      const double angle = 2 * CGAL_PI * k / 11 + random(0, 0.3);
      star.push_back(place + longest * (k % 2 == 0 ? 1 : thinnest) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    const auto figures = FFM::internal::Cell_figure::quarter_turns(outline_of({star}), size);
    for(const auto& figure : figures) {
      Eigen::Vector2d low = star.front();
      for(const Eigen::Vector2d& point : star)
        low = low.cwiseMin(point);
      Polygon moved;
      for(const Eigen::Vector2d& point : star)
        moved.push_back(point - low + figure.low());
      std::vector<char> cells(figure.width() * figure.height(), 0);
      for(const auto& run : figure.runs())
        for(int x = run.first; x <= run.last; ++x)
          cells[run.row * figure.width() + x] = 1;
      int number_wrong = 0;
      for(int y = -1; y <= figure.height(); ++y)
        for(int x = -1; x <= figure.width(); ++x) {
          const Eigen::Vector2d corner(x, y), inset(rounding, rounding);
          bool is_met = contains(moved, corner + Eigen::Vector2d(0.5, 0.5)), may_be_met = is_met;
          for(std::size_t k = 0; k < moved.size(); ++k) {
            const Eigen::Vector2d &p = moved[k], &q = moved[(k + 1) % moved.size()];
            is_met = is_met || meets_box(p, q, corner + inset, 1 - 2 * rounding);
            may_be_met = may_be_met || meets_box(p, q, corner - inset, 1 + 2 * rounding);
          }
          const bool is_inside = x >= 0 && y >= 0 && x < figure.width() && y < figure.height();
          const bool is_taken = is_inside && cells[y * figure.width() + x] == 1;
          number_wrong += (is_met && !is_taken) || (is_taken && !may_be_met);
        }
      BOOST_TEST(number_wrong == 0);
      for(Eigen::Vector2d& point : star)
        point = Eigen::Vector2d(-point[1], point[0]);
    }
  }
}

// Places and lengths of free runs, one cell at a time.
BOOST_AUTO_TEST_CASE(places_in_a_grid_are_the_first_ones)
{
  const int size = 128;
  Random random(7);
  FFM::internal::Cell_grid grid(size);
  std::vector<char> is_taken(size * size, 0);
  int number_placed = 0, number_refused = 0;
  for(int i = 0; i < 150; ++i) {
    // A star, some with dents.
    Polygon star;
    const double longest = random(3, i < 20 ? 45 : 9), thinnest = random(0.3, 1);
    for(int k = 0; k < 9; ++k)
      star.push_back(longest * (k % 2 == 0 ? 1 : thinnest) * Eigen::Vector2d(std::cos(0.7 * k), std::sin(0.7 * k)));
    const FFM::internal::Cell_figure figure = FFM::internal::Cell_figure::quarter_turns(outline_of({star}), size)[i % 4];
    std::vector<char> cells(figure.width() * figure.height(), 0);
    for(const auto& run : figure.runs())
      for(int x = run.first; x <= run.last; ++x)
        cells[run.row * figure.width() + x] = 1;
    for(std::size_t k = 0; k < figure.blocks().size(); ++k)
      for(int y = 0; y < 1 << k; ++y)
        for(int x = figure.blocks()[k].first; x <= figure.blocks()[k].last; ++x)
          BOOST_TEST_REQUIRE(cells[(figure.blocks()[k].row + y) * figure.width() + x] == 1);
    const auto has_room = [&](int x0, int y0) {
      for(int y = 0; y < figure.height(); ++y)
        for(int x = 0; x < figure.width(); ++x)
          if(cells[y * figure.width() + x] && is_taken[(y0 + y) * size + x0 + x])
            return false;
      return true;
    };
    int place = -1, row = 0;
    for(; row + figure.height() <= size && place < 0; ++row) {
      int expected = 0;
      while(expected + figure.width() <= size && !has_room(expected, row))
        ++expected;
      place = grid.first_place(figure, row);
      BOOST_TEST_REQUIRE(place == (expected + figure.width() <= size ? expected : -1));
    }
    if(place < 0) {
      ++number_refused;
      continue;
    }
    ++number_placed;
    const double distance = random(0, 3);
    grid.take(figure, place, --row, distance);
    for(int y = 0; y < size; ++y)
      for(int x = 0; x < size; ++x)
        for(const auto& run : figure.runs()) {
          // Between the nearest points of two cells.
          const int dx = (std::max)({place + run.first - x - 1, x - place - run.last - 1, 0});
          const int dy = (std::max)(std::abs(row + run.row - y) - 1, 0);
          if(std::hypot(dx, dy) < distance || (y == row + run.row && x >= place + run.first && x <= place + run.last))
            is_taken[y * size + x] = 1;
        }
  }
  BOOST_TEST(number_placed > 30);
  BOOST_TEST(number_refused > 10);
}

// Boxes of unit length would be half as large.
BOOST_AUTO_TEST_CASE(triangles_share_a_square)
{
  const std::vector<FFM::internal::Chart_outline> outlines(2, outline_of({triangle}));
  std::vector<FFM::internal::Chart_outline> placed;
  for(const double distance : {0.004, 0.03}) {
    const double scale = packed_outlines(outlines, 0.45, 1, distance, false, placed);
    BOOST_TEST(scale <= 1 - distance / std::sqrt(2.) + 1e-9);
    BOOST_TEST(scale >= 0.9 * (1 - 2 * distance));
  }
}

BOOST_AUTO_TEST_CASE(holes_and_dents_are_used)
{
  // A frame with a hole of half its side, and a square that fills most of it.
  Polygon frame, hole, inner;
  for(const Eigen::Vector2d& p : square) {
    frame.push_back(2 * p);
    hole.insert(hole.begin(), p + Eigen::Vector2d(0.5, 0.5));
    inner.push_back(0.9 * p);
  }
  const std::vector<FFM::internal::Chart_outline> outlines{outline_of({frame, hole}), outline_of({inner})};
  std::vector<FFM::internal::Chart_outline> placed;
  const double scale = packed_outlines(outlines, 0.2, 0.6, 0.01, false, placed);
  BOOST_TEST(scale >= 0.48);
  BOOST_TEST(scale <= 0.5 + 1e-9);
  // It lies within the hole, not only clear of all borders.
  const Eigen::Vector2d centre = placed[1].sources.rowwise().mean();
  BOOST_TEST((centre.array() > placed[0].sources.rightCols(4).rowwise().minCoeff().array()).all());
  BOOST_TEST((centre.array() < placed[0].sources.rightCols(4).rowwise().maxCoeff().array()).all());
}

// Where nothing would be too near the border of another chart, but within it.
BOOST_AUTO_TEST_CASE(charts_keep_out_of_others)
{
  Polygon small;
  for(const Eigen::Vector2d& p : square)
    small.push_back(0.1 * p);
  const std::vector<FFM::internal::Chart_outline> outlines{outline_of({square}), outline_of({small})};
  std::vector<FFM::internal::Chart_outline> placed;
  const double scale = packed_outlines(outlines, 0.5, 0.95, 0.01, false, placed);
  BOOST_TEST(scale * 1.1 + 0.01 <= 1 + 1e-9);
}

// The longest needle in a square lies on its diagonal.
BOOST_AUTO_TEST_CASE(charts_turn_freely)
{
  const std::vector<FFM::internal::Chart_outline> needle{outline_of({{{0, 0}, {1, 0}, {1, 0.02}, {0, 0.02}}})};
  std::vector<FFM::internal::Chart_outline> placed;
  BOOST_TEST(packed_outlines(needle, 0.5, 2, 0.01, false, placed) <= 1);
  const double scale = packed_outlines(needle, 0.5, 2, 0.01, true, placed);
  BOOST_TEST(scale >= 1.25);
  BOOST_TEST(scale <= std::sqrt(2.));
}

BOOST_AUTO_TEST_SUITE_END() // test_packers
