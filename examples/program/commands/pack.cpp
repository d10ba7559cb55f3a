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
#include "../report.h"

#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/pack_charts.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace program {

namespace {

class Pack : public Command
{
public:
  explicit Pack(CLI::App& application)
  {
    app =
      application.add_subcommand("pack", "Pack the islands of existing texture coordinates into the unit square, without flattening anew");
    app->add_option("input", m_input, "OBJ, PLY, GLB or glTF with texture coordinates")->required();
    add_surface_output(*app, m_output, "the mesh with its islands in the unit square");
    add_packing_options(*app, m_packing);
    app->add_option("--pinned", m_pinned,
                    "file with the number of a face of the input per line, from 0: islands with these stay where they are");
    add_summary_options(*app, m_limits);
    app->add_flag("--quiet", m_limits.quiet, "print nothing but errors");
    add_picture_options(*app, m_pictures);
    add_surface_picture(*app, m_pictures);
  }

  int run() override
  {
    m_files = files_of(m_output, m_pictures, m_limits);
    std::string reason = why_not_written(m_input, m_output);
    if(reason.empty())
      reason = why_files_collide({{"the input", m_input}, {"--pinned", m_pinned}}, m_files);
    if(!reason.empty())
      return refuse(reason);
    FFM::Packing_summary summary;
    run_guarded(m_limits, summary, [this](FFM::Packing_summary& account) { pack(account); });
    std::ostringstream text;
    text << summary;
    return report(m_limits, summary.status, summary.message, summary, text.str(), pictures_of(m_pictures));
  }

private:
  void pack(FFM::Packing_summary& summary)
  {
    check_folders(m_files);
    Surface surface;
    surface.uv_set = m_output.uv_set;
    read_surface(m_input, true, surface);
    Atlas atlas = make_atlas(surface, surface.images);
    check(!atlas.mesh.triangles.empty(), m_input + ": no face with an area has texture coordinates");
    // Of islands as large as the surface; what they are packed to is for the picture only.
    std::vector<double> distortion;
    FFM::Textured_mesh unscaled = atlas.mesh;
    const FFM::Distortion_report measured = FFM::measure_distortion(unscaled);
    const double scale = std::sqrt(measured.rest_area / std::abs(measured.image_area));
    if(std::isfinite(scale) && scale > 0)
      for(auto& p : unscaled.texture)
        p = {p[0] * scale, p[1] * scale};
    FFM::measure_distortion(unscaled, &distortion);
    // Outlines are all that counts, hence flipped triangles are handed over turned round, and those without an area not at all.
    FFM::Textured_mesh packed = atlas.mesh;
    const std::vector<char> is_pinned_face = read_pinned_faces(m_pinned, surface, atlas);
    std::vector<std::size_t> given;
    std::vector<char> is_pinned;
    packed.triangles.clear();
    packed.texture_triangles.clear();
    for(std::size_t i = 0; i < atlas.mesh.triangles.size(); ++i) {
      const CGAL::Orientation orientation = image_orientation(atlas.mesh, i);
      if(orientation == CGAL::COLLINEAR)
        continue;
      given.push_back(i);
      is_pinned.push_back(is_pinned_face[atlas.polygons[i]]);
      packed.triangles.push_back(atlas.mesh.triangles[i]);
      packed.texture_triangles.push_back(atlas.mesh.texture_triangles[i]);
      if(orientation == CGAL::RIGHT_TURN) {
        std::swap(packed.triangles.back()[1], packed.triangles.back()[2]);
        std::swap(packed.texture_triangles.back()[1], packed.texture_triangles.back()[2]);
      }
    }
    summary = FFM::pack_charts(packed, m_packing.chosen(), is_pinned);
    if(!summary.is_valid())
      return;
    std::vector<std::size_t> owner(atlas.mesh.texture.size(), atlas.mesh.texture.size());
    for(std::size_t i = 0; i < given.size(); ++i) {
      const bool is_turned = packed.triangles[i] != atlas.mesh.triangles[given[i]];
      for(int k = 0; k < 3; ++k)
        owner[atlas.mesh.texture_triangles[given[i]][k]] = packed.texture_triangles[i][is_turned ? (3 - k) % 3 : k];
    }
    for(std::size_t t = 0; t < owner.size(); ++t)
      if(owner[t] < packed.texture.size())
        atlas.mesh.texture[t] = packed.texture[owner[t]];
    Corner_images images = surface.images;
    copy_images(atlas, images);
    char title[200];
    std::snprintf(title, sizeof title, "%s   %d island%s", m_input.substr(m_input.rfind('/') + 1).c_str(), summary.charts,
                  summary.charts == 1 ? "" : "s");
    write_pictures(m_pictures, title, atlas.mesh, distortion);
    add_note(summary.message, write_surface(m_output, surface, images));
  }

  Method_arguments m_limits;
  Picture_arguments m_pictures;
  Packing_arguments m_packing;
  Surface_output m_output;
  std::vector<File_argument> m_files;
  std::string m_input, m_pinned;
};

} // namespace

std::unique_ptr<Command> pack_command(CLI::App& app) { return std::make_unique<Pack>(app); }

} // namespace program
