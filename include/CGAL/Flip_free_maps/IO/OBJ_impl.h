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
      error = read_coordinates(words, m_mesh.points);
    else if(words[0] == "vt")
      error = read_coordinates(words, m_mesh.texture);
    else if(words[0] == "f") {
      error = read_triangle(words);
      m_lines.push_back(tokenizer.line());
    }
    if(!error.empty())
      return at_line(tokenizer.line(), error);
  }

  // A face may precede the points that it uses, hence the upper bound is tested at the end.
  for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
    for(int k = 0; k < 3; ++k) {
      if(std::size_t(m_mesh.triangles[i][k]) >= m_mesh.points.size())
        return at_line(m_lines[i], too_large("v", m_mesh.triangles[i][k], m_mesh.points.size()));
      if(std::size_t(m_mesh.texture_triangles[i][k]) >= m_mesh.texture.size())
        return at_line(m_lines[i], too_large("vt", m_mesh.texture_triangles[i][k], m_mesh.texture.size()));
    }
  }
  return m_mesh.triangles.empty() ? "the file has no triangle" : "";
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::too_large(const char* kind, int index, std::size_t size)
{
  return std::string(kind) + " index " + std::to_string(index + 1LL) + " is out of range, the file has " + std::to_string(size) + " '" +
         kind + "' lines";
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read_triangle(const std::vector<std::string_view>& words)
{
  if(words.size() != 4)
    return "the face has " + std::to_string(words.size() - 1) + " corners, only triangles are supported";

  std::array<int, 3> triangle;
  std::array<int, 3> texture_triangle;
  for(int k = 0; k < 3; ++k) {
    const std::string_view corner = words[k + 1];
    const std::size_t first = corner.find('/');
    const std::size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
    const std::string_view point_word = corner.substr(0, first);
    std::string_view texture_word;
    if(first != std::string_view::npos)
      texture_word = corner.substr(first + 1, second == std::string_view::npos ? second : second - first - 1);

    std::string error = read_index("v", point_word, corner, m_mesh.points.size(), triangle[k]);
    if(!error.empty())
      return error;
    if(second != std::string_view::npos) {
      long long normal = 0;
      if(parse_number(corner.substr(second + 1), normal) != std::errc() || normal == 0)
        return "corner " + quoted_word(corner) + " has no valid vn index";
    }
    if(texture_word.empty())
      return "corner " + quoted_word(corner) + " has no texture coordinates (vt index)";
    error = read_index("vt", texture_word, corner, m_mesh.texture.size(), texture_triangle[k]);
    if(!error.empty())
      return error;
  }
  m_mesh.triangles.push_back(triangle);
  m_mesh.texture_triangles.push_back(texture_triangle);
  return std::string();
}

CGAL_FLIP_FREE_MAPS_INLINE std::string OBJ_reader::read_index(const char* kind, std::string_view word, std::string_view corner,
                                                              std::size_t size, int& index)
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
  index = static_cast<int>(value - 1);
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

  const internal::Checkerboard_choice choice = internal::choose_checkerboard(internal::texture_extent(mesh) * texture_scale);
  const int pixels_per_square = (std::max)(1, 1024 / choice.squares);
  return internal::write_whole_file(path, internal::textured_OBJ_text(mesh, material_name, texture_scale), message) &&
         write_checkerboard_PNG(beside(image_name), choice.squares * pixels_per_square, choice.squares, message) &&
         internal::write_whole_file(beside(material_name), internal::checkerboard_material_text(choice, image_name), message);
}

CGAL_FLIP_FREE_MAPS_INLINE bool read_textured_OBJ(const std::string& path, Textured_mesh& mesh, std::string* message)
{
  std::string text;
  if(!internal::read_whole_file(path, text, message))
    return false;

  internal::OBJ_reader reader;
  const std::string error = reader.read(text);
  if(!error.empty())
    return internal::fail(message, path + ", " + error);
  mesh = std::move(reader.mesh());
  return internal::succeed(message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_OBJ_IMPL_H
