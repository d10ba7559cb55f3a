// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "outputs.h"

#include "Atlas.h"
#include "formats/Polygon_document.h"
#include "formats/gltf/Gltf_document.h"
#include "formats/gltf/Gltf_surface.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/is_bijective.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <sstream>
#include <system_error>
#include <utility>

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

void add_uv_set(CLI::App& command, std::size_t& uv_set)
{
  command
    .add_option("--uv-set", uv_set,
                "which texture coordinates of .glb or .gltf are meant, as 1 for TEXCOORD_1, where light maps are expected; the others stay")
    ->check(CLI::Range(0, 7))
    ->capture_default_str();
}

void add_surface_output(CLI::App& command, Surface_output& output, const std::string& what)
{
  command.add_option("-o,--output", output.path,
                     what +
                       ": .obj, .ply, .glb or .gltf. The input's file with nothing but its texture coordinates changed if it has the same "
                       "extension, otherwise a new one; it may be the input itself");
  command.add_flag("--checker", output.checker,
                   "give the faces of an OBJ or glTF a checkerboard as their material; otherwise only files, or meshes of glTF, without "
                   "materials get it");
  add_uv_set(command, output.uv_set);
}

std::string why_not_written(const std::string& input, const Surface_output& output)
{
  if(output.uv_set > 0 && !is_gltf(input) && !is_gltf(output.path))
    return "--uv-set is for .glb and .gltf: other formats have a single set of texture coordinates";
  if(output.path.empty())
    return output.checker ? "--checker needs an output" : "";
  const std::string extension = small_extension(output.path);
  if(extension != ".obj" && extension != ".ply" && !is_gltf(output.path))
    return "cannot write " + output.path + ": texture coordinates are written to files .obj, .ply, .glb and .gltf";
  return output.checker && extension == ".ply" ? "--checker needs an output .obj, .glb or .gltf: PLY has no materials" : "";
}

std::vector<File_argument> files_of(const Surface_output& output)
{
  std::vector<File_argument> files{{"--output", output.path}};
  if(small_extension(output.path) == ".obj")
    for(const char* end : {".mtl", ".png"})
      files.push_back({"the checkerboard of --output", checker_path(output.path, end)});
  return files;
}

namespace {

// Names may hold what would be another line.
std::string object_line(const Surface& surface, std::size_t object)
{
  std::string name = surface.object_names[object];
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127 || c == '\\'; }, '_');
  return "o " + (name.empty() ? "object_" + std::to_string(object) : name) + '\n';
}

} // namespace

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
    for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
      if(!surface.objects.empty() && (i == 0 || surface.objects[i] != surface.objects[i - 1]))
        text += object_line(surface, surface.objects[i]);
      text += 'f';
      for(const std::size_t v : surface.polygons[i]) {
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

namespace {

// Polygons as triangles, each object's together, and their images.
Surface triangles_of(const Surface& surface, const Corner_images& images)
{
  Surface result;
  result.path = surface.path;
  result.points = surface.points;
  result.object_names = surface.object_names;
  result.is_transposed = surface.is_transposed;
  std::vector<std::size_t> order(surface.polygons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if(!surface.objects.empty())
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return surface.objects[i] < surface.objects[j]; });
  for(const std::size_t i : order) {
    // Without images they are fans.
    const std::vector<Image> same(surface.polygons[i].size(), Image{0, 0});
    for(const auto& corners : triangulation(images[i].empty() ? same : images[i])) {
      result.polygons.emplace_back();
      result.images.emplace_back();
      for(const std::size_t k : corners) {
        result.polygons.back().push_back(surface.polygons[i][k]);
        if(!images[i].empty())
          result.images.back().push_back(images[i][k]);
      }
      if(!surface.objects.empty())
        result.objects.push_back(surface.objects[i]);
    }
  }
  return result;
}

// The images as pairs (t, s) in single precision, certified if they had to be rounded.
Corner_images rounded_images(const Surface& surface, const Corner_images& images)
{
  Corner_images result = images;
  bool is_rounded = false;
  for(auto& corners : result)
    for(Image& image : corners) {
      const Image exact = surface.is_transposed ? image : Image{1 - image[1], image[0]};
      image = {static_cast<double>(static_cast<float>(exact[0])), static_cast<double>(static_cast<float>(exact[1]))};
      is_rounded = is_rounded || image != exact || !surface.is_transposed;
    }
  if(!is_rounded)
    return result;
  const Atlas exact = make_atlas(surface, images);
  if(!stay_positive(exact, result) || (!FFM::is_bijective(make_atlas(surface, result).mesh) && FFM::is_bijective(exact.mesh)))
    throw Failure{Status::result_not_representable,
                  "triangles flip or overlap when the texture coordinates are rounded to single precision, which glTF has; .obj and .ply "
                  "have double precision"};
  return result;
}

std::string write_gltf(const Surface_output& output, const Surface& surface, const Corner_images& images)
{
  Gltf_request request{surface.path, surface.text, output.path, output.uv_set, output.checker};
  if(surface.text.empty() || !is_gltf(surface.path)) {
    request.input = output.path;
    request.text = gltf_text(surface);
  }
  Corner_images coordinates = rounded_images(surface, images);
  for(auto& corners : coordinates)
    for(Image& image : corners)
      std::swap(image[0], image[1]);
  std::string note;
  write_text(output.path, with_gltf_images(request, coordinates, note));
  return note;
}

// The images as other formats have them.
Corner_images upright_images(const Surface& surface, Corner_images images)
{
  if(surface.is_transposed)
    for(auto& corners : images)
      for(Image& image : corners)
        image = {image[1], 1 - image[0]};
  return images;
}

void write_document(const Surface_output& output, const Surface& surface, const Corner_images& images)
{
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

} // namespace

std::string write_surface(const Surface_output& output, const Surface& surface, const Corner_images& images)
{
  const bool has_scene = is_gltf(surface.path) && !surface.text.empty();
  if(output.path.empty())
    return "";
  if(is_gltf(output.path)) {
    if(has_scene)
      return write_gltf(output, surface, images);
    const Surface triangles = triangles_of(surface, images);
    return write_gltf(output, triangles, triangles.images);
  }
  const Surface scene = has_scene ? gltf_scene(surface, images) : Surface();
  write_document(output, has_scene ? scene : surface, upright_images(surface, has_scene ? scene.images : images));
  return "";
}

void add_note(std::string& message, const std::string& note)
{
  if(!note.empty())
    message += "; " + note;
}

} // namespace program
