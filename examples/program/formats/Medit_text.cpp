// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Medit_text.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

namespace program {

std::string Medit_with_points(const std::string& text, const std::vector<std::array<double, 3>>& points)
{
  namespace internal = CGAL::Flip_free_maps::internal;
  internal::Word_reader reader(text);
  while(!reader.at_end() && reader.word() != "Vertices")
    reader.skip_word();
  reader.skip_word();
  reader.skip_word(); // how many
  std::string result;
  const char* copied = text.data();
  for(const auto& point : points) {
    for(const double coordinate : point) {
      result.append(copied, reader.word().data());
      internal::append_number(result, coordinate);
      copied = reader.word().data() + reader.word().size();
      reader.skip_word();
    }
    if(reader.is_line_continued()) // the reference
      reader.skip_word();
  }
  result.append(copied, text.data() + text.size());
  return result;
}

} // namespace program
