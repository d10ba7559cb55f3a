// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_OBJ_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IO_OBJ_IMPL_H

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE OBJ_tokenizer::OBJ_tokenizer(std::string_view text) : m_text(text)
{
  const std::string_view byte_order_mark("\xEF\xBB\xBF");
  if(m_text.substr(0, byte_order_mark.size()) == byte_order_mark)
    m_position = byte_order_mark.size();
}

CGAL_FLIP_FREE_MAPS_INLINE bool OBJ_tokenizer::next_line(std::vector<std::string_view>& words)
{
  words.clear();
  if(m_position >= m_text.size())
    return false;

  m_line = m_next_line;
  while(m_position < m_text.size()) {
    const char c = m_text[m_position];
    if(skip_line_end(m_position))
      return true;
    if(c == ' ' || c == '\t' || c == '\v' || c == '\f')
      ++m_position;
    else if(c == '#')
      while(m_position < m_text.size() && m_text[m_position] != '\n' && m_text[m_position] != '\r')
        ++m_position;
    else if(is_continuation(m_position)) {
      ++m_position;
      skip_line_end(m_position);
    } else {
      const std::size_t begin = m_position;
      while(m_position < m_text.size() && !is_space(m_text[m_position]) && !is_continuation(m_position))
        ++m_position;
      words.push_back(m_text.substr(begin, m_position - begin));
    }
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool OBJ_tokenizer::skip_line_end(std::size_t& i)
{
  if(i >= m_text.size() || (m_text[i] != '\n' && m_text[i] != '\r'))
    return false;
  i += (m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n') ? 2 : 1;
  ++m_next_line;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read(std::string_view text)
{
  OBJ_tokenizer tokenizer(text);
  std::vector<std::string_view> words;
  while(tokenizer.next_line(words)) {
    if(words.empty())
      continue;
    std::string error;
    if(words[0] == "v")
      error = read_coordinates(words, points);
    else if(words[0] == "vt" && m_demand != Demand::points_only)
      error = read_coordinates(words, texture);
    else if(words[0] == "f") {
      error = read_polygon(words);
      lines.push_back(tokenizer.line());
    }
    if(!error.empty())
      return at_line(tokenizer.line(), error);
  }
  const std::string error = range_error();
  if(!error.empty() || m_demand != Demand::textured_triangles)
    return error;
  return polygons.empty() ? "the file has no triangle" : "";
}

// A face may precede the points that it uses, hence the upper bound is tested at the end.
CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::range_error() const
{
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(std::size_t k = 0; k < polygons[i].size(); ++k) {
      if(polygons[i][k] >= points.size())
        return at_line(lines[i], too_large("v", polygons[i][k], points.size()));
      if(m_demand == Demand::points_only)
        continue;
      const std::size_t t = texture_polygons[i][k];
      if(t != no_texture && t >= texture.size())
        return at_line(lines[i], too_large("vt", t, texture.size()));
    }
  return std::string();
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::too_large(const char* kind, std::size_t index, std::size_t size)
{
  return std::string(kind) + " index " + std::to_string(index + 1) + " is out of range, the file has " + std::to_string(size) + " '" +
         kind + "' lines";
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read_polygon(const std::vector<std::string_view>& words)
{
  if(m_demand == Demand::textured_triangles && words.size() != 4)
    return "the face has " + std::to_string(words.size() - 1) + " corners, only triangles are supported";

  std::vector<std::size_t> polygon(words.size() - 1), texture_polygon(m_demand == Demand::points_only ? 0 : words.size() - 1);
  for(std::size_t k = 0; k < polygon.size(); ++k) {
    const std::string_view corner = words[k + 1];
    std::string error = read_index("v", corner.substr(0, corner.find('/')), corner, points.size(), polygon[k]);
    if(error.empty() && m_demand != Demand::points_only)
      error = read_texture_index(corner, texture_polygon[k]);
    if(!error.empty())
      return error;
  }
  polygons.push_back(std::move(polygon));
  if(m_demand != Demand::points_only)
    texture_polygons.push_back(std::move(texture_polygon));
  return std::string();
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read_texture_index(std::string_view corner, std::size_t& index) const
{
  const std::size_t first = corner.find('/');
  const std::size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
  // Some programs write v/vt/ without a normal.
  if(second != std::string_view::npos && second + 1 < corner.size()) {
    long long normal = 0;
    if(parse_number(corner.substr(second + 1), normal) != std::errc() || normal == 0)
      return "corner " + quoted_word(corner) + " has no valid vn index";
  }
  const std::string_view word =
    first == std::string_view::npos ? "" : corner.substr(first + 1, second == std::string_view::npos ? second : second - first - 1);
  if(!word.empty())
    return read_index("vt", word, corner, texture.size(), index);
  index = no_texture;
  return m_demand == Demand::textured_triangles ? "corner " + quoted_word(corner) + " has no texture coordinates (vt index)" : "";
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read_index(const char* kind, std::string_view word, std::string_view corner,
                                                              std::size_t size, std::size_t& index)
{
  long long value = 0;
  const std::errc status = parse_number(word, value);
  if(status != std::errc() && status != std::errc::result_out_of_range)
    return "corner " + quoted_word(corner) + " has no valid " + kind + " index";
  if(status == std::errc() && value < 0)
    value += static_cast<long long>(size) + 1;
  if(status != std::errc() || value < 1 || value > (std::numeric_limits<int>::max)())
    return std::string(kind) + " index " + quoted_word(word) + " is out of range, " + std::to_string(size) + " '" + kind +
           "' lines precede this face";
  index = static_cast<std::size_t>(value - 1);
  return std::string();
}

CGAL_FLIP_FREE_MAPS_INLINE std::string textured_mesh_error(const Textured_mesh& mesh, double texture_scale)
{
  if(!std::isfinite(texture_scale) || texture_scale <= 0)
    return "texture_scale is not a positive number";
  if(mesh.triangles.empty())
    return "the mesh has no triangle";
  if(mesh.triangles.size() != mesh.texture_triangles.size())
    return "triangles and texture_triangles differ in size";
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    for(const double coordinate : mesh.points[i])
      if(!std::isfinite(coordinate))
        return "point " + std::to_string(i) + " is not finite";
  for(std::size_t i = 0; i < mesh.texture.size(); ++i)
    for(const double coordinate : mesh.texture[i])
      if(!std::isfinite(coordinate * texture_scale))
        return "texture coordinate " + std::to_string(i) + " is not finite";
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for(int k = 0; k < 3; ++k)
      if(mesh.triangles[i][k] < 0 || std::size_t(mesh.triangles[i][k]) >= mesh.points.size() || mesh.texture_triangles[i][k] < 0 ||
         std::size_t(mesh.texture_triangles[i][k]) >= mesh.texture.size())
        return "triangle " + std::to_string(i) + " has an index out of range";
  return std::string();
}

CGAL_FLIP_FREE_MAPS_INLINE double texture_extent(const Textured_mesh& mesh)
{
  double lower[2];
  double upper[2];
  std::fill_n(lower, 2, (std::numeric_limits<double>::max)());
  std::fill_n(upper, 2, std::numeric_limits<double>::lowest());
  for(const std::array<int, 3>& triangle : mesh.texture_triangles) {
    for(const int index : triangle) {
      for(int c = 0; c < 2; ++c) {
        lower[c] = (std::min)(lower[c], mesh.texture[index][c]);
        upper[c] = (std::max)(upper[c], mesh.texture[index][c]);
      }
    }
  }
  return (std::max)(upper[0] - lower[0], upper[1] - lower[1]);
}

CGAL_FLIP_FREE_MAPS_INLINE Checkerboard_choice choose_checkerboard(double layout_extent)
{
  const double squares_across = 40.;
  const int max_squares = 256;
  Checkerboard_choice choice;
  const double wanted = squares_across / layout_extent;
  if(!std::isfinite(wanted) || !(wanted > 0))
    return choice;
  if(wanted >= 2. && wanted <= max_squares)
    choice.squares = 2 * static_cast<int>(std::lround(wanted / 2.));
  else {
    choice.squares = wanted < 2. ? 2 : max_squares;
    choice.pattern_scale = wanted / choice.squares;
  }
  return choice;
}

CGAL_FLIP_FREE_MAPS_INLINE std::string textured_OBJ_text(const Textured_mesh& mesh, const std::string& material_name, double texture_scale)
{
  std::string text;
  text.reserve(mesh.points.size() * 62 + mesh.texture.size() * 42 + mesh.triangles.size() * 48 + 1024);
  text += "mtllib " + material_name + '\n';
  for(const std::array<double, 3>& point : mesh.points) {
    text += 'v';
    for(const double coordinate : point) {
      text += ' ';
      append_number(text, coordinate);
    }
    text += '\n';
  }
  for(const std::array<double, 2>& coordinates : mesh.texture) {
    text += "vt";
    for(const double coordinate : coordinates) {
      text += ' ';
      append_number(text, coordinate * texture_scale);
    }
    text += '\n';
  }
  text += "usemtl checkerboard\n";
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += 'f';
    for(int k = 0; k < 3; ++k) {
      text += ' ';
      append_number(text, mesh.triangles[i][k] + 1LL);
      text += '/';
      append_number(text, mesh.texture_triangles[i][k] + 1LL);
    }
    text += '\n';
  }
  return text;
}

CGAL_FLIP_FREE_MAPS_INLINE std::string checkerboard_material_text(const Checkerboard_choice& choice, const std::string& image_name)
{
  std::string text = "newmtl checkerboard\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd ";
  if(choice.pattern_scale != 1.) {
    std::string scale;
    append_number(scale, choice.pattern_scale, 6);
    text += "-s " + scale + ' ' + scale + " 1 ";
  }
  return text + image_name + '\n';
}

CGAL_FLIP_FREE_MAPS_INLINE bool write_checkerboard_material(const std::string& material_path, const std::string& image_path,
                                                            double layout_extent, std::string* message)
{
  const Checkerboard_choice choice = choose_checkerboard(layout_extent);
  const int pixels_per_square = (std::max)(1, 1024 / choice.squares);
  return write_checkerboard_PNG(image_path, choice.squares * pixels_per_square, choice.squares, message) &&
         write_whole_file(material_path, checkerboard_material_text(choice, std::filesystem::path(image_path).filename().string()),
                          message);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool write_textured_OBJ(const std::string& path, const Textured_mesh& mesh, std::string* message,
                                                   double texture_scale)
{
  const std::string error = internal::textured_mesh_error(mesh, texture_scale);
  if(!error.empty())
    return internal::fail(message, "cannot write " + path + ": " + error);

  const std::filesystem::path obj_path(path);
  const std::string name = obj_path.filename().string();
  if(name.empty() || obj_path.extension() == ".mtl" ||
     std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    return internal::fail(message, "cannot write " + path + ": not a valid name of an OBJ file");
  const std::string material_name = obj_path.stem().string() + ".mtl";
  const std::string image_name = obj_path.stem().string() + "_checker.png";
  const auto beside = [&](const std::string& file) { return (obj_path.parent_path() / file).string(); };

  return internal::write_whole_file(path, internal::textured_OBJ_text(mesh, material_name, texture_scale), message) &&
         internal::write_checkerboard_material(beside(material_name), beside(image_name), internal::texture_extent(mesh) * texture_scale,
                                               message);
}

CGAL_FLIP_FREE_MAPS_INLINE bool read_textured_OBJ(const std::string& path, Textured_mesh& mesh, std::string* message)
{
  std::string text;
  if(!internal::read_whole_file(path, text, message))
    return false;

  internal::OBJ_reader reader(internal::OBJ_reader::Demand::textured_triangles);
  const std::string error = reader.read(text);
  if(!error.empty())
    return internal::fail(message, path + ", " + error);
  Textured_mesh result;
  result.points = std::move(reader.points);
  result.texture = std::move(reader.texture);
  const auto triangle = [](const std::vector<std::size_t>& polygon) {
    return std::array<int, 3>{static_cast<int>(polygon[0]), static_cast<int>(polygon[1]), static_cast<int>(polygon[2])};
  };
  for(const auto& polygon : reader.polygons)
    result.triangles.push_back(triangle(polygon));
  for(const auto& polygon : reader.texture_polygons)
    result.texture_triangles.push_back(triangle(polygon));
  mesh = std::move(result);
  return internal::succeed(message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_OBJ_IMPL_H
