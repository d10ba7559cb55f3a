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
#include <CGAL/Flip_free_maps/map_volume.h>

#include <array>
#include <cstdint>
#include <utility>

namespace program {

namespace {

class Map_volume : public Command
{
public:
  explicit Map_volume(CLI::App& application)
  {
    app = application.add_subcommand("map-volume", "Map a solid to another one, whose surface is given");
    m_arguments.method.energy = "symmetric-gradient";
    app->add_option("input", m_arguments.input, "tetrahedra: " + std::string(VOLUME_EXTENSIONS))->required();
    app
      ->add_option("target", m_arguments.handles,
                   "surface (OFF, OBJ or PLY) whose vertex k is where vertex k of the solid goes, or a file .handles with a line for each "
                   "vertex on the boundary, as for deform")
      ->required();
    app->add_option("-o,--output", m_arguments.output, "the mapped solid: " + std::string(VOLUME_EXTENSIONS));
    app->add_option("--start", m_arguments.start, "the same mesh, mapped, perhaps with flips, instead of the mean of neighbours inside");
    app->add_option("--energy", m_arguments.method.energy, "what is minimised when the flips are gone")
      ->check(CLI::IsMember({"symmetric-gradient", "symmetric-dirichlet"}))
      ->capture_default_str();
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    add_refine(*app, m_refines);
    add_solid_options(*app, m_arguments);
    add_limit_options(*app, m_arguments.method);
    refuse_without_cairo(app->add_option("--png", m_arguments.pictures.png, "draw the solid before and after, coloured by distortion"));
    add_picture_width(*app, m_arguments.pictures);
  }

  int run() override
  {
    const std::string reason = why_files_collide(
      {{"the input", m_arguments.input}, {"the target", m_arguments.handles}, {"--start", m_arguments.start}}, files_of(m_arguments));
    if(!reason.empty())
      return refuse(reason);
    return run_reported(
      m_arguments.method, [this](FFM::Summary& summary) { map(summary); }, {}, pictures_of(m_arguments.pictures));
  }

private:
  void map(FFM::Summary& summary)
  {
    FFM::Tetrahedral_domain volume;
    Solid_input input = read_solid_to_map(m_arguments, volume);
    const FFM::Tetrahedral_mesh& mesh = input.solid.mesh;

    std::vector<Kernel::Point_3> result = points_of(mesh);
    if(!m_arguments.start.empty()) {
      const FFM::Tetrahedral_mesh start = read_solid(m_arguments.start, m_arguments.second_order).solid.mesh;
      check(start.points.size() == mesh.points.size(), m_arguments.start + " has another number of vertices than " + m_arguments.input);
      result = points_of(start);
    }
    const auto places = read_places(m_arguments.handles, m_arguments.input, mesh, volume);
    std::vector<std::size_t> handles;
    for(const auto& [v, place] : places) {
      result[v] = place;
      handles.push_back(v);
    }

    FFM::Repair_options options;
    options.polish = !m_no_polish;
    FFM::Any_map_traits traits = make_traits(m_arguments.method);
    set_limits(m_arguments.method, options);
    const auto reporter = std::make_shared<Reporter>(m_arguments.method);
    set_options(m_arguments.method, reporter, traits.options);
    const FFM::Volume_start start = m_arguments.start.empty() ? FFM::Volume_start::extension : FFM::Volume_start::given;
    std::vector<std::pair<std::int32_t, Eigen::Vector3d>> exact_places;
    FFM::Positions<3> x;
    const auto run = [&] {
      std::vector<std::int32_t> boundary;
      exact_places.clear();
      for(const auto& [v, place] : places) {
        boundary.push_back(volume.number(v));
        exact_places.emplace_back(boundary.back(), Eigen::Vector3d(place.x(), place.y(), place.z()));
      }
      x.resize(3, volume.vertices().size());
      for(std::size_t v = 0; v < volume.vertices().size(); ++v) {
        const Kernel::Point_3& p = result[volume.vertices()[v]];
        x.col(v) = volume.to_domain(Eigen::Vector3d(p.x(), p.y(), p.z()));
      }
      summary = FFM::map_volume(volume.domain(), boundary, x, start, options, traits);
    };
    map_and_refine(m_refines, input, volume, summary, run, [&result](const std::vector<FFM::Edge_split>& splits) {
      for(const FFM::Edge_split& split : splits)
        result.push_back(CGAL::midpoint(result[split.ends[0]], result[split.ends[1]]));
    });
    reporter->finish();
    if(!summary.is_valid())
      return;
    if(options.polish)
      traits.name_choices(summary);
    std::string message;
    const Status written = volume.write_back(x, CGAL::make_property_map(result), message, exact_places);
    if(written != Status::success)
      throw Failure{written, message};
    write_solid(m_arguments, std::move(input), volume, result, handles, summary);
  }

  Deform_arguments m_arguments;
  bool m_no_polish = false, m_refines = false;
};

} // namespace

std::unique_ptr<Command> map_volume_command(CLI::App& app) { return std::make_unique<Map_volume>(app); }

} // namespace program
