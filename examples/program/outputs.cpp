// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "outputs.h"

#include "formats/Polygon_document.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

namespace program {

namespace fs = std::filesystem;

namespace {

// The names of all files that one name stands for.
std::vector<std::string> all_paths(const std::string& path)
{
  const std::string extension = small_extension(path);
  if(extension != ".node" && extension != ".ele")
    return {path};
  return {fs::path(path).replace_extension(".node").string(), fs::path(path).replace_extension(".ele").string()};
}

bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  if(fs::exists(a, error) && fs::exists(b, error))
    return fs::equivalent(a, b, error) && fs::is_regular_file(a, error);
  return fs::weakly_canonical(fs::absolute(a, error), error) == fs::weakly_canonical(fs::absolute(b, error), error);
}

bool is_same(const File_argument& a, const File_argument& b)
{
  if(a.path.empty() || b.path.empty())
    return false;
  for(const std::string& p : all_paths(a.path))
    for(const std::string& q : all_paths(b.path))
      if(is_same_file(p, q))
        return true;
  return false;
}

std::string checker_path(const std::string& path, const char* end)
{
  const fs::path output(path);
  return (output.parent_path() / (output.stem().string() + "_checker" + end)).string();
}

} // namespace

std::string why_files_collide(const std::vector<File_argument>& inputs, const std::vector<File_argument>& outputs)
{
  for(std::size_t i = 0; i < outputs.size(); ++i) {
    for(std::size_t j = 0; j < i; ++j)
      if(is_same(outputs[i], outputs[j]))
        return outputs[i].option + " and " + outputs[j].option + " name the same file, " + outputs[i].path;
    for(std::size_t j = 0; j < inputs.size(); ++j)
      if((i > 0 || j > 0) && is_same(outputs[i], inputs[j]))
        return outputs[i].option + " would replace the file that " + inputs[j].option + " reads, " + inputs[j].path;
  }
  return "";
}

void check_folders(const std::vector<File_argument>& outputs)
{
  for(const File_argument& output : outputs) {
    const fs::path folder = fs::path(output.path).parent_path();
    std::error_code error;
    check(folder.empty() || fs::is_directory(folder, error), "cannot write " + output.path + ": there is no folder " + folder.string());
  }
}

int refuse(const std::string& reason)
{
  std::cerr << "flip_free_maps: " << reason << '\n';
  return 2;
}

void add_surface_output(CLI::App& command, Surface_output& output, const std::string& what)
{
  command.add_option("-o,--output", output.path,
                     what + ": .obj or .ply. The input's file with nothing but its texture coordinates changed if it has the same "
                            "extension, otherwise a new one; it may be the input itself");
  command.add_flag("--checker", output.checker,
                   "give the faces of an OBJ a checkerboard as their material; otherwise only faces of files without materials get it");
}

std::string why_not_written(const Surface_output& output)
{
  if(output.path.empty())
    return output.checker ? "--checker needs an output" : "";
  const std::string extension = small_extension(output.path);
  if(extension != ".obj" && extension != ".ply")
    return "cannot write " + output.path + ": texture coordinates are written to files .obj and .ply";
  return output.checker && extension != ".obj" ? "--checker needs an output .obj: other formats have no materials" : "";
}

std::vector<File_argument> files_of(const Surface_output& output)
{
  std::vector<File_argument> files{{"--output", output.path}};
  if(small_extension(output.path) == ".obj")
    for(const char* end : {".mtl", ".png"})
      files.push_back({"the checkerboard of --output", checker_path(output.path, end)});
  return files;
}

std::string surface_text(const std::string& extension, const Surface& surface)
{
  if(extension == ".obj") {
    std::string text;
    for(const Kernel::Point_3& p : surface.points) {
      text += 'v';
      for(int c = 0; c < 3; ++c) {
        text += ' ';
        FFM::internal::append_number(text, p[c]);
      }
      text += '\n';
    }
    for(const auto& polygon : surface.polygons) {
      text += 'f';
      for(const std::size_t v : polygon) {
        text += ' ';
        FFM::internal::append_number(text, static_cast<long long>(v) + 1);
      }
      text += '\n';
    }
    return text;
  }
  std::ostringstream out;
  out.precision(17);
  // Binary STL has single precision, in which the certificate of a map is lost.
  if(extension == ".ply") {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, surface.points, surface.polygons);
  } else if(extension == ".stl")
    CGAL::IO::write_STL(out, surface.points, surface.polygons);
  else
    CGAL::IO::write_OFF(out, surface.points, surface.polygons);
  return out.str();
}

void write_text(const std::string& path, const std::string& text)
{
  std::string message;
  check(FFM::internal::write_whole_file(path, text, &message), message);
}

void write_surface(const Surface_output& output, const Surface& surface, const Corner_images& images)
{
  if(output.path.empty())
    return;
  const std::string extension = small_extension(output.path);
  const bool is_kept = !surface.text.empty() && small_extension(surface.path) == extension;
  const auto document = make_document(extension, is_kept ? surface.text : surface_text(extension, surface));
  const bool has_checker = extension == ".obj" && (output.checker || !document->has_material());
  std::string material, message;
  if(has_checker) {
    material = checker_path(output.path, ".mtl");
    double low[2] = {0, 0}, high[2] = {0, 0};
    for(const auto& corners : images)
      for(const Image& image : corners)
        for(int c = 0; c < 2; ++c) {
          low[c] = (std::min)(low[c], image[c]);
          high[c] = (std::max)(high[c], image[c]);
        }
    check(FFM::internal::write_checkerboard_material(material, checker_path(output.path, ".png"),
                                                     (std::max)(high[0] - low[0], high[1] - low[1]), &message),
          message);
    material = fs::path(material).filename().string();
  }
  write_text(output.path, document->with_images(images, material));
}

} // namespace program
