// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "deform.h"

#include "../splitting.h"

#include "../formats/volume_files.h"
#include "../pictures/Surface_picture.h"
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace program {

namespace {

void draw(const Deform_arguments& arguments, const FFM::Tetrahedral_mesh& before, const FFM::Tetrahedral_mesh& after,
          const std::vector<double>& distortion, double energy)
{
  std::vector<std::size_t> owners;
  FFM::Solid_view rest, image;
  rest.points = before.points;
  rest.triangles = image.triangles = FFM::boundary_triangles(before, &owners);
  rest.caption = "at rest: " + arguments.input.substr(arguments.input.rfind('/') + 1);
  image.points = after.points;
  for(std::size_t owner : owners)
    image.values.push_back(distortion[owner]);
  char caption[80];
  std::snprintf(caption, sizeof caption, "deformed: energy %.6f", energy);
  image.caption = caption;
  FFM::Surface_picture_options options;
  options.width = arguments.pictures.width;
  options.height = arguments.pictures.width / 2;
  options.label = "distortion";
  std::string message;
  check(FFM::write_surface_PNG(arguments.pictures.png, {rest, image}, options, &message), message);
}

std::optional<Volume_encoding> encoding_of(const Deform_arguments& arguments)
{
  return arguments.encoding.empty() ? std::nullopt : std::make_optional(volume_encoding(arguments.encoding));
}

} // namespace

std::vector<File_argument> files_of(const Deform_arguments& arguments)
{
  return {{"--output", arguments.output},      {"--json", arguments.method.json}, {"--report", arguments.method.report},
          {"--trace", arguments.method.trace}, {"--svg", arguments.pictures.svg}, {"--png", arguments.pictures.png}};
}

void add_solid_options(CLI::App& command, Deform_arguments& arguments)
{
  command.add_flag("--second-order", arguments.second_order,
                   "map tetrahedra of 10 nodes by their corners; the other nodes go to the middles of the mapped edges");
  command
    .add_option("--encoding", arguments.encoding,
                "of the output: ascii or binary for .vtk and .msh; ascii, binary (raw), base64 or compressed for .vtu. That of the input "
                "if it has the same format, otherwise base64 for .vtu and binary for .vtk and .msh")
    ->check(CLI::IsMember(volume_encoding_names()));
}

void check_solid_output(const Deform_arguments& arguments)
{
  check(!arguments.output.empty() || arguments.encoding.empty(), "--encoding needs an output");
  const std::string reason = arguments.output.empty() ? "" : why_volume_not_written(arguments.output, encoding_of(arguments));
  check(reason.empty(), reason);
}

void check_solid_output(const Deform_arguments& arguments, const Volume_file& file)
{
  const std::string reason = arguments.output.empty() ? "" : why_volume_not_written(arguments.output, file);
  check(reason.empty(), reason);
}

Solid_input read_solid_to_map(const Deform_arguments& arguments, FFM::Tetrahedral_domain& volume)
{
  check_folders(files_of(arguments));
  check_solid_output(arguments);
  Solid_input input = read_solid(arguments.input, arguments.second_order);
  check_solid_output(arguments, input.file);
  std::string message;
  const Status status = volume.load(input.solid.mesh.points, input.solid.mesh.tetrahedra, message);
  // Each is held where some of its vertices are.
  if(status != Status::success && status != Status::several_components)
    throw Failure{status, message};
  return input;
}

std::vector<Kernel::Point_3> points_of(const FFM::Tetrahedral_mesh& mesh)
{
  std::vector<Kernel::Point_3> result;
  for(const auto& p : mesh.points)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

FFM::Handles<3> read_solid_handles(const std::string& path, const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume)
{
  FFM::Positions<3> points(3, mesh.points.size());
  std::vector<bool> is_used(mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v) {
    points.col(v) = Eigen::Map<const Eigen::Vector3d>(mesh.points[v].data());
    is_used[v] = volume.number(v) >= 0;
  }
  FFM::Handles<3> handles;
  std::string message;
  check(FFM::read_handles<3>(path, points, handles, &message, is_used), message);
  return handles;
}

std::vector<std::pair<std::size_t, Kernel::Point_3>> read_places(const std::string& path, const std::string& input,
                                                                 const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume)
{
  std::vector<std::pair<std::size_t, Kernel::Point_3>> places;
  if(small_extension(path) == ".handles") {
    const FFM::Handles<3> read = read_solid_handles(path, mesh, volume);
    for(std::size_t i = 0; i < read.vertices.size(); ++i)
      places.emplace_back(read.vertices[i], Kernel::Point_3(read.targets(0, i), read.targets(1, i), read.targets(2, i)));
    return places;
  }
  Polygon_file surface;
  const std::string error = read_polygon_file(path, surface);
  check(error.empty(), error);
  check(surface.points.size() <= mesh.points.size(), path + " has more vertices than " + input);
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    if(volume.number(v) >= 0)
      places.emplace_back(v, Kernel::Point_3(surface.points[v][0], surface.points[v][1], surface.points[v][2]));
  return places;
}

void deform_solid(const Deform_arguments& arguments, Solid_input input, FFM::Summary& summary)
{
  if(!arguments.pictures.svg.empty())
    throw Failure{Status::invalid_option, "solids are drawn to PNG only"};
  check_solid_output(arguments);
  check_solid_output(arguments, input.file);
  const FFM::Tetrahedral_mesh& mesh = input.solid.mesh;
  FFM::Tetrahedral_domain volume;
  std::string message;
  const Status status = volume.load(mesh.points, mesh.tetrahedra, message);
  if(status != Status::success)
    throw Failure{status, message};

  const FFM::Handles<3> read = read_solid_handles(arguments.handles, mesh, volume);
  std::vector<std::pair<std::size_t, Kernel::Point_3>> handles;
  for(std::size_t i = 0; i < read.vertices.size(); ++i)
    handles.emplace_back(read.vertices[i], Kernel::Point_3(read.targets(0, i), read.targets(1, i), read.targets(2, i)));

  std::vector<Kernel::Point_3> result = points_of(mesh);
  const auto reporter = std::make_shared<Reporter>(arguments.method);
  Method_choice method = arguments.method;
  method.dimension = 3;
  FFM::Any_map_traits traits = make_traits(method);
  set_options(arguments.method, reporter, traits.options);
  traits.options.tikhonov = arguments.tikhonov;
  FFM::Deform_volume_options options;
  options.soft_weight = arguments.soft_weight;
  if(!arguments.start.empty()) {
    const FFM::Tetrahedral_mesh start = read_solid(arguments.start, arguments.second_order).solid.mesh;
    check(start.points.size() == mesh.points.size(), arguments.start + " has another number of vertices than " + arguments.input);
    options.start.resize(3, volume.vertices().size());
    for(std::size_t v = 0; v < volume.vertices().size(); ++v)
      options.start.col(v) = Eigen::Map<const Eigen::Vector3d>(start.points[volume.vertices()[v]].data());
  }
  if(arguments.method.is_splitting())
    summary = FFM::deform_volume(volume, handles, CGAL::make_property_map(result), splitting_traits(arguments.method, traits), options);
  else {
    summary = FFM::deform_volume(volume, handles, CGAL::make_property_map(result), traits, options);
    traits.name_choices(summary);
  }
  reporter->finish();
  if(summary.is_valid())
    write_solid(arguments, std::move(input), volume, result, {read.vertices.begin(), read.vertices.end()}, summary);
}

void write_solid(const Deform_arguments& arguments, Solid_input input, const FFM::Tetrahedral_domain& volume,
                 const std::vector<Kernel::Point_3>& result, const std::vector<std::size_t>& handles, const FFM::Summary& summary)
{
  const std::vector<Eigen::Vector3d> singular_values = singular_values_of(volume.domain(), volume, result);
  FFM::Tetrahedral_mesh deformed = input.solid.mesh;
  for(std::size_t i = 0; i < result.size(); ++i)
    deformed.points[i] = {result[i].x(), result[i].y(), result[i].z()};
  center_mid_nodes(input.file.cells, deformed.points);
  if(!arguments.output.empty()) {
    const std::string extension = small_extension(arguments.output);
    if(extension == ".vtu" || extension == ".vtk")
      add_solid_fields(input.solid, singular_values, deformed.points, handles, input.file);
    input.file.points = deformed.points;
    const std::string error = write_volume_file(arguments.output, input.file, encoding_of(arguments));
    check(error.empty(), error);
  }
  if(!arguments.pictures.png.empty()) {
    std::vector<double> distortion;
    for(const Eigen::Vector3d& s : singular_values)
      distortion.push_back(distortion_of(s));
    draw(arguments, input.solid.mesh, deformed, distortion, summary.energy);
  }
}

} // namespace program
