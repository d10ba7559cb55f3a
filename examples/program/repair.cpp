// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "splitting.h"

#include <CGAL/Flip_free_maps/repair_map.h>

namespace program {

namespace {

class Repair
  : public Command
{
public:
  explicit Repair(CLI::App& application)
  {
    app = application.add_subcommand("repair", "Remove the flips of texture coordinates, and then minimise their distortion");
    app->add_option("input", m_input, "OBJ of a topological disk with one pair of texture coordinates per vertex")->required();
    app->add_option("-o,--output", m_output, "OBJ with the repaired texture coordinates");
    app->add_flag("--unit-square", m_unit_square, "scale the texture coordinates into the unit square");
    app->add_flag("--fix-border", m_fix_border, "border vertices keep their places");
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    add_limit_options(*app, m_method);
    add_picture_options(*app, m_pictures);
  }

  int run() override
  {
    return run_reported(m_method, [this](FFM::Summary& summary) { repair(summary); });
  }

private:
  void repair(FFM::Summary& summary)
  {
        Triangles triangles;
    read_triangles(m_input, triangles);
    Mesh& mesh = triangles.mesh;
    const Mesh::Halfedge_index border = longest_border(mesh);
    if(border == Mesh::null_halfedge())
      throw Failure{Status::no_border, "the surface is closed"};
    UV_map uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
    const std::vector<Kernel::Point_2> given = vertex_texture(m_input, triangles);
    for(const auto v : mesh.vertices())
      uv[v] = given[v];

    FFM::Repair_options options;
    options.polish = !m_no_polish;
    options.fix_border = m_fix_border;
    FFM::Flip_free_map_traits<> traits;
    set_limits(m_method, options);
    const auto reporter = std::make_shared<Reporter>(m_method);
    set_options(m_method, reporter, traits.options);
    summary = FFM::repair_map(mesh, border, uv, options, traits);
    reporter->finish();
    if(summary.is_valid())
      write_layout(triangles, uv, m_unit_square, m_output, m_pictures, m_input, summary);
  }

  Method_arguments m_method;
  Picture_arguments m_pictures;
  std::string m_input, m_output;
  bool m_unit_square = false, m_fix_border = false, m_no_polish = false;
};

} // namespace

std::unique_ptr<Command> repair_command(CLI::App& app)
{
  return std::make_unique<Repair>(app);
}

} // namespace program
