// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../layout.h"
#include "../report.h"
#include "../splitting.h"

#include <CGAL/Flip_free_maps/repair_map.h>

namespace program {

namespace {

class Repair : public Command
{
public:
  explicit Repair(CLI::App& application)
  {
    app = application.add_subcommand("repair", "Remove the flips of texture coordinates, and then minimise their distortion");
    add_layout_options(*app, m_layout, "OBJ of a topological disk with one pair of texture coordinates per vertex",
                       "OBJ with the repaired texture coordinates");
    app->add_flag("--fix-border", m_fix_border, "border vertices keep their places");
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    add_limit_options(*app, m_method);
    add_picture_options(*app, m_layout.pictures);
  }

  int run() override
  {
    return run_reported(m_method, [this](FFM::Summary& summary) { repair(summary); });
  }

private:
  void repair(FFM::Summary& summary)
  {
    Patch patch;
    read_patch(m_layout.input, patch);
    const Mesh& mesh = patch.triangles.mesh;
    const std::vector<Kernel::Point_2> given = vertex_texture(m_layout.input, patch.triangles);
    for(const auto v : mesh.vertices())
      patch.uv[v] = given[v];

    FFM::Repair_options options;
    options.polish = !m_no_polish;
    options.fix_border = m_fix_border;
    FFM::Flip_free_map_traits<> traits;
    set_limits(m_method, options);
    const auto reporter = std::make_shared<Reporter>(m_method);
    set_options(m_method, reporter, traits.options);
    summary = FFM::repair_map(mesh, patch.border, patch.uv, options, traits);
    reporter->finish();
    if(summary.is_valid())
      write_layout(m_layout, patch, summary);
  }

  Method_arguments m_method;
  Layout_arguments m_layout;
  bool m_fix_border = false, m_no_polish = false;
};

} // namespace

std::unique_ptr<Command> repair_command(CLI::App& app) { return std::make_unique<Repair>(app); }

} // namespace program
