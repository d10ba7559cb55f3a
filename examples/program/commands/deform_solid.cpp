// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "deform.h"

#include "../splitting.h"

#include "../formats/VTU.h"
#include "../formats/volume_files.h"
#include "../formats/volume_text.h"
#include "../pictures/Surface_picture.h"
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace program {

namespace {

// Distortion of each tetrahedron of the user's mesh: those of a map may come from another mesh with the same numbers.
std::vector<double> distortions(const FFM::Simplicial_domain<3>& domain, const FFM::Tetrahedral_domain& numbers,
                                const std::vector<Kernel::Point_3>& points)
{
  FFM::Positions<3> x(3, domain.number_of_vertices);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const Kernel::Point_3& p = points[numbers.vertices()[v]];
    x.col(v) = numbers.to_domain(Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  const FFM::Map_measure<3> measure(domain);
  std::vector<double> result;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Vector3d s = measure.singular_values(x, e);
    result.push_back(s[2] > 0 ? (std::min)(FFM::Symmetric_dirichlet().value<3>(s), 1e30) : 1e30);
  }
  return result;
}

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

// Writes the input's file with other points, where the output is of its format. `false` for formats of which nothing is kept.
bool write_back(const Deform_arguments& arguments, const std::vector<std::array<double, 3>>& points)
{
  const auto read = [](const std::string& path) {
    std::string text, message;
    check(FFM::internal::read_whole_file(path, text, &message), message);
    return text;
  };
  const auto is_tetgen = [](const std::string& path) { return small_extension(path) == ".node" || small_extension(path) == ".ele"; };
  if(small_extension(arguments.input) == ".mesh" && small_extension(arguments.output) == ".mesh")
    write_text(arguments.output, Medit_with_points(read(arguments.input), points));
  else if(is_tetgen(arguments.input) && is_tetgen(arguments.output)) {
    const auto [node_input, element_input] = FFM::internal::tetgen_file_names(arguments.input);
    const auto [node_output, element_output] = FFM::internal::tetgen_file_names(arguments.output);
    const std::string elements = read(element_input);
    write_text(node_output, Tetgen_with_points(read(node_input), points));
    write_text(element_output, elements);
  } else
    return false;
  return true;
}

} // namespace

std::vector<File_argument> files_of(const Deform_arguments& arguments)
{
  return {{"--output", arguments.output},
          {"--json", arguments.method.json},
          {"--trace", arguments.method.trace},
          {"--svg", arguments.pictures.svg},
          {"--png", arguments.pictures.png}};
}

void check_solid_output(const std::string& path)
{
  const std::string extension = small_extension(path);
  check(path.empty() || extension == ".mesh" || extension == ".vtu" || extension == ".node" || extension == ".ele",
        "cannot write " + path + ": solids are written to files .mesh, .vtu, .node and .ele");
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

void deform_solid(const Deform_arguments& arguments, FFM::Tetrahedral_mesh mesh, FFM::Summary& summary)
{
  if(!arguments.pictures.svg.empty())
    throw Failure{Status::invalid_option, "solids are drawn to PNG only"};
  check_solid_output(arguments.output);
  FFM::Tetrahedral_domain volume;
  std::string message;
  const Status status = volume.load(mesh.points, mesh.tetrahedra, message);
  if(status != Status::success)
    throw Failure{status, message};

  const FFM::Handles<3> read = read_solid_handles(arguments.handles, mesh, volume);
  std::vector<std::pair<std::size_t, Kernel::Point_3>> handles;
  for(std::size_t i = 0; i < read.vertices.size(); ++i)
    handles.emplace_back(read.vertices[i], Kernel::Point_3(read.targets(0, i), read.targets(1, i), read.targets(2, i)));

  std::vector<Kernel::Point_3> result;
  for(const auto& p : mesh.points)
    result.emplace_back(p[0], p[1], p[2]);
  const auto reporter = std::make_shared<Reporter>(arguments.method);
  FFM::Any_map_traits traits = make_traits(arguments.method);
  set_options(arguments.method, reporter, traits.options);
  traits.options.tikhonov = arguments.tikhonov;
  FFM::Deform_volume_options options;
  options.soft_weight = arguments.soft_weight;
  if(!arguments.start.empty()) {
    FFM::Tetrahedral_mesh start;
    check(FFM::read_volume(arguments.start, start, &message), message);
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
    write_solid(arguments, mesh, volume, result, summary);
}

void write_solid(const Deform_arguments& arguments, const FFM::Tetrahedral_mesh& mesh, const FFM::Tetrahedral_domain& volume,
                 const std::vector<Kernel::Point_3>& result, const FFM::Summary& summary)
{
  std::string message;
  const std::vector<double> distortion = distortions(volume.domain(), volume, result);
  FFM::Tetrahedral_mesh deformed = mesh;
  for(std::size_t i = 0; i < result.size(); ++i)
    deformed.points[i] = {result[i].x(), result[i].y(), result[i].z()};
  if(!arguments.output.empty() && !write_back(arguments, deformed.points)) {
    const bool is_vtu = small_extension(arguments.output) == ".vtu";
    check(is_vtu ? FFM::write_VTU(arguments.output, deformed, {}, {{"symmetric_dirichlet_energy", 1, distortion}}, &message)
                 : FFM::write_volume(arguments.output, deformed, &message),
          message);
  }
  if(!arguments.pictures.png.empty())
    draw(arguments, mesh, deformed, distortion, summary.energy);
}

} // namespace program
