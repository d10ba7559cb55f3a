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

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
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
  explicit OBJ_tokenizer(std::string_view text);

  bool next_line(std::vector<std::string_view>& words);

  // Number, from 1, of the physical line on which the current logical line starts.
  long long line() const { return m_line; }

  // Where the next logical line begins in the text.
  std::size_t position() const { return m_position; }

private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r'; }

  bool is_continuation(std::size_t i) const
  {
    return m_text[i] == '\\' && (i + 1 == m_text.size() || m_text[i + 1] == '\n' || m_text[i + 1] == '\r');
  }

  bool skip_line_end(std::size_t& i);

  std::string_view m_text;
  std::size_t m_position = 0;
  long long m_line = 0;
  long long m_next_line = 1;
};

// The one reader of OBJ files: polygons, with or without texture coordinates.
class OBJ_reader
{
public:
  enum class Demand
  {
    points_only,       // lines vt and what follows the point of a corner are not looked at
    texture_if_any,    // a corner may have no texture coordinates
    textured_triangles // every face is a triangle, and every corner has texture coordinates
  };

  explicit OBJ_reader(Demand demand) : m_demand(demand) {}

  // Returns the empty string, or what is wrong with the file.
  std::string read(std::string_view text);

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> texture;
  // Indices into both; `no_texture` where there is none. Without texture coordinates `texture_polygons` stays empty.
  std::vector<std::vector<std::size_t>> polygons, texture_polygons;
  std::vector<long long> lines; // of the polygons

  static constexpr std::size_t no_texture = static_cast<std::size_t>(-1);

private:
  static std::string at_line(long long line, const std::string& error) { return "line " + std::to_string(line) + ": " + error; }

  static std::string too_large(const char* kind, std::size_t index, std::size_t size);

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

  std::string read_polygon(const std::vector<std::string_view>& words);

  std::string read_texture_index(std::string_view corner, std::size_t& index) const;

  static std::string read_index(const char* kind, std::string_view word, std::string_view corner, std::size_t size, std::size_t& index);

  std::string range_error() const;

  Demand m_demand;
};

// Returns the empty string, or why the mesh cannot be written.
std::string textured_mesh_error(const Textured_mesh& mesh, double texture_scale);

// Larger side of the bounding box of the texture coordinates in use.
double texture_extent(const Textured_mesh& mesh);

// Checkerboard that shows about 40 squares across the layout.
struct Checkerboard_choice
{
  int squares = 8;           // per side of the image, that is per unit of vt; even, so that the image tiles seamlessly
  double pattern_scale = 1.; // additional factor on vt, for layouts that no reasonable number of squares can serve
};

Checkerboard_choice choose_checkerboard(double layout_extent);

} // namespace internal

namespace internal {

std::string textured_OBJ_text(const Textured_mesh& mesh, const std::string& material_name, double texture_scale);

std::string checkerboard_material_text(const Checkerboard_choice& choice, const std::string& image_name);

// Both files are in the same folder; the layout has the larger side `layout_extent`.
bool write_checkerboard_material(const std::string& material_path, const std::string& image_path, double layout_extent,
                                 std::string* message);

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
bool write_textured_OBJ(const std::string& path, const Textured_mesh& mesh, std::string* message = nullptr, double texture_scale = 1.);

/// \ingroup PkgFlipFreeMapsIO
/// Reads a triangle mesh with texture coordinates from a Wavefront OBJ file.
///
/// The lines `v`, `vt` and `f` are read, all others are ignored, and so are numbers after the third of `v` and the second of `vt`.
/// A corner of a face is `v/vt`, `v/vt/` or `v/vt/vn`, with indices from 1, or negative ones that count back from the last element that
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
bool read_textured_OBJ(const std::string& path, Textured_mesh& mesh, std::string* message = nullptr);

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/IO/OBJ_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IO_OBJ_H
