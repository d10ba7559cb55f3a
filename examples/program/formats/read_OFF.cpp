// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Binary_reader.h"
#include "readers.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

#include <cmath>
#include <cstdint>

namespace program {

namespace {

using CGAL::Flip_free_maps::internal::quoted_word;
using CGAL::Flip_free_maps::internal::Word_reader;

struct OFF_header
{
  bool has_texture = false, has_colors = false, has_normals = false, is_valid = false;
};

// [ST][C][N]OFF; further coordinates, 4OFF and nOFF, are not supported.
OFF_header parse_OFF_keyword(std::string_view word)
{
  OFF_header header;
  const auto take = [&](std::string_view prefix) {
    const bool is_there = word.substr(0, prefix.size()) == prefix;
    if(is_there)
      word.remove_prefix(prefix.size());
    return is_there;
  };
  header.has_texture = take("ST");
  header.has_colors = take("C");
  header.has_normals = take("N");
  header.is_valid = word == "OFF";
  return header;
}

std::string read_ascii_OFF(Word_reader& reader, Polygon_file& file)
{
  std::size_t points = 0, faces = 0;
  if(!reader.read_count(points) || !reader.read_count(faces))
    return reader.error();
  reader.skip_line(); // the number of edges
  for(std::size_t i = 0; i < points; ++i) {
    std::array<double, 3> point;
    for(double& coordinate : point)
      if(!reader.read_finite(coordinate))
        return reader.error();
    file.points.push_back(point);
    reader.skip_line(); // normals, colors, texture coordinates
  }
  for(std::size_t i = 0; i < faces; ++i) {
    std::size_t corners = 0;
    if(!reader.read_count(corners))
      return reader.error();
    file.polygons.emplace_back();
    for(std::size_t k = 0; k < corners; ++k) {
      const long long line = reader.line();
      std::size_t v = 0;
      if(!reader.read_count(v))
        return reader.error();
      if(v >= points)
        return "line " + std::to_string(line) + ": face number " + std::to_string(i) + " (from 0) names the vertex " + std::to_string(v) +
               ", which does not exist";
      file.polygons.back().push_back(v);
    }
    reader.skip_line(); // colors
  }
  return "";
}

// Some programs leave the colors of faces out, even their number. Whatever is true, all bytes must be used.
std::string read_binary_OFF(std::string_view bytes, bool is_big_endian, bool has_face_colors, const OFF_header& header, Polygon_file& file)
{
  file = Polygon_file();
  Binary_reader reader(bytes, is_big_endian);
  const std::uint32_t points = reader.read<std::uint32_t>(), faces = reader.read<std::uint32_t>();
  reader.read<std::uint32_t>();
  const int others = (header.has_normals ? 3 : 0) + (header.has_colors ? 4 : 0) + (header.has_texture ? 2 : 0);
  for(std::uint32_t i = 0; i < points && !reader.has_failed(); ++i) {
    std::array<double, 3> point;
    for(double& coordinate : point) {
      coordinate = reader.read<float>();
      if(!std::isfinite(coordinate))
        return "a coordinate of point number " + std::to_string(i) + " (from 0) is not a finite number";
    }
    for(int k = 0; k < others; ++k)
      reader.read<float>();
    file.points.push_back(point);
  }
  for(std::uint32_t i = 0; i < faces && !reader.has_failed(); ++i) {
    const std::uint32_t corners = reader.read<std::uint32_t>();
    if(corners == 0)
      return "face number " + std::to_string(i) + " (from 0) has no corners";
    file.polygons.emplace_back();
    for(std::uint32_t k = 0; k < corners && !reader.has_failed(); ++k)
      file.polygons.back().push_back(reader.read<std::uint32_t>());
    const std::uint32_t colors = has_face_colors ? reader.read<std::uint32_t>() : 0;
    for(std::uint32_t k = 0; k < colors && !reader.has_failed(); ++k)
      reader.read<float>();
  }
  return reader.has_failed() ? "the file ends too early, or its counts are wrong"
         : reader.left() > 0 ? "more bytes follow the last face"
                             : "";
}

} // namespace

std::string read_OFF(std::string_view text, bool, Polygon_file& file)
{
  Word_reader reader(text);
  const std::string_view word = reader.word();
  double number;
  OFF_header header;
  // The keyword may be missing.
  if(CGAL::Flip_free_maps::internal::parse_number(word, number) != std::errc()) {
    header = parse_OFF_keyword(word);
    if(!header.is_valid)
      return quoted_word(word) +
             " is none of the keywords OFF, COFF, NOFF, CNOFF, STOFF, ..., hence this is not an OFF file that can be read";
    reader.skip_word();
  }
  if(!reader.is_line_continued() || reader.word() != "BINARY")
    return read_ascii_OFF(reader, file);
  const std::size_t end_of_line = text.find('\n');
  if(end_of_line == std::string_view::npos)
    return "the file ends after its first line";
  // Big endian by definition; the other order is found, too.
  std::string first_error;
  for(const bool is_big_endian : {true, false})
    for(const bool has_face_colors : {true, false}) {
      const std::string error = read_binary_OFF(text.substr(end_of_line + 1), is_big_endian, has_face_colors, header, file);
      if(error.empty())
        return "";
      if(first_error.empty())
        first_error = error;
    }
  return first_error;
}

} // namespace program
