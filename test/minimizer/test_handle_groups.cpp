// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The ways of handles to their targets against rigid motions that are known.

#include "support/unit_test.h"

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/minimizer/internal/Handle_groups.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_handle_groups)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// Handles in two corners of a sheet: those of each share elements with each other.
struct Two_groups
{
  static constexpr std::int32_t COLUMNS = 9;
  Surface flat = grid(8, 6, [](double u, double v) { return Eigen::Vector3d(8 * u, 6 * v, 0); });
  FFM::Simplicial_domain<2> domain = make_domain(flat);
  FFM::Positions<2> x = domain.scale * positions_of<2>(flat, domain.scale);
  std::vector<std::int32_t> first{0, 1, COLUMNS, COLUMNS + 1}, second{6 * COLUMNS + 7, 6 * COLUMNS + 8, 5 * COLUMNS + 8};
  FFM::internal::Handle_groups<2> groups{domain, [this](std::int32_t v) { return is_in(first, v) || is_in(second, v); }};

  static bool is_in(const std::vector<std::int32_t>& group, std::int32_t v)
  {
    return std::find(group.begin(), group.end(), v) != group.end();
  }

  // The targets of a group that turns around its centre and moves.
  void turn(const std::vector<std::int32_t>& group, double angle, const Eigen::Vector2d& translation, FFM::Positions<2>& targets) const
  {
    const Eigen::Vector2d centre = centre_of(group, x);
    for(std::int32_t v : group)
      targets.col(v) = centre + translation + Eigen::Rotation2Dd(angle) * (x.col(v) - centre);
  }

  static Eigen::Vector2d centre_of(const std::vector<std::int32_t>& group, const FFM::Positions<2>& y)
  {
    Eigen::Vector2d sum(0, 0);
    for(std::int32_t v : group)
      sum += y.col(v);
    return sum / group.size();
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(each_group_turns_around_its_own_centre, Two_groups)
{
  FFM::Positions<2> targets = FFM::Positions<2>::Constant(2, x.cols(), std::numeric_limits<double>::quiet_NaN());
  const Eigen::Vector2d translation(0.3, -0.2);
  turn(first, 2, translation, targets);
  turn(second, -1, {0, 0}, targets);
  FFM::Positions<2> y = x;
  bool is_last = false;
  int rounds = 0;
  for(; !is_last && rounds < 10; ++rounds) {
    FFM::Positions<2> displacement = FFM::Positions<2>::Zero(2, x.cols());
    BOOST_TEST_REQUIRE(groups.next_displacement(y, targets, displacement, is_last));
    y += displacement;
    if(is_last)
      break;
    // Half a radian of the greatest angle that was left, and the same part of everything else.
    FFM::Positions<2> expected = x;
    const double fraction = 0.25 * (rounds + 1);
    turn(first, 2 * fraction, fraction * translation, expected);
    turn(second, -fraction, {0, 0}, expected);
    BOOST_TEST((y - expected).norm() <= 1e-12);
  }
  BOOST_TEST(rounds == 3);
  for(const auto* group : {&first, &second})
    for(std::int32_t v : *group)
      BOOST_TEST((y.col(v) - targets.col(v)).norm() <= 1e-14);

  FFM::Positions<2> placed = x;
  groups.place(targets, placed);
  for(std::int32_t v = 0; v < x.cols(); ++v)
    BOOST_TEST((placed.col(v) == (is_in(first, v) || is_in(second, v) ? targets : x).col(v)));
}

// Handles that share no element go straight, however their line turns.
BOOST_FIXTURE_TEST_CASE(single_handles_go_straight, Two_groups)
{
  const std::int32_t a = 0, b = 8;
  const FFM::internal::Handle_groups<2> singles(domain, [](std::int32_t v) { return v == a || v == b; });
  FFM::Positions<2> targets = x, displacement = FFM::Positions<2>::Zero(2, x.cols());
  turn({a, b}, 3, {0.1, 0.2}, targets);
  bool is_last = false;
  BOOST_TEST_REQUIRE(singles.next_displacement(x, targets, displacement, is_last));
  BOOST_TEST(is_last);
  BOOST_TEST((displacement - (targets - x)).norm() <= 1e-14);
}

BOOST_FIXTURE_TEST_CASE(the_whole_is_carried_where_all_handles_turn, Two_groups)
{
  const auto moved = [this](double angle) {
    return FFM::Positions<2>((Eigen::Rotation2Dd(angle).toRotationMatrix() * x).colwise() + Eigen::Vector2d(3, -1));
  };
  FFM::Positions<2> carried;
  for(const double angle : {0.6, -2.5, 3.1}) {
    BOOST_TEST_REQUIRE(groups.carry(x, moved(angle), carried));
    BOOST_TEST((carried - moved(angle)).norm() <= 1e-12 * x.norm());
  }
  BOOST_TEST(!groups.carry(x, moved(0.4), carried));
  // One of the groups turns further on its own.
  FFM::Positions<2> targets = moved(1);
  const Eigen::Vector2d centre = centre_of(second, targets);
  for(std::int32_t v : second)
    targets.col(v) = centre + Eigen::Rotation2Dd(2) * (targets.col(v) - centre);
  BOOST_TEST(!groups.carry(x, targets, carried));
}

BOOST_FIXTURE_TEST_CASE(targets_that_are_not_finite_are_refused, Two_groups)
{
  for(const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FFM::Positions<2> targets = x, displacement = FFM::Positions<2>::Zero(2, x.cols());
    targets(1, second[1]) = bad;
    bool is_last = false;
    BOOST_TEST(!groups.next_displacement(x, targets, displacement, is_last));
    BOOST_TEST(displacement.isZero(0));
  }
}

// Of all rotations that lead a line of handles to its targets the one with the least angle is taken.
BOOST_AUTO_TEST_CASE(a_line_in_space_turns_as_little_as_it_can)
{
  const Volume volume = bar(4, 1, 1, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(volume);
  const FFM::Positions<3> x = domain.scale * positions_of<3>(volume, domain.scale);
  const auto is_handle = [&](std::int32_t v) { return x(1, v) == 0 && x(2, v) == 0; };
  const FFM::internal::Handle_groups<3> groups(domain, is_handle);
  const Eigen::Vector3d centre(2, 0, 0);
  const auto turned = [&](double angle) {
    FFM::Positions<3> y = x;
    for(std::int32_t v = 0; v < x.cols(); ++v)
      if(is_handle(v))
        y.col(v) = centre + Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * (x.col(v) - centre);
    return y;
  };
  FFM::Positions<3> displacement = FFM::Positions<3>::Zero(3, x.cols());
  bool is_last = true;
  BOOST_TEST_REQUIRE(groups.next_displacement(x, turned(1.25), displacement, is_last));
  BOOST_TEST(!is_last);
  BOOST_TEST((x + displacement - turned(0.5)).norm() <= 1e-12);
}

// Opposite directions do not tell the axis: any one that is orthogonal to them will do.
BOOST_AUTO_TEST_CASE(a_line_in_space_turns_round)
{
  const Volume shape = bar(6, 1, 1, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Simplicial_domain<3> domain = make_domain(shape);
  const FFM::Positions<3> x = domain.scale * positions_of<3>(shape, domain.scale);
  std::vector<std::int32_t> line;
  for(std::int32_t v = 0; v < x.cols(); ++v)
    if(x(1, v) == 0 && x(2, v) == 0)
      line.push_back(v);
  BOOST_TEST_REQUIRE(line.size() == 7u);
  const FFM::internal::Handle_groups<3> groups(domain,
                                               [&](std::int32_t v) { return std::find(line.begin(), line.end(), v) != line.end(); });
  Eigen::Vector3d centre(0, 0, 0);
  for(const std::int32_t v : line)
    centre += x.col(v) / line.size();
  for(const double angle : {1e-9, 3.14, CGAL_PI - 1e-9, CGAL_PI}) {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(0, 0.6, 0.8));
    FFM::Positions<3> targets = x, displacement = FFM::Positions<3>::Zero(3, x.cols());
    for(const std::int32_t v : line)
      targets.col(v) = centre + turn * (x.col(v) - centre);
    bool is_last = false;
    BOOST_TEST_REQUIRE(groups.next_displacement(x, targets, displacement, is_last));
    BOOST_TEST(is_last == (angle < 0.5));
    // After a round the line is as long as before, and has turned by its part of the angle, half a radian at most.
    const Eigen::Vector3d before = x.col(line.back()) - x.col(line.front());
    const Eigen::Vector3d after = before + displacement.col(line.back()) - displacement.col(line.front());
    BOOST_TEST(std::abs(after.norm() / before.norm() - 1) <= 1e-8);
    const double turned = std::atan2(before.cross(after).norm(), before.dot(after));
    BOOST_TEST(std::abs(turned - (std::min)(angle, 0.5)) <= 1e-7);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_handle_groups
