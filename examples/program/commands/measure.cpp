// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../Atlas.h"
#include "../commands.h"
#include "../layout.h"
#include "../outputs.h"
#include "../report.h"

#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <algorithm>
#include <iostream>

namespace program {

namespace {

class Measure : public Command
{
public:
  explicit Measure(CLI::App& application)
  {
    app = application.add_subcommand("measure", "Measure texture coordinates, in any number of islands; exit code 0 only without flips");
    app
      ->add_option("input", m_input,
                   "OBJ, PLY, GLB or glTF with texture coordinates; faces without them, or without area, are counted only")
      ->required();
    add_uv_set(*app, m_uv_set);
    app->add_option("--json", m_json, "write the figures");
    add_surface_picture(*app, m_picture);
    add_picture_width(*app, m_picture);
  }

  int run() override
  {
    const std::string reason = why_files_collide({{"", ""}, {"the input", m_input}}, {{"--json", m_json}, {"--png3d", m_picture.png3d}});
    if(!reason.empty())
      return refuse(reason);
    FFM::Distortion_report report;
    Atlas atlas;
    bool is_bijective = false;
    std::string overlap;
    std::size_t number_of_islands = 0;
    run_guarded(Method_arguments(), report, [&](FFM::Distortion_report& account) {
      measure(atlas, account);
      if(account.status != Status::success)
        return;
      is_bijective = FFM::is_bijective(atlas.mesh, &overlap);
      number_of_islands = islands(atlas).size();
    });
    const bool is_measured = report.status == Status::success;
    nlohmann::json json = report;
    json["bijective"] = is_bijective;
    json["islands"] = number_of_islands;
    json["faces_without_texture"] = atlas.without_images;
    json["faces_without_area"] = atlas.without_area;
    try {
      write_json(m_json, json);
      if(is_measured)
        write_surface_picture(m_picture, atlas.mesh);
    } catch(const Failure& failure) {
      std::cerr << "flip_free_maps: " << failure.message << '\n';
      return exit_code(failure.status);
    }
    if(!is_measured) {
      std::cerr << "flip_free_maps: " << FFM::status_name(report.status) << ": " << report.message << '\n';
      return exit_code(report.status);
    }
    std::cout << report.elements << " faces in " << number_of_islands << (number_of_islands == 1 ? " island, " : " islands, ")
              << report.flips << " flipped; " << (is_bijective ? "the map is bijective" : "the map is not bijective: " + overlap) << '\n';
    if(atlas.without_images > 0)
      std::cout << atlas.without_images << " faces without texture coordinates are left out\n";
    if(atlas.without_area > 0)
      std::cout << atlas.without_area << " faces without area are left out\n";
    std::cout << "symmetric Dirichlet energy " << report.energy << " (" << report.energy_of_similarity
              << " after the best scaling), largest " << report.max_energy << '\n'
              << "mean angle distortion " << report.mean_angle_distortion << ", mean area distortion " << report.mean_area_distortion
              << '\n'
              << "singular values [" << report.min_singular_value << ", " << report.max_singular_value
              << "]; after the best scaling 95 % of the area are stretched or compressed by at most " << report.stretch_95 << '\n';
    return report.flips == 0 ? 0 : exit_code(Status::start_not_flip_free);
  }

private:
  void measure(Atlas& atlas, FFM::Distortion_report& report) const
  {
    Surface surface;
    surface.uv_set = m_uv_set;
    read_surface(m_input, true, surface);
    atlas = make_atlas(surface, surface.images);
    check(atlas.without_images < surface.polygons.size(), m_input + ": no face has texture coordinates");
    report = FFM::measure_distortion(atlas.mesh);
    if(report.status != Status::success)
      return;
    // A polygon counts once, and is flipped if a triangle of it is.
    std::vector<char> state(surface.polygons.size(), 0);
    for(std::size_t i = 0; i < atlas.polygons.size(); ++i)
      state[atlas.polygons[i]] |= image_orientation(atlas.mesh, i) == CGAL::LEFT_TURN ? 1 : 2;
    report.elements = state.size() - std::count(state.begin(), state.end(), 0);
    report.flips = report.elements - std::count(state.begin(), state.end(), 1);
  }

  Picture_arguments m_picture;
  std::string m_input, m_json;
  std::size_t m_uv_set = 0;
};

} // namespace

std::unique_ptr<Command> measure_command(CLI::App& app) { return std::make_unique<Measure>(app); }

} // namespace program
