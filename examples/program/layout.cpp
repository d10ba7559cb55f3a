// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "layout.h"

#include "pictures/Layout_picture.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
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
  command.add_option("--picture-width", arguments.width, "width of the drawings in pixels")
    ->check(CLI::Range(320, 16000))
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
}

namespace {

FFM::Textured_mesh textured(const Triangles& triangles, const UV_map& uv, bool unit_square)
{
  FFM::Textured_mesh result;
  for(const auto& p : triangles.points)
    result.points.push_back({p.x(), p.y(), p.z()});
  std::vector<int> texture_of_point(triangles.points.size(), -1);
  std::array<double, 2> low{}, high{};
  for(const auto& polygon : triangles.polygons) {
    std::array<int, 3> triangle, texture;
    for(int k = 0; k < 3; ++k) {
      const std::size_t v = polygon[k];
      if(texture_of_point[v] < 0) {
        texture_of_point[v] = static_cast<int>(result.texture.size());
        const Kernel::Point_2 p = uv[Vertex(static_cast<Mesh::size_type>(v))];
        const bool first = result.texture.empty();
        for(int c = 0; c < 2; ++c) {
          low[c] = first ? p[c] : (std::min)(low[c], p[c]);
          high[c] = first ? p[c] : (std::max)(high[c], p[c]);
        }
        result.texture.push_back({p.x(), p.y()});
      }
      triangle[k] = static_cast<int>(v);
      texture[k] = texture_of_point[v];
    }
    result.triangles.push_back(triangle);
    result.texture_triangles.push_back(texture);
  }
  if(unit_square) {
    const double extent = (std::max)(high[0] - low[0], high[1] - low[1]);
    for(auto& p : result.texture)
      p = {(p[0] - low[0]) / extent, (p[1] - low[1]) / extent};
    // Scaling rounds, and what is written must be certified.
    const auto point = [&](int t) { return Kernel::Point_2(result.texture[t][0], result.texture[t][1]); };
    for(const auto& t : result.texture_triangles)
      if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::LEFT_TURN)
        throw Failure{Status::result_not_representable, "triangles flip when the texture coordinates are scaled into the unit square"};
  }
  return result;
}

} // namespace

void add_layout_options(CLI::App& command, Layout_arguments& arguments, const std::string& input, const std::string& output)
{
  command.add_option("input", arguments.input, input)->required();
  command.add_option("-o,--output", arguments.output, output);
  command.add_flag("--unit-square", arguments.unit_square, "scale the texture coordinates into the unit square");
}

void write_layout(const Layout_arguments& arguments, Patch& patch, const FFM::Summary& summary)
{
  Mesh& mesh = patch.triangles.mesh;
  std::vector<double> distortion;
  auto distortion_map = mesh.add_property_map<Mesh::Face_index, double>("f:distortion").first;
  FFM::face_distortions(mesh, patch.uv, distortion_map);
  for(const auto face : mesh.faces())
    distortion.push_back(distortion_map[face]);
  const FFM::Textured_mesh layout = textured(patch.triangles, patch.uv, arguments.unit_square);
  write_pictures(arguments.pictures, arguments.input, layout, distortion, summary);
  std::string message;
  if(!arguments.output.empty())
    check(FFM::write_textured_OBJ(arguments.output, layout, &message), message);
}

} // namespace program
