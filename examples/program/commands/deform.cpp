// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "deform.h"

#include "../commands.h"
#include "../splitting.h"

#include "../formats/Polygon_document.h"
#include "../formats/volume_files.h"
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace program {

namespace {

// The plane in which a planar mesh lies: the two axes along it in rising order, and whether its faces are seen from behind.
struct Mesh_plane
{
  int first = 0, second = 1;
  bool is_mirrored = false;

  Kernel::Point_2 operator()(const Kernel::Point_3& p) const { return Kernel::Point_2(is_mirrored ? -p[first] : p[first], p[second]); }
};

// The coordinate plane that a mesh lies in, up to rounding.
Mesh_plane find_plane(const Surface& surface, const std::vector<bool>& is_used)
{
  const std::size_t origin = surface.polygons[0][0];
  std::array<double, 3> deviation{};
  std::array<std::size_t, 3> vertex{};
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    for(int c = 0; is_used[v] && c < 3; ++c)
      if(std::abs(surface.points[v][c] - surface.points[origin][c]) > deviation[c]) {
        deviation[c] = std::abs(surface.points[v][c] - surface.points[origin][c]);
        vertex[c] = v;
      }
  const int normal = deviation[2] <= (std::min)(deviation[0], deviation[1]) ? 2 : deviation[1] <= deviation[0] ? 1 : 0;
  const double extent = (std::max)({deviation[0], deviation[1], deviation[2]});
  if(deviation[normal] > 1e-9 * extent) {
    const std::string axis(1, static_cast<char>('x' + normal));
    std::string text;
    FFM::internal::append_number(text, deviation[normal], 3);
    throw Failure{Status::not_planar, "the mesh lies in no plane " + axis + " = const: " + axis + " of vertex number " +
                                        std::to_string(vertex[normal]) + " differs by " + text + " from that of vertex number " +
                                        std::to_string(origin) + "; solids are tetrahedra, or closed surfaces"};
  }
  Mesh_plane plane;
  plane.first = normal == 0 ? 1 : 0;
  plane.second = normal == 2 ? 1 : 2;
  // In the plane of x and y, turned faces are an error of the file.
  if(normal != 2) {
    double area = 0;
    for(const auto& polygon : surface.polygons)
      for(std::size_t k = 2; k < polygon.size(); ++k)
        area += CGAL::area(plane(surface.points[polygon[0]]), plane(surface.points[polygon[k - 1]]), plane(surface.points[polygon[k]]));
    plane.is_mirrored = area < 0;
  }
  return plane;
}

class Deform : public Command
{
public:
  explicit Deform(CLI::App& application)
  {
    app = application.add_subcommand("deform", "Deform a planar shape or a solid by handles");
    app
      ->add_option("input", m_arguments.input,
                   "planar mesh, in a plane x, y or z = const: OFF, OBJ, PLY or STL; tetrahedra: " + std::string(VOLUME_EXTENSIONS) +
                     "; or a closed surface, which is filled with tetrahedra first")
      ->required();
    app
      ->add_option("--handles", m_arguments.handles,
                   "file with lines 'vertex x y [z]', vertices numbered from 0, or 'x y [z] -> x2 y2 [z2]', which means the vertex "
                   "nearest to x y [z]; two coordinates for planar meshes, those along the plane")
      ->required();
    app->add_option("-o,--output", m_arguments.output, "deformed mesh, in a format of the same kind");
    app->add_option("--start", m_arguments.start, "solids: the same mesh, deformed, to begin with instead of the rest shape");
    app->add_option("--soft-weight", m_arguments.soft_weight, "solids: pull handles with this weight instead of holding them")
      ->check(CLI::PositiveNumber);
    app->add_option("--tikhonov", m_arguments.tikhonov, "solids: added to the diagonal of the matrix")->check(CLI::NonNegativeNumber);
    app->add_option("--cell-size", m_arguments.cell_size, "closed surfaces: size of tetrahedra over the diagonal of the bounding box")
      ->check(CLI::Range(0.001, 1.))
      ->capture_default_str();
    add_solid_options(*app, m_arguments);
    app->add_flag("--strict", m_arguments.strict,
                  "planar meshes: refuse polygons that are no triangles, faces without area, and points or faces that are there twice");
    add_method_options(*app, m_arguments.method);
    add_picture_options(*app, m_arguments.pictures);
  }

  int run() override
  {
    m_is_volume = is_volume_file(m_arguments.input);
    std::string reason = why_not_available(m_arguments.method, m_is_volume ? 3 : 2);
    if(reason.empty())
      reason = why_files_collide({{"the input", m_arguments.input}, {"--handles", m_arguments.handles}, {"--start", m_arguments.start}},
                                 files_of(m_arguments));
    if(!reason.empty())
      return refuse(reason);
    return run_reported(
      m_arguments.method, [this](FFM::Summary& summary) { deform(summary); }, {}, pictures_of(m_arguments.pictures));
  }

private:
  void deform(FFM::Summary& summary)
  {
    check_folders(files_of(m_arguments));
    if(m_is_volume) {
      check_solid_output(m_arguments);
      deform_solid(m_arguments, read_solid(m_arguments.input, m_arguments.second_order), summary);
      return;
    }
    const std::string extension = small_extension(m_arguments.input);
    check(extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl",
          "cannot read " + m_arguments.input +
            ": planar meshes and surfaces are read from files .off, .obj, .ply and .stl, tetrahedra from " + VOLUME_EXTENSIONS);
    Surface surface;
    read_piece(m_arguments.input, m_arguments.strict, surface);
    if(!is_closed(surface)) {
      deform_planar(surface, summary);
      return;
    }
    Mesh mesh;
    make_mesh(surface, mesh);
    check_solid_output(m_arguments);
    Solid_input input;
    input.file = make_volume_file(tetrahedralized(mesh, m_arguments.cell_size));
    take_solid(input.file, false, input.solid);
    deform_solid(m_arguments, std::move(input), summary);
  }

  void deform_planar(Surface& surface, FFM::Summary& summary)
  {
    if(!m_arguments.start.empty() || m_arguments.soft_weight > 0 || m_arguments.tikhonov > 0 || m_arguments.second_order ||
       !m_arguments.encoding.empty())
      throw Failure{Status::invalid_option, "--start, --soft-weight, --tikhonov, --second-order and --encoding are for solids"};
    const std::string extension = small_extension(m_arguments.output);
    check(m_arguments.output.empty() || extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl",
          "cannot write " + m_arguments.output + ": planar meshes are written to files .off, .obj, .ply and .stl");
    std::vector<bool> is_used(surface.points.size(), false);
    for(const auto& polygon : surface.polygons)
      for(const std::size_t v : polygon)
        is_used[v] = true;
    const Mesh_plane plane = find_plane(surface, is_used);
    std::vector<Kernel::Point_2> points, result;
    for(const Kernel::Point_3& p : surface.points)
      points.push_back(plane(p));
    const auto handles = read_planar_handles(surface, plane, is_used);

    const auto reporter = std::make_shared<Reporter>(m_arguments.method);
    FFM::Any_map_traits traits = make_traits(m_arguments.method);
    set_options(m_arguments.method, reporter, traits.options);
    const auto deform = [&](const auto& method) {
      return FFM::deform(points, surface.polygons, handles, result,
                         FFM::parameters::map_traits(method, FFM::parameters::strict(m_arguments.strict)));
    };
    if(m_arguments.method.is_splitting())
      summary = deform(splitting_traits(m_arguments.method, traits));
    else {
      summary = deform(traits);
      traits.name_choices(summary);
    }
    reporter->finish();
    explain_failure(surface, m_arguments.strict, summary);
    if(!summary.is_valid())
      return;

    const Atlas atlas = make_atlas(surface, corner_images(surface, result));
    std::vector<double> distortion;
    FFM::measure_distortion(atlas.mesh, &distortion);
    write_pictures(m_arguments.pictures, m_arguments.input, atlas.mesh, distortion, summary);
    for(std::size_t v = 0; v < result.size(); ++v)
      if(is_used[v]) {
        std::array<double, 3> p{surface.points[v].x(), surface.points[v].y(), surface.points[v].z()};
        p[plane.first] = plane.is_mirrored ? -result[v].x() : result[v].x();
        p[plane.second] = result[v].y();
        surface.points[v] = Kernel::Point_3(p[0], p[1], p[2]);
      }
    if(!m_arguments.output.empty())
      write_text(m_arguments.output, deformed_text(extension, surface));
  }

  // Their coordinates in the file are those along the plane.
  std::vector<std::pair<std::size_t, Kernel::Point_2>> read_planar_handles(const Surface& surface, const Mesh_plane& plane,
                                                                           const std::vector<bool>& is_used) const
  {
    FFM::Positions<2> points(2, surface.points.size());
    for(std::size_t i = 0; i < surface.points.size(); ++i)
      points.col(i) << surface.points[i][plane.first], surface.points[i][plane.second];
    FFM::Handles<2> read;
    std::string message;
    check(FFM::read_handles<2>(m_arguments.handles, points, read, &message, is_used), message);
    std::vector<std::pair<std::size_t, Kernel::Point_2>> handles;
    for(std::size_t i = 0; i < read.vertices.size(); ++i)
      handles.emplace_back(read.vertices[i],
                           Kernel::Point_2(plane.is_mirrored ? -read.targets(0, i) : read.targets(0, i), read.targets(1, i)));
    return handles;
  }

  // Everything else of the input's file is kept if the output has the same format and can hold more than points and faces.
  static std::string deformed_text(const std::string& extension, const Surface& surface)
  {
    const auto document = make_document(extension, surface.text);
    if(document == nullptr || small_extension(surface.path) != extension)
      return surface_text(extension, surface);
    std::vector<std::array<double, 3>> points;
    for(const Kernel::Point_3& p : surface.points)
      points.push_back({p.x(), p.y(), p.z()});
    return document->with_points(points);
  }

  Deform_arguments m_arguments;
  bool m_is_volume = false;
};

} // namespace

std::unique_ptr<Command> deform_command(CLI::App& app) { return std::make_unique<Deform>(app); }

} // namespace program
