// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "deform.h"
#include "refine_solid.h"

#include "../commands.h"
#include "../splitting.h"

#include "../formats/volume_files.h"
#include <CGAL/Flip_free_maps/morph_volume.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace program {

namespace {

using Places = std::vector<std::pair<std::size_t, Kernel::Point_3>>;

class Morph : public Command
{
public:
  explicit Morph(CLI::App& application)
  {
    app = application.add_subcommand("morph", "Move the boundary of a solid, or a part of it, and let the inside follow without a flip");
    m_arguments.method.energy = "symmetric-gradient";
    app->add_option("input", m_arguments.input, "tetrahedra: " + std::string(VOLUME_EXTENSIONS))->required();
    CLI::Option* to = app->add_option(
      "--to", m_to,
      "where the boundary goes: the same solid, moved, of which its boundary counts; or a surface (OFF, OBJ or PLY) whose vertex k is "
      "where vertex k of the solid goes, or with --from");
    app->add_option("--from", m_from, "the surface of --to at rest: each of its vertices is the one of the solid that is at its place")
      ->needs(to);
    CLI::Option* displacement = app
                                  ->add_option("--displacement", m_displacement,
                                               "where the boundary goes: the name of an array of the input, a VTK file, with the "
                                               "displacements of its points; NaN for points that are free")
                                  ->excludes(to);
    app->add_option("--handles", m_arguments.handles, "where vertices go, as for deform")->excludes(to)->excludes(displacement);
    app->add_option("-o,--output", m_arguments.output, "the morphed solid: " + std::string(VOLUME_EXTENSIONS));
    app
      ->add_option("--energy", m_arguments.method.energy,
                   "what is minimised when the flips are gone; exponential-symmetric-dirichlet for the sake of the worst tetrahedra")
      ->check(CLI::IsMember({"symmetric-gradient", "symmetric-dirichlet", "exponential-symmetric-dirichlet"}))
      ->capture_default_str();
    CLI::Option* no_polish =
      app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    app
      ->add_flag("--slide", m_slides,
                 "let the rest of the boundary slide on its planes and along its straight creases; it is free otherwise")
      ->excludes(no_polish);
    add_refine(*app, m_refines);
    add_solid_options(*app, m_arguments);
    add_limit_options(*app, m_arguments.method);
    refuse_without_cairo(app->add_option("--png", m_arguments.pictures.png, "draw the solid before and after, coloured by distortion"));
    add_picture_width(*app, m_arguments.pictures);
  }

  int run() override
  {
    if(m_to.empty() && m_displacement.empty() && m_arguments.handles.empty())
      return refuse("morph wants to know where the boundary goes: --to, --displacement or --handles");
    const std::string reason = why_files_collide(
      {{"the input", m_arguments.input}, {"--to", m_to}, {"--from", m_from}, {"--handles", m_arguments.handles}}, files_of(m_arguments));
    if(!reason.empty())
      return refuse(reason);
    FFM::Morph_summary summary;
    run_guarded(m_arguments.method, summary, [&](FFM::Morph_summary& account) { morph(account); });
    std::ostringstream text;
    text << summary;
    if(summary.is_valid())
      text << "  scaled Jacobians: worst " << summary.quality_before.min_scaled_jacobian << " at rest, "
           << summary.quality.min_scaled_jacobian << " now; mean " << summary.quality_before.mean_scaled_jacobian << ", "
           << summary.quality.mean_scaled_jacobian << '\n';
    return report(m_arguments.method, summary.status, summary.message, summary, text.str(), pictures_of(m_arguments.pictures));
  }

private:
  void morph(FFM::Morph_summary& summary)
  {
    FFM::Tetrahedral_domain volume;
    Solid_input input = read_solid_to_map(m_arguments, volume);
    const Places places = read_places_of(input, volume);
    FFM::Morph_options options;
    options.slide_on_boundary = m_slides;
    options.polish = !m_no_polish;
    FFM::Any_map_traits traits = make_traits(m_arguments.method);
    set_limits(m_arguments.method, options);
    const auto reporter = std::make_shared<Reporter>(m_arguments.method);
    set_options(m_arguments.method, reporter, traits.options);
    std::vector<Kernel::Point_3> result;
    map_and_refine(
      m_refines, input, volume, summary,
      [&] {
        result = points_of(input.solid.mesh);
        summary = FFM::morph_volume(volume, places, CGAL::make_property_map(result), traits, options);
      },
      [](const std::vector<FFM::Edge_split>&) {});
    reporter->finish();
    if(!summary.is_valid())
      return;
    if(options.polish)
      traits.name_choices(summary);
    std::vector<std::size_t> handles;
    for(const auto& place : places)
      handles.push_back(place.first);
    write_solid(m_arguments, std::move(input), volume, result, handles, summary);
  }

  Places read_places_of(const Solid_input& input, const FFM::Tetrahedral_domain& volume) const
  {
    const FFM::Tetrahedral_mesh& mesh = input.solid.mesh;
    if(!m_arguments.handles.empty()) {
      const FFM::Handles<3> read = read_solid_handles(m_arguments.handles, mesh, volume);
      Places places;
      for(std::size_t i = 0; i < read.vertices.size(); ++i)
        places.emplace_back(read.vertices[i], Kernel::Point_3(read.targets(0, i), read.targets(1, i), read.targets(2, i)));
      return places;
    }
    if(!m_displacement.empty())
      return displaced(input);
    if(is_volume_file(m_to)) {
      const FFM::Tetrahedral_mesh moved = read_solid(m_to, m_arguments.second_order).solid.mesh;
      check(moved.points.size() == mesh.points.size(), m_to + " has another number of vertices than " + m_arguments.input);
      Places places;
      for(const std::size_t v : boundary(mesh))
        places.emplace_back(v, Kernel::Point_3(moved.points[v][0], moved.points[v][1], moved.points[v][2]));
      return places;
    }
    return m_from.empty() ? read_places(m_to, m_arguments.input, mesh, volume) : matched_by_place(mesh);
  }

  static std::set<std::size_t> boundary(const FFM::Tetrahedral_mesh& mesh)
  {
    std::set<std::size_t> vertices;
    for(const auto& triangle : FFM::boundary_triangles(mesh))
      vertices.insert(triangle.begin(), triangle.end());
    return vertices;
  }

  Places displaced(const Solid_input& input) const
  {
    const Data_array* array = nullptr;
    const std::string error = find_point_array(input.file, m_displacement, array);
    check(error.empty(), error);
    check(array->number_of_components == 3, m_displacement + " has no three components");
    Places places;
    for(const std::size_t v : boundary(input.solid.mesh)) {
      const auto& p = input.solid.mesh.points[v];
      const double d[3] = {array->value(3 * v), array->value(3 * v + 1), array->value(3 * v + 2)};
      if(!std::isnan(d[0]) && !std::isnan(d[1]) && !std::isnan(d[2]))
        places.emplace_back(v, Kernel::Point_3(p[0] + d[0], p[1] + d[1], p[2] + d[2]));
    }
    return places;
  }

  Places matched_by_place(const FFM::Tetrahedral_mesh& mesh) const
  {
    Polygon_file from, to;
    for(const auto& [path, file] : {std::make_pair(m_from, &from), std::make_pair(m_to, &to)}) {
      const std::string error = read_polygon_file(path, *file);
      check(error.empty(), error);
    }
    check(from.points.size() == to.points.size(), m_to + " has another number of vertices than " + m_from);
    FFM::Positions<3> points(3, mesh.points.size());
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      points.col(v) = Eigen::Map<const Eigen::Vector3d>(mesh.points[v].data());
    std::vector<bool> is_on_boundary(mesh.points.size(), false);
    Eigen::AlignedBox3d box;
    for(const std::size_t v : boundary(mesh)) {
      is_on_boundary[v] = true;
      box.extend(points.col(v));
    }
    const FFM::internal::Nearest_point<3> nearest(points, is_on_boundary);
    Places places;
    for(std::size_t i = 0; i < from.points.size(); ++i) {
      const Eigen::Vector3d place(from.points[i][0], from.points[i][1], from.points[i][2]);
      const std::int32_t v = nearest(place);
      if(!((points.col(v) - place).norm() <= TOLERANCE * box.diagonal().norm()))
        throw Failure{Status::invalid_option, m_from + ": no vertex of the boundary of " + m_arguments.input + " is at vertex " +
                                                std::to_string(i) + "; the nearest one is number " + std::to_string(v)};
      places.emplace_back(v, Kernel::Point_3(to.points[i][0], to.points[i][1], to.points[i][2]));
    }
    return places;
  }

  // Within which vertices are at the same place, in parts of the solid's diagonal: files of surfaces may have single precision.
  static constexpr double TOLERANCE = 1e-6;

  Deform_arguments m_arguments;
  std::string m_to, m_from, m_displacement;
  bool m_no_polish = false, m_slides = false, m_refines = false;
};

} // namespace

std::unique_ptr<Command> morph_command(CLI::App& app) { return std::make_unique<Morph>(app); }

} // namespace program
