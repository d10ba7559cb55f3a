// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../report.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <iostream>

namespace program {

namespace {

class Measure : public Command
{
public:
  explicit Measure(CLI::App& application)
  {
    app = application.add_subcommand("measure", "Measure the texture coordinates of an OBJ; exit code 0 only without flips");
    app->add_option("input", m_input, "OBJ with texture coordinates")->required();
    app->add_option("--json", m_json, "write the figures");
  }

  int run() override
  {
    FFM::Distortion_report report;
    FFM::Textured_mesh mesh;
    if(!FFM::read_textured_OBJ(m_input, mesh, &report.message))
      report.status = Status::file_error;
    else
      report = FFM::measure_distortion(mesh);
    std::string reason;
    const bool is_bijective = report.status == Status::success && FFM::is_bijective(mesh, &reason);
    nlohmann::json json = report;
    json["bijective"] = is_bijective;
    try {
      write_json(m_json, json);
    } catch(const Failure& failure) {
      std::cerr << "flip_free_maps: " << failure.message << '\n';
      return exit_code(failure.status);
    }
    if(report.status != Status::success) {
      std::cerr << "flip_free_maps: " << FFM::status_name(report.status) << ": " << report.message << '\n';
      return exit_code(report.status);
    }
    std::cout << report.elements << " faces, " << report.flips << " flipped; "
              << (is_bijective ? "the map is bijective" : "the map is not bijective: " + reason) << '\n'
              << "symmetric Dirichlet energy " << report.energy << " (" << report.energy_of_similarity
              << " after the best scaling), largest " << report.max_energy << '\n'
              << "mean angle distortion " << report.mean_angle_distortion << ", mean area distortion " << report.mean_area_distortion
              << '\n'
              << "singular values [" << report.min_singular_value << ", " << report.max_singular_value << "]\n";
    return report.flips == 0 ? 0 : exit_code(Status::start_not_flip_free);
  }

private:
  std::string m_input, m_json;
};

} // namespace

std::unique_ptr<Command> measure_command(CLI::App& app) { return std::make_unique<Measure>(app); }

} // namespace program
