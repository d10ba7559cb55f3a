// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_OBJ_H
#define CGAL_FLIP_FREE_MAPS_IO_OBJ_H

#include <CGAL/Flip_free_maps/IO/checkerboard.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Splits the text of an OBJ file into logical lines of words: a backslash at the end of a line joins the next one, a comment
// ends with its physical line (so that a Windows path in a comment does not swallow data), and a line ends with \n, \r\n or \r.
class OBJ_tokenizer
{
public:
  explicit OBJ_tokenizer(std::string_view text) : m_text(text)
  {
    const std::string_view byte_order_mark("\xEF\xBB\xBF");
    if(m_text.substr(0, byte_order_mark.size()) == byte_order_mark)
      m_position = byte_order_mark.size();
  }

  bool next_line(std::vector<std::string_view>& words)
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

  // Number, from 1, of the physical line on which the current logical line starts.
  long long line() const { return m_line; }

private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r'; }

  bool is_continuation(std::size_t i) const
  {
    return m_text[i] == '\\' && (i + 1 == m_text.size() || m_text[i + 1] == '\n' || m_text[i + 1] == '\r');
  }

  bool skip_line_end(std::size_t& i)
  {
    if(i >= m_text.size() || (m_text[i] != '\n' && m_text[i] != '\r'))
      return false;
    i += (m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n') ? 2 : 1;
    ++m_next_line;
    return true;
  }

  std::string_view m_text;
  std::size_t m_position = 0;
  long long m_line = 0;
  long long m_next_line = 1;
};

class OBJ_reader
{
public:
  // Returns the empty string, or what is wrong with the file.
  std::string read(std::string_view text)
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

  Textured_mesh& mesh() { return m_mesh; }

private:
  static std::string at_line(long long line, const std::string& error) { return "line " + std::to_string(line) + ": " + error; }

  static std::string too_large(const char* kind, int index, std::size_t size)
  {
    return std::string(kind) + " index " + std::to_string(index + 1LL) + " is out of range, the file has " + std::to_string(size) + " '" +
           kind + "' lines";
  }

  template <std::size_t N>
  static std::string read_coordinates(const std::vector<std::string_view>& words, std::vector<std::array<double, N>>& list)
  {
    if(words.size() < N + 1)
      return quoted_word(words[0]) + " needs " + std::to_string(N) + " numbers, found " + std::to_string(words.size() - 1);
    if(list.size() >= std::size_t((std::numeric_limits<int>::max)()))
      return "too many " + quoted_word(words[0]) + " lines";

    std::array<double, N> coordinates;
    for(std::size_t k = 0; k < N; ++k) {
      const std::errc status = parse_number(words[k + 1], coordinates[k]);
      if(status == std::errc::result_out_of_range)
        return quoted_word(words[k + 1]) + " is not in the range of double precision numbers";
      if(status != std::errc())
        return quoted_word(words[k + 1]) + " is not a number";
      if(!std::isfinite(coordinates[k]))
        return quoted_word(words[k + 1]) + " is not a finite number";
    }
    list.push_back(coordinates);
    return std::string();
  }

  std::string read_triangle(const std::vector<std::string_view>& words)
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

  static std::string read_index(const char* kind, std::string_view word, std::string_view corner, std::size_t size, int& index)
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

  Textured_mesh m_mesh;
  std::vector<long long> m_lines;
};

// Returns the empty string, or why the mesh cannot be written.
inline std::string textured_mesh_error(const Textured_mesh& mesh, double texture_scale)
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

// Larger side of the bounding box of the texture coordinates in use.
inline double texture_extent(const Textured_mesh& mesh)
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

// Checkerboard that shows about 40 squares across the layout.
struct Checkerboard_choice
{
  int squares = 8;           // per side of the image, that is per unit of vt; even, so that the image tiles seamlessly
  double pattern_scale = 1.; // additional factor on vt, for layouts that no reasonable number of squares can serve
};

inline Checkerboard_choice choose_checkerboard(double layout_extent)
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

} // namespace internal

namespace internal {

inline std::string textured_OBJ_text(const Textured_mesh& mesh, const std::string& material_name, double texture_scale)
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

inline std::string checkerboard_material_text(const Checkerboard_choice& choice, const std::string& image_name)
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

/// \ingroup PkgFlipFreeMapsIO
/// Writes a triangle mesh with texture coordinates as a Wavefront OBJ file together with a material that shows the map as a
/// checkerboard, so that Blender or MeshLab display it at once.
///
/// For `path` = `dir/name.obj` three files are written (existing ones are replaced): `dir/name.obj` with the lines `v`, `vt` and
/// `f v/vt`, the material `dir/name.mtl`, and its texture `dir/name_checker.png`. The texture tiles (no `-clamp`), hence any range
/// of texture coordinates is valid. The number of squares in the image is chosen such that about 40 squares lie across the larger
/// side of the layout if `40/256 <= texture_scale * side <= 20`; beyond that range the material carries in addition the scale
/// option `-s` of `map_Kd`, which Blender honours. For a viewer without it, choose `texture_scale` = 1 / side.
///
/// Numbers are written with as many digits (up to 17) as it takes to read back exactly the same doubles; the locale has no
/// influence. The cost is linear in the size of the mesh.
///
/// \param path name of the OBJ file; its extension must not be `.mtl` and its file name must not contain control characters
/// \param mesh the mesh; it must have a triangle, finite coordinates and valid indices
/// \param message if not null, receives the reason of a failure, and the empty string on success
/// \param texture_scale positive factor by which the texture coordinates are multiplied in the file. The default 1 keeps them as
///        given, that is in the units of the surface.
///
/// \returns `true` if all files were written. An invalid mesh is refused before any file is touched.
inline bool write_textured_OBJ(const std::string& path, const Textured_mesh& mesh, std::string* message = nullptr,
                               double texture_scale = 1.)
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

/// \ingroup PkgFlipFreeMapsIO
/// Reads a triangle mesh with texture coordinates from a Wavefront OBJ file.
///
/// The lines `v`, `vt` and `f` are read, all others are ignored, and so are numbers after the third of `v` and the second of `vt`.
/// A corner of a face is `v/vt` or `v/vt/vn`, with indices from 1, or negative ones that count back from the last element that
/// precedes the face. Comments, line continuation by a backslash and the three conventions for line ends are understood.
///
/// \param path name of the file
/// \param mesh receives the mesh; unchanged on failure. Points and texture coordinates keep the order of the file, unused ones
///        included.
/// \param message if not null, receives the reason of a failure with the number of the line, and the empty string on success
///
/// \returns `false` if the file cannot be read, has no triangle, a face that is not a triangle, a corner without texture
///          coordinates, an index out of range, or a coordinate that is not a finite double precision number. Degenerate or
///          repeated triangles are not looked for. The cost is linear in the size of the file.
inline bool read_textured_OBJ(const std::string& path, Textured_mesh& mesh, std::string* message = nullptr)
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

#endif // CGAL_FLIP_FREE_MAPS_IO_OBJ_H
