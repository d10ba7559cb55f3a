// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Where charts meet: chart_contacts().

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/atlas/internal/chart_contacts.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_chart_contacts)

namespace FFM = CGAL::Flip_free_maps;
using FFM::internal::Chart_contact;
using FFM::internal::Linked_triangles;

// Three by three unit squares, two triangles each; the squares' numbers go by columns.
static Linked_triangles nine_squares()
{
  Linked_triangles surface;
  surface.points.resize(3, 16);
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j)
      surface.points.col(4 * i + j) << i, j, 0;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j) {
      const int v = 4 * i + j;
      surface.triangles.push_back({{v, v + 4, v + 5}});
      surface.triangles.push_back({{v, v + 5, v + 1}});
    }
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> sides;
  surface.opposite.assign(3 * surface.triangles.size(), -1);
  for(std::int32_t h = 0; h < static_cast<std::int32_t>(surface.opposite.size()); ++h) {
    const auto& t = surface.triangles[h / 3];
    const std::int32_t v = t[h % 3], w = t[(h + 1) % 3];
    sides[{v, w}] = h;
    const auto other = sides.find({w, v});
    if(other != sides.end()) {
      surface.opposite[h] = other->second;
      surface.opposite[other->second] = h;
    }
  }
  for(std::int32_t f = 0; f < static_cast<std::int32_t>(surface.triangles.size()); ++f)
    surface.polygons.push_back(f);
  return surface;
}

struct Contacts
{
  std::vector<Chart_contact> contacts;
  double perimeter;
};

// Those of chart 0, given the charts of the squares.
static Contacts contacts_of_first(const std::array<std::int32_t, 9>& charts, std::int32_t open_side = -1)
{
  const Linked_triangles surface = nine_squares();
  std::vector<std::int32_t> chart_of, faces;
  for(std::int32_t f = 0; f < 18; ++f) {
    chart_of.push_back(charts[f / 2]);
    if(chart_of.back() == 0)
      faces.push_back(f);
  }
  Contacts result;
  result.contacts = FFM::internal::chart_contacts(
    surface, faces, chart_of, [open_side](std::int32_t h) { return h != open_side; }, result.perimeter);
  for(const Chart_contact& contact : result.contacts)
    for(const std::int32_t h : contact.halfedges) {
      BOOST_TEST(chart_of[h / 3] == 0);
      BOOST_TEST(chart_of[surface.opposite[h] / 3] == contact.neighbor);
    }
  return result;
}

BOOST_AUTO_TEST_CASE(a_chart_within_another)
{
  const Contacts all = contacts_of_first({{1, 1, 1, 1, 0, 1, 1, 1, 1}});
  BOOST_TEST(std::abs(all.perimeter - 4) <= 1e-15);
  BOOST_TEST_REQUIRE(all.contacts.size() == 1u);
  BOOST_TEST(all.contacts[0].halfedges.size() == 4u);
  BOOST_TEST(std::abs(all.contacts[0].length - 4) <= 1e-15);

  // One of the sides is to stay open: the lower side of the square is the first halfedge of its second triangle.
  const Contacts some = contacts_of_first({{1, 1, 1, 1, 0, 1, 1, 1, 1}}, all.contacts[0].halfedges[0]);
  BOOST_TEST(std::abs(some.perimeter - 4) <= 1e-15);
  BOOST_TEST_REQUIRE(some.contacts.size() == 1u);
  BOOST_TEST(some.contacts[0].halfedges.size() == 3u);
}

BOOST_AUTO_TEST_CASE(neighbors_are_sorted_by_length)
{
  const Contacts two = contacts_of_first({{2, 2, 2, 2, 0, 1, 2, 2, 1}});
  BOOST_TEST_REQUIRE(two.contacts.size() == 2u);
  BOOST_TEST(two.contacts[0].neighbor == 2);
  BOOST_TEST(std::abs(two.contacts[0].length - 3) <= 1e-15);
  BOOST_TEST(two.contacts[1].neighbor == 1);
  BOOST_TEST(std::abs(two.contacts[1].length - 1) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(contacts_apart_are_different_ones)
{
  // The column in the middle has the same chart on both sides; closing both seams would make a ring if the chart went around.
  const Contacts both = contacts_of_first({{1, 1, 1, 0, 0, 0, 1, 1, 1}});
  BOOST_TEST(std::abs(both.perimeter - 8) <= 1e-15);
  BOOST_TEST_REQUIRE(both.contacts.size() == 2u);
  for(const Chart_contact& contact : both.contacts)
    BOOST_TEST(std::abs(contact.length - 3) <= 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
