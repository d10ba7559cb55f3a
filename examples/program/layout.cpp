// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "layout.h"

#include "pictures/Layout_picture.h"
#include "pictures/Texture_picture.h"

#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace program {

void refuse_without_cairo([[maybe_unused]] CLI::Option* option)
{
#ifndef CGAL_FLIP_FREE_MAPS_USE_CAIRO
  option->check([](const std::string&) { return "this program was built without Cairo, which draws the pictures"; }, "");
#endif
}

void add_picture_options(CLI::App& command, Picture_arguments& arguments)
{
  refuse_without_cairo(command.add_option("--svg", arguments.svg, "draw the result, coloured by distortion"));
  refuse_without_cairo(command.add_option("--png", arguments.png, "draw the result, coloured by distortion"));
  add_picture_width(command, arguments);
}

void add_picture_width(CLI::App& command, Picture_arguments& arguments)
{
  command.add_option("--picture-width", arguments.width, "width of the drawings in pixels")
    ->check(CLI::Range(320, 16000))
    ->capture_default_str();
}

void add_surface_picture(CLI::App& command, Picture_arguments& arguments)
{
  refuse_without_cairo(command.add_option(
    "--png3d", arguments.png3d, "draw the surface itself from four sides, with a checkerboard, seams in red and flips in magenta"));
  command.add_option("--picture-up", arguments.up, "the axis that points upwards on the picture of --png3d")
    ->check(CLI::IsMember({'x', 'y', 'z'}))
    ->capture_default_str();
}

void write_pictures(const Picture_arguments& arguments, const std::string& input, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion, const FFM::Summary& summary)
{
  char title[200];
  std::snprintf(title, sizeof title, "%s   %s %.6f", input.substr(input.rfind('/') + 1).c_str(),
                summary.energy_name == FFM::Symmetric_dirichlet::name() ? "energy" : summary.energy_name.c_str(), summary.energy);
  write_pictures(arguments, title, layout, distortion);
}

void write_pictures(const Picture_arguments& arguments, const std::string& title, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion)
{
  FFM::Layout_picture_options options;
  options.title = title;
  options.width = arguments.width;
  options.distortion_label = "symmetric Dirichlet";
  std::string message;
  if(!arguments.svg.empty())
    check(FFM::write_layout_SVG(arguments.svg, layout.texture, layout.texture_triangles, distortion, options, &message), message);
  if(!arguments.png.empty())
    check(FFM::write_layout_PNG(arguments.png, layout.texture, layout.texture_triangles, distortion, options, &message), message);
  write_surface_picture(arguments, layout);
}

void write_surface_picture(const Picture_arguments& arguments, const FFM::Textured_mesh& layout)
{
  if(arguments.png3d.empty())
    return;
  FFM::Texture_picture_options options;
  options.width = arguments.width;
  options.up = {{arguments.up == 'x' ? 1. : 0., arguments.up == 'y' ? 1. : 0., arguments.up == 'z' ? 1. : 0.}};
  std::string message;
  check(FFM::write_textured_surface_PNG(arguments.png3d, layout, options, &message), message);
}

namespace {

// Scales texture coordinates into the unit square.
void scale_into_unit_square(const Atlas& atlas, Corner_images& images)
{
  std::array<double, 2> low{}, high{};
  bool is_first = true;
  for(const auto& corners : images)
    for(const Image& image : corners) {
      for(int c = 0; c < 2; ++c) {
        low[c] = is_first ? image[c] : (std::min)(low[c], image[c]);
        high[c] = is_first ? image[c] : (std::max)(high[c], image[c]);
      }
      is_first = false;
    }
  const double extent = (std::max)(high[0] - low[0], high[1] - low[1]);
  for(auto& corners : images)
    for(Image& image : corners)
      image = {(image[0] - low[0]) / extent, (image[1] - low[1]) / extent};
  // Scaling rounds, and what is written must be certified.
  if(!stay_positive(atlas, images))
    throw Failure{Status::result_not_representable, "triangles flip when the texture coordinates are scaled into the unit square"};
}

} // namespace

void add_layout_options(CLI::App& command, Layout_arguments& arguments, const std::string& input, const std::string& output)
{
  command.add_option("input", arguments.input, input)->required();
  add_surface_output(command, arguments.output, output);
  command.add_flag("--unit-square", arguments.unit_square, "scale the texture coordinates into the unit square");
}

std::vector<std::string> pictures_of(const Picture_arguments& arguments)
{
  std::vector<std::string> result;
  for(const std::string& path : {arguments.png, arguments.png3d, arguments.svg})
    if(!path.empty())
      result.push_back(path);
  return result;
}

std::vector<File_argument> files_of(const Surface_output& output, const Picture_arguments& pictures, const Method_arguments& method)
{
  std::vector<File_argument> files = files_of(output);
  files.insert(
    files.end(),
    {{"--json", method.json}, {"--report", method.report}, {"--svg", pictures.svg}, {"--png", pictures.png}, {"--png3d", pictures.png3d}});
  return files;
}

std::vector<File_argument> files_of(const Layout_arguments& arguments, const Method_arguments& method)
{
  std::vector<File_argument> files = files_of(arguments.output, arguments.pictures, method);
  files.push_back({"--trace", method.trace});
  return files;
}

Corner_images corner_images(const Surface& surface, const std::vector<Kernel::Point_2>& uv)
{
  Corner_images images;
  for(const auto& polygon : surface.polygons) {
    images.emplace_back();
    for(const std::size_t v : polygon) {
      const Kernel::Point_2& p = uv[v];
      images.back().push_back({p.x(), p.y()});
    }
  }
  return images;
}

std::string write_layout(const Layout_arguments& arguments, const Surface& surface, Corner_images images, const FFM::Summary& summary)
{
  const Atlas atlas = make_atlas(surface, images);
  std::vector<double> distortion;
  FFM::measure_distortion(atlas.mesh, &distortion);
  if(arguments.unit_square)
    scale_into_unit_square(atlas, images);
  write_pictures(arguments.pictures, arguments.input, atlas.mesh, distortion, summary);
  return write_surface(arguments.output, surface, images);
}

} // namespace program
