// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "readers.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>

#include <cmath>
#include <system_error>

namespace program {

namespace {

namespace internal = CGAL::Flip_free_maps::internal;
using Words = std::vector<std::string_view>;

std::string read_vertex(const Words& words, Polygon_file& file)
{
  if(words.size() < 4)
    return "a vertex needs three coordinates";
  std::array<double, 3> point;
  for(std::size_t k = 0; k < 3; ++k)
    if(internal::parse_number(words[k + 1], point[k]) != std::errc() || !std::isfinite(point[k]))
      return internal::quoted_word(words[k + 1]) + " is not a finite number";
  file.points.push_back(point);
  return "";
}

// A face may precede its vertices, hence only negative indices are checked here.
std::string read_face(const Words& words, Polygon_file& file)
{
  file.polygons.emplace_back();
  for(std::size_t k = 1; k < words.size(); ++k) {
    const std::string_view word = words[k].substr(0, words[k].find('/'));
    long long index = 0;
    if(internal::parse_number(word, index) != std::errc())
      return "corner " + internal::quoted_word(words[k]) + " does not begin with the number of a vertex";
    if(index < 0)
      index += static_cast<long long>(file.points.size()) + 1;
    if(index < 1)
      return "corner " + internal::quoted_word(words[k]) + " names a vertex that does not exist";
    file.polygons.back().push_back(static_cast<std::size_t>(index - 1));
  }
  return "";
}

} // namespace

// Keywords other than v and f are skipped.
std::string read_OBJ(std::string_view text, Polygon_file& file)
{
  internal::OBJ_tokenizer tokenizer(text);
  Words words;
  std::vector<long long> lines;
  while(tokenizer.next_line(words)) {
    if(words.empty())
      continue;
    std::string error;
    if(words[0] == "v")
      error = read_vertex(words, file);
    else if(words[0] == "f") {
      error = read_face(words, file);
      lines.push_back(tokenizer.line());
    }
    if(!error.empty())
      return "line " + std::to_string(tokenizer.line()) + ": " + error;
  }
  for(std::size_t i = 0; i < file.polygons.size(); ++i)
    for(const std::size_t v : file.polygons[i])
      if(v >= file.points.size())
        return "line " + std::to_string(lines[i]) + ": the face names the vertex " + std::to_string(v + 1) +
               ", which does not exist: the file has " + std::to_string(file.points.size());
  if(file.points.empty() && file.polygons.empty())
    return "there is no vertex and no face, hence this is not an OBJ file";
  return "";
}

} // namespace program
