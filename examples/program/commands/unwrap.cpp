// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../layout.h"
#include "../report.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <unistd.h>

namespace program {

namespace {

using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Corner_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Branches = FFM::Cut_options::Branches;

const std::map<std::string, Branches> branches{{"none", Branches::none},
                                               {"extremities", Branches::extremities},
                                               {"curvature-peaks", Branches::curvature_peaks},
                                               {"farthest-points", Branches::farthest_points}};

// Marks the edges of a file with the numbers of two vertices in each line.
void read_seams(const std::string& path, const Mesh& mesh, Edge_map seams)
{
  std::ifstream in(path);
  check(bool(in), "cannot open " + path);
  int number = 0;
  for(std::string line; std::getline(in, line);) {
    ++number;
    const std::string where = path + ", line " + std::to_string(number);
    std::istringstream words(line.substr(0, line.find('#')));
    long long v = -1, w = -1;
    if(!(words >> v) && words.eof())
      continue;
    check(bool(words >> w) && (words >> std::ws).eof(), where + ": the numbers of two vertices are expected");
    const long long size = static_cast<long long>(mesh.number_of_vertices());
    check(v >= 0 && w >= 0 && v < size && w < size, where + " names a vertex that does not exist");
    const Mesh::Halfedge_index h = mesh.halfedge(Vertex(static_cast<Mesh::size_type>(v)), Vertex(static_cast<Mesh::size_type>(w)));
    check(h != Mesh::null_halfedge(), where + ": there is no edge between these vertices");
    seams[mesh.edge(h)] = true;
  }
}

class Unwrap : public Command
{
public:
  explicit Unwrap(CLI::App& application)
  {
    app = application.add_subcommand("unwrap", "Make a texture atlas of any surface: cut it open, flatten it, pack the charts");
    app->add_option("input", m_input, "mesh: OFF, OBJ, PLY or STL; closed or with holes, of any genus, of any number of components")
      ->required();
    app->add_option("-o,--output", m_output, "OBJ with texture coordinates in the unit square");
    app->add_option("--margin", m_options.packing.margin, "least distance between charts, in parts of the square's side")
      ->capture_default_str();
    app->add_flag("--no-rotation", m_no_rotation, "do not turn charts other than by quarters");
    app->add_flag("--no-pack", m_no_pack, "leave the charts where they are, upon each other, in the units of the surface");
    app->add_option("--max-distortion", m_options.max_distortion,
                    "split charts until their mean symmetric Dirichlet energy is at most this; 1 is an isometry");
    app->add_option("--seams", m_seams, "file with the numbers of two vertices, from 0, per line: the edges between them are cut");
    app->add_option("--branches", m_branches, "what seams reach beside what the topology asks for")
      ->check(CLI::IsMember({"none", "extremities", "curvature-peaks", "farthest-points"}))
      ->capture_default_str();
    app
      ->add_option("--points", m_options.cut.number_of_points,
                   "for farthest-points: how many; for the others: at most so many, 0 is no limit")
      ->capture_default_str();
    app->add_flag("--cut-disks", m_options.cut.cut_disks, "lead seams into pieces that are disks already, too");
    app->add_flag(
      "--repair", m_repair,
      "first remove what makes a mesh unfit: duplicated points and faces, faces without area, sheets that meet, different orientations");
    add_limit_options(*app, m_limits);
    add_picture_options(*app, m_pictures);
  }

  int run() override
  {
    FFM::Unwrap_summary summary;
    std::string repairs;
    run_guarded(
      m_limits, [&] { unwrap(summary, repairs); },
      [&](Status status, const std::string& message) {
        summary.status = status;
        summary.message = message;
      });
    nlohmann::json json = summary;
    if(m_repair)
      json["repairs"] = repairs;
    std::ostringstream text;
    text << summary;
    if(m_repair)
      text << "  " << repairs << '\n';
    return report(m_limits, summary.status, summary.message, json, text.str());
  }

private:
  void unwrap(FFM::Unwrap_summary& summary, std::string& repairs)
  {
    Triangles triangles;
    read_surface(m_input, m_repair, triangles, repairs);
    Mesh& mesh = triangles.mesh;
    Corner_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    Edge_map seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    if(!m_seams.empty())
      read_seams(m_seams, mesh, seams);
    FFM::Unwrap_options options = m_options;
    options.pack = !m_no_pack;
    options.packing.rotate = !m_no_rotation;
    options.cut.branches = branches.at(m_branches);
    if(m_limits.time_limit > 0)
      options.max_seconds = m_limits.time_limit;
    const bool is_quiet = m_limits.quiet || !isatty(STDERR_FILENO);
    if(!is_quiet)
      options.observer = [](const FFM::Unwrap_progress& progress) {
        std::fprintf(stderr, "\rchart %d of %d  %.0f %% of the faces  %.1f s   ", progress.charts_done + 1, progress.charts,
                     100. * progress.faces_done / progress.faces, progress.seconds);
        return true;
      };
    FFM::Flip_free_map_traits<> traits;
    set_limits(m_limits, traits.options);
    summary = FFM::unwrap(mesh, uv, options, traits, CGAL::parameters::edge_is_constrained_map(seams));
    if(!is_quiet)
      std::fputc('\n', stderr);
    if(!summary.is_valid())
      return;

    const FFM::Textured_mesh atlas = FFM::textured_atlas(mesh, uv);
    FFM::Textured_mesh unscaled = atlas;
    for(auto& p : unscaled.texture)
      p = {p[0] / summary.scale, p[1] / summary.scale};
    std::vector<double> distortion;
    FFM::measure_distortion(unscaled, &distortion);
    char title[200];
    std::snprintf(title, sizeof title, "%s   %d charts, energy %.6f", m_input.substr(m_input.rfind('/') + 1).c_str(),
                  static_cast<int>(summary.charts.size()), summary.energy);
    write_pictures(m_pictures, title, atlas, distortion);
    std::string message;
    if(!m_output.empty())
      check(FFM::write_textured_OBJ(m_output, atlas, &message), message);
  }

  Method_arguments m_limits;
  Picture_arguments m_pictures;
  FFM::Unwrap_options m_options;
  std::string m_input, m_output, m_seams, m_branches = "extremities";
  bool m_no_pack = false, m_no_rotation = false, m_repair = false;
};

} // namespace

std::unique_ptr<Command> unwrap_command(CLI::App& app) { return std::make_unique<Unwrap>(app); }

} // namespace program
