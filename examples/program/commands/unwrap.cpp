// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../layout.h"
#include "../number_files.h"
#include "../packing_arguments.h"
#include "../repair_polygons.h"
#include "../report.h"
#include "../unwrap_surface.h"

#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <cstddef>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

namespace program {

namespace {

using Branches = FFM::Cut_options::Branches;

const std::map<std::string, Branches> branches{{"none", Branches::none},
                                               {"extremities", Branches::extremities},
                                               {"curvature-peaks", Branches::curvature_peaks},
                                               {"farthest-points", Branches::farthest_points}};

double radians(double degrees) { return degrees * CGAL_PI / 180; }

class Unwrap : public Command
{
public:
  explicit Unwrap(CLI::App& application)
  {
    app = application.add_subcommand("unwrap", "Make a texture atlas of any surface: cut it open, flatten it, pack the charts");
    app
      ->add_option("input", m_input,
                   "polygons: OFF, OBJ, PLY, STL, GLB or glTF; closed or with holes, of any genus, of any number of components")
      ->required();
    add_surface_output(*app, m_output, "the mesh with texture coordinates in the unit square");
    add_packing_options(*app, m_packing);
    app->add_flag("--no-pack", m_no_pack, "leave the charts where they are, upon each other, in the units of the surface");
    app
      ->add_option("--max-distortion", m_options.max_distortion,
                   "split charts until their mean symmetric Dirichlet energy is at most this; 1 is an isometry; inf for no bound")
      ->capture_default_str();
    app->add_option("--max-stretch", m_options.max_stretch,
                    "split charts until 95 % of their area are stretched or compressed by at most this factor in any direction");
    app
      ->add_option("--hard-edges", m_hard_edges,
                   "edges across which the surface turns by at least so many degrees are seams, as lightmaps and hard normals want")
      ->check(CLI::Range(0., 180.));
    app
      ->add_option(
        "--crease-angle", m_crease_angle,
        "edges across which the surface turns by at least so many degrees, 28.6 if not given, are creases, which seams follow first")
      ->check(CLI::Range(0., 180.));
    app
      ->add_option("--min-occupancy", m_options.min_occupancy,
                   "while less than this part of the square is covered, charts that leave much of it empty are split; 0: never")
      ->capture_default_str();
    CLI::Option* pinned =
      app
        ->add_option("--pinned", m_pinned,
                     "file with the number of a face of the input per line, from 0: its islands of texture coordinates with these stay as "
                     "they are, and all else is packed around them")
        ->excludes("--no-pack");
    CLI::Option* per_object = app->add_flag("--atlas-per-object", m_request.has_atlas_per_object,
                                            "give each mesh of a glTF, or object of an OBJ, an atlas of its own; otherwise they share one");
    per_object->excludes(pinned);
    app->add_option("--seams", m_seams,
                    "file with the numbers of two vertices of the input, from 0, per line: the edges between them are cut");
    app->add_flag(
      "--keep-seams", m_keep_seams,
      "flatten anew along the seams of the input's own texture coordinates; further seams only where the topology asks for them");
    app->add_option("--branches", m_branches, "what seams reach beside what the topology asks for")
      ->check(CLI::IsMember({"none", "extremities", "curvature-peaks", "farthest-points"}))
      ->capture_default_str();
    app
      ->add_option("--points", m_options.cut.number_of_points,
                   "for farthest-points: how many; for the others: at most so many, 0 is no limit")
      ->capture_default_str();
    app->add_flag("--cut-disks", m_options.cut.cut_disks, "lead seams into pieces that are disks already, too");
    CLI::Option* repair = app->add_flag(
      "--repair", m_repair,
      "first remove what makes a mesh unfit: duplicated points and faces, faces without area, sheets that meet, different orientations; "
      "the output is a new file of triangles then");
    repair->excludes(pinned);
    app
      ->add_flag("--strict", m_strict,
                 "refuse what is no manifold mesh of triangles, whose neighbours are oriented alike and which has no face without area")
      ->excludes(repair);
    add_limit_options(*app, m_limits);
    add_picture_options(*app, m_pictures);
    add_surface_picture(*app, m_pictures);
  }

  int run() override
  {
    m_files = files_of(m_output, m_pictures, m_limits);
    std::string reason = why_not_written(m_input, m_output);
    if(reason.empty())
      reason = why_files_collide({{"the input", m_input}, {"--seams", m_seams}, {"--pinned", m_pinned}}, m_files);
    if(!reason.empty())
      return refuse(reason);
    FFM::Unwrap_summary summary;
    std::string repairs;
    run_guarded(m_limits, summary, [&](FFM::Unwrap_summary& account) { unwrap(account, repairs); });
    if(!summary.is_valid() && !repairs.empty())
      summary.message += " (numbers are those after --repair)";
    nlohmann::json json = summary;
    if(m_repair)
      json["repairs"] = repairs;
    std::ostringstream text;
    text << summary;
    if(m_repair)
      text << "  " << repairs << '\n';
    return report(m_limits, summary.status, summary.message, json, text.str(), pictures_of(m_pictures));
  }

private:
  void unwrap(FFM::Unwrap_summary& summary, std::string& repairs)
  {
    check_folders(m_files);
    Surface surface;
    surface.uv_set = m_output.uv_set;
    read_surface(m_input, m_keep_seams || !m_pinned.empty(), surface);
    const Vertex_pairs seams = prepare(surface, repairs);
    FFM::Unwrap_options options = m_options;
    options.strict = m_strict;
    options.pack = !m_no_pack;
    options.packing = m_packing.chosen();
    if(m_crease_angle > 0)
      options.crease_angle = radians(m_crease_angle);
    if(m_hard_edges > 0)
      options.seam_angle = radians(m_hard_edges);
    options.cut.branches = branches.at(m_branches);
    if(m_keep_seams) {
      options.cut.branches = Branches::none;
      options.max_distortion = std::numeric_limits<double>::infinity();
    }
    if(m_limits.time_limit > 0)
      options.max_seconds = m_limits.time_limit;
    Progress progress(m_limits);
    if(progress.is_shown())
      options.observer = [&progress](const FFM::Unwrap_progress& report) {
        progress(report);
        return true;
      };
    m_request.options = options;
    set_limits(m_limits, m_request.traits.options);
    const bool was_transposed = surface.is_transposed;
    m_request.is_single_precision = surface.is_transposed = is_gltf(m_output.path);
    Corner_images images;
    if(!m_pinned.empty()) {
      m_request.is_pinned = read_pinned_faces(m_pinned, surface, make_atlas(surface, surface.images));
      images = surface.images;
      for(auto& polygon : images)
        for(Image& image : polygon)
          if(was_transposed != surface.is_transposed)
            image = was_transposed ? Image{image[1], 1 - image[0]} : Image{1 - image[1], image[0]};
    }
    summary = unwrap_surface(m_request, surface, seams, images);
    progress.finish();
    explain_failure(surface, m_strict, summary);
    if(!summary.is_valid())
      return;
    draw(summary, surface, images);
    add_note(summary.message, write_surface(m_output, surface, images));
  }

  // Reads the seams, and repairs the surface if asked to.
  Vertex_pairs prepare(Surface& surface, std::string& repairs) const
  {
    Vertex_pairs seams;
    if(!m_seams.empty())
      seams = read_seams(m_seams, surface);
    if(m_keep_seams) {
      const Vertex_pairs own = seams_of_images(surface);
      seams.insert(seams.end(), own.begin(), own.end());
    }
    if(!m_repair)
      return seams;
    if(surface.are_objects_apart && surface.object_names.size() > 1)
      throw Failure{Status::invalid_option, "--repair makes one surface of what it repairs, and " + m_input +
                                              " has several meshes; without it, they are taken as they are"};
    const std::vector<Kernel::Point_3> points = surface.points;
    repairs = repair_polygons(surface);
    if(surface.polygons.empty())
      throw Failure{Status::empty_mesh, "nothing is left after the repair"};
    return repaired_seams(seams, points, surface);
  }

  void draw(const FFM::Unwrap_summary& summary, const Surface& surface, const Corner_images& images) const
  {
    if(m_pictures.svg.empty() && m_pictures.png.empty() && m_pictures.png3d.empty())
      return;
    const Atlas atlas = make_atlas(surface, images);
    FFM::Textured_mesh unscaled = atlas.mesh;
    for(auto& p : unscaled.texture)
      p = {p[0] / summary.scale, p[1] / summary.scale};
    std::vector<double> distortion;
    FFM::measure_distortion(unscaled, &distortion);
    char title[200];
    std::snprintf(title, sizeof title, "%s   %d chart%s, energy %.6f", m_input.substr(m_input.rfind('/') + 1).c_str(),
                  static_cast<int>(summary.charts.size()), summary.charts.size() == 1 ? "" : "s", summary.energy);
    write_pictures(m_pictures, title, atlas.mesh, distortion);
  }

  Method_arguments m_limits;
  Picture_arguments m_pictures;
  FFM::Unwrap_options m_options;
  Packing_arguments m_packing;
  Unwrap_request m_request;
  Surface_output m_output;
  std::vector<File_argument> m_files;
  std::string m_input, m_seams, m_pinned, m_branches = "extremities";
  double m_crease_angle = 0, m_hard_edges = 0;
  bool m_no_pack = false, m_repair = false, m_strict = false, m_keep_seams = false;
};

} // namespace

std::unique_ptr<Command> unwrap_command(CLI::App& app) { return std::make_unique<Unwrap>(app); }

} // namespace program
