// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "volume_files.h"

#include "Binary_reader.h"
#include "Polygon_file.h"
#include "packed_bytes.h"
#include "volume_formats.h"
#include "volume_text.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

enum class Format
{
  none,
  medit,
  medit_binary,
  vtu,
  vtk,
  gmsh,
  abaqus,
  tetgen
};

Format format_of(const std::string& path)
{
  const std::string extension = small_extension(path);
  return extension == ".mesh"                          ? Format::medit
         : extension == ".meshb"                       ? Format::medit_binary
         : extension == ".vtu"                         ? Format::vtu
         : extension == ".vtk"                         ? Format::vtk
         : extension == ".msh"                         ? Format::gmsh
         : extension == ".inp"                         ? Format::abaqus
         : extension == ".node" || extension == ".ele" ? Format::tetgen
                                                       : Format::none;
}

std::string why_no_format(const std::string& path)
{
  return path + ": no format of tetrahedral meshes has this extension; known are .mesh and .meshb (Medit), .vtu and .vtk (VTK), .msh "
                "(Gmsh), .inp (Abaqus), .node and .ele (TetGen)";
}

// The names of both files, given the name of one of them.
std::pair<std::string, std::string> tetgen_file_names(const std::string& path)
{
  std::filesystem::path node(path), element(path);
  return {node.replace_extension(".node").string(), element.replace_extension(".ele").string()};
}

std::string read_content(const std::string& path, std::string& text)
{
  std::string message;
  return internal::read_whole_file(path, text, &message) ? "" : message;
}

std::string with_path(const std::string& path, const std::string& error)
{
  return error.empty() ? "" : "cannot read " + path + ": " + error;
}

std::string read_tetgen(const std::string& path, Volume_file& file)
{
  const auto [node_path, element_path] = tetgen_file_names(path);
  long long first = 0;
  std::string error = read_content(node_path, file.text);
  if(error.empty())
    error = with_path(node_path, read_Tetgen_nodes(file.text, file, first));
  if(error.empty())
    error = read_content(element_path, file.element_text);
  return error.empty() ? with_path(element_path, read_Tetgen_elements(file.element_text, file, first)) : error;
}

std::string read_one(Format format, const std::string& path, Volume_file& file)
{
  std::string text;
  std::string error = read_content(path, text);
  if(!error.empty())
    return error;
  const auto read = format == Format::medit          ? &read_Medit_text
                    : format == Format::medit_binary ? &read_Medit_binary
                    : format == Format::vtu          ? &read_VTU
                    : format == Format::vtk          ? &read_VTK
                    : format == Format::gmsh         ? &read_Gmsh
                                                     : &read_Abaqus;
  error = read(text, file);
  // Those of VTK are written anew, since their numbers may have single precision only.
  if(format != Format::vtu && format != Format::vtk)
    file.text = std::move(text);
  return with_path(path, error);
}

// The text of a file with other coordinates in their places.
std::string with_points(const Volume_file& file)
{
  std::string text;
  std::size_t copied = 0;
  const std::string& old = file.text;
  text.reserve(old.size());
  for(std::size_t i = 0; i < file.coordinate_places.size(); ++i) {
    const std::size_t place = file.coordinate_places[i];
    text.append(old, copied, place - copied);
    if(file.has_binary_coordinates) {
      append_number_bytes(text, file.points[i / 3][i % 3], file.has_big_endian);
      copied = place + sizeof(double);
    } else {
      internal::append_number(text, file.points[i / 3][i % 3]);
      copied = (std::min)(old.find_first_of(" \t\v\f\r\n,", place), old.size());
    }
  }
  return text.append(old, copied, std::string::npos);
}

std::string new_text(Format format, const Volume_file& file, Volume_encoding encoding)
{
  const bool is_binary = encoding != Volume_encoding::ascii;
  switch(format) {
  case Format::medit:
    return Medit_text(file);
  case Format::medit_binary:
    return Medit_binary(file);
  case Format::vtu:
    return VTU_text(file, encoding);
  case Format::vtk:
    return VTK_text(file, is_binary);
  case Format::gmsh:
    return Gmsh_text(file, is_binary);
  default:
    return Abaqus_text(file);
  }
}

// Points and cells as they can be written.
std::string content_error(const Volume_file& file)
{
  for(std::size_t i = 0; i < file.points.size(); ++i)
    for(const double coordinate : file.points[i])
      if(!std::isfinite(coordinate))
        return "point " + std::to_string(i) + " is not finite";
  return cells_error(file);
}

std::string write_content(const std::string& path, const std::string& text)
{
  std::string message;
  return internal::write_whole_file(path, text, &message) ? "" : message;
}

std::string write_tetgen(const std::string& path, const Volume_file& file, bool is_kept)
{
  const auto [node_path, element_path] = tetgen_file_names(path);
  const std::string error = write_content(node_path, is_kept ? Tetgen_with_points(file.text, file.points) : Tetgen_nodes(file));
  return error.empty() ? write_content(element_path, is_kept ? file.element_text : Tetgen_elements(file)) : error;
}

constexpr std::pair<const char*, Volume_encoding> ENCODINGS[] = {{"ascii", Volume_encoding::ascii},
                                                                 {"binary", Volume_encoding::binary},
                                                                 {"base64", Volume_encoding::base64},
                                                                 {"compressed", Volume_encoding::compressed}};

} // namespace

bool is_volume_file(const std::string& path) { return format_of(path) != Format::none; }

std::string read_volume_file(const std::string& path, Volume_file& file)
{
  const Format format = format_of(path);
  if(format == Format::none)
    return why_no_format(path);
  Volume_file result;
  std::string error = format == Format::tetgen ? read_tetgen(path, result) : read_one(format, path, result);
  if(error.empty())
    error = with_path(path, content_error(result));
  if(!error.empty())
    return error;
  result.path = path;
  file = std::move(result);
  return "";
}

std::vector<std::string> volume_encoding_names()
{
  std::vector<std::string> names;
  for(const auto& entry : ENCODINGS)
    names.push_back(entry.first);
  return names;
}

Volume_encoding volume_encoding(const std::string& name)
{
  for(const auto& entry : ENCODINGS)
    if(name == entry.first)
      return entry.second;
  return Volume_encoding::ascii;
}

std::string why_volume_not_written(const std::string& path, std::optional<Volume_encoding> encoding)
{
  const Format format = format_of(path);
  if(format == Format::none)
    return "cannot write " + path + ": solids are written to files " + VOLUME_EXTENSIONS;
  if(!encoding)
    return "";
  if(*encoding == Volume_encoding::compressed && format == Format::vtu && !can_compress())
    return "cannot write " + path + " with compression: this program was built without zlib (Debian: zlib1g-dev)";
  const bool is_possible = format == Format::vtu            ? true
                           : format == Format::medit_binary ? *encoding == Volume_encoding::binary
                           : format == Format::vtk || format == Format::gmsh
                             ? *encoding == Volume_encoding::ascii || *encoding == Volume_encoding::binary
                             : *encoding == Volume_encoding::ascii;
  return is_possible ? "" : "cannot write " + path + ": files of this format do not have the encoding that is asked for";
}

std::string why_volume_not_written(const std::string& path, const Volume_file& file)
{
  const Format format = format_of(path);
  const bool has_second_order = format == Format::vtu || format == Format::vtk || format == Format::gmsh || format == Format::abaqus;
  return !has_second_order && std::count(file.cells.types.begin(), file.cells.types.end(), cell_type::QUADRATIC_TETRAHEDRON) > 0
           ? "cannot write " + path + ": tetrahedra of second order are written to files .vtu, .vtk, .msh and .inp"
           : "";
}

std::string write_volume_file(const std::string& path, const Volume_file& file, std::optional<Volume_encoding> encoding)
{
  const Format format = format_of(path);
  std::string error = why_volume_not_written(path, encoding);
  if(error.empty())
    error = why_volume_not_written(path, file);
  if(!error.empty())
    return error;
  error = content_error(file);
  if(!error.empty())
    return "cannot write " + path + ": " + error;
  const bool is_same_format = format_of(file.path) == format;
  const Volume_encoding chosen = encoding         ? *encoding
                                 : is_same_format ? file.encoding
                                                  : (format == Format::vtu ? Volume_encoding::base64 : Volume_encoding::binary);
  const bool is_kept = is_same_format && !file.text.empty() && chosen == file.encoding;
  if(format == Format::tetgen)
    return write_tetgen(path, file, is_same_format && !file.text.empty());
  if(is_kept && !file.coordinate_places.empty())
    return write_content(path, with_points(file));
  if(is_kept && format == Format::medit)
    return write_content(path, Medit_with_points(file.text, file.points));
  return write_content(path, new_text(format, file, chosen));
}

std::string find_point_array(const Volume_file& file, const std::string& name, const Data_array*& array)
{
  array = find_array(file.point_data, name);
  if(array != nullptr)
    return "";
  std::string names;
  for(const Data_array& other : file.point_data)
    names += (names.empty() ? ": " : ", ") + internal::quoted_word(other.name);
  return file.path + " has no values " + internal::quoted_word(name) + " at its points; it has " +
         (names.empty() ? "none" : std::to_string(file.point_data.size()) + names);
}

} // namespace program

namespace CGAL {
namespace Flip_free_maps {

bool read_volume(const std::string& path, Tetrahedral_mesh& mesh, std::string* message)
{
  program::Volume_file file;
  program::Solid solid;
  std::string error = program::read_volume_file(path, file);
  if(error.empty()) {
    error = program::take_solid(file, false, solid);
    if(!error.empty())
      error = "cannot read " + path + ": " + error;
  }
  if(!error.empty())
    return internal::fail(message, error);
  mesh = std::move(solid.mesh);
  return internal::succeed(message);
}

bool write_volume(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message)
{
  std::string error = internal::tetrahedral_mesh_error(mesh);
  if(!error.empty())
    return internal::fail(message, "cannot write " + path + ": " + error);
  error = program::write_volume_file(path, program::make_volume_file(mesh));
  return error.empty() ? internal::succeed(message) : internal::fail(message, error);
}

} // namespace Flip_free_maps
} // namespace CGAL
