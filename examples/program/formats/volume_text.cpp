// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "volume_text.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

// The text with other points. The reader is at the first of them; `skip_before` and `skip_after` skip what a point's line holds beside
// its coordinates.
template <typename SkipBefore, typename SkipAfter>
std::string replaced_points(const std::string& text, internal::Word_reader& reader, const std::vector<std::array<double, 3>>& points,
                            SkipBefore&& skip_before, SkipAfter&& skip_after)
{
  std::string result;
  const char* copied = text.data();
  for(const auto& point : points) {
    skip_before();
    for(const double coordinate : point) {
      result.append(copied, reader.word().data());
      internal::append_number(result, coordinate);
      copied = reader.word().data() + reader.word().size();
      reader.skip_word();
    }
    skip_after();
  }
  result.append(copied, text.data() + text.size());
  return result;
}

} // namespace

std::string Medit_with_points(const std::string& text, const std::vector<std::array<double, 3>>& points)
{
  internal::Word_reader reader(text);
  while(!reader.at_end() && reader.word() != "Vertices")
    reader.skip_word();
  reader.skip_word();
  reader.skip_word(); // how many
  return replaced_points(
    text, reader, points, [] {},
    [&] {
      if(reader.is_line_continued()) // the reference
        reader.skip_word();
    });
}

std::string Tetgen_with_points(const std::string& text, const std::vector<std::array<double, 3>>& points)
{
  internal::Word_reader reader(text);
  reader.skip_word(); // how many
  reader.skip_word(); // the dimension, which may be on a line of its own
  reader.skip_line();
  return replaced_points(
    text, reader, points, [&] { reader.skip_word(); }, // the number
    [&] { reader.skip_line(); });
}

} // namespace program
